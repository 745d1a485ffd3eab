#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/result.hpp"

namespace arenite::io {

/// What a run needs to go on after it was killed: the engine's bytes, where the loading stands, and what is already
/// known of the stage. Blobs and numbers are named by who writes them.
struct Checkpoint {
  std::string key;                                         ///< hash of what the run depends on, as in Provenance
  std::map<std::string, std::vector<std::uint8_t>> blobs;  ///< e.g. "engine"
  std::map<std::string, double> numbers;
  std::map<std::string, std::int64_t> integers;
  StageResult partial;                                     ///< frames and history so far
};

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Nothing if there is no such file, or if it belongs to another key: then the run starts anew. A damaged one is an
/// InputError.
std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path, const std::string& key);

}  // namespace arenite::io
