#pragma once
#include "dem/sample.hpp"

namespace arenite::dem {

/// Mass of the disk in record k by density, radius and thickness, kg.
double own_mass(const Sample& sample, std::size_t k);

/// Gives the disks their own masses, or even ones. Even: every grain is as heavy as makes its contacts as fast as those of
/// the grain whose contacts are fastest, k/m alike. The step stays stable, waves run through grains of unlike sizes as
/// fast as it allows, and states of rest do not change, for they do not know masses (but for weight: no gravity then).
/// Dashpots follow the masses, so restitution is kept. Speeds stay.
void give_masses(Sample& sample, Masses masses);

}  // namespace arenite::dem
