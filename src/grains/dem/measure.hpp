#pragma once
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Grains (velocities at the time of the positions), walls and contacts in the caller's order.
Packing packing_of(const Sample& sample);

/// Energies stored now, with the tally of what was dissipated and done so far.
Energies energies_of(const Sample& sample);

Equilibrium equilibrium_of(const Sample& sample);

/// Energy of the adhesion, J, <= 0.
double adhesive_energy(const Sample& sample);

}  // namespace arenite::dem
