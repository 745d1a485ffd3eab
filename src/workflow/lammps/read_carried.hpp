#pragma once
#include <filesystem>

#include "grains/dem/sample.hpp"
#include "grains/lammps/carried.hpp"

namespace arenite::workflow {

/// The state that LAMMPS left in a folder, of the sample it was given. Throws InputError for files that are cut off, or
/// of another sample.
template <int D> lammps::CarriedIn<D> read_carried(const std::filesystem::path& folder, const dem::SampleIn<D>& given);

}  // namespace arenite::workflow
