#pragma once
#include <string>
#include <vector>

#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::study {

/// When the film itself says that the load is largest, against what the recipe tells, in cycles from -0.5 to 0.5. A swing
/// that heat does not blur is in phase with the load everywhere; of the two ends the film takes that at which pixels warm.
double phase_off(const LockinMaps& maps, double told_cycles);

/// Throws InputError for maps that cannot be those of a load as the recipe tells it: values that are no temperatures, swings
/// of kelvins, a phase that is off by an eighth of a cycle or more.
void refuse_impossible(const FilmRecipe& recipe, const LockinMaps& maps);

/// What the forces and the film say against what was told beside them, one sentence each with the likely causes: phase,
/// factors of the materials one against another, the scale of temperatures and forces against the load, and what the fit
/// leaves. Throws InputError where they have nothing to do with each other.
std::vector<std::string> film_doubts(const FilmRecipe& recipe, const FilmResult& result);

}  // namespace arenite::study
