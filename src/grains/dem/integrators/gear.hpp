#pragma once
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Between steps the sample holds the predicted state at t_n and the forces there. One fused sweep corrects it and
/// predicts t_{n+1}; walls and affine motion too. False if the contact list has become stale.
bool gear_sweep(Sample& sample, const Team& team);

/// Starting values: third to fifth derivatives from forces at the Taylor continuation of the present state half a step
/// and a step ahead and back, three times over. A grain whose contacts change within that span starts with zeros.
/// Expects corrected positions and velocities; leaves forces and springs as of now.
void gear_start(Sample& sample);

}  // namespace arenite::dem
