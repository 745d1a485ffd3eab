#pragma once
#include <filesystem>

#include "model/field_result.hpp"

namespace arenite::io {

/// Writes a result on a raster as one HDF5 file, all or nothing: the same result gives the same bytes. /map and /field
/// hold arrays of height x width nodes, the bottom row first; those of the field in single precision, with their SI unit
/// as the attribute "unit". Other groups: /provenance, /outcome, /packing, /cement, /convergence, /curve, /cracks,
/// /numbers.
void write_field(const std::filesystem::path& path, const FieldResult& result);

/// Reads it back. Throws InputError for a file that is missing, foreign, newer, cut short (DamagedFile) or damaged.
FieldResult read_field(const std::filesystem::path& path);

}  // namespace arenite::io
