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

/// Place of inner disk k: Gear's records hold the predicted one, which this corrects.
Vec2 place_of(const Sample& sample, std::size_t k);

/// Velocity of a wall at the time of its position.
double wall_rate(const Sample& sample, std::size_t side);

double wall_place(const Sample& sample, std::size_t side);

/// Energy of the adhesion, J, <= 0.
double adhesive_energy(const Sample& sample);

}  // namespace arenite::dem
