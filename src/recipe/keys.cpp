#include "recipe/keys.hpp"

#include "recipe/recipe.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/units.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "recipe/keys/boundary_shapes.hpp"
#include "recipe/keys/membranes.hpp"
#include "recipe/keys/room.hpp"
#include "recipe/keys/space.hpp"
#include "recipe/keys/stages.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

namespace {

void declare(Visitor& v, Material& material) {
  v.number({"density", "Mass density.", true}, material.density, "kg/m^3", range::positive);
  v.number({"youngs_modulus", "Young's modulus E, for contact.normal = \"hertz_mindlin\"."}, material.youngs_modulus,
           "GPa", range::positive);
  v.number({"poisson", "Poisson's ratio nu, for contact.normal = \"hertz_mindlin\"."}, material.poisson, "",
           range::between(0, 0.5));
  const bool elastic = material.youngs_modulus && material.poisson;
  v.number_above_0(
      {"stiffness", "Contact stiffness k of two grains of this material; not needed if the normal law takes E and nu.",
       !elastic},
      material.stiffness, "kN/mm");
  v.number({"thermoelastic_factor", "Temperature rise per decrease of the sum of principal stresses; 0: not known."},
           material.thermoelastic_factor, "K/MPa", range::not_negative);
}

/// Names that stand in a column of a CSV.
bool is_label(const std::string& name) {
  return !name.empty() && std::none_of(name.begin(), name.end(), [](unsigned char c) {
    return c < ' ' || c == 127 || c == ',' || c == '"' || c == '\'' || c == ';';
  });
}

void require_known_material(Visitor& v, const Population& population, const Materials& materials) {
  const auto names = mapped(materials, &Material::name);
  const bool known = names.empty() || std::find(names.begin(), names.end(), population.material) != names.end();
  const std::string near = nearest(population.material, names);
  v.require(known, {"material"},
            fmt::format("there is no section [materials.{}]; {}", population.material,
                        near.empty() ? "add it" : fmt::format("did you mean \"{}\"?", near)));
}

void declare(Visitor& v, BidisperseSection& classes, const Materials& materials) {
  classes.law.declare(v);
  v.text({"large", "Material of the large grains, a section of [materials]."}, classes.large);
  v.text({"small", "Material of the small grains, another section of [materials]."}, classes.small);
  for (const auto& [key, name] : {std::pair{"large", classes.large}, {"small", classes.small}})
    v.require(materials.empty() || std::ranges::count(materials, name, &Material::name) > 0, {key},
              fmt::format(
                  "there is no section [materials.{0}]; add it, or name the material of {1} grains with bidisperse.{1}",
                  name, key));
  v.require(classes.large != classes.small, {"small", "large"},
            fmt::format(
                "both classes are made of \"{}\"; give each its own material, with the same numbers if they are alike",
                classes.small));
}

void require_grains(Visitor& v, const Recipe& recipe) {
  using Method = PackingParameters::Method;
  const auto& populations = recipe.populations;
  const bool from_file = recipe.packing.method == Method::file, sampled = recipe.packing.method == Method::poisson;
  v.require(from_file || sampled || !populations.empty(), {"populations", "packing"},
            "is missing; define the grains in [[populations]], or read them with packing.method = \"file\"");
  v.require(!sampled || populations.empty(), {"populations", "packing"},
            "the grains come from [bidisperse]; leave out [[populations]], or choose another packing.method");
  v.require(!from_file || populations.empty(), {"populations", "packing"},
            "the grains come from packing.file; leave out [[populations]], or choose another packing.method");
  v.require(!from_file || recipe.container.height > 0, {"container"},
            "grains from a file need a height; write height = \"... mm\"");
  const bool shares =
      std::any_of(populations.begin(), populations.end(), [](const auto& p) { return p.ratio.has_value(); });
  std::int64_t counted = 0;
  for (const auto& population : populations) counted += population.count.value_or(0);
  v.require(
      !shares || recipe.packing.grains > counted, {"packing", "populations"},
      recipe.packing.grains == 0
          ? "how many grains there are is missing; write packing.grains, or a count in each population"
          : fmt::format("populations with a ratio share packing.grains minus the {} counted grains; set it higher",
                        counted));
}

/// What only disks can be part of.
void require_movable_shapes(Visitor& v, const Recipe& recipe) {
  const bool disks = std::ranges::all_of(
      recipe.populations, [](const auto& p) { return std::holds_alternative<packing::DiskShape>(p.shape); });
  const bool rough = std::any_of(recipe.stages.begin(), recipe.stages.end(),
                                 [](const Stage& stage) { return stage.rough != ByAnySide<bool>{}; });
  v.require(
      disks || !recipe.has_field(), {"populations", "cement"},
      "grains other than disks cannot be cemented and loaded as a field; leave out [cement], [grid] and [[loads]]");
  v.require(disks || dem::integrator_of(recipe.integration.integrator).moves_bodies, {"populations", "integration"},
            "grains other than disks need integration.integrator = " + dem::integrators_of_bodies());
  v.require(disks || !recipe.contact.has_bonds(), {"populations", "contact"},
            "bonds join disks only; leave contact.bonds at \"none\"");
  v.require(disks || !recipe.contact.is_cohesive(), {"populations", "contact"},
            "cohesion is not implemented for grains other than disks; leave contact.cohesion at \"none\"");
  v.require(disks || !rough, {"populations", "stages"},
            "rough walls work with disks only; use smooth walls with friction for clumps and polygons");
}

void declare_materials(Visitor& v, Materials& materials) {
  v.sections({"materials", "Constitutive materials of the grains, by name.", true},
             {[&] { return materials.size(); }, [&](std::size_t n) { materials.resize(n); },
              [&](Visitor& inner, std::size_t i) {
                inner.require(is_label(materials[i].name), {},
                              "a material's name must not be empty or hold commas, quotes or control characters");
                declare(inner, materials[i]);
              },
              [&](std::size_t i) -> std::string& { return materials[i].name; }});
}

void require_constants(Visitor& v, const Recipe& recipe) {
  const bool by_moduli = recipe.contact.takes_moduli();
  for (const Material& m : recipe.materials) {
    if (by_moduli) {
      v.require(m.youngs_modulus && m.poisson, {"contact", "materials"},
                fmt::format("normal = \"{}\" needs E and nu; write youngs_modulus and poisson in [materials.{}]",
                            recipe.contact.normal.word(), m.name));
    } else {
      v.require(
          m.stiffness > 0, {"contact", "materials"},
          fmt::format("the normal law needs a stiffness; write it in [materials.{}], or use normal = \"{}\"", m.name,
                      dem::NormalLaw::word_where([]<class L>(const L&) { return dem::ElasticContact<L>; })));
    }
  }
}

/// Grains in space are spheres, which were once called disks as in the plane: such recipes are read, and keep the names
/// of their results.
void declare_shape(Visitor& v, Population& population, int dimension) {
  constexpr std::string_view disk = packing::DiskShape::word.word;
  const Key key{"shape",
                "Shape of the grains; the diameter of a grain that is not a disk is that of the disk of equal area. In "
                "space all are spheres."};
  if (dimension != 3) return v.member(key, population.shape);
  std::vector<Word> words{{"sphere", "a sphere", disk}};
  [&]<class... Shape>(const packing::GrainShapes<Shape...>&) { (words.push_back(Shape::word), ...); }(population.shape);
  int chosen = 0;
  v.choice(key, chosen, words);
  v.require(chosen <= 1, {key.name},
            "there are no clumps and no polygons in space; leave that out, or take dimension = 2");
}

}  // namespace

