#include "grains/fields/nonaffine.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/problems.hpp"
#include "model/matching.hpp"
#include "model/periodic_images.hpp"
#include "statistics/estimate.hpp"

namespace arenite::fields {
namespace {

using statistics::unknown;

constexpr Tensor2 no_tensor{unknown, unknown, unknown, unknown};

Vec2 times(const Tensor2& a, Vec2 b) { return {a.xx * b.x + a.xy * b.y, a.yx * b.x + a.yy * b.y}; }

/// What the cell makes of a vector between two states: x stretched by the width, y by the height, and sheared by what
/// the tilt gained. Along sides that are not periodic nothing is known and nothing needed: there no image is chosen.
Tensor2 cell_motion(const Domain& before, const Domain& after) {
  const double wider = before.periodic[0] ? after.width() / before.width() : 1;
  if (!before.periodic[1]) return {wider, 0, 0, 1};
  return {wider, (after.tilt - wider * before.tilt) / before.height(), 0, after.height() / before.height()};
}

/// Where the grains are in the state after; -1 of those that left.
std::vector<std::int32_t> matched(const Packing& before, const Packing& after) {
  const std::vector<std::int32_t> places = places_in(after.grains, before.grains);
  if (before.grains.size() > 0 && std::ranges::all_of(places, [](std::int32_t place) { return place < 0; }))
    throw refusal("states of {} and {} grains have no grain in common; compare states of the same grains",
                  before.grains.size(), after.grains.size());
  if (before.domain.periodic[0] != after.domain.periodic[0] || before.domain.periodic[1] != after.domain.periodic[1])
    throw InputError("one state is periodic along a side where the other has walls; compare states of one sample");
  return places;
}

struct Neighbour {
  std::size_t grain = 0;
  Vec2 separation;  // from the grain to its neighbour's image, before
};

/// Of every grain, near images included.
std::vector<std::vector<Neighbour>> neighbours_within(const Packing& packing, double range) {
  const std::size_t n = packing.grains.size();
  const PeriodicImages images =
      images_of(packing.grains.position, std::vector<double>(n, range / 2), packing.domain, 0);
  std::vector<std::vector<Neighbour>> list(n);
  for (const auto [first, second] : images.close_pairs(0)) {
    const auto a = static_cast<std::size_t>(first), b = static_cast<std::size_t>(second);
    const auto of_a = static_cast<std::size_t>(images.of[a]), of_b = static_cast<std::size_t>(images.of[b]);
    if (of_a == of_b) continue;  // a grain and its own image say what the cell did, not what its neighbours did
    const Vec2 separation = images.centre[b] - images.centre[a];
    if (a < n) list[a].push_back({of_b, separation});
    if (b < n) list[b].push_back({of_a, -separation});
  }
  return list;
}

/// The gradient F that maps vectors `from` to `to` with the least sum of squares: F = (sum to (x) from)(sum from (x)
/// from)^-1.
Tensor2 best_gradient(std::span<const Vec2> from, std::span<const Vec2> to) {
  Tensor2 x, y;
  for (std::size_t k = 0; k < from.size(); ++k) {
    x += outer(to[k], from[k]);
    y += outer(from[k], from[k]);
  }
  const double determinant = y.xx * y.yy - y.xy * y.yx, size = trace(y);
  if (from.size() < 3 || !(determinant > 1e-12 * size * size)) return no_tensor;
  const Tensor2 inverse{y.yy / determinant, -y.xy / determinant, -y.yx / determinant, y.xx / determinant};
  return {x.xx * inverse.xx + x.xy * inverse.yx, x.xx * inverse.xy + x.xy * inverse.yy,
          x.yx * inverse.xx + x.yy * inverse.yx, x.yx * inverse.xy + x.yy * inverse.yy};
}

}  // namespace

LocalDeformation local_deformation(const Packing& before, const Packing& after, double range) {
  const std::vector<std::int32_t> places = matched(before, after);
  if (!(range > 0)) throw refusal("neighbours within {:g} m; give a positive length", range);
  const Tensor2 motion = cell_motion(before.domain, after.domain);
  const auto list = neighbours_within(before, range);
  const std::size_t n = before.grains.size();
  LocalDeformation out{std::vector<std::int32_t>(n), std::vector<Tensor2>(n, no_tensor),
                       std::vector<double>(n, unknown), std::vector<double>(n, unknown)};
  std::vector<Vec2> from, to;
  for (std::size_t g = 0; g < n; ++g) {
    from.clear();
    to.clear();
    for (const Neighbour& k : list[g]) {
      if (places[g] < 0 || places[k.grain] < 0) continue;
      const Vec2 carried = times(motion, k.separation);
      from.push_back(k.separation);
      to.push_back(carried +
                   after.domain.nearest_image(after.grains.position[static_cast<std::size_t>(places[k.grain])] -
                                              after.grains.position[static_cast<std::size_t>(places[g])] - carried));
    }
    out.neighbours[g] = static_cast<std::int32_t>(from.size());
    const Tensor2 f = best_gradient(from, to);
    if (std::isnan(f.xx)) continue;
    out.strain[g] = {f.xx - 1, (f.xy + f.yx) / 2, (f.xy + f.yx) / 2, f.yy - 1};
    out.rotation[g] = (f.yx - f.xy) / 2;
    double sum = 0;
    for (std::size_t k = 0; k < from.size(); ++k) {
      const Vec2 rest = to[k] - times(f, from[k]);
      sum += dot(rest, rest);
    }
    out.d2min[g] = sum / static_cast<double>(from.size());
  }
  return out;
}

AffineFit affine_fit(const Packing& before, const Packing& after) {
  const std::vector<std::int32_t> places = matched(before, after);
  const Tensor2 motion = cell_motion(before.domain, after.domain);
  std::vector<Vec2> from, to;
  std::vector<std::size_t> both;
  for (std::size_t g = 0; g < before.grains.size(); ++g) {
    if (places[g] < 0) continue;
    both.push_back(g);
    const Vec2 now = after.grains.position[static_cast<std::size_t>(places[g])];
    from.push_back(before.grains.position[g]);
    // Carried along by the cell and by the first grain: the images are those nearest to that.
    const Vec2 start = to.empty() ? now : to.front(), carried = start + times(motion, from.back() - from.front());
    to.push_back(carried + after.domain.nearest_image(now - carried));
  }
  const Vec2 middle = mean_point(from), middle_after = mean_point(to);
  for (Vec2& p : from) p = p - middle;
  for (Vec2& p : to) p = p - middle_after;

  AffineFit fit;
  fit.gradient = best_gradient(from, to);
  fit.shift = middle_after - times(fit.gradient, middle);
  double sum = 0;
  fit.residual.assign(before.grains.size(), {unknown, unknown});
  for (std::size_t k = 0; k < from.size(); ++k) {
    const Vec2 residual = fit.residual[both[k]] = to[k] - times(fit.gradient, from[k]);
    sum += dot(residual, residual);
  }
  fit.fluctuation = from.empty() ? unknown : std::sqrt(sum / static_cast<double>(from.size()));
  return fit;
}

}  // namespace arenite::fields
