#pragma once
#include <array>

#include "core/parameters.hpp"
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// One scheme for Newton's equations: a file beside this one. A new one is a word of IntegratorKind and a place in `integrators`.
struct Integrator {
  Word word;
  /// Takes the forces at t_n in the sample to positions and seen velocities at t_{n+1}; walls and affine motion too. False if the contact list has
  /// become stale.
  bool (*sweep)(Sample&, const ThreadPool&);
  /// Finds starting values from a state whose velocities are those of its places; null where none are needed.
  void (*start)(Sample&);
  /// Between steps a predictor and corrector holds a predicted state, whose rates lack this share of the change of acceleration times dt/2, and its
  /// places this share of that times dt^2/2; 0 and 0 of other schemes.
  double velocity_share, position_share;
  /// Share of a step by which the places are ahead of the velocities that memories of friction are fed with.
  double lead;
  /// The stable step: p (omega dt)^2 + q lambda dt = 1 with damping lambda, and omega dt = undamped without.
  double p, q, undamped;

  bool corrects() const { return velocity_share > 0; }
};

/// Velocity Verlet in its half-step form, one force evaluation and one sweep a step. Its growing mode flips sign every step.
///
/// The integrated velocity w belongs to the middle of the step: w_{n+1/2} = w_{n-1/2} + dt a_n, x_{n+1} = x_n + dt w_{n+1/2}, and v_n = w_{n-1/2} +
/// (dt/2) a_n. Forces depend on velocities, so they are given u_{n+1} = w_{n+1/2} + c (dt/2) a_n: with c = 1 (velocity_verlet) that is v_{n+1} to
/// second order; with c = 0 (leapfrog) it is the mid-step velocity, as LAMMPS's velocity Verlet has it: of first order in the damping, stable up to
/// twice the step.
///
extern const Integrator velocity_verlet, leapfrog;

/// Between steps the sample holds the predicted state at t_n and the forces there. One fused sweep corrects it and predicts t_{n+1}.
extern const Integrator gear5;

/// In the order of IntegratorKind.
inline const std::array<const Integrator*, 3> integrators{&velocity_verlet, &leapfrog, &gear5};
inline const Integrator& integrator_of(IntegratorKind kind) { return *integrators[static_cast<std::size_t>(kind)]; }
inline const Integrator& integrator_of(const Sample& s) { return integrator_of(s.integration.integrator); }

/// A step of all disks in one sweep of the kernel. To be made before the walls move, run after.
class DiskSweep {
 public:
  explicit DiskSweep(Sample& sample);
  /// Moves the disks and what goes with the cell. False if the contact list has become stale.
  bool run(Kernel::Sweep loop, const ThreadPool& pool);

  SweepTask task{};  ///< `kick` and `ahead` are the integrator's to fill in

 private:
  Sample& sample_;
  CellFrame before_;
};

}  // namespace arenite::dem
