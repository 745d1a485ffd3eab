#pragma once
#include "grains/dem/integrators/integrator.hpp"

namespace arenite::dem {

// Velocity Verlet in its half-step form, one force evaluation and one sweep a step. Its growing mode flips sign every
// step.
//
// The integrated velocity w belongs to the middle of the step: w_{n+1/2} = w_{n-1/2} + dt a_n, x_{n+1} = x_n + dt
// w_{n+1/2}, and v_n = w_{n-1/2} + (dt/2) a_n. Forces depend on velocities, so they are given u_{n+1} = w_{n+1/2} +
// ahead dt a_n: with 1/2 (velocity_verlet) that is v_{n+1} to second order; with 0 (leapfrog) it is the mid-step
// velocity, as LAMMPS's velocity Verlet has it: of first order in the damping, stable up to twice the step.

inline constexpr Integrator velocity_verlet{.word = {"velocity_verlet", "second order, the most robust"},
                                            .lag = 0.5,
                                            .ahead = 0.5,
                                            .lead = 0.5,
                                            .p = 0.25,
                                            .q = 1,
                                            .undamped = 2};
inline constexpr Integrator leapfrog{.word = {"leapfrog", "second order, velocities half a step off"},
                                     .lag = 0.5,
                                     .ahead = 0,
                                     .lead = 1,
                                     .p = 0.25,
                                     .q = 0.5,
                                     .undamped = 2};

}  // namespace arenite::dem
