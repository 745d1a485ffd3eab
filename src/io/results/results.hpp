#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/film_result.hpp"

namespace arenite::io {

/// Writes the result of a stage as one HDF5 file, all or nothing: the same result gives the same bytes. Arrays carry
/// their SI unit as the attribute "unit"; numbers have it in their name, "time [s]". What does not change while a
/// sample moves (ids, radii, materials, zones) is stored once. Groups: /provenance, /outcome, /materials, /grains,
/// /frames/0000/{grains,contacts,domain,energies,equilibrium}, /history, /texture, /continuation.
template <int D> void write_stage(const std::filesystem::path& path, const StageResultIn<D>& result);

/// Reads it back bit for bit. Throws InputError for a file that is missing, foreign, newer, cut short or damaged.
template <int D = 2> StageResultIn<D> read_stage(const std::filesystem::path& path);

/// Writes a result on a grid as one HDF5 file, all or nothing: the same result gives the same bytes. /map and /field
/// hold arrays of height x width nodes, the bottom row first; those of the field in single precision, with their SI
/// unit as the attribute "unit". Other groups: /provenance, /outcome, /packing, /cement, /convergence, /curve, /cracks,
/// /numbers.
void write_field(const std::filesystem::path& path, const FieldResult& result);

/// Reads it back. Throws InputError for a file that is missing, foreign, newer, cut short (DamagedFile) or damaged.
FieldResult read_field(const std::filesystem::path& path);

/// Writes what a film gave as one HDF5 file, all or nothing. /maps holds arrays of height x width pixels, the top row
/// first, in kelvin; /grains, /peak_to_peak and /forces arrays as long as the grains or contacts of /packing.
void write_film_result(const std::filesystem::path& path, const FilmResult& result);

/// Reads it back. Throws InputError for a file that is missing, foreign, newer, cut short (DamagedFile) or damaged.
FilmResult read_film_result(const std::filesystem::path& path);

/// Writes a sample in space as one HDF5 file, all or nothing. /map and /field hold arrays of depth x height x width
/// voxels, the lowest layer first; those of the field with their SI unit as the attribute "unit".
void write_voxels(const std::filesystem::path& path, const VoxelResult& result);

/// Reads it back. Throws InputError for a file that is missing, foreign, newer, cut short (DamagedFile) or damaged.
VoxelResult read_voxels(const std::filesystem::path& path);

/// A result of whichever kind its file says it is.
using AnyResult = std::variant<StageResult, FieldResult, FilmResult, VoxelResult, SphereResult>;
AnyResult read_result(const std::filesystem::path& path);

/// Writes a tree of numbers as one HDF5 file, all or nothing.
void write_numbers_file(const std::filesystem::path& path, const Numbers& numbers);

/// Reads it back; not known where there is none. InputError for what is damaged.
Numbers read_numbers_file(const std::filesystem::path& path);

/// What a run needs to go on after it was killed: the engine's bytes, where the loading stands, and what is already
/// known of the stage. Blobs and numbers are named by who writes them.
template <int D> struct CheckpointIn {
  std::string key;                                         ///< hash of what the run depends on, as in Provenance
  std::map<std::string, std::vector<std::uint8_t>> blobs;  ///< e.g. "engine"
  std::map<std::string, double> numbers;
  std::map<std::string, std::int64_t> integers;
  StageResultIn<D> partial;  ///< frames and history so far
};
using Checkpoint = CheckpointIn<2>;

template <int D> void write_checkpoint(const std::filesystem::path& path, const CheckpointIn<D>& checkpoint);

/// Nothing if there is no such file, or if it belongs to another key: then the run starts anew. A damaged one is an
/// InputError.
template <int D = 2>
std::optional<CheckpointIn<D>> read_checkpoint(const std::filesystem::path& path, const std::string& key);

}  // namespace arenite::io
