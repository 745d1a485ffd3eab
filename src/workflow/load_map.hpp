#pragma once
#include <filesystem>
#include <string>

#include "model/field_result.hpp"
#include "solid/raster/cavities.hpp"
#include "recipe/recipe.hpp"

namespace arenite::study {

/// A sample for apply_load from anybody's phase map: its phases, pores and voids as numbers, their volumes over the mean
/// area of a grain. Throws InputError unless the map is sound.
FieldResult sample_of_map(PhaseMap map, const raster::CavityRules& rules = {});

/// Says in the sample's numbers that its lengths are in nodes, where nobody said how large a node is.
void count_lengths_in_nodes(FieldResult& sample);

/// Name and provenance for a load of a map that no recipe made: `source` is the file, `asked` the options in words.
void sign(FieldResult& result, const std::filesystem::path& source, const std::string& asked, const Load& load);

}  // namespace arenite::study
