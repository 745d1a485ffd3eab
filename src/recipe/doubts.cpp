#include "recipe/doubts.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace arenite::recipe {
namespace {

/// Whether the sample is compressed along an axis (0: x) while a load acts across.
bool is_biaxial(const Stage& stage, std::size_t axis) {
  const auto cycled = [&](std::size_t side) {
    return (stage.strain_cycles && stage.strain_cycles->of == static_cast<int>(side)) ||
           (stage.cycles && stage.cycles->side == static_cast<int>(side));
  };
  bool driven = false, loaded = false;
  for (std::size_t end = 0; end < 2; ++end) {
    const std::size_t along = 2 * axis + end, across = 2 * (1 - axis) + end;
    driven |= stage.side[along].kind == SideDrive::Kind::velocity || cycled(along);
    loaded |= stage.side[across].presses() && !cycled(across);
  }
  return driven && loaded;
}

/// Platens that rub carry shear: the sample's principal stresses turn, and the forces on its sides are not they.
void doubt_rubbing_platens(const Recipe& recipe, const Stage& stage, std::vector<std::string>& doubts) {
  const double mu = stage.friction.value_or(recipe.contact.wall_friction.value_or(recipe.contact.friction));
  const bool walls = !recipe.container.periodic[0] && !recipe.container.periodic[1];
  if (!walls || !(mu > 0) || !(is_biaxial(stage, 0) || is_biaxial(stage, 1))) return;
  doubts.push_back(fmt::format(
      "stages.{}: the walls rub (mu = {:g}) and carry a part of the load, which raises q/p; a biaxial test has smooth "
      "ones: contact.wall_friction = 0",
      stage.name, mu));
}

/// A stage without a duration ends at equilibrium.
void doubt_its_end(const Stage& stage, std::vector<std::string>& doubts) {
  if (stage.duration || stage.strain_cycles) return;
  if (stage.snapshots > 1)
    doubts.push_back(fmt::format(
        "stages.{}.snapshots: has no effect, because only a stage with a duration stores states on its way; give it "
        "one, or take increments",
        stage.name));
  if (stage.gravity && std::ranges::count(stage.open, true) > 0)
    doubts.push_back(
        fmt::format("stages.{}: grains that leave through the open side fall on, so that equilibrium may never be "
                    "reached; give the "
                    "stage a duration, for example duration = \"1 s\"",
                    stage.name));
  for (std::size_t side = 0; side < stage.side.size(); ++side)
    if (stage.side[side].presses() && !(stage.side[side].value > 0))
      doubts.push_back(
          fmt::format("stages.{}.{}: no sample comes to equilibrium under a load of 0; give a load above it, or the "
                      "stage a duration",
                      stage.name, any_side_names[side]));
}

}  // namespace

std::vector<std::string> doubts_of(const Recipe& recipe) {
  std::vector<std::string> doubts;
  for (const Stage& stage : recipe.stages) {
    doubt_rubbing_platens(recipe, stage, doubts);
    doubt_its_end(stage, doubts);
  }
  return doubts;
}

}  // namespace arenite::recipe
