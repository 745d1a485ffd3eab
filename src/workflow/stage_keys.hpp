#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "model/film.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
struct FilmRecipe;
}

namespace arenite::workflow {

/// What the names of results follow from: the keys of a recipe that differ from their defaults. Version 0.1 took every key with its
/// default; its names are known still, so that what it left is found. No key that came later may change those.
enum class Names { now, of_version_0_1 };

/// Hash of all that the packing depends on: its part of the recipe, the seed, and the bytes of the file it is read from.
std::string packing_key(const recipe::Recipe& recipe, Names names = Names::now);

/// Hash of all that a load depends on: the cemented sample and the load itself, but not its name's place among others.
std::string load_key(const recipe::Load& load, const std::string& cement_hash, Names names = Names::now);

/// Hash of a film, of all files that its recipe names, and of the recipe: what the measured film's name is made of. A film is
/// hashed by what it says about itself and by the bytes of its file, or by its frames where they lie in several files.
std::string film_key(const std::filesystem::path& film, FilmSource& source, const recipe::FilmRecipe& recipe, Names names = Names::now);

/// One stage of a run: the packing, a loading, the cemented sample, or a load of it; or a film.
struct PlannedStage {
  std::string name, hash, file;       ///< file: its name in the run's folder
  bool field = false;                 ///< cemented sample or load
  std::string former_hash{};          ///< by version 0.1
  std::vector<std::string> former{};  ///< names of its file by version 0.1 and before
  /// Whether a result with this hash is that of the stage.
  bool names(const std::string& of) const { return of == hash || (!former_hash.empty() && of == former_hash); }
  bool operator==(const PlannedStage& other) const { return name == other.name && hash == other.hash && file == other.file && field == other.field; }
};

/// The stage at a place (from 1) of a run.
PlannedStage planned_stage(int place, std::string name, std::string hash, bool field, std::string former_hash = {});

/// All stages of a run in their order, packing first.
std::vector<PlannedStage> plan_of(const recipe::Recipe& recipe);

/// The recipe as far as stage `s` of the plan depends on it, and its title: what the stage's file carries, so that it has the
/// same bytes whichever of the runs that share it made it.
recipe::Recipe part_of(const recipe::Recipe& recipe, std::size_t s);

/// Changes when the same recipe gets other keys.
std::string key_versions();

}  // namespace arenite::workflow
