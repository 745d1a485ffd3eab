#pragma once
#include "core/problems.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/sample.hpp"

namespace arenite::io {

/// Checks rows against each other and makes a packing of them: numbers of grains become indices, the file's forces on j
/// become the model's forces on i, arms halve the overlap or end at the contact point that the file gives. Rows without
/// a force whose surfaces are apart are no contacts. Throws InputError with the problems of both files.
void assemble(const RawGrains& grains, const RawContacts& contacts, const SampleOptions& options, Sample& sample,
              Problems& grain_problems, Problems& contact_problems);

}  // namespace arenite::io
