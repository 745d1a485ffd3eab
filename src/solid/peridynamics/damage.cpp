#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/problems.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/failure.hpp"
#include "solid/peridynamics/support.hpp"

namespace arenite::peridynamics {
namespace {

void check(const DamageOptions& o) {
  const auto positive = [](double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value))
      throw refusal("the {} of a test to failure is {:g}; give a positive one", what, value);
  };
  positive(o.tolerance, "tolerance");
  positive(o.max_strain, "largest strain");
  if (!(o.end_stress >= 0) || !(o.end_stress < 1))
    throw refusal("the fraction of the strength at which a test ends is {:g}; give one from 0 to below 1",
                  o.end_stress);
  if (!(o.band >= 0) || !(o.band < 1))
    throw refusal("the band of bonds that break together is {:g}; give one from 0 to below 1", o.band);
}

/// How a test ended and what came of it, in words.
std::string sentence_of(const DamageResult& r) {
  const char* end = damage_endings[static_cast<std::size_t>(r.ending)].phrase;
  if (r.ending == DamageResult::Ending::no_path) return end;
  return fmt::format("{}; strength {:.6g} Pa, {} bonds broken in {} solves", end, r.strength, r.broken.size(),
                     r.solves);
}

}  // namespace

std::array<double, 4> critical_stretches(const DamageOptions& o, double dx) {
  const Stiffness& e = o.stiffness;
  const Toughness& k = o.toughness;
  const Strength& f = o.strength;
  check_by_type("toughness", "Pa m^0.5", k.matrix, k.interface, k.particle);
  for (const double strength : {f.matrix, f.interface, f.particle})
    if (!(strength > 0)) throw refusal("a strength of bonds is {:g} Pa; give a positive one", strength);
  return std::visit(
      [&](const auto& law) -> std::array<double, 4> {
        const auto lower = [&](double toughness, double strength, double modulus) {
          return std::min(law.critical_stretch(toughness, modulus, dx), strength / modulus);
        };
        return {0, lower(k.matrix, f.matrix, e.matrix), lower(k.interface, f.interface, e.interface),
                lower(k.particle, f.particle, e.particle)};
      },
      o.law);
}

FailureTest::FailureTest(const PhaseMap& map, const DamageOptions& options)
    : map_(map),
      options_(options),
      way_(direction_of(options.loading)),
      closes_(!options.cracks_stay_open),
      bonds_(make_bonds(map, options.stiffness, options.law, options.stop_at_voids)),
      prescribed_(prescribed_rows(map.height, options.loading, options.lower)),
      critical_(critical_stretches(options, map.dx)),
      f_(bonds_.grid.padded_size()),
      criterion_(bonds_, map.dx, critical_, state_.u) {
  state_.width = map.width;
  state_.height = map.height;
  state_.u = f_;
  if (closes_) state_.parted = bonds_.words;
  make_cuts(bonds_, options.cuts);
  for (std::size_t i = 0; i < state_.parted.size(); ++i) state_.parted[i] ^= bonds_.words[i];
  resisting_ = bonds_;
}

/// After a round of breaking, at the strain that it happened at.
void FailureTest::settle() {
  state_.now.released += state_.now.elastic - elastic(state_.now.strain);
  state_.now.elastic = elastic(state_.now.strain);
  state_.now.stress = stress(state_.now.strain);
  state_.now.broken = state_.broken.size();
}

/// On to the strain at which the next bond breaks.
void FailureTest::strain_to(double next) {
  if (next > state_.now.strain) {
    const double to = std::min(next, options_.max_strain);
    state_.now.work += unit_force_ * gauge() * (to * to - state_.now.strain * state_.now.strain) / 2;
    state_.now.strain = to;
    state_.now.elastic = elastic(to);
    state_.now.stress = stress(to);
  }
  state_.curve.push_back(state_.now);
  if (state_.now.work > 0)
    state_.energy_defect = std::max(
        state_.energy_defect, std::abs(state_.now.work - state_.now.elastic - state_.now.released) / state_.now.work);
  if (state_.now.stress > state_.strength) remember();
}

void FailureTest::remember() {
  state_.strength = state_.now.stress;
  state_.strongest_words = resisting_.words;
  state_.strongest_u = state_.u;
  state_.strongest_strain = state_.now.strain;
}

/// Breaks what is stretched beyond the critical stretch, the worst of it.
void FailureTest::break_worst(double largest) {
  const double limit = std::max(1 - 1e-9, (1 - options_.band) * state_.now.strain * largest) / state_.now.strain;
  criterion_.each_above(limit, [&](const Bond& b, double ratio) {
    const double stretch = state_.now.strain * ratio * critical_[b.type];
    const double modulus = bonds_.modulus(b.type) * map_.dx * map_.dx * length(b.step());
    state_.now.bond_energy += std::visit([&](const auto& law) { return law.energy(stretch, modulus); }, bonds_.law);
    bonds_.break_bond(b.i, b.d);
    if (closes_) state_.parted[b.i] |= b.type << (2 * b.d);
    state_.broken.push_back(
        {b.x, b.y, static_cast<std::uint8_t>(b.d), static_cast<std::uint8_t>(b.type), state_.now.strain});
  });
}

void FailureTest::run() {
  ending_ = Ending::no_path;
  if (!solver_) {
    uniform_strain();
    if (!prepare()) return;
  }
  const auto hand_out = [&] {
    if (options_.keep) options_.keep([&] { return state(); });
  };
  for (;; ++state_.rounds) {
    hold();
    hand_out();
    if (!equilibrate()) {
      if (ending_ == Ending::stopped) hand_out();
      return;
    }
    if (state_.rounds == 0) state_.modulus = unit_force_ / (map_.width * map_.dx);
    settle();
    if (state_.rounds > 0 && state_.now.stress <= options_.end_stress * state_.strength) {
      state_.curve.push_back(state_.now);
      ending_ = prepare() ? Ending::dropped : Ending::severed;
      return;
    }
    const double largest = criterion_.largest();
    strain_to(largest > 0 ? 1 / largest : options_.max_strain);
    if (state_.now.strain >= options_.max_strain || state_.rounds >= options_.max_events) {
      ending_ = state_.now.strain >= options_.max_strain ? Ending::strain_reached : Ending::events_reached;
      return;
    }
    break_worst(largest);
  }
}

DamageResult FailureTest::finish() {
  DamageResult result;
  static_cast<FailureRecord&>(result) = std::move(state_);
  result.ending = ending_;
  if (result.strength > 0) {
    resisting_.words = state_.strongest_words;
    for (auto* component : {&state_.strongest_u.x, &state_.strongest_u.y})
      for (double& u : *component) u *= state_.strongest_strain;
    result.at_strength = node_stress(resisting_, map_.dx, state_.strongest_u, false);
  }
  result.sentence = sentence_of(result);
  return result;
}

DamageResult load_to_failure(const PhaseMap& map, const DamageOptions& options) {
  check(options);
  FailureTest test(map, options);
  if (options.resume) test.resume(*options.resume);
  test.run();
  return test.finish();
}

}  // namespace arenite::peridynamics