void declare(Visitor& v, Population& population, const Recipe& recipe) {
  v.text({"material", "Name of a section of [materials].", true}, population.material);
  require_known_material(v, population, recipe.materials);
  v.integer({"count", "Number of grains; 0 of a population that only an inflow brings."}, population.count,
            {0, 100'000'000});
  v.number(
      {"ratio",
       "Fraction by number of packing.grains, relative to the ratios of the other populations; the only population "
       "has them all."},
      population.ratio, "", range::positive);
  if (recipe.populations.size() == 1 && !population.count && !population.ratio) population.ratio = 1;
  v.require(population.count.has_value() != population.ratio.has_value(), {"ratio", "count"},
            "give either count or ratio");

  auto& size = population.size;
  auto* const fixed = std::get_if<packing::FixedSize>(&size);
  std::optional<double> diameter = fixed && fixed->diameter > 0 ? std::optional(fixed->diameter) : std::nullopt;
  v.number({"diameter", "Diameter of every grain; short for size = { law = \"fixed\", ... }."}, diameter, "mm",
           range::positive);
  if (diameter && fixed) fixed->diameter = *diameter;
  bool has_law = !fixed;
  v.section({"size", "Size law of the grains, if they are not all equal."}, has_law, [&](Visitor& inner) {
    inner.member({"law", "Distribution of the diameters.", true}, size);
  });
  v.require(diameter.has_value() != has_law, {"size", "diameter"}, "give either diameter or size");
  declare_shape(v, population, recipe.dimension);
  const double width = recipe.container.width, largest = std::visit([](const auto&law) { return law.largest(); }, size);
  v.require(width <= 0 || largest <= width, {"diameter", "size"},
            fmt::format("the largest grain ({}) is wider than the container ({})", format_quantity(largest, "mm"),
                        format_quantity(width, "mm")));
}

