#pragma once
#include "core/problems.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/sample.hpp"

namespace arenite::io {

/// Checks rows against each other and makes a packing of them: numbers of grains become indices, the file's forces on j
/// become the model's forces on i, arms halve the overlap or end at the contact point that the file gives. Rows without
/// a force whose surfaces are apart are no contacts. `laid` is the one of the grains. Throws InputError with the
/// problems of both files.
template <int D>
void assemble(const RawGrains& grains, const Laid<D>& laid, const RawContacts& contacts, const SampleOptions& options,
              SampleIn<D>& sample, Problems& grain_problems, Problems& contact_problems);

}  // namespace arenite::io
