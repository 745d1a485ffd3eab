#include "model/periodic_images.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace arenite {
namespace {

/// Images on either side along one axis that a reach covers.
int turns(double reach, double length, bool periodic) {
  constexpr double most = 1000;
  if (!periodic) return 0;
  if (!(reach < most * length))
    throw InputError(
        "grains are a thousand times larger than their periodic cell; correct the unit of the radii, or the cell");
  return 1 + static_cast<int>(reach / length);
}

}  // namespace

void PeriodicImages::add(Vec2 place, double r, std::int32_t disk) {
  centre.push_back(place);
  radius.push_back(r);
  of.push_back(disk);
}

std::vector<geometry::Pair> PeriodicImages::close_pairs(double gap) const {
  if (centre.empty()) return {};
  const auto box = geometry::bounds(centre);
  return geometry::close_pairs(
      centre, radius, {{box.x_min, box.y_min}, {std::max(box.width(), radius[0]), std::max(box.height(), radius[0])}},
      gap);
}

PeriodicImages images_of(std::span<const Vec2> centre, std::span<const double> radius, const Domain& d, double gap) {
  const double largest = radius.empty() ? 0 : *std::max_element(radius.begin(), radius.end());
  PeriodicImages images;
  for (std::size_t g = 0; g < centre.size(); ++g)
    images.add(d.wrapped(centre[g]), radius[g], static_cast<std::int32_t>(g));
  for (std::size_t g = 0; g < centre.size(); ++g) {
    const double reach = radius[g] + largest + gap;
    const int ny = turns(reach, d.height(), d.periodic[1]),
              nx = d.periodic[0] ? turns(reach, d.width(), true) + (d.tilt != 0 ? ny : 0) : 0;
    for (int iy = -ny; iy <= ny; ++iy)
      for (int ix = -nx; ix <= nx; ++ix) {
        const Vec2 p = images.centre[g] + d.way({ix, iy});
        if (d.is_near(p, reach) && (ix != 0 || iy != 0)) images.add(p, radius[g], static_cast<std::int32_t>(g));
      }
    if (images.centre.size() > 1'000'000 + 256 * centre.size())
      throw InputError(
          "grains or the gap are so wide compared with the periodic cell that each grain has hundreds of images; "
          "correct the unit of the radii, the gap or the cell");
  }
  return images;
}

std::vector<geometry::Pair> pairs_within(const Grains& grains, const Domain& domain, double gap) {
  const PeriodicImages images = images_of(grains, domain, gap);
  std::vector<geometry::Pair> pairs = images.close_pairs(gap);
  for (auto& [i, j] : pairs) {
    i = images.of[i];
    j = images.of[j];
    if (i > j) std::swap(i, j);
  }
  const auto key = [](const geometry::Pair& p) { return std::pair(p.i, p.j); };
  std::erase_if(pairs, [](const geometry::Pair& p) { return p.i == p.j; });
  std::ranges::sort(pairs, {}, key);
  const auto same = [&](const geometry::Pair& p, const geometry::Pair& q) { return key(p) == key(q); };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
  return pairs;
}

}  // namespace arenite
