#include "recipe/doubts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

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

/// Forces come in steps, each to equilibrium, in stages that end there; in those that last a time states are stored on
/// the way instead.
void doubt_its_steps(const Stage& stage, std::vector<std::string>& doubts) {
  const bool has_force = std::ranges::count(stage.side, SideDrive::Kind::force, &SideDrive::kind) > 0;
  const bool is_cycled = stage.strain_cycles.has_value(), is_timed = is_cycled || stage.duration;
  if (stage.snapshots > 1 && !stage.duration)
    doubts.push_back(
        fmt::format("stages.{}.snapshots: has no effect, because {}", stage.name,
                    is_cycled ? "strain cycles store states by their store_every; take that"
                              : fmt::format("only a stage with a duration stores states on its way; give it one{}",
                                            has_force ? ", or take increments" : "")));
  if (stage.increments > 1 && (is_timed || !has_force))
    doubts.push_back(fmt::format("stages.{}.increments: has no effect, because {}; leave it out{}", stage.name,
                                 is_timed ? "forces act in full at once in a stage that does not end at equilibrium"
                                          : "no side is under a force, and pressures act in full at once",
                                 is_cycled  ? ""
                                 : is_timed ? ", or store states on the way by snapshots"
                                            : ", or write the load as a force"));
  if (is_timed && stage.equilibrium != EquilibriumCriterion{})
    doubts.push_back(
        fmt::format("stages.{}.equilibrium: does not end this stage, which lasts {}; it only judges whether the last "
                    "state is at rest",
                    stage.name, is_cycled ? "as long as its cycles" : "its duration"));
}

/// A stage without a duration ends at equilibrium.
void doubt_its_end(const Stage& stage, std::vector<std::string>& doubts) {
  if (stage.duration || stage.strain_cycles) return;
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

/// A rough wall that slides takes the grains that it holds with it, as far as the next wall.
void doubt_its_sliding_walls(const Recipe& recipe, const Stage& stage, std::vector<std::string>& doubts) {
  for (std::size_t side = 0; side < stage.slide.size(); ++side) {
    const std::size_t way = axis_of(static_cast<int>(side)) == 0 ? 1 : 0;
    if (stage.slide[side] == 0 || !stage.rough[side] || recipe.container.periodic[way]) continue;
    const std::size_t ahead = 2 * way + (stage.slide[side] > 0 ? 1 : 0);
    if (stage.open[ahead]) continue;
    doubts.push_back(fmt::format(
        "stages.{}: the rough {} wall slides and carries its grains into the {} one; set container.periodic_{} = true",
        stage.name, any_side_names[side], any_side_names[ahead], "xy"[way]));
  }
}

/// Keys that another one makes idle.
void doubt_idle_keys(const Recipe& recipe, std::vector<std::string>& doubts) {
  const auto doubt = [&](bool idle, std::string_view key, std::string_view why) {
    if (idle) doubts.push_back(fmt::format("{}: has no effect, because {}", key, why));
  };
  const Recipe usual;
  const dem::ContactParameters &contact = recipe.contact, &as_ever = usual.contact;
  const double fraction = PackingParameters{}.fraction_in(recipe.dimension);
  const bool shares = std::ranges::any_of(recipe.populations, [](const Population& p) { return p.ratio.has_value(); });
  doubt(recipe.packing.grains > 0 && !shares, "packing.grains",
        "every population has its count; leave it out, or give a population a ratio instead");
  doubt(recipe.packing.method == PackingParameters::Method::random && recipe.container.height > 0 &&
            recipe.packing.solid_fraction != fraction,
        "packing.solid_fraction", "container.height says how high the box is; leave out one of the two");
  doubt(contact.normal_damping && contact.restitution != as_ever.restitution, "contact.restitution",
        "contact.normal_damping is given; leave out one of the two");
  doubt(recipe.integration.time_step && recipe.integration.safety != usual.integration.safety, "integration.safety",
        "integration.time_step is given; leave out one of the two");
  const bool has_skin = std::ranges::any_of(
      recipe.stages, [](const Stage& stage) { return std::ranges::any_of(stage.side, &SideDrive::is_skin); });
  doubt(recipe.membrane && !has_skin, "membrane",
        "no stage makes a side one; write for example left = { membrane = \"100 kPa\" } there, or leave the section "
        "out");
  doubt(recipe.map && recipe.map->labels != "watershed" && recipe.map->smoothing != MapSection{}.smoothing,
        "map.smoothing", "only labels = \"watershed\" cuts grains at necks; take that, or leave this key out");
  for (const Load& load : recipe.loads)
    for (const std::string& sentence : load.idle_keys())
      doubts.push_back(fmt::format("loads.{}.{}", load.name, sentence));
  if (contact.adheres()) return;
  constexpr std::string_view no_adhesion = "contact.adhesion is \"none\"; choose one, or leave this key out";
  doubt(contact.surface_energy > 0, "contact.surface_energy", no_adhesion);
  doubt(contact.effective_radius != as_ever.effective_radius, "contact.effective_radius", no_adhesion);
  doubt(contact.friction_cap != as_ever.friction_cap, "contact.friction_cap", no_adhesion);
  doubt(!contact.glued_pairs.empty() && !contact.has_bonds(), "contact.glued_pairs",
        "there is nothing to glue with; choose contact.adhesion or contact.bonds, or leave this key out");
}

bool is_driven(const Recipe& recipe, const std::string& boundary) {
  return std::ranges::any_of(recipe.stages, [&](const Stage& stage) {
    return std::ranges::count(stage.boundaries, boundary, &dem::BoundaryMotion::name) > 0 ||
           std::ranges::count(stage.boundaries_in_space, boundary, &dem::BoundaryMotionIn<3>::name) > 0 ||
           std::ranges::count(stage.programmes, boundary, &dem::Programme::name) > 0;
  });
}

/// A boundary that stands further from the box than that is wide or high is met by no grain: a slip of a unit.
template <int D>
void doubt_far_boundaries(const Recipe& recipe, const std::vector<BoundaryIn<D>>& boundaries,
                          std::vector<std::string>& doubts) {
  const double size[] = {recipe.container.width, recipe.container.height, recipe.container.depth};
  const double reach = std::max({size[0], size[1], size[2]});
  for (const BoundaryIn<D>& boundary : boundaries) {
    double apart = 0;
    for (int axis = 0; axis < D; ++axis) {
      const auto along = [axis](const Vec<D>& point) { return point[axis]; };
      if (boundary.points.empty() || !(size[axis] > 0)) continue;
      const auto [low, high] = std::ranges::minmax(boundary.points, {}, along);
      apart = std::max({apart, along(low) - size[axis], -along(high)});
    }
    if (apart > reach && !is_driven(recipe, boundary.name))
      doubts.push_back(fmt::format(
          "boundaries: \"{}\" stands {:.3g} mm outside of the container, where it meets no grain; check the units of "
          "its points",
          boundary.name, 1e3 * apart));
  }
}

}  // namespace

std::vector<std::string> doubts_of(const Recipe& recipe) {
  std::vector<std::string> doubts;
  doubt_idle_keys(recipe, doubts);
  doubt_far_boundaries<2>(recipe, recipe.boundaries, doubts);
  doubt_far_boundaries<3>(recipe, recipe.boundaries_in_space, doubts);
  for (const Stage& stage : recipe.stages) {
    doubt_rubbing_platens(recipe, stage, doubts);
    doubt_its_steps(stage, doubts);
    doubt_its_end(stage, doubts);
    doubt_its_sliding_walls(recipe, stage, doubts);
  }
  return doubts;
}

}  // namespace arenite::recipe
