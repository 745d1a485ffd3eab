#pragma once
#include <filesystem>

#include "model/result.hpp"

namespace arenite::io {

/// Writes the result of a stage as one HDF5 file, all or nothing: the same result gives the same bytes. Arrays carry
/// their SI unit as the attribute "unit"; numbers have it in their name, "time [s]". What does not change while a
/// sample moves (ids, radii, materials, zones) is stored once. Groups: /provenance, /outcome, /materials,
/// /grains, /frames/0000/{grains,contacts,domain,energies,equilibrium}, /history, /texture,
/// /continuation.
void write_stage(const std::filesystem::path& path, const StageResult& result);

/// Reads it back bit for bit. Throws InputError for a file that is missing, foreign, newer, cut short or damaged.
StageResult read_stage(const std::filesystem::path& path);

}  // namespace arenite::io
