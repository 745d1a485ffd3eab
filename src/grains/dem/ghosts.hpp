#pragma once
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Makes the images of the disks near the right and the upper edge of a periodic cell; all others are the same pairs
/// seen from the other side. The images' records come behind those of the disks.
void make_ghosts(Sample& sample);

/// Copies the sources of ghosts to their images (positions and seen velocities).
void refresh_ghosts(Sample& sample);

}  // namespace arenite::dem
