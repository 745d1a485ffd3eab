#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/exact_stretch.hpp"
#include "solid/peridynamics/failure_state.hpp"
#include "solid/peridynamics/support.hpp"

namespace arenite::peridynamics {

/// A sample in a test to failure (damage.hpp), and how it comes to equilibrium whenever bonds have broken: what of it
/// resists, the solver for that, and faces that part and meet. Displacements and forces are those of unit strain.
class FailureEquilibrium {
 public:
  FailureEquilibrium(const PhaseMap& map, const DamageOptions& options);

  /// Takes over a state.
  void resume(const FailureState& state);

 protected:
  using Ending = DamageResult::Ending;

  double gauge() const { return (map_.height - 1) * map_.dx; }
  bool is_set_up() const { return solver_.has_value(); }
  void uniform_strain();
  bool prepare();
  bool equilibrate();

  const PhaseMap& map_;
  const DamageOptions& options_;
  const bool closes_;   ///< faces that have parted push where they meet again
  Bonds bonds_;         ///< those that are whole
  Bonds resisting_;     ///< these, and parted ones whose faces press on each other: what the solver sees
  FailureState state_;  ///< where the test stands, but for its words: these are those of `bonds_`
  Ending ending_ = Ending::no_path;
  double unit_force_ = 0;   ///< of the clamp, N/m
  double unit_energy_ = 0;  ///< of all bonds, J/m

 private:
  struct Joined {
    bool changed = false;  ///< other bonds resist than before
    bool outside = false;  ///< some of them did not when the solver was set up
  };
  Joined join();
  void follow_clamps(const Buffer<Tie>& tie);
  void drop_loose(const Buffer<Tie>& tie);
  bool watched(int iterations, double residual);
  StaticReport solve(int most);
  enum class Rest { found, apart, not_found };
  Rest find_rest();
  bool shorten_step(const Field<double>& from);

  const Vec2 way_;  ///< of the top row
  std::vector<std::uint8_t> prescribed_;
  std::optional<StaticSolver> solver_;
  Field<double> f_;
};

}  // namespace arenite::peridynamics
