#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "grains/dem/parameters.hpp"
#include "grains/dem/stage.hpp"
#include "grains/packing/bidisperse.hpp"
#include "grains/packing/population.hpp"
#include "model/measuring.hpp"
#include "model/packing.hpp"
#include "recipe/document.hpp"
#include "recipe/record.hpp"
#include "solid/cement/cement.hpp"
#include "solid/elements/options.hpp"
#include "solid/grid/cavities.hpp"
#include "solid/peridynamics/options.hpp"
#include "solid/stress/options.hpp"
#include "thermal/imaging/label_grains.hpp"

namespace arenite::recipe {

using packing::Population;
using packing::Region;
using packing::SizeLaw;

struct ContainerParameters {
  double width = 0;      ///< m
  double height = 0;     ///< m; 0: as packing.solid_fraction asks
  double thickness = 0;  ///< m
  std::array<bool, 2> periodic{};
  bool is_periodic(std::size_t side) const { return periodic[side / 2]; }
  bool operator==(const ContainerParameters&) const = default;
};

/// The part of the container that is filled, m; unset: up to its side.
struct FillArea {
  std::optional<double> left, right, bottom, top;
  bool operator==(const FillArea&) const = default;
};

struct PackingParameters {
  enum class Method { random, lattice, file, poisson };
  Method method = Method::random;
  std::int64_t grains = 0;  ///< total, where populations give ratios
  std::string file;         ///< CSV of centres, radii, materials
  std::optional<FillArea> area;
  double solid_fraction = 0.78;  ///< of the random filling; loading stages compact it further
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

/// The nodes that the cemented packing is brought to, and the rules of its pores.
struct GridSection {
  std::int64_t nodes = 1024;   ///< a side
  std::optional<double> crop;  ///< side of the square, m; if not given, 25.6 mean large radii, or what fits
  grid::CavityRules cavities;
  bool operator==(const GridSection&) const = default;
};

/// A phase map that loads act on in the place of a cemented packing: a picture, or a field of ours, which says all the
/// rest by itself.
struct MapSection {
  std::string file;
  std::string phases;                 ///< "0=void,85=particle,170=matrix"; empty: guessed of a picture of two values
  std::string labels = "components";  ///< a way to find grains, "none", or a picture whose values number them
  double smoothing = imaging::LabelOptions{}.smoothing;
  std::string crop;  ///< "X,Y,WIDTH,HEIGHT", pixels from the upper left
  std::optional<std::int64_t> slice, label_slice;
  std::string dataset, label_dataset;
  std::optional<double> dx;  ///< side of a pixel, m; if not given, lengths are in nodes
  bool has_label_file() const { return labels != "components" && labels != "watershed" && labels != "none"; }
  bool operator==(const MapSection&) const = default;
};

/// Moduli of the bonds, Pa; what is not given follows P Table I.
struct StiffnessSection {
  double matrix = 1e9;
  std::optional<double> interface, particle;  ///< E_i = E_m, E_p = 4 E_m
  bool calibrated = true;
  bool operator==(const StiffnessSection&) const = default;
  peridynamics::Stiffness resolved() const;
};

/// Poisson's ratio of elements; what is not given is as in the lattice, 1/3.
struct PoissonSection {
  double matrix = 1.0 / 3;
  std::optional<double> interface, particle;  ///< as the matrix
  bool operator==(const PoissonSection&) const = default;
};

/// Fracture toughness of the bonds, Pa m^0.5; what is not given follows P Table I.
struct ToughnessSection {
  double matrix = 1e5;
  std::optional<double> interface, particle;  ///< K_i = K_m, K_p = 3.5 K_m
  bool operator==(const ToughnessSection&) const = default;
  peridynamics::Toughness resolved() const;
};

/// Tensile strength of the bonds, Pa: none is given, or the matrix's with what follows from it.
struct StrengthSection {
  std::optional<double> matrix, interface, particle;
  bool operator==(const StrengthSection&) const = default;
  peridynamics::Strength resolved() const;
};

/// What joins the nodes of a sample, and how its field is found: bonds (peridynamics::Method), or elements.
enum class LoadMethod { peridynamics, elements, relaxation, damped };

/// One loading of the cemented sample.
struct Load : peridynamics::LoadCase, peridynamics::FieldChoices, peridynamics::FailureChoices {
  enum class Axis { y, x };
  Load() { max_strain = 0.1; }
  std::string name;
  Axis axis = Axis::y;
  bool moduli = false;   ///< load it along both axes and in shear, too
  bool failure = false;  ///< pull until it breaks
  LoadMethod method = LoadMethod::peridynamics;
  elements::Element element = elements::Element::wilson;
  elements::PlaneState plane = elements::PlaneState::stress;
  PoissonSection poisson;
  StiffnessSection stiffness;
  ToughnessSection toughness;
  StrengthSection strength;
  stress::StressOptions statistics;
  bool by_elements() const { return !failure && method == LoadMethod::elements; }
  peridynamics::Method bond_method() const;
  elements::Material material() const;
  bool operator==(const Load&) const = default;
};

/// What a recipe says, checked and in SI. The declaration of every key (name, unit, range, sentence) is in
/// recipe/keys*.cpp, or with the struct that it fills (`declare`); reading, checks, the resolved recipe and
/// docs/recipe.md follow from it.
struct Recipe {
  std::string title;
  std::uint64_t seed = 1;
  std::string source_file;           ///< as given; relative paths in the recipe start at its folder
  std::vector<std::string> notices;  ///< what the reader of the recipe found worth a word
  Materials materials;
  std::vector<Population> populations;
  ContainerParameters container;
  PackingParameters packing;
  dem::ContactParameters contact;
  dem::IntegrationParameters integration;
  std::optional<Region> glued;
  std::optional<dem::SkinParameters> membrane;  ///< of all sides that a stage makes membranes
  std::vector<Boundary> boundaries;             ///< name, points and closed; the rest is the stages' to say
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

/// Every key of a recipe: its name, unit, range and meaning, and what must hold between keys. The structs that come
/// from elsewhere declare their own.
void declare(ParameterVisitor& visitor, Recipe& recipe);
/// When keys of grains exist.
inline constexpr std::string_view no_map = "no [map]";
// Its parts. Where a part's keys must agree with others, it gets the recipe as far as it is known by then.
void declare(ParameterVisitor& visitor, Stage& stage, const Recipe& recipe);
void declare_boundaries(ParameterVisitor& visitor, Recipe& recipe);
/// What membranes are made of; of a stage whose keys have all been read, that its sides can be membranes.
void declare_membrane(ParameterVisitor& visitor, Recipe& recipe);
void require_membranes(ParameterVisitor& visitor, Stage& stage, const Recipe& recipe);
/// Of a stage, tables in time that drive it, which sides are open, how boundaries move, what is counted as having
/// passed, which grains come in and leave, and cycles of strain; and what boundaries ask of a stage whose keys have all
/// been read.
void declare_programmes(ParameterVisitor& visitor, Stage& stage, const Recipe& recipe);
void declare_openings(ParameterVisitor& visitor, Stage& stage, const Recipe& recipe);
void declare_exchange(ParameterVisitor& visitor, Stage& stage, const Recipe& recipe);
void declare_strain_cycles(ParameterVisitor& visitor, Stage& stage, const Recipe& recipe);
void require_boundary_loads(ParameterVisitor& visitor, const Stage& stage, const Recipe& recipe);
void require_usable_sides(ParameterVisitor& visitor, const Stage& stage, const ContainerParameters& container);
/// Cement and grid, and the loads on them or on a map: what comes after loading by discrete elements.
void declare_field(ParameterVisitor& visitor, Recipe& recipe);
void declare(ParameterVisitor& visitor, cement::CementParameters& law);
void declare(ParameterVisitor& visitor, MapSection& map);
void declare(ParameterVisitor& visitor, GridSection& grid);
/// Of a load all but its name, which must differ from others.
void declare(ParameterVisitor& visitor, Load& load);

/// The words that a recipe, a command line and Python share for a choice, in the order of its enumeration.
std::vector<Word> words(cement::CementParameters::Kind);
std::vector<Word> words(peridynamics::Loading);
std::vector<Word> words(peridynamics::LowerEdge);
std::vector<Word> words(LoadMethod);
std::vector<Word> words(elements::Element);
std::vector<Word> words(elements::PlaneState);
std::vector<Word> words(Load::Axis);
std::vector<Word> words(grid::Cavity);

/// The word for a value.
template <class Enum> std::string word_of(Enum value) {
  return std::string(words(value)[static_cast<std::size_t>(value)].word);
}

/// The value that a word stands for. Throws InputError, which calls the choice `what`, for a word that is not among
/// them.
template <class Enum> Enum chosen(std::string_view word, std::string_view what) {
  const auto known = words(Enum{});
  std::string list;
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (known[k].word == word) return static_cast<Enum>(k);
    list.append(k > 0 ? ", " : "").append(known[k].word);
  }
  throw InputError(std::string(what) + " \"" + std::string(word) + "\" is not known; there are " + list);
}

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
