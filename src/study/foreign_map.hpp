#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "imaging/label_grains.hpp"
#include "io/phase_map_image.hpp"

namespace arenite::study {

/// Anybody's picture as a phase map with labelled grains.
struct ForeignMapOptions {
  io::PhaseMapOptions reading;
  imaging::LabelOptions labelling;  ///< where the picture brings no labels
};

struct LabelledMap {
  PhaseMap map;
  std::vector<std::string> notes;  ///< one sentence each: what was guessed, how grains were found
};

/// A file of Arenite's own gives its map as it is, to which nothing of `options` may be added. Throws InputError as
/// io::read_phase_map, io::read_field and imaging::label_grains do.
LabelledMap read_foreign_map(const std::filesystem::path& path, const ForeignMapOptions& options);

}  // namespace arenite::study
