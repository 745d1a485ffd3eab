#pragma once
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Velocity Verlet in its half-step form, one force evaluation and one sweep a step.
///
/// The integrated velocity w belongs to the middle of the step: w_{n+1/2} = w_{n-1/2} + dt a_n, x_{n+1} = x_n + dt w_{n+1/2}, and v_n = w_{n-1/2} +
/// (dt/2) a_n. Forces depend on velocities, so they are given u_{n+1} = w_{n+1/2} + c (dt/2) a_n: with c = 1 (velocity_verlet) that is v_{n+1} to
/// second order; with c = 0 (leapfrog) it is the mid-step velocity, as LAMMPS's velocity Verlet has it: of first order in the damping, stable up to
/// twice the step.
///
/// Takes the forces at t_n in the sample to positions and seen velocities at t_{n+1}; walls and affine motion too. False if the contact list has
/// become stale.
bool verlet_sweep(Sample& sample, double extrapolation, const Team& team);

/// Between steps the sample holds the predicted state at t_n and the forces there. One fused sweep corrects it and predicts t_{n+1}; walls and affine
/// motion too. False if the contact list has become stale.
bool gear_sweep(Sample& sample, const Team& team);

/// Starting values: third to fifth derivatives from forces at the Taylor continuation of the present state half a step and a step ahead and back,
/// three times over. A grain whose contacts change within that span starts with zeros. Expects corrected positions and velocities; leaves forces and
/// springs as of now.
void gear_start(Sample& sample);

/// A step of all disks in one sweep of the kernel. To be made before the walls move, run after.
class DiskSweep {
 public:
  explicit DiskSweep(Sample& sample);
  /// Moves the disks and what goes with the cell. False if the contact list has become stale.
  bool run(Kernel::Sweep loop, const Team& team);

  SweepTask task;  ///< `kick` and `ahead` are the integrator's to fill in

 private:
  Sample& sample_;
  CellFrame before_;
};

}  // namespace arenite::dem
