#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/film.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
struct FilmRecipe;
}

namespace arenite::workflow {

// A result is named by the hash of the keys of its recipe that differ from their defaults, under the names that keys
// had first: neither a key that comes later nor one that is renamed changes it. Version 0.1 took every key with its
// default; its results are not found any more.

/// Hash of all that the packing depends on, as version 0.1 named it: seeds of a study's runs follow from it, and other
/// seeds would be other samples.
std::string seed_key(const recipe::Recipe& recipe);

/// Hash of all that the stage at `place` (from 1) depends on when it begins with the grains of an engine, as this saves
/// them.
std::string stage_key(const recipe::Recipe& recipe, std::size_t place, const std::vector<std::uint8_t>& start);

/// Hash of all that a load depends on: the cemented sample and the load itself, but not its name's place among others.
std::string load_key(const recipe::Load& load, const std::string& cement_hash);

/// The keys of a map that differ from their defaults, one a line, but for the names of its files.
std::string map_keys(const recipe::MapSection& map);

/// The same for people, in a line without the names of files: dx = "25 um", labels = "watershed".
std::string told_map_keys(const recipe::MapSection& map);

/// Hash of all that the sample of a map depends on: the bytes of its files, and how they are read.
std::string map_key(const recipe::MapSection& map);

/// Hash of a film, of all files that its recipe names, and of the recipe: what the measured film's name is made of. A
/// film is hashed by what it says about itself and by the bytes of its file, or by its frames where they lie in several
/// files.
using KnownFilms = std::map<std::string, std::vector<std::string>>;  ///< hashes of what was read once, by file
std::string film_key(const std::filesystem::path& film, FilmSource& source, const recipe::FilmRecipe& recipe,
                     KnownFilms& known);

/// Hash of all that the film of a run depends on: the camera's recipe, and the states or the load that it films, by the
/// names of their results.
std::string virtual_film_key(const recipe::FilmRecipe& camera, const std::string& low, const std::string& high);

/// Whether what is loaded on a grid has a result of its own; in space it is part of each load's.
bool has_sample_apart(const recipe::Recipe& recipe);

/// One stage of a run: the packing, a loading, the cemented sample, or a load of it; or a film.
struct PlannedStage {
  std::string name, hash, file;  ///< file: its name in the run's folder
  bool field = false;            ///< cemented sample or load
  bool operator==(const PlannedStage&) const = default;
};

/// The stage at a place (from 1) of a run.
PlannedStage planned_stage(int place, std::string name, std::string hash, bool field);

/// All stages of a run in their order, packing first.
std::vector<PlannedStage> plan_of(const recipe::Recipe& recipe);

/// The recipe as far as stage `s` of the plan depends on it, and its title: what the stage's file carries, so that it
/// has the same bytes whichever of the runs that share it made it.
recipe::Recipe part_of(const recipe::Recipe& recipe, std::size_t s);

/// Changes when the same recipe gets other keys.
std::string key_versions();

}  // namespace arenite::workflow
