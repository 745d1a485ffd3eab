#include "recipe/keys/membranes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <variant>

#include "core/mapped.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/membranes/membranes.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

namespace {

bool has_membrane(const Stage& stage) { return std::ranges::any_of(stage.side, &SideDrive::is_skin); }

bool has_polygons(const Recipe& recipe) {
  return std::ranges::any_of(recipe.populations, [](const Population& population) {
    return std::visit([]<class Shape>(const Shape&) { return std::is_base_of_v<packing::PolygonShape, Shape>; },
                      population.shape);
  });
}

/// A membrane goes from one wall to the one across from it, and nothing else is done with its side.
void require_membrane(Visitor& v, std::size_t side, const Stage& stage, const Recipe& recipe) {
  const char* name = side_names[side];
  const std::size_t low = 2 * (1 - side / 2);
  for (const std::size_t platen : {low, low + 1}) {
    v.require(!stage.side[platen].is_skin(), {name},
              fmt::format("a membrane is held by two walls, and the {} side is a membrane itself; give that one a "
                          "pressure",
                          side_names[platen]));
    v.require(
        !stage.open[platen], {name, "open"},
        fmt::format("a membrane is held by two walls, and the {} one is open; leave that out", side_names[platen]));
  }
  v.require(stage.slide[side] == 0 && !stage.rough[side], {name, "slide", "rough"},
            "a membrane neither slides nor is rough; leave that out, or give this side a pressure instead");
  const auto names = mapped(recipe.boundaries, &Boundary::name);
  const std::string own = dem::membrane_name(static_cast<int>(side));
  v.require(std::ranges::count(names, own) == 0, {name},
            fmt::format("one of the [[boundaries]] is called \"{}\", as the membrane would be; rename it", own));
}

/// No side that has become a membrane is a wall later.
void require_membranes_to_stay(Visitor& v, const Stage& stage, const Recipe& recipe) {
  for (const Stage& earlier : recipe.stages) {
    if (&earlier == &stage) return;
    for (std::size_t side = 0; side < 4; ++side)
      v.require(
          !earlier.side[side].is_skin() || stage.side[side].is_skin(), {side_names[side], "name"},
          fmt::format("the {0} side is a membrane from stage \"{1}\" on and cannot become a wall again; write {0} "
                      "= {{ membrane = \"... kPa\" }} here, too",
                      side_names[side], earlier.name));
  }
}

}  // namespace

void declare_membrane(Visitor& v, Recipe& recipe) {
  v.optional_section<dem::SkinParameters>(
      {"membrane", "Skin of the sides that a stage makes membranes, as in left = { membrane = \"100 kPa\" }."},
      recipe.membrane, [](Visitor& inner, dem::SkinParameters& skin) { skin.declare(inner); });
}

void require_membranes(Visitor& v, Stage& stage, const Recipe& recipe) {
  require_membranes_to_stay(v, stage, recipe);
  if (!has_membrane(stage)) return;
  stage.skin = recipe.membrane.value_or(dem::SkinParameters{});
  const auto first = std::ranges::find_if(stage.side, &SideDrive::is_skin) - stage.side.begin();
  const char* name = side_names[static_cast<std::size_t>(first)];
  v.require(!recipe.container.periodic[0] && !recipe.container.periodic[1], {name},
            "a membrane needs a container with four walls; set container.periodic_x = false and periodic_y = false");
  v.require(dem::integrator_of(recipe.integration.integrator).moves_bodies, {name},
            "membranes need integration.integrator = " + dem::integrators_of_bodies());
  v.require(
      stage.exchange.is_none(), {name, "inflow", "outlets"},
      "grains neither come in nor leave between membranes; leave inflow and outlets out, or give this side a pressure");
  v.require(!has_polygons(recipe), {name},
            "the nodes of a membrane would cut into polygons; take disks or clumps, or give this side a pressure");
  for (std::size_t side = 0; side < 4; ++side)
    if (stage.side[side].is_skin()) require_membrane(v, side, stage, recipe);
}

}  // namespace arenite::recipe
