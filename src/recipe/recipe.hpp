#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.hpp"
#include "grains/dem/parameters.hpp"
#include "grains/dem/stage.hpp"
#include "grains/packing/bidisperse.hpp"
#include "grains/packing/population.hpp"
#include "model/measuring.hpp"
#include "model/packing.hpp"
#include "recipe/document.hpp"
#include "recipe/keys.hpp"
#include "recipe/loads.hpp"
#include "recipe/map_section.hpp"
#include "recipe/record.hpp"
#include "solid/cement/cement.hpp"

namespace arenite::recipe {

using packing::Population;
using packing::Region;
using packing::SizeLaw;

struct ContainerParameters {
  double width = 0;      ///< m
  double height = 0;     ///< m; 0: as packing.solid_fraction asks
  double thickness = 0;  ///< m, of disks
  double depth = 0;      ///< m, of a container in space
  std::array<bool, 3> periodic{};
  bool is_periodic(std::size_t side) const { return periodic[side / 2]; }
  bool operator==(const ContainerParameters&) const = default;
};

/// The part of the container that is filled, m; unset: up to its side.
struct FillArea {
  ByAnySide<std::optional<double>> edge;
  bool operator==(const FillArea&) const = default;
};

struct PackingParameters {
  enum class Method { random, lattice, file, poisson };
  Method method = Method::random;
  std::int64_t grains = 0;  ///< total, where populations give ratios
  std::string file;         ///< CSV of centres, radii, materials
  std::optional<FillArea> area;
  static constexpr double usual_fraction = 0.78, usual_in_space = 0.5;
  double solid_fraction = usual_fraction;  ///< of the random filling; loading stages compact it further
  /// The usual one of disks is beyond any packing of spheres, and stands for theirs.
  double fraction_in(int dimension) const {
    return dimension == 3 && solid_fraction == usual_fraction ? usual_in_space : solid_fraction;
  }
  bool operator==(const PackingParameters&) const = default;
};

using dem::Cycles;
using dem::EquilibriumCriterion;
using dem::SideDrive;
using dem::Stage;

/// Two size classes for packing.method = "poisson", and the materials that they are made of.
struct BidisperseSection {
  packing::BidisperseParameters law;
  std::string large = "large", small = "small";
  bool operator==(const BidisperseSection&) const = default;
};

/// What a recipe says, checked and in SI. The declaration of every key (name, unit, range, sentence) is in
/// recipe/keys.cpp and recipe/keys/, or with the struct that it fills (`declare`); reading, checks, the resolved recipe
/// and docs/recipe.md follow from it.
struct Recipe {
  std::string title;
  std::uint64_t seed = 1;
  int dimension = 2;                 ///< 3: of spheres
  std::string source_file;           ///< as given; relative paths in the recipe start at its folder
  std::vector<std::string> notices;  ///< what the reader of the recipe found worth a word
  Materials materials;
  std::vector<Population> populations;
  ContainerParameters container;
  PackingParameters packing;
  dem::ContactParameters contact;
  dem::IntegrationParameters integration;
  std::optional<Region> glued;
  std::optional<dem::SkinParameters> membrane;     ///< of all sides that a stage makes membranes
  std::vector<Boundary> boundaries;                ///< name, points and closed; the rest is the stages' to say
  std::vector<BoundaryIn<3>> boundaries_in_space;  ///< name, points and corners
  std::vector<Stage> stages;
  std::optional<BidisperseSection> bidisperse;
  std::optional<cement::CementParameters> cement;  ///< the binding matrix of the packing at the end of its stages
  std::optional<GridSection> grid;
  std::vector<Load> loads;
  std::optional<MapSection> map;  ///< instead of grains, their container and their stages
  std::optional<Measuring> measure;
  /// The sections, or what stands for them where they are not given: no cement, and P's grid.
  cement::CementParameters cement_or_none() const;
  GridSection grid_or_default() const { return grid.value_or(GridSection{}); }
  bool has_field() const { return cement || grid || map || !loads.empty(); }  ///< goes on to nodes and loads
  std::filesystem::path beside(const std::string& file) const {
    return std::filesystem::path(source_file).parent_path() / file;
  }                               ///< that it names
  MapSection map_beside() const;  ///< its map, with its files as they are opened
  bool operator==(const Recipe&) const = default;
};

/// Reads a recipe from a file. `overrides` are "key=value" with dotted keys ("seed=7", "stages.0.bottom.force=60 kN"),
/// applied before anything is checked. Throws InputError with all problems found, each with its place.
Recipe read_recipe(const std::string& file, const std::vector<std::string>& overrides = {});

struct Node;
/// The same from a tree that was read already (recipe/document.hpp) and has no [sweep]; `file` is what problems are
/// reported under, and files that the recipe names are looked for beside it.
Recipe recipe_from(const Node& root, const std::string& file);

/// The same from text in memory; `file_name` is what problems are reported under. Files that the recipe names are not
/// looked for.
Recipe parse_recipe(std::string_view text, const std::string& file_name,
                    const std::vector<std::string>& overrides = {});

/// The resolved recipe as TOML: every key that is set, defaults included, with units, in a fixed order. Reading it
/// back gives an equal recipe, but for what a recipe does not say (`source_file`, `integration.threads`).
std::string to_toml(const Recipe& recipe);

/// The keys that differ from their defaults, one a line with its path, under their names of version 0.1: what the names
/// of results follow from.
std::string changed_keys(const Recipe& recipe);

/// The resolved recipe of a packing, without stages and loads, as version 0.1 wrote it: what seeds of a study's runs
/// follow from.
std::string to_toml_of_version_0_1(const Recipe& recipe);

/// As to_toml for people: sections and keys are explained, and keys at their default are there as comments.
std::string to_commented_toml(const Recipe& recipe);

/// The title that a recipe's text gives, whether or not the rest is a whole recipe; empty if it gives none.
std::string title_in(const std::string& text);

/// Documentation of every key (Markdown), generated from the declarations.
std::string key_reference();

/// A recipe to start from, as `arenite init` writes it: src/recipe/templates, compiled in.
struct RecipeTemplate {
  const char *name, *sentence;
  std::string_view text;
  bool explained = false;  ///< written with every key that it leaves at its default, and what each means; else as it is
  Recipe make() const { return parse_recipe(text, {}); }
};

/// All of packings; a new one is one row.
const std::vector<RecipeTemplate>& recipe_templates();

/// A small recipe with a [sweep], for `arenite study run`.
std::string study_template();

/// Every key of a recipe of a simulation.
const RecordTable& recipe_keys();

}  // namespace arenite::recipe
