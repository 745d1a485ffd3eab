#include "thermal/inference/pixel_forces.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "model/periodic_images.hpp"
#include "thermal/inference/check_problem.hpp"
#include "thermal/inference/pixel_rounds.hpp"

namespace arenite::inference {
namespace {

void check_picture(const ThermoelasticPicture& p) {
  const auto size = static_cast<std::size_t>(std::max(0, p.width)) * static_cast<std::size_t>(std::max(0, p.height));
  if (size == 0 || p.value.size() != size || p.error.size() != size)
    throw InputError("the thermoelastic picture needs a value and an error for each of its pixels");
  if (!(p.pixel > 0)) throw InputError("the side of a pixel is not known; give it, e.g. \"1.60 mm\"");
}

Pixels seen_pixels(const ForceProblem& problem, Pixels pixels) {
  for (std::size_t g = 0; g < pixels.size(); ++g)
    if (!problem.is_seen(g)) pixels[g].clear();
  return pixels;
}

/// Throws InputError for contacts that no pixel of either grain sees.
void check_pixels(const ForceProblem& problem, const Pixels& pixels) {
  const Packing& packing = problem.packing;
  Problems problems;
  const Contacts& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto i = static_cast<std::size_t>(contacts.i[c]);
    const auto shows = [&](std::size_t g) { return !pixels[g].empty() || !problem.is_seen(g); };
    if (shows(i) || (!contacts.is_wall(c) && shows(static_cast<std::size_t>(contacts.j[c])))) continue;
    problems.add(
        "no pixel of the picture sees the contact of grain {} with {}; leave the contact out or lower the margins",
        packing.grains.id[i],
        contacts.is_wall(c) ? std::string("a wall")
                            : fmt::format("grain {}", packing.grains.id[static_cast<std::size_t>(contacts.j[c])]));
  }
  problems.raise();
}

Placed placed_grains(const ForceProblem& problem) {
  const Grains& grains = problem.packing.grains;
  Placed placed;
  placed.length = problem.packing.domain.thickness;
  placed.radius = grains.radius;
  placed.material = grains.material;
  placed.factor = mapped(grains.material, [&](std::int32_t m) { return problem.factor[static_cast<std::size_t>(m)]; });
  placed.centre = placed.found = grains.position;
  placed.touches = touches_of_grains(problem.packing, placed.centre);
  placed.force.assign(2 * problem.packing.contacts.size(), 0.0);
  return placed;
}

/// Grains whose rims are nearer than a pixel's spread reaches.
std::vector<std::vector<Near>> near_grains(const Packing& packing, double gap) {
  const Grains& grains = packing.grains;
  const Domain& d = packing.domain;
  std::vector<std::vector<Near>> near(grains.size());
  const auto add = [&](std::size_t i, std::size_t j) {
    const Vec2 apart = grains.position[i] - grains.position[j];
    near[i].push_back({j, apart - d.nearest_image(apart)});
  };
  for (const geometry::Pair& pair : pairs_within(grains, d, gap)) {
    add(static_cast<std::size_t>(pair.i), static_cast<std::size_t>(pair.j));
    add(static_cast<std::size_t>(pair.j), static_cast<std::size_t>(pair.i));
  }
  return near;
}

/// Mean force of a contact by the sum rule, from the grains' mean warming, N.
double typical_force(const Placed& placed, const Pixels& pixels) {
  double sum = 0, touches = 0;
  for (std::size_t g = 0; g < pixels.size(); ++g) {
    if (pixels[g].empty()) continue;
    sum +=
        std::numbers::pi * placed.radius[g] * placed.length * root_mean_square(pixels[g]) / std::abs(placed.factor[g]);
    touches += static_cast<double>(placed.touches[g].size());
  }
  return sum > 0 ? sum / touches : 1;
}

/// What the picture would show of these forces in all pixels whose centres are in grains that are seen.
std::vector<float> drawn(const ForceProblem& problem, const Placed& placed, const ThermoelasticPicture& picture,
                         const PointSpread& spread) {
  std::vector<float> fitted(picture.value.size(), std::numeric_limits<float>::quiet_NaN());
  const Pixels all = seen_pixels(problem, pixels_of_grains(picture, problem.packing, placed.touches, 0, 0));
  for (std::size_t g = 0; g < all.size(); ++g) {
    const std::vector<double> warming = warming_of_grain(placed, g, all[g], spread);
    for (std::size_t q = 0; q < all[g].size(); ++q) fitted[all[g][q].number] = static_cast<float>(warming[q]);
  }
  return fitted;
}

}  // namespace

InferredForces infer_from_pixels(const ForceProblem& problem, const ThermoelasticPicture& picture,
                                 const ForceOptions& options) {
  check_problem(problem, options, true);
  check_picture(picture);
  const Packing& packing = problem.packing;
  Placed placed = placed_grains(problem);
  const Pixels pixels = seen_pixels(
      problem, pixels_of_grains(picture, packing, placed.touches, options.rim_margin, options.contact_margin));
  check_pixels(problem, pixels);
  const PointSpread spread(picture.pixel, options.blur);
  placed.near = near_grains(packing, spread.reach);
  const double force = typical_force(placed, pixels);
  PixelRounds rounds(problem, options, pixels, spread, picture.pixel, std::move(placed), force, picture.common_error);
  InferredForces out = rounds.solved();
  out.fit.picture = drawn(problem, rounds.placed_by_material(), picture, spread);
  return out;
}

}  // namespace arenite::inference
