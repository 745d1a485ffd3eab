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
    if (!(value > 0) || !std::isfinite(value)) throw refusal("the {} of a test to failure is {:g}; give a positive one", what, value);
  };
  positive(o.tolerance, "tolerance");
  positive(o.max_strain, "largest strain");
  if (!(o.end_stress >= 0) || !(o.end_stress < 1))
    throw refusal("the fraction of the strength at which a test ends is {:g}; give one from 0 to below 1", o.end_stress);
  if (!(o.band >= 0) || !(o.band < 1)) throw refusal("the band of bonds that break together is {:g}; give one from 0 to below 1", o.band);
}

/// By BondType; that of `no_bond` is 0.
std::array<double, 4> critical_stretches(const DamageOptions& o, double dx) {
  const Stiffness& e = o.stiffness;
  const Toughness& k = o.toughness;
  return std::visit(
      [&](const auto& law) -> std::array<double, 4> {
        check_by_type("toughness", "Pa m^0.5", k.matrix, k.interface, k.particle);
        return {0, law.critical_stretch(k.matrix, e.matrix, dx), law.critical_stretch(k.interface, e.interface, dx),
                law.critical_stretch(k.particle, e.particle, dx)};
      },
      o.law);
}

/// How a test ended and what came of it, in words.
std::string sentence_of(const DamageResult& r) {
  const char* end = damage_endings[static_cast<std::size_t>(r.ending)].phrase;
  if (r.ending == DamageResult::Ending::no_path) return end;
  return fmt::format("{}; strength {:.6g} Pa, {} bonds broken in {} solves", end, r.strength, r.broken.size(), r.solves);
}

}  // namespace

FailureTest::FailureTest(const PhaseMap& map, const DamageOptions& options)
    : map_(map),
      options_(options),
      way_(direction_of(options.loading)),
      bonds_(make_bonds(map, options.stiffness, options.law)),
      prescribed_(prescribed_rows(map.height, options.loading, options.lower)),
      critical_(critical_stretches(options, map.dx)),
      f_(bonds_.grid.padded_size()),
      criterion_(bonds_, map.dx, critical_, state_.u) {
  state_.width = map.width;
  state_.height = map.height;
  state_.u = f_;
  make_cuts(bonds_, options.cuts);
}

/// Set-up for the bonds as they are; false if nothing ties the clamps any more.
bool FailureTest::prepare() {
  state_.words_at_setup = bonds_.words;
  auto aggregates = cut_into_aggregates(map_, bonds_, prescribed_);
  Buffer<Tie> tie;
  if (prune(bonds_, aggregates, prescribed_, tie).carrying == 0) return false;
  solver_.emplace(bonds_, std::move(aggregates), prescribed_);
  return true;
}

void FailureTest::uniform_strain() {
  auto phase = map_.phase.begin();
  bonds_.grid.each([&](std::ptrdiff_t i, int y) {
    if (*phase++ != Phase::empty) state_.u.set(i, y * map_.dx * way_);
  });
}

bool FailureTest::watched(int iterations, double residual) {
  if (!options_.watch) return true;
  const double fallen = state_.strength > 0 ? (1 - state_.now.stress / state_.strength) / (1 - options_.end_stress) : 0;
  state_.share = std::clamp(std::max({fallen, state_.now.strain / options_.max_strain, static_cast<double>(state_.solves) / (options_.max_events + 1)}),
                            state_.share, 1.0);
  return options_.watch({state_.share, state_.iterations + iterations, residual, state_.broken.size(), state_.now.strain, state_.now.stress});
}

StaticReport FailureTest::solve(int most) {
  const StaticReport report = solver_->solve(bonds_, state_.u, options_.tolerance, most, [&](const Progress& p) { return watched(p.iterations, p.residual); });
  state_.iterations += report.iterations;
  if (report.stopped) ending_ = Ending::stopped;
  return report;
}

/// The field at unit strain from the last one. A set-up that the broken bonds have left behind is made anew. False where the test ends here.
bool FailureTest::equilibrate() {
  constexpr int tired = 25;
  ending_ = Ending::not_converged;
  StaticReport report = solve(2 * tired);
  ++state_.solves;
  if (report.stopped) return false;
  if (report.iterations > tired || !report.converged) {
    if (!prepare()) {
      unit_force_ = unit_energy_ = 0;
      return true;
    }
    report = solve(100);
  }
  unit_energy_ = -linear_force(bonds_, state_.u, f_) / 2;
  unit_force_ = 0;
  for (std::ptrdiff_t i = bonds_.grid.row(map_.height - 1), end = i + map_.width; i < end; ++i) unit_force_ -= dot(f_.at(i), way_);
  return report.converged;
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
    state_.energy_defect = std::max(state_.energy_defect, std::abs(state_.now.work - state_.now.elastic - state_.now.released) / state_.now.work);
  if (state_.now.stress > state_.strength) remember();
}

void FailureTest::remember() {
  state_.strength = state_.now.stress;
  state_.strongest_words = bonds_.words;
  state_.strongest_u = state_.u;
  state_.strongest_strain = state_.now.strain;
}

/// Breaks what is stretched beyond the critical stretch, the worst of it.
void FailureTest::break_worst(double largest) {
  const double limit = std::max(1 - 1e-9, (1 - options_.band) * state_.now.strain * largest) / state_.now.strain;
  int low = map_.height, high = -1;
  criterion_.each_above(limit, [&](const Bond& b, double ratio) {
    const double stretch = state_.now.strain * ratio * critical_[b.type];
    const double modulus = bonds_.modulus(b.type) * map_.dx * map_.dx * length(b.step());
    state_.now.bond_energy += std::visit([&](const auto& law) { return law.energy(stretch, modulus); }, bonds_.law);
    bonds_.break_bond(b.i, b.d);
    state_.broken.push_back({b.x, b.y, static_cast<std::uint8_t>(b.d), static_cast<std::uint8_t>(b.type), state_.now.strain});
    low = std::min(low, b.y);
    high = std::max(high, b.y);
  });
  classify_groups(bonds_, low, high);
}

void FailureTest::run() {
  ending_ = Ending::no_path;
  if (!solver_) {
    if (!prepare()) return;
    uniform_strain();
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
    bonds_.words = state_.strongest_words;
    for (auto* component : {&state_.strongest_u.x, &state_.strongest_u.y})
      for (double& u : *component) u *= state_.strongest_strain;
    result.at_strength = node_stress(bonds_, map_.dx, state_.strongest_u, false);
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
