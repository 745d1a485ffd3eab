#pragma once
#include <functional>

#include "grains/dem/kernels/kernel.hpp"

namespace arenite::dem {

template <int D> struct SampleIn;

/// Hertz contacts stiffen without end: bounds of the step hold for overlaps up to this share of R*, or the largest
/// there is.
inline constexpr double reference_share = 0.02;

/// Largest steps that the sample in hand allows, s.
struct StepBounds {
  double stiffness = 0;  ///< from the largest eigenfrequency bound of a grain's contacts
  double damping = 0;    ///< from the largest damping rate (dashpots, sliding viscosity with rotation)
  double largest() const { return stiffness < damping ? stiffness : damping; }
};

/// How fast something rings, and how fast that dies away.
struct Rates {
  double frequency_squared = 0, damping = 0;  ///< 1/s^2, 1/s
};

/// Steepest slopes of the forces of a contact, along n, along t, and of rolling resistance over r^2: in its ways, N/m,
/// or in its velocities, N s/m.
struct Slopes {
  double normal = 0, sliding = 0, rolling = 0;
};
struct ContactSlopes {
  Slopes springs, dashpots;
};
/// Those of two grains like this disk or sphere at a reference overlap.
template <int D> using SlopesOf = std::function<ContactSlopes(const GrainRecord<D>&)>;

/// Shortest contact time T_c = pi sqrt(m_eff/k) of any two grains of the sample (or a grain and a wall), those on bonds
/// included, s.
template <int D> double shortest_contact_time(const SampleIn<D>& sample);

/// Largest stable steps of the sample's integrator, from the stiffest and the most damped grain. A grain counts with
/// its contacts now or with six (spheres: twelve) of grains like itself, whichever is more, so that a loose sample may
/// be compacted.
template <int D> StepBounds step_bounds(const SampleIn<D>& sample);

}  // namespace arenite::dem
