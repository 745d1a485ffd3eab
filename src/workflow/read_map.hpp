#pragma once
#include <functional>
#include <string>

#include "model/phase_map.hpp"
#include "model/result.hpp"
#include "recipe/recipe.hpp"
#include "solid/grid/cavities.hpp"

namespace arenite::workflow {

/// A sample for apply_load from anybody's phase map: its phases, pores and voids as numbers, their volumes over the
/// mean area of a grain. Throws InputError unless the map is sound.
FieldResult sample_of_map(PhaseMap map, const grid::CavityRules& rules = {});

/// A phase map of a file; what is found worth a word is told.
PhaseMap read_map(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice);

/// The same from a file; its notes are told. Throws InputError for what cannot be read as a phase map.
FieldResult read_sample(const recipe::MapSection& map, const std::function<void(const std::string&)>& notice);

/// Throws InputError for a load to failure of a map without a length: a crack needs one.
void require_length(const recipe::MapSection& map, const recipe::Load& load);

}  // namespace arenite::workflow
