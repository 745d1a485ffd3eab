#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dem/parameters.hpp"
#include "dem/stage.hpp"
#include "model/material.hpp"
#include "packing/population.hpp"
#include "packing/region.hpp"

namespace arenite::study {

using packing::Population;
using packing::Region;
using packing::SizeLaw;

struct FrameParameters {
  double width = 0;                    ///< m
  double height = 0;                   ///< m; 0: as packing.solid_fraction asks
  double thickness = 0;                ///< m
  bool periodic_x = false, periodic_y = false;
  bool operator==(const FrameParameters&) const = default;
};

struct PackingParameters {
  enum class Method { random, lattice, file };
  Method method = Method::random;
  std::int64_t grains = 0;             ///< total, where populations give ratios
  std::string file;                    ///< CSV of centres, radii, materials
  double solid_fraction = 0.78;        ///< of the random filling; loading stages compact it further
  bool operator==(const PackingParameters&) const = default;
};

using dem::Cycles;
using dem::RestCriterion;
using dem::SideDrive;
using dem::Stage;

/// What a recipe says, checked and in SI. The declaration of every key (name, unit, range, sentence) is in
/// study/recipe_keys.cpp; reading, checks, the resolved recipe and docs/recipe.md follow from it.
struct Recipe {
  std::string title;
  std::uint64_t seed = 1;
  std::string source_file;             ///< as given; relative paths in the recipe start at its folder
  Materials materials;
  std::vector<Population> populations;
  FrameParameters frame;
  PackingParameters packing;
  dem::ContactParameters contact;
  dem::IntegrationParameters integration;
  std::optional<Region> glued;
  std::vector<Stage> stages;
  bool operator==(const Recipe&) const = default;
};

/// Reads a recipe from a file. `overrides` are "key=value" with dotted keys ("seed=7", "stages.0.bottom.force=60 kN"),
/// applied before anything is checked. Throws InputError with all problems found, each with its place.
Recipe read_recipe(const std::string& file, const std::vector<std::string>& overrides = {});

/// The same from text in memory; `file_name` is what problems are reported under. Files that the recipe names are not
/// looked for.
Recipe parse_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides = {});

/// The resolved recipe as TOML: every key that is set, defaults included, with units, in a fixed order. Reading it
/// back gives an equal recipe, but for what a recipe does not say (`source_file`, `integration.threads`).
std::string to_toml(const Recipe& recipe);

/// The same for people: sections and keys are explained, and keys at their default are there as comments.
std::string to_commented_toml(const Recipe& recipe);

/// Documentation of every key (Markdown), generated from the declarations.
std::string key_reference();

}  // namespace arenite::study
