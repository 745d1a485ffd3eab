#include "grains/packing/region.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace arenite::packing {

namespace {

bool lies_inside(Vec2 from_centre, const Region& region) {
  if (region.shape == Region::Shape::circle) return dot(from_centre, from_centre) <= region.radius * region.radius;
  return std::abs(from_centre.x) <= region.width / 2 && std::abs(from_centre.y) <= region.height / 2;
}

}  // namespace

std::int64_t mark_region(Grains& grains, const Domain& domain, const Region& region) {
  const Vec2 centre{domain.wall[left].position + region.x, domain.wall[bottom].position + region.y};
  std::vector<Vec2> d(grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i) d[i] = domain.nearest_image(grains.centre(i) - centre);
  std::fill(grains.zone.begin(), grains.zone.end(), std::uint8_t{0});
  if (region.count) {
    std::vector<std::size_t> nearest(grains.size());
    std::iota(nearest.begin(), nearest.end(), std::size_t{0});
    std::stable_sort(nearest.begin(), nearest.end(), [&](auto a, auto b) { return dot(d[a], d[a]) < dot(d[b], d[b]); });
    const auto n = std::min<std::size_t>(nearest.size(), static_cast<std::size_t>(std::max<std::int64_t>(0, *region.count)));
    for (std::size_t k = 0; k < n; ++k) grains.zone[nearest[k]] = 1;
  } else {
    for (std::size_t i = 0; i < grains.size(); ++i) grains.zone[i] = lies_inside(d[i], region) ? 1 : 0;
  }
  return std::count(grains.zone.begin(), grains.zone.end(), std::uint8_t{1});
}

}  // namespace arenite::packing
