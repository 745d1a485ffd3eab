#pragma once
#include "core/problems.hpp"
#include "io/sample/formats.hpp"

namespace arenite::io {

/// Finds the plane in which the centres lie, or takes them as they lie in space, and takes the cell that the file
/// states. `dimension` 2 or 3 says which, 0 leaves it to the centres. No grains, centres that fill space where a plane
/// is wanted, and a cell that shifts its images as none of ours does, are problems; a plane other than x-y, and one
/// that holds the centres to a part of a radius only, is told.
void lay_out(RawGrains& grains, int dimension, Problems& problems);

/// Puts the corner of a box whose place nobody gave: at the origin if all centres lie in it so, else around the grains.
/// A box smaller than the grains' extent is a problem unless it is periodic.
void place_box(RawGrains& grains, Problems& problems);

/// The same of a box that the file states: one that does not hold the centres between its walls is a problem, and told
/// where they only lie beside it.
void check_stated_box(RawGrains& grains, Problems& problems);

}  // namespace arenite::io
