#include "recipe/keys/space.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

using Visitor = ParameterVisitor;

/// What a stage says that only a sample of the plane can do; empty where it says nothing of the kind.
std::string of_the_plane(const Stage& stage) {
  if (std::ranges::any_of(stage.side, &SideDrive::is_skin)) return "membranes";
  if (!stage.exchange.is_none()) return "inflows and outlets";
  return {};
}

/// What is cemented in space is kept with its loads.
void require_field(Visitor& v, const Recipe& recipe) {
  v.require(recipe.loads.empty() == !recipe.has_field(), {"cement", "grid"},
            "a cemented sample in space is kept with its loads; add [[loads]]");
  v.require(!recipe.grid || recipe.grid->cavities == grid::CavityRules{}, {"grid"},
            "single pores and voids are found in the plane alone; leave their rules out in space");
  for (const Load& load : recipe.loads)
    if (const std::string sentence = load.not_in_space(); !sentence.empty())
      v.require(false, {"loads"}, fmt::format("load \"{}\": {}", load.name, sentence));
}

}  // namespace

void require_in_space(Visitor& v, const Recipe& recipe) {
  if (recipe.dimension == 2) {
    const bool twists = recipe.contact.rolling.visit([](const auto& law) { return law.twisting > 0; });
    v.require(!twists, {"contact"}, "disks cannot twist; leave twisting_friction out, or take dimension = 3");
    return;
  }
  using Method = PackingParameters::Method;
  const auto refuse = [&](bool asked, std::initializer_list<std::string_view> keys, std::string_view what) {
    v.require(!asked, keys, fmt::format("{} in space; leave that out, or take dimension = 2", what));
  };
  const Method method = recipe.packing.method;
  refuse(method == Method::file, {"packing"}, "no packing is read from a file");
  v.require(!recipe.bidisperse || !(recipe.bidisperse->law.hold_radius || recipe.bidisperse->law.maximal),
            {"bidisperse"}, packing::of_disks_alone);
  v.require(method != Method::random || recipe.packing.solid_fraction <= 0.62, {"packing"},
            "spheres at random jam at a solid fraction of 0.64; start from 0.62 or less, and let a stage compact them");
  v.require(!std::holds_alternative<dem::CapillaryDisks>(recipe.contact.cohesion), {"contact"},
            "capillary_disks are bridges between disks; spheres take cohesion = \"capillary_spheres\"");
  refuse(recipe.glued.has_value(), {"glued"}, "no region can be glued by itself");
  refuse(recipe.membrane.has_value(), {"membrane"}, "there are no membranes");
  require_field(v, recipe);
  for (const Stage& stage : recipe.stages)
    if (const std::string what = of_the_plane(stage); !what.empty())
      v.require(false, {"stages"},
                fmt::format("stage \"{}\" asks for {}, which spheres do not have; leave that out, or take dimension = "
                            "2",
                            stage.name, what));
}

}  // namespace arenite::recipe
