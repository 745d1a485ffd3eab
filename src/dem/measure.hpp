#pragma once
#include "dem/sample.hpp"

namespace arenite::dem {

/// Grains (velocities at the time of the positions), walls and contacts in the caller's order.
Packing packing_of(const Sample& sample);

/// Energies stored now, with the tally of what was dissipated and done so far.
Energies energies_of(const Sample& sample);

Equilibrium equilibrium_of(const Sample& sample);

/// Velocity of inner disk k at the time of its position, without the affine motion; its turning as third.
struct Motion {
  double vx, vy, omega;
};
Motion motion_of(const Sample& sample, std::size_t k);

/// Velocity of a wall at the time of its position.
double wall_rate(const Sample& sample, std::size_t side);

/// Elastic (normal and tangential) and adhesive energy of one slot, J.
struct StoredEnergy {
  double normal = 0, tangential = 0, adhesive = 0;
};

}  // namespace arenite::dem
