#pragma once
#include "core/problems.hpp"
#include "io/sample/formats.hpp"

namespace arenite::io {

/// Finds the plane in which the centres lie, takes their centres there and the cell that the file states. No grains,
/// centres that fill space, and a cell that shifts its images out of the plane, are problems; a plane other than x-y,
/// and one that holds the centres to a part of a radius only, is told.
void lay_in_plane(RawGrains& grains, Problems& problems);

/// Puts the corner of a box whose place nobody gave: at the origin if all centres lie in it so, else around the grains.
/// A box smaller than the grains' extent is a problem unless it is periodic.
void place_box(RawGrains& grains, Problems& problems);

}  // namespace arenite::io
