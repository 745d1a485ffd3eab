#pragma once
#include "grains/dem/engine.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Shortest contact time T_c = pi sqrt(m_eff/k) of any two grains of the sample (or a grain and a wall), s.
double shortest_contact_time(const Sample& sample);

/// Largest stable steps of the sample's integrator, from the stiffest and the most damped grain. A grain counts with
/// its contacts now or with six of grains like itself, whichever is more, so that a loose sample may be compacted.
StepBounds step_bounds(const Sample& sample);

}  // namespace arenite::dem
