#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/solvers/solvers.hpp"
#include "solid/peridynamics/support.hpp"

namespace arenite::peridynamics {

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

/// A sample in a test to failure (damage.hpp); displacements and forces are those of unit strain.
class FailureTest {
 public:
  FailureTest(const PhaseMap& map, const DamageOptions& options);

  /// Takes over a state; `run` then goes on from it.
  void resume(const FailureState& state);
  /// Rounds of breaking until the test ends.
  void run();
  /// The result, once; `run` comes first.
  DamageResult finish();

 private:
  using Ending = DamageResult::Ending;

  double gauge() const { return (map_.height - 1) * map_.dx; }
  double elastic(double strain) const { return strain * strain * unit_energy_; }
  double stress(double strain) const { return strain * unit_force_ / (map_.width * map_.dx); }

  // Bonds and equilibrium (failure_equilibrium.cpp).
  struct Joined {
    bool changed = false;  ///< other bonds resist than before
    bool outside = false;  ///< some of them did not when the solver was set up
  };
  Joined join();
  void uniform_strain();
  bool prepare();
  void follow_clamps(const Buffer<Tie>& tie);
  void drop_loose(const Buffer<Tie>& tie);
  bool watched(int iterations, double residual);
  StaticReport solve(int most);
  enum class Rest { found, apart, not_found };
  Rest find_rest();
  bool shorten_step(const Field<double>& from);
  bool equilibrate();

  void settle();
  void strain_to(double next);
  void remember();
  void break_worst(double largest);
  void hold();
  FailureState state() const;

  const PhaseMap& map_;
  const DamageOptions& options_;
  const Vec2 way_;     ///< of the top row
  const bool closes_;  ///< faces that have parted push where they meet again
  Bonds bonds_;        ///< those that are whole
  Bonds resisting_;    ///< these, and parted ones whose faces press on each other: what the solver sees
  std::vector<std::uint8_t> prescribed_;
  std::array<double, 4> critical_;
  std::optional<StaticSolver> solver_;
  Field<double> f_;
  FailureState state_;   ///< where the test stands, but for its words: these are those of `bonds_`
  FailureState before_;  ///< of this round's solve, what it changes; for those who keep states
  FailureCriterion criterion_;
  Ending ending_ = Ending::no_path;
  double unit_force_ = 0;   ///< of the clamp, N/m
  double unit_energy_ = 0;  ///< of all bonds, J/m
};

}  // namespace arenite::peridynamics
