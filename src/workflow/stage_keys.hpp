#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "recipe/recipe.hpp"

namespace arenite::study {

/// Hash of all that the packing depends on: its part of the recipe, the seed, and the bytes of the file it is read from.
std::string packing_key(const Recipe& recipe);

/// Hash of all that stage `s` (0-based) depends on: the packing, laws, integration, the stages up to it.
/// What changes no bit (title, number of threads, kernel, later stages) is not in it.
std::string stage_key(const Recipe& recipe, std::size_t s, const std::string& packing_hash);

/// Hash of all that the cemented sample depends on: the last stage, the cement and the raster.
std::string cement_key(const Recipe& recipe, const std::string& last_stage_hash);

/// Hash of all that a load depends on: the cemented sample and the load itself, but not its name's place among others.
std::string load_key(const Load& load, const std::string& cement_hash);

/// One stage of a run: the packing, a loading, the cemented sample, or a load of it.
struct PlannedStage {
  std::string name, hash, file;        ///< file: its name in the run's folder
  bool field = false;                  ///< cemented sample or load
  std::string former{};                ///< what the file is called in folders of before
  bool operator==(const PlannedStage&) const = default;
};

/// The stage at a place (from 1) of a run.
PlannedStage planned_stage(int place, std::string name, std::string hash, bool field);

/// All stages of a run in their order, packing first.
std::vector<PlannedStage> plan_of(const Recipe& recipe);

/// The recipe as far as stage `s` of the plan depends on it, and its title: what the stage's file carries, so that it has the
/// same bytes whichever of the runs that share it made it.
Recipe part_of(const Recipe& recipe, std::size_t s);

/// Changes when the same recipe gets other keys.
std::string key_versions();

}  // namespace arenite::study
