#include "workflow/make_packing.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "grains/packing/bidisperse.hpp"
#include "grains/packing/fill.hpp"
#include "grains/packing/population.hpp"
#include "grains/packing/room.hpp"
#include "grains/packing/two_classes.hpp"
#include "io/sample/placed_grains.hpp"

namespace arenite::workflow {

namespace {

using Method = recipe::PackingParameters::Method;

/// Its sides, and along which axes it is periodic.
template <int D> void give_sides(Container<D>& domain, const recipe::ContainerParameters& container) {
  const double size[] = {container.width, container.height, container.depth};
  for (int axis = 0; axis < D; ++axis) {
    domain.periodic[axis] = container.periodic[axis];
    domain.wall[2 * axis].present = domain.wall[2 * axis + 1].present = !container.periodic[axis];
    domain.wall[2 * axis + 1].position = size[axis];
  }
}

template <int D> void give_boundaries(Vessel<D>& domain, const std::vector<BoundaryIn<D>>& boundaries) {
  domain.boundaries = boundaries;
  for (BoundaryIn<D>& boundary : domain.boundaries) boundary.centre = mean_point(boundary.points);
}

Domain container_of(const recipe::Recipe& recipe) {
  Domain domain;
  give_sides(domain, recipe.container);
  domain.thickness = recipe.container.thickness;
  give_boundaries(domain, recipe.boundaries);
  return domain;
}

/// The part of a container that is filled; the container itself unless a recipe names one.
template <class Whole> Whole area_of(const Whole& container, const std::optional<recipe::FillArea>& area) {
  Whole part = container;
  for (std::size_t side = 0; area && side < part.wall.size(); ++side)
    part.wall[side].position = area->edge[side].value_or(container.wall[side].position);
  return part;
}

std::string describe(const packing::RelaxReport& report) {
  return fmt::format(
      "relaxed in {} iterations, largest move {:.3g} mm, largest overlap left {:.2g} % of the mean radius of two "
      "grains",
      report.iterations, 1e3 * report.largest_move, 100 * report.overlap_after);
}

/// Throws InputError where grains that are no disks get no room to be put down.
void check_room(const Grains& grains, const packing::Circles& circles, const Domain& domain, bool size_is_given) {
  const auto room = packing::room_in(domain.area(), grains.radius, circles.own_radii());
  if (grains.shapes.empty() || room.suffices()) return;
  throw InputError(
      fmt::format("the circumscribed circles of the grains cover {:.3g} of {}; {} and let a loading stage compact it",
                  room.circles, size_is_given ? "the area that they fill" : "the container",
                  size_is_given ? fmt::format("give it {:.2f} times as much, or take fewer grains",
                                              std::ceil(100 * room.times_larger()) / 100)
                                : fmt::format("start from a packing.solid_fraction of {:.2f} or less",
                                              std::floor(100 * room.solid_fraction()) / 100)));
}

/// Throws InputError where a lattice is higher than what it fills, m.
void check_lattice(double filled, double room) {
  if (filled > room * (1 + 1e-12))
    throw InputError(fmt::format(
        "the lattice is {:g} mm high and the container only {:g} mm; raise container.height or leave it out",
        1e3 * filled, 1e3 * room));
}

std::string fill(const recipe::Recipe& recipe, Packing& packing) {
  auto& grains = packing.grains;
  packing.grains = packing::draw_grains(recipe.populations, recipe.materials, recipe.packing.grains, recipe.seed);
  double& height = packing.domain.wall[top].position;
  const bool height_given = recipe.container.height > 0, at_random = recipe.packing.method == Method::random;
  if (at_random && !height_given)
    height = packing::height_for(grains, recipe.container.width, recipe.packing.solid_fraction);
  const Domain part = area_of(packing.domain, recipe.packing.area);
  const packing::Circles circles(grains);
  if (at_random) {
    check_room(grains, circles, part, height_given || recipe.packing.area.has_value());
    return "random filling, " + describe(packing::fill_at_random(grains, part, recipe.seed));
  }
  const double filled = packing::fill_lattice(grains, part), room = part.height();
  if (!height_given) height = filled;
  else check_lattice(filled, room);
  return "triangular lattice";
}

std::string read(const recipe::Recipe& recipe, Packing& packing) {
  const auto path = recipe.beside(recipe.packing.file);
  std::vector<std::string> notes;
  packing.grains = io::read_placed_grains(path, recipe.materials, packing.domain, notes);
  const auto report = packing::relax(packing.grains, packing.domain, 1e-3);
  const std::string outcome =
      fmt::format("read from file with overlaps up to {:.2g} %, {}", 100 * report.overlap_before, describe(report));
  return notes.empty() ? outcome : outcome + ". " + list_of(notes, " ");
}

/// The classes get the materials that [bidisperse] names for them.
template <int D> std::string sample(const recipe::Recipe& recipe, PackingIn<D>& packing) {
  const recipe::BidisperseSection& classes = *recipe.bidisperse;
  const auto report = packing::sample_bidisperse(packing, classes.law, recipe.seed);
  const std::size_t material[] = {index_of(recipe.materials, classes.large), index_of(recipe.materials, classes.small)};
  for (auto& m : packing.grains.material) m = static_cast<std::int32_t>(material[m]);
  packing.materials = recipe.materials;
  const std::string left_out =
      report.left_out > 0 ? fmt::format(", {} small {} removed for this", report.left_out, packing::round_grains<D>)
                          : "";
  return fmt::format(
      "{} large and {} small {} sampled in two steps, mean radii {:.4g} and {:.4g} mm; theta {:.4g} (prescribed "
      "{:g}, error {:+.1g} %) with a gap of {:.3g} mm between large ones{}; solid fraction {:.3f}",
      report.large, report.small, packing::round_grains<D>, 1e3 * report.mean_large, 1e3 * report.mean_small,
      report.volume_ratio, classes.law.volume_ratio, 100 * report.volume_ratio_error, 1e3 * report.gap, left_out,
      report.solid_fraction);
}

}  // namespace

SphereResult make_sphere_packing(const recipe::Recipe& recipe) {
  SphereResult result;
  result.name = "packing";
  auto& snapshot = result.snapshots.emplace_back();
  snapshot.label = "start";
  PackingIn<3>& packing = snapshot.packing;
  packing.materials = recipe.materials;
  give_sides(packing.domain, recipe.container);
  give_boundaries(packing.domain, recipe.boundaries_in_space);
  if (recipe.packing.method == Method::poisson) {
    result.outcome = sample(recipe, packing);
    return result;
  }
  packing.grains = packing::draw_spheres(recipe.populations, recipe.materials, recipe.packing.grains, recipe.seed);
  double& height = packing.domain.wall[top].position;
  const bool height_given = recipe.container.height > 0;
  if (recipe.packing.method == Method::lattice) {
    const DomainIn<3> part = area_of(packing.domain, recipe.packing.area);
    const double filled = packing::fill_lattice(packing.grains, part);
    if (!height_given) height = filled;
    else check_lattice(filled, part.extent(1));
    result.outcome = "face-centred cubic lattice";
    return result;
  }
  if (!height_given)
    height = packing::height_for(packing.grains, recipe.container.width, recipe.container.depth,
                                 recipe.packing.solid_fraction);
  const DomainIn<3> part = area_of(packing.domain, recipe.packing.area);
  result.outcome = "random filling, " + describe(packing::fill_at_random<3>(packing.grains, part, recipe.seed));
  return result;
}

StageResult make_packing(const recipe::Recipe& recipe) {
  if (recipe.map) throw InputError("a recipe with [map] has no grains to pack; give one without it");
  StageResult result;
  result.name = "packing";
  Snapshot& snapshot = result.snapshots.emplace_back();
  snapshot.label = "start";
  snapshot.packing.materials = recipe.materials;
  snapshot.packing.domain = container_of(recipe);
  if (recipe.packing.method == Method::file) result.outcome = read(recipe, snapshot.packing);
  else if (recipe.packing.method == Method::poisson) result.outcome = sample(recipe, snapshot.packing);
  else result.outcome = fill(recipe, snapshot.packing);
  if (recipe.glued) packing::mark_region(snapshot.packing.grains, snapshot.packing.domain, *recipe.glued);
  return result;
}

}  // namespace arenite::workflow
