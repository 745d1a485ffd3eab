#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
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

/// What a map would have to be read from, or be given with, for that key of it or of its load to have an effect, "a
/// table of spheres"; empty where it has one, or is refused with its reason.
std::string idle_without(std::string_view key, const recipe::MapSection& map);
/// Sentences on the keys of a map that are given, are not as they are otherwise, and have no effect on it.
std::vector<std::string> idle_keys(const recipe::MapSection& map);

/// Throws InputError for a load to failure of a map without a length: a crack needs one.
void require_length(const recipe::MapSection& map, const recipe::Load& load);
/// What is then thrown, with what would give the map its length; and the usual of that, with the side of a "pixel".
InputError crack_without_length(const std::string& mend);
std::string side_to_give(std::string_view of);

}  // namespace arenite::workflow
