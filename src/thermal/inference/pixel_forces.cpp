#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "model/periodic_images.hpp"
#include "thermal/inference/pixel_equations.hpp"

namespace arenite::inference {
namespace {

void check_picture(const ThermoelasticPicture& p) {
  const auto size = static_cast<std::size_t>(std::max(0, p.width)) * static_cast<std::size_t>(std::max(0, p.height));
  if (size == 0 || p.value.size() != size || p.error.size() != size)
    throw InputError("the thermoelastic picture needs a value and an error for each of its pixels");
  if (!(p.pixel > 0)) throw InputError("the side of a pixel is not known; give it, e.g. \"1.60 mm\"");
}

/// Throws InputError for contacts that no pixel of either grain sees.
void check_pixels(const Packing& packing, const Pixels& pixels) {
  Problems problems;
  const Contacts& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto i = static_cast<std::size_t>(contacts.i[c]);
    if (!pixels[i].empty() || (!contacts.is_wall(c) && !pixels[static_cast<std::size_t>(contacts.j[c])].empty())) continue;
    problems.add("no pixel of the picture sees the contact of grain {} with {}; leave the contact out or lower the margins", packing.grains.id[i],
                 contacts.is_wall(c) ? std::string("a wall") : fmt::format("grain {}", packing.grains.id[static_cast<std::size_t>(contacts.j[c])]));
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
    sum += std::numbers::pi * placed.radius[g] * placed.length * root_mean_square(pixels[g]) / std::abs(placed.factor[g]);
    touches += static_cast<double>(placed.touches[g].size());
  }
  return sum > 0 ? sum / touches : 1;
}

/// Centres stay near where they were found.
void add_positions(ForceEquations& equations, const Placed& placed, double error) {
  const Unknowns& unknowns = equations.unknowns;
  if (unknowns.move <= 0) return;
  const double weight = unknowns.move * unknowns.move / (error * error);
  for (std::size_t g = 0; g < unknowns.grains; ++g) {
    const Vec2 back = (1 / unknowns.move) * (placed.found[g] - placed.centre[g]);
    equations.add_diagonal(unknowns.centre(g), weight, back.x);
    equations.add_diagonal(unknowns.centre(g) + 1, weight, back.y);
  }
}

/// Factors stay near what was given, as far as nothing else says: without a load only their ratio shows.
void add_factors(ForceEquations& equations, const std::vector<double>& scale) {
  constexpr double free = 3;
  const Unknowns& unknowns = equations.unknowns;
  for (std::size_t m = 0; m < unknowns.scales; ++m)
    equations.add_diagonal(unknowns.scale(m), 1 / (free * free * scale[m] * scale[m]), (1 - scale[m]) / scale[m]);
}

/// Takes over the solution.
void take(Placed& placed, std::vector<double>& scale, const Packing& packing, const Unknowns& unknowns, const std::vector<double>& x) {
  for (std::size_t k = 0; k < 2 * unknowns.contacts; ++k) placed.force[k] = unknowns.force * x[k];
  for (std::size_t m = 0; m < unknowns.scales; ++m) {
    // Half or double in one round at most: product of factor and force is far from linear beyond.
    const double times = std::clamp(1 + x[static_cast<std::size_t>(unknowns.scale(m))], 0.5, 2.0);
    scale[m] *= times;
    for (std::size_t g = 0; g < placed.factor.size(); ++g)
      if (static_cast<std::size_t>(placed.material[g]) == m) placed.factor[g] *= times;
  }
  if (unknowns.move <= 0) return;
  for (std::size_t g = 0; g < unknowns.grains; ++g) {
    const auto u = static_cast<std::size_t>(unknowns.centre(g));
    placed.centre[g] += unknowns.move * Vec2{x[u], x[u + 1]};
  }
  placed.touches = touches_of_grains(packing, placed.centre);
}

/// What the picture would show of these forces in all pixels whose centres are in grains.
std::vector<float> drawn(const Placed& placed, const Packing& packing, const ThermoelasticPicture& picture, const PointSpread& spread) {
  std::vector<float> fitted(picture.value.size(), std::numeric_limits<float>::quiet_NaN());
  const Pixels all = pixels_of_grains(picture, packing, placed.touches, 0, 0);
  for (std::size_t g = 0; g < all.size(); ++g) {
    const std::vector<double> warming = warming_of_grain(placed, g, all[g], spread);
    for (std::size_t q = 0; q < all[g].size(); ++q) fitted[all[g][q].number] = static_cast<float>(warming[q]);
  }
  return fitted;
}

}  // namespace

InferredForces infer_from_pixels(const ForceProblem& problem, const ThermoelasticPicture& picture, const ForceOptions& options) {
  check_problem(problem, options, true);
  check_picture(picture);
  const Packing& packing = problem.packing;
  Placed placed = placed_grains(problem);
  const Pixels pixels = pixels_of_grains(picture, packing, placed.touches, options.rim_margin, options.contact_margin);
  check_pixels(packing, pixels);
  const PointSpread spread(picture.pixel, options.blur);
  placed.near = near_grains(packing, spread.reach);
  Unknowns unknowns{packing.contacts.size(), packing.grains.size(), typical_force(placed, pixels), 0, 0};
  // Balance takes three of the forces' unknowns a grain.
  const double taken = std::max(0.0, 2.0 * static_cast<double>(unknowns.contacts) - 3.0 * static_cast<double>(unknowns.grains));
  double model_error = options.model_error;
  std::vector<double> scale(options.fit_factors ? problem.factor.size() : 0, 1.0);
  for (int iteration = 1;; ++iteration) {
    // Without forces centres are of no consequence: the first solution is of forces only.
    const double position_error = options.position_error * picture.pixel;
    unknowns.move = iteration > 1 ? position_error : 0;
    unknowns.scales = iteration > 1 ? scale.size() : 0;
    ForceEquations equations(packing, unknowns);
    const auto rows = add_pixels(equations, placed, pixels, spread, model_error, options.contact_margin * picture.pixel);
    equations.add_balance(placed.touches, placed.force, options.balance_error * unknowns.force);
    equations.add_walls(problem.walls);
    equations.add_energy(options.prior > 0 ? options.prior : 10);
    add_positions(equations, placed, position_error);
    add_factors(equations, scale);
    const std::vector<double> x = iteration == options.iterations ? equations.solution(options) : equations.solve();
    take(placed, scale, packing, unknowns, x);
    const Misfit left = misfit(rows, x, taken);
    if (iteration < options.iterations) {
      if (options.fit_model_error) model_error = std::max(1e-4, model_error * std::sqrt(left.weighed));
      continue;
    }
    InferredForces out = equations.finish(options, placed.touches, placed.force);
    out.residual = std::sqrt(left.weighed);
    out.fit.over_noise = std::sqrt(left.over_noise), out.fit.over_signal = left.over_signal, out.fit.model_error = model_error;
    for (std::size_t m = 0; m < scale.size(); ++m) out.fit.factor_scale_error[m] *= scale[m];
    out.fit.factor_scale = std::move(scale);
    out.fit.picture = drawn(placed, packing, picture, spread);
    return out;
  }
}

}  // namespace arenite::inference
