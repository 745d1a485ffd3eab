#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solid/peridynamics/couplings.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/failure_bonds.hpp"
#include "solid/peridynamics/failure_state.hpp"
#include "solid/peridynamics/kernels/kernels.hpp"
#include "solid/peridynamics/kernels/space_kernels.hpp"
#include "solid/peridynamics/space/couplings_in_space.hpp"
#include "solid/statics/static_solver.hpp"

namespace arenite::peridynamics {

/// A sample in a test to failure (damage.hpp), and how it comes to equilibrium whenever bonds have broken: what of it
/// resists, the solver for that, and faces that part and meet. Displacements and forces are those of unit strain.
template <int D> class FailureEquilibrium {
 public:
  FailureEquilibrium(const MapIn<D>& map, const DamageOptionsIn<D>& options);

  /// Takes over a state.
  void resume(const FailureStateIn<D>& state);

 protected:
  using Ending = DamageOutcome::Ending;
  using Displacements = statics::FieldIn<D, double>;

  double gauge() const { return (bonds_.grid.levels() - 1) * map_.dx; }
  bool is_set_up() const { return solver_.has_value(); }
  void uniform_strain();
  bool prepare();
  bool equilibrate();

  const MapIn<D>& map_;
  const DamageOptionsIn<D>& options_;
  const bool closes_;        ///< faces that have parted push where they meet again
  BondsIn<D> bonds_;         ///< those that are whole
  BondsIn<D> resisting_;     ///< these, and parted ones whose faces press on each other: what the solver sees
  FailureStateIn<D> state_;  ///< where the test stands, but for its words: these are those of `bonds_`
  Ending ending_ = Ending::no_path;
  double unit_force_ = 0;   ///< of the clamp, N; in the plane N/m
  double unit_energy_ = 0;  ///< of all bonds, J; in the plane J/m

 private:
  struct Joined {
    bool changed = false;  ///< other bonds resist than before
    bool outside = false;  ///< some of them did not when the solver was set up
  };
  Joined join();
  void follow_clamps(const Buffer<statics::Tie>& tie);
  void drop_loose(const Buffer<statics::Tie>& tie);
  bool watched(int iterations, double residual);
  statics::StaticReport solve(int most);
  enum class Rest { found, apart, not_found };
  Rest find_rest();
  bool shorten_step(const Displacements& from);

  const Vec<D> way_;  ///< of the upper clamp
  std::vector<std::uint8_t> prescribed_;
  std::optional<statics::StaticSolver<BondsIn<D>>> solver_;
  Displacements f_;
};

}  // namespace arenite::peridynamics
