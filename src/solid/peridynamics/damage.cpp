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
#include "solid/peridynamics/critical_stretch.hpp"
#include "solid/peridynamics/failure_bonds.hpp"
#include "solid/peridynamics/failure_equilibrium.hpp"
#include "solid/peridynamics/failure_state.hpp"

namespace arenite::peridynamics {
namespace {

template <int D> void check(const DamageOptionsIn<D>& o) {
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
std::string sentence_of(const DamageOutcome& r) {
  const char* end = damage_endings[static_cast<std::size_t>(r.ending)].phrase;
  if (r.ending == DamageOutcome::Ending::no_path) return end;
  return fmt::format("{}; strength {:.6g} Pa, {} bonds broken in {} solves", end, r.strength, r.broken.size(),
                     r.solves);
}

/// How near the bonds of a sample are to breaking.
template <int D> class FailureCriterion {
 public:
  FailureCriterion(const BondsIn<D>& bonds, double dx, const BondLawChoice& law, const std::array<double, 4>& critical,
                   const statics::FieldIn<D, double>& u)
      : bonds_(bonds),
        dx_(dx),
        law_(law),
        critical_(critical),
        u_(u),
        by_level_(static_cast<std::size_t>(bonds.grid.levels())) {}

  /// The law's damage at the linearised stretch: both stretches times |e|^2 dx, e in nodes.
  template <BondLaw Law> double ratio(const Law& law, const auto& bond) const {
    return law.damage(extension(bond, u_), square(bond.step()) * dx_ * critical_[bond.type]);
  }

  /// Largest ratio of all bonds, 0 where none is stretched. Notes it level by level for `each_above`.
  double largest() {
    std::visit(
        [&](const auto& law) {
          for (int level = 0; level < bonds_.grid.levels(); ++level) {
            double& worst = by_level_[level] = 0;
            each_bond_of_level(bonds_, bonds_.words, level,
                               [&](const auto& b) { worst = std::max(worst, ratio(law, b)); });
          }
        },
        law_);
    return *std::max_element(by_level_.begin(), by_level_.end());
  }

  /// Bonds whose ratio is `limit` or more, as `largest` last saw them, in order: `visit(bond, ratio)`.
  template <class Visit> void each_above(double limit, const Visit& visit) const {
    std::visit(
        [&](const auto& law) {
          for (int level = 0; level < bonds_.grid.levels(); ++level)
            if (by_level_[level] >= limit)
              each_bond_of_level(bonds_, bonds_.words, level, [&](const auto& b) {
                if (const double r = ratio(law, b); r >= limit) visit(b, r);
              });
        },
        law_);
  }

 private:
  const BondsIn<D>& bonds_;
  double dx_;
  const BondLawChoice& law_;
  std::array<double, 4> critical_;
  const statics::FieldIn<D, double>& u_;
  std::vector<double> by_level_;
};

StressField stress_of(const Bonds& bonds, double dx, const Field<double>& u) {
  return node_stress(bonds, dx, u, false);
}
VoxelStress stress_of(const SpaceBonds& bonds, double dx, const statics::FieldIn<3, double>& u) {
  return node_stress(bonds, dx, u);
}

/// The place of a bond's first node.
BrokenBond broken_at(const Bond& b, double strain) {
  return {b.x, b.y, 0, static_cast<std::uint8_t>(b.d), static_cast<std::uint8_t>(b.type), strain};
}
BrokenBond broken_at(const SpaceBond& b, double strain) {
  return {b.x, b.y, b.z, static_cast<std::uint8_t>(b.d), static_cast<std::uint8_t>(b.type), strain};
}

auto changed_by_solve(auto& s) {
  return std::tie(s.words, s.parted, s.words_at_setup, s.u, s.solves, s.iterations, s.share);
}

/// A test to failure on its way; displacements and forces are those of unit strain.
template <int D> class FailureTest : public FailureEquilibrium<D> {
  using Base = FailureEquilibrium<D>;

 public:
  FailureTest(const MapIn<D>& map, const DamageOptionsIn<D>& options)
      : Base(map, options),
        critical_(critical_stretches(options, map.dx)),
        criterion_(bonds_, map.dx, options.law, critical_, state_.u) {}

  /// Rounds of breaking until the test ends.
  void run();
  /// The result, once; `run` comes first.
  DamageResultIn<D> finish();

 private:
  using Base::bonds_, Base::state_, Base::resisting_, Base::map_, Base::options_, Base::ending_;
  using Base::unit_energy_, Base::unit_force_;
  using typename Base::Ending;

  double elastic(double strain) const { return strain * strain * unit_energy_; }
  double stress(double strain) const { return strain * unit_force_ / section_of(map_); }
  void settle();
  void strain_to(double next);
  void remember();
  void break_worst(double largest);
  void hold();
  FailureStateIn<D> state() const;

  std::array<double, 4> critical_;
  FailureCriterion<D> criterion_;
  FailureStateIn<D> before_;  ///< of this round's solve, what it changes; for those who keep states
};

}  // namespace

/// After a round of breaking, at the strain that it happened at.
template <int D> void FailureTest<D>::settle() {
  state_.now.released += state_.now.elastic - elastic(state_.now.strain);
  state_.now.elastic = elastic(state_.now.strain);
  state_.now.stress = stress(state_.now.strain);
  state_.now.broken = state_.broken.size();
}

/// On to the strain at which the next bond breaks.
template <int D> void FailureTest<D>::strain_to(double next) {
  if (next > state_.now.strain) {
    const double to = std::min(next, options_.max_strain);
    state_.now.work += unit_force_ * this->gauge() * (to * to - state_.now.strain * state_.now.strain) / 2;
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

template <int D> void FailureTest<D>::remember() {
  state_.strength = state_.now.stress;
  state_.strongest_words = resisting_.words;
  state_.strongest_u = state_.u;
  state_.strongest_strain = state_.now.strain;
}

/// Breaks what is stretched beyond the critical stretch, the worst of it.
template <int D> void FailureTest<D>::break_worst(double largest) {
  const double limit = std::max(1 - 1e-9, (1 - options_.band) * state_.now.strain * largest) / state_.now.strain;
  criterion_.each_above(limit, [&](const auto& b, double ratio) {
    const double stretch = state_.now.strain * ratio * critical_[b.type];
    const double modulus = energy_modulus(bonds_, b, map_.dx);
    state_.now.bond_energy += std::visit([&](const auto& law) { return law.energy(stretch, modulus); }, options_.law);
    clear(bonds_.words, b.i, b.d);
    if (this->closes_) word_at(state_.parted, b.i, b.d) |= b.type << bit_of(b.d);
    state_.broken.push_back(broken_at(b, state_.now.strain));
  });
}

template <int D> void FailureTest<D>::run() {
  ending_ = Ending::no_path;
  if (!this->is_set_up()) {
    this->uniform_strain();
    if (!this->prepare()) return;
  }
  const auto hand_out = [&] {
    if (options_.keep) options_.keep([&] { return state(); });
  };
  for (;; ++state_.rounds) {
    hold();
    hand_out();
    if (!this->equilibrate()) {
      if (ending_ == Ending::stopped) hand_out();
      return;
    }
    if (state_.rounds == 0) state_.modulus = unit_force_ / section_of(map_);
    settle();
    if (state_.rounds > 0 && state_.now.stress <= options_.end_stress * state_.strength) {
      state_.curve.push_back(state_.now);
      ending_ = this->prepare() ? Ending::dropped : Ending::severed;
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

template <int D> DamageResultIn<D> FailureTest<D>::finish() {
  DamageResultIn<D> result;
  static_cast<FailureRecord&>(result) = std::move(state_);
  result.ending = ending_;
  if (result.strength > 0) {
    resisting_.words = state_.strongest_words;
    for (int axis = 0; axis < D; ++axis)
      for (double& u : state_.strongest_u[axis]) u *= state_.strongest_strain;
    result.at_strength = stress_of(resisting_, map_.dx, state_.strongest_u);
  }
  result.sentence = sentence_of(result);
  return result;
}

/// Notes what the solve of a round changes, where somebody may ask for the state before it.
template <int D> void FailureTest<D>::hold() {
  if (!options_.keep) return;
  changed_by_solve(before_) = changed_by_solve(state_);
  before_.words = bonds_.words;
}

template <int D> FailureStateIn<D> FailureTest<D>::state() const {
  FailureStateIn<D> s = state_;  // this round's solve will be done again
  changed_by_solve(s) = changed_by_solve(before_);
  return s;
}

template <int D> DamageResultIn<D> load_to_failure(const MapIn<D>& map, const DamageOptionsIn<D>& options) {
  check(options);
  FailureTest<D> test(map, options);
  if (options.resume) test.resume(*options.resume);
  test.run();
  return test.finish();
}

template DamageResultIn<2> load_to_failure<2>(const PhaseMap&, const DamageOptionsIn<2>&);
template DamageResultIn<3> load_to_failure<3>(const VoxelMap&, const DamageOptionsIn<3>&);

}  // namespace arenite::peridynamics
