#pragma once
#include "grains/dem/engine.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Shortest contact time T_c = pi sqrt(m_eff/k) of any two grains of the sample (or a grain and a wall), those on bonds included, s.
double shortest_contact_time(const Sample& sample);

/// Largest stable steps of the sample's integrator, from the stiffest and the most damped grain. A grain counts with its contacts now or with six of
/// grains like itself, whichever is more, so that a loose sample may be compacted.
StepBounds step_bounds(const Sample& sample);

/// Mass of the disk in record k by density, radius and thickness, kg.
double own_mass(const Sample& sample, std::size_t k);

/// Gives the disks their own masses, or even ones. Even: every grain is as heavy as makes its contacts as fast as those of the grain whose contacts
/// are fastest, k/m alike. The step stays stable, waves run through grains of unlike sizes as fast as it allows, and equilibria do not change,
/// for they do not know masses (but for weight: no gravity then). Dashpots follow the masses, so restitution is kept. Speeds stay.
void give_masses(Sample& sample, MassScaling mass_scaling);

/// Makes all grains heavier alike, where masses are not their own, until the sample allows its time step: many grains as fast as the fastest may
/// together be faster than it is alone.
void make_heavy_enough(Sample& sample);

}  // namespace arenite::dem
