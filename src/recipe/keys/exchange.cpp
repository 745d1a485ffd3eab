#include "recipe/keys/exchange.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "recipe/recipe.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

namespace {

/// An area lies in the container, as far as that is known before it is filled.
void require_within(Visitor& v, const dem::Area& area, const ContainerParameters& container,
                    std::initializer_list<std::string_view> keys) {
  const auto within = [](const std::optional<double>& edge, double size) {
    return !edge || (*edge >= 0 && (size <= 0 || *edge <= size * (1 + 1e-12)));
  };
  v.require(within(area.left, container.width) && within(area.right, container.width) &&
                within(area.bottom, container.height) && within(area.top, container.height),
            keys, "must lie in the container, for grains beyond it would never come in");
}

/// The populations that an inflow draws from.
std::vector<Population> drawn_from(const Recipe& recipe, const std::string& material) {
  std::vector<Population> chosen;
  for (const Population& population : recipe.populations)
    if (material.empty() || population.material == material) chosen.push_back(population);
  return chosen;
}

void require_disks(Visitor& v, const Stage& stage, const Recipe& recipe) {
  const bool disks = std::ranges::all_of(
      recipe.populations, [](const auto& p) { return std::holds_alternative<packing::DiskShape>(p.shape); });
  const std::initializer_list<std::string_view> keys = {"inflow", "outlets"};
  v.require(
      disks, keys,
      "grains other than disks cannot come in or leave; leave shape out of the populations, or inflow and outlets out");
  v.require(!recipe.contact.has_bonds(), keys, "bonded grains cannot come in or leave; set contact.bonds = \"none\"");
  v.require(!stage.glue, keys, "glued grains cannot come in or leave; leave glue out");
  v.require(stage.rough == ByAnySide<bool>{}, keys, "grains cannot come in or leave where a rough wall holds some");
  v.require(stage.mass_scaling == dem::MassScaling::none, keys,
            "grains come in with their own masses; leave mass_scaling at \"none\"");
  v.require(!recipe.contact.is_cohesive() || stage.exchange.inflow.empty(), keys,
            "grains that cohere cannot be added; leave inflow out, or set contact.cohesion = \"none\"");
}

}  // namespace

void declare_exchange(Visitor& v, Stage& stage, const Recipe& recipe) {
  dem::Exchange& exchange = stage.exchange;
  v.list<dem::Inflow>(
      {"inflow",
       "Areas in which grains come in during this stage, drawn from the populations, at places without overlap. An "
       "area without an edge goes to the container's side; one without width or height is a line on which centres lie. "
       "Grains that find no room come later: the history counts them as `waiting`."},
      exchange.inflow, [&](Visitor& inner, dem::Inflow& inflow) {
        inflow.declare(inner);
        inflow.of = drawn_from(recipe, inflow.material);
        require_within(inner, inflow.area, recipe.container, {"top", "bottom", "left", "right"});
        inner.require(!inflow.of.empty(), {"material", "rate", "mass_rate"},
                      inflow.material.empty() ? "there are no [[populations]] that grains could be drawn from"
                                              : fmt::format("no population is of \"{}\"", inflow.material));
      });
  v.list<dem::Outlet>(
      {"outlets",
       "Areas in which grains are removed during this stage, or put back elsewhere: those whose centre lies there. An "
       "area without an edge goes on for ever."},
      exchange.outlets, [&](Visitor& inner, dem::Outlet& outlet) {
        outlet.declare(inner);
        if (outlet.recycle_to) require_within(inner, *outlet.recycle_to, recipe.container, {"recycle_to"});
      });
  if (exchange.is_none()) return;
  exchange.seed = recipe.seed;
  require_disks(v, stage, recipe);
  v.require(stage.duration.has_value(), {"duration", "inflow", "outlets"},
            "a stage in which grains come in or leave needs a duration, for example duration = \"1 s\"");
  v.require(!stage.count_below || exchange.outlets.empty(), {"count_below", "outlets"},
            "outlets count the grains that leave, as `removed`; leave count_below out");
}

}  // namespace arenite::recipe
