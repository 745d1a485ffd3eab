#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/solvers/static_solve.hpp"

namespace arenite::peridynamics {

/// A sample under a pull to failure (damage.hpp); displacements and forces are those of unit strain.
class Pull {
 public:
  Pull(const PhaseMap& map, const DamageOptions& options);

  /// Takes over a state; `run` then goes on from it.
  void resume(const PullState& state);
  /// Rounds of breaking until the pull ends.
  void run();
  /// The result, once; `run` comes first.
  DamageResult finish();

 private:
  double gauge() const { return (map_.height - 1) * map_.dx; }
  double elastic(double strain) const { return strain * strain * unit_energy_; }
  double stress(double strain) const { return strain * unit_force_ / (map_.width * map_.dx); }

  bool prepare();
  void uniform_strain();
  bool watched(int iterations, double residual);
  StaticReport solve(int most);
  bool equilibrate();
  void settle();
  void strain_to(double next);
  void remember();
  void break_worst(double largest);
  void hold();
  PullState state() const;

  const PhaseMap& map_;
  const DamageOptions& options_;
  const Vec2 way_;  ///< of the top row
  Bonds bonds_;
  std::vector<std::uint8_t> prescribed_;
  std::array<double, 4> critical_;
  std::optional<StaticSolver> solver_;
  Buffer<std::uint32_t> words_at_setup_;
  Field<double> u_, f_;
  Overstretch overstretch_;
  DamageResult result_;
  DamageState now_;
  std::int64_t rounds_ = 0;  ///< of breaking so far
  double unit_force_ = 0;    ///< of the clamp, N/m
  double unit_energy_ = 0;   ///< of all bonds, J/m
  double share_ = 0;         ///< Progress::share
  PullState held_;           ///< before this round, of what its solve changes

  /// Bonds and equilibrium when the stress was largest.
  struct Strongest {
    Buffer<std::uint32_t> words;
    Field<double> u;
    double strain = 0;
  } strongest_;
};

}  // namespace arenite::peridynamics
