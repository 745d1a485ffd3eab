#pragma once
#include "core/problems.hpp"
#include "io/raw_sample.hpp"
#include "io/sample.hpp"

namespace arenite::io {

/// Puts the corner of a box whose place nobody gave: at the origin if all centres lie in it so, else around the grains.
/// A box smaller than the grains' extent is a problem unless it is periodic.
void place_box(RawGrains& grains, Problems& problems);

/// Checks rows against each other and makes a packing of them: numbers of grains become indices, the file's forces on j
/// become the model's forces on i, arms halve the overlap. Throws InputError with the problems of both files.
void assemble(const RawGrains& grains, const RawContacts& contacts, const SampleOptions& options, Sample& sample,
              Problems& grain_problems, Problems& contact_problems);

}  // namespace arenite::io
