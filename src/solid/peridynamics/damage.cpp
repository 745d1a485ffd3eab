#include "solid/peridynamics/damage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "core/problems.hpp"
#include "solid/peridynamics/failure_equilibrium.hpp"
#include "solid/peridynamics/failure_state.hpp"

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

/// How near the bonds of a sample are to breaking.
class FailureCriterion {
 public:
  FailureCriterion(const Bonds& bonds, double dx, const std::array<double, 4>& critical, const Field<double>& u)
      : bonds_(bonds),
        dx_(dx),
        critical_(critical),
        u_(u),
        by_row_(static_cast<std::size_t>(bonds.grid.height)) {}

  /// The law's damage at the linearised stretch: both stretches times |e|^2 dx, e in nodes.
  template <BondLaw Law> double ratio(const Law& law, const Bond& b) const {
    const Offset e = b.step();
    return law.damage(e.x * (u_.x[b.j] - u_.x[b.i]) + e.y * (u_.y[b.j] - u_.y[b.i]),
                      (e.x * e.x + e.y * e.y) * dx_ * critical_[b.type]);
  }

  /// Largest ratio of all bonds, 0 where none is stretched. Notes it row by row for `each_above`.
  double largest() {
    std::visit(
        [&](const auto& law) {
          for (int y = 0; y < bonds_.grid.height; ++y) {
            double& worst = by_row_[y] = 0;
            each_bond_of_row(bonds_, y, [&](const Bond& b) { worst = std::max(worst, ratio(law, b)); });
          }
        },
        bonds_.law);
    return *std::max_element(by_row_.begin(), by_row_.end());
  }

  /// Bonds whose ratio is `limit` or more, as `largest` last saw them, in order: `visit(Bond, ratio)`.
  template <class Visit> void each_above(double limit, const Visit& visit) const {
    std::visit(
        [&](const auto& law) {
          for (int y = 0; y < bonds_.grid.height; ++y)
            if (by_row_[y] >= limit)
              each_bond_of_row(bonds_, y, [&](const Bond& b) {
                if (const double r = ratio(law, b); r >= limit) visit(b, r);
              });
        },
        bonds_.law);
  }

 private:
  const Bonds& bonds_;
  double dx_;
  std::array<double, 4> critical_;
  const Field<double>& u_;
  std::vector<double> by_row_;
};

auto changed_by_solve(auto& s) {
  return std::tie(s.words, s.parted, s.words_at_setup, s.u, s.solves, s.iterations, s.share);
}

/// A test to failure on its way; displacements and forces are those of unit strain.
class FailureTest : public FailureEquilibrium {
 public:
  FailureTest(const PhaseMap& map, const DamageOptions& options)
      : FailureEquilibrium(map, options),
        critical_(critical_stretches(options, map.dx)),
        criterion_(bonds_, map.dx, critical_, state_.u) {}

  /// Rounds of breaking until the test ends.
  void run();
  /// The result, once; `run` comes first.
  DamageResult finish();

 private:
  double elastic(double strain) const { return strain * strain * unit_energy_; }
  double stress(double strain) const { return strain * unit_force_ / (map_.width * map_.dx); }
  void settle();
  void strain_to(double next);
  void remember();
  void break_worst(double largest);
  void hold();
  FailureState state() const;

  std::array<double, 4> critical_;
  FailureCriterion criterion_;
  FailureState before_;  ///< of this round's solve, what it changes; for those who keep states
};

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
  if (!is_set_up()) {
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

/// Notes what the solve of a round changes, where somebody may ask for the state before it.
void FailureTest::hold() {
  if (!options_.keep) return;
  changed_by_solve(before_) = changed_by_solve(state_);
  before_.words = bonds_.words;
}

FailureState FailureTest::state() const {
  FailureState s = state_;  // this round's solve will be done again
  changed_by_solve(s) = changed_by_solve(before_);
  return s;
}

DamageResult load_to_failure(const PhaseMap& map, const DamageOptions& options) {
  check(options);
  FailureTest test(map, options);
  if (options.resume) test.resume(*options.resume);
  test.run();
  return test.finish();
}

std::vector<Crack> cracks_of(const std::vector<BrokenBond>& broken, double dx) {
  std::vector<Crack> cracks;
  for (const auto& bond : broken) {
    const auto step = half_bonds[bond.direction];
    cracks.push_back({static_cast<float>((bond.x + 0.5 + 0.5 * step.x) * dx),
                      static_cast<float>((bond.y + 0.5 + 0.5 * step.y) * dx), bond.type, bond.strain});
  }
  return cracks;
}

}  // namespace arenite::peridynamics
