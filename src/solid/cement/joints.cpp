#include "solid/cement/joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/bracketed_root.hpp"
#include "geometry/meniscus.hpp"

namespace arenite::cement {
namespace {

geometry::MeniscusDisks disks_of(const Packing& packing, geometry::Pair pair) {
  const Grains& g = packing.grains;
  const Vec2 d = packing.domain.nearest_image(g.centre(pair.j) - g.centre(pair.i));
  return {g.radius[pair.i], g.radius[pair.j], norm(d)};
}

/// A disk inside another has no meniscus.
bool can_hold(const geometry::MeniscusDisks& d) { return d.distance > std::abs(d.radius_i - d.radius_j); }

/// Curvature of the arcs that enclose `volume`, which lies between what the largest curvature and straight arcs enclose.
double curvature_of(const geometry::MeniscusDisks& d, double volume, double most) {
  // Curvature may be infinite at contact: x = c r / (1 + c r) runs from 0 to 1.
  const double r = std::min(d.radius_i, d.radius_j), largest = geometry::largest_meniscus_curvature(d);
  const double end = std::isinf(largest) ? 1 : largest * r / (1 + largest * r);
  const auto curvature = [&](double x) { return x < 1 ? x / ((1 - x) * r) : std::numeric_limits<double>::infinity(); };
  const auto excess = [&](double x) { return geometry::meniscus_area(d, curvature(x)) - volume; };
  return curvature(bracketed_root(excess, 0, most - volume, end, excess(end), 1e-15, 1e-14 * volume));
}

}  // namespace

std::vector<geometry::Pair> joined_pairs(const Packing& packing, double gap) {
  const Grains& g = packing.grains;
  const Domain& domain = packing.domain;
  if (g.size() == 0) return {};
  std::vector<double> x = g.x, y = g.y;
  const auto span = [&](std::vector<double>& v, bool periodic, double low, double length) {
    if (!periodic) {
      const auto [first, last] = std::minmax_element(v.begin(), v.end());
      return std::pair{*first, std::max(*last - *first, g.radius[0])};
    }
    for (double& p : v) p -= std::floor((p - low) / length) * length;
    return std::pair{low, length};
  };
  const auto [x0, width] = span(x, domain.periodic_x, domain.wall[left].position, domain.width());
  const auto [y0, height] = span(y, domain.periodic_y, domain.wall[bottom].position, domain.height());
  return geometry::close_pairs(x, y, g.radius, {x0, y0, width, height, domain.periodic_x, domain.periodic_y}, gap);
}

std::vector<Bridge> make_bridges(const Packing& packing, const std::vector<geometry::Pair>& pairs, double half_width) {
  std::vector<Bridge> bridges;
  bridges.reserve(pairs.size());
  const auto& r = packing.grains.radius;
  for (const auto [i, j] : pairs) bridges.push_back({i, j, half_width * r[i], half_width * r[j]});
  return bridges;
}

Menisci make_menisci(const Packing& packing, const std::vector<geometry::Pair>& pairs, double volume) {
  Menisci made;
  if (!(volume > 0)) return made;
  for (const auto pair : pairs) {
    const geometry::MeniscusDisks disks = disks_of(packing, pair);
    if (!can_hold(disks)) continue;
    const double least = geometry::meniscus_area(disks, geometry::largest_meniscus_curvature(disks));
    const double most = geometry::meniscus_area(disks, 0);
    if (volume <= least) {
      ++made.ruptured;
    } else if (volume >= most) {
      ++made.capped;
      made.menisci.push_back({pair.i, pair.j, std::numeric_limits<double>::infinity()});
    } else {
      made.menisci.push_back({pair.i, pair.j, 1 / curvature_of(disks, volume, most)});
    }
  }
  return made;
}

double largest_meniscus_volume(const Packing& packing, const std::vector<geometry::Pair>& pairs) {
  double largest = 0;
  for (const auto pair : pairs) {
    const geometry::MeniscusDisks disks = disks_of(packing, pair);
    if (can_hold(disks)) largest = std::max(largest, geometry::meniscus_area(disks, 0));
  }
  return largest;
}

}  // namespace arenite::cement