namespace {

/// Grains, what holds them, their laws and their stages.
void declare_grains(Visitor& v, Recipe& recipe) {
  recipe.packing.solid_fraction = recipe.packing.fraction_in(recipe.dimension);  // without the section, too
  v.section({"packing", "Initial packing of the grains in the container."},
            [&](Visitor& inner) { declare_packing(inner, recipe); });
  v.section({"container", "The box, or periodic cell, that holds the grains.", true, "frame"},
            [&](Visitor& inner) { declare_container(inner, recipe); });
  declare_materials(v, recipe.materials);
  const bool sampled = recipe.packing.method == PackingParameters::Method::poisson;
  v.when(sampled, "packing.method = \"poisson\"", [&](Visitor& outer) {
    outer.optional_section<BidisperseSection>(
        {"bidisperse", "Two size classes of disks in a square, of spheres in a cube, of their own.", sampled},
        recipe.bidisperse,
        [&](Visitor& inner, BidisperseSection& classes) { declare(inner, classes, recipe.materials); });
  });
  v.list<Population>({"populations", "Grains of one material and one size law."}, recipe.populations,
                     [&](Visitor& inner, Population& population) { declare(inner, population, recipe); });
  require_grains(v, recipe);
  v.section({"contact", "Forces between grains, and between grains and walls."},
            [&](Visitor& inner) { recipe.contact.declare(inner); });
  require_constants(v, recipe);
  v.section({"integration", "Newton's equations in time."}, [&](Visitor& inner) { recipe.integration.declare(inner); });
  v.optional_section<Region>({"glued", "Region in which grains are glued to each other."}, recipe.glued,
                             [&](Visitor& inner, Region& region) {
                               region.declare(inner);
                               inner.require(recipe.container.width <= 0 || region.centre.x <= recipe.container.width,
                                             {"x"}, "must lie inside the container");
                               inner.require(recipe.container.height <= 0 || region.centre.y <= recipe.container.height,
                                             {"y"}, "must lie inside the container");
                             });
  v.require(!recipe.glued || recipe.contact.adheres() || recipe.contact.has_bonds(), {"glued", "contact"},
            "there is nothing to glue with; set contact.adhesion and contact.surface_energy, or contact.bonds");
  declare_boundaries(v, recipe);
  declare_membrane(v, recipe);
  require_fill_area(v, recipe);
  v.list<Stage>({"stages", "Loading, stage after stage; each starts where the one before ended.", true}, recipe.stages,
                [&](Visitor& inner, Stage& stage) { declare(inner, stage, recipe); });
}

}  // namespace

void declare(Visitor& v, Recipe& recipe) {
  v.text({"title", "Title of reports, one line."}, recipe.title);
  v.integer({"seed", "Seed of all random numbers: the same seed gives the same sample."}, recipe.seed,
            {0, std::numeric_limits<std::int64_t>::max()});
  // Of the plane nothing is written, so that its recipes read as before.
  std::optional<std::int64_t> dimension = recipe.dimension == 2 ? std::nullopt : std::optional<std::int64_t>(3);
  v.integer({"dimension", "2 (unless given): disks in the plane; 3: spheres in space, whose container has a depth."},
            dimension, {2, 3});
  recipe.dimension = static_cast<int>(dimension.value_or(2));
  v.optional_section<MapSection>(
      {"map", "Phase map that is loaded in the place of grains: a recipe with it has loads, and no other sections."},
      recipe.map, [](Visitor& inner, MapSection& map) { declare(inner, map); });
  v.when(!recipe.map, no_map, [&](Visitor& of_grains) { declare_grains(of_grains, recipe); });
  declare_field(v, recipe);
  if (!recipe.map) require_movable_shapes(v, recipe);
  require_in_space(v, recipe);
  v.when(!recipe.map, no_map, [&](Visitor& of_grains) {
    of_grains.defaulted_section<Measuring>(
        {"measure", "How statistics of grains and contacts are measured at the end of every stage."}, recipe.measure,
        [](Visitor& inner, Measuring& measure) { declare(inner, measure); });
  });
}

}  // namespace arenite::recipe
