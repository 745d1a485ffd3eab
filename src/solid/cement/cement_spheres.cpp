#include "solid/cement/cement_spheres.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/error.hpp"
#include "core/problems.hpp"
#include "geometry/close_pairs.hpp"
#include "geometry/rectangle.hpp"
#include "geometry/round_bridge.hpp"
#include "model/grain_classes.hpp"

namespace arenite::cement {
namespace {

double mean_radius(const SpherePack& pack) {
  return std::accumulate(pack.radius.begin(), pack.radius.end(), 0.0) / static_cast<double>(pack.size());
}

double gap_of(const SpherePack& pack, const CementParameters& parameters) {
  return parameters.gap.value_or(SampleLengths::gap_over_radius * mean_radius(pack));
}

/// Images of one sphere along one axis: those whose coordinate lies within `reach` of the box.
template <class Use> void along(const SpherePack& pack, Vec3 centre, int axis, double reach, const Use& use) {
  const double side = pack.high[axis] - pack.low[axis];
  for (int shift = -1; shift <= 1; ++shift) {
    Vec3 image = centre;
    image[axis] += shift * side;
    if (image[axis] >= pack.low[axis] - reach && image[axis] <= pack.high[axis] + reach) use(image);
  }
}

/// From the smaller sphere of a pair, whose radius says how wide it is.
void add_meniscus(const SpherePack& pack, std::size_t small, std::size_t large, const CementParameters& parameters,
                  SphereCement& cement) {
  const geometry::MeniscusDisks disks{pack.radius[small], pack.radius[large],
                                      norm(pack.centre[large] - pack.centre[small])};
  if (const auto shape = geometry::round_bridge(disks, parameters.contact_angle, parameters.width))
    cement.menisci.push_back({pack.centre[small], pack.centre[large], *shape});
}

}  // namespace

SpherePack with_images(const SpherePack& pack, double gap) {
  if (!pack.periodic) return pack;
  const double largest = *std::ranges::max_element(pack.radius);
  SpherePack all = pack;
  all.centre.clear();
  all.radius.clear();
  all.label.clear();
  for (std::size_t k = 0; k < pack.size(); ++k) {
    const double reach = pack.radius[k] + gap + 2 * largest;
    along(pack, pack.centre[k], 0, reach, [&](Vec3 x) {
      along(pack, x, 1, reach, [&](Vec3 y) {
        along(pack, y, 2, reach, [&](Vec3 z) {
          all.centre.push_back(z);
          all.radius.push_back(pack.radius[k]);
          all.label.push_back(pack.label[k]);
        });
      });
    });
  }
  return all;
}

SphereCement cement_spheres(const SpherePack& pack, const CementParameters& parameters) {
  using Kind = CementParameters::Kind;
  SphereCement cement;
  cement.full = parameters.kind == Kind::full;
  if (parameters.kind == Kind::coating) cement.coating = parameters.thickness;
  if (parameters.kind != Kind::bridges && parameters.kind != Kind::menisci) return cement;
  const double gap = gap_of(pack, parameters), share = parameters.width / (parameters.full_width ? 2 : 1);
  const SpherePack all = with_images(pack, gap);
  Vec3 low = all.centre.front(), high = low;
  for (const Vec3& centre : all.centre)
    for (int axis = 0; axis < 3; ++axis)
      low[axis] = std::min(low[axis], centre[axis]), high[axis] = std::max(high[axis], centre[axis]);
  const Vec3 trifle = 1e-9 * (pack.high - pack.low);
  const geometry::Box<3> box{low - trifle, high - low + 2 * trifle, {}};
  for (const auto [i, j] : geometry::close_pairs<3>(std::span(all.centre), std::span(all.radius), box, gap)) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    if (parameters.kind == Kind::menisci) {
      add_meniscus(all, all.radius[a] <= all.radius[b] ? a : b, all.radius[a] <= all.radius[b] ? b : a, parameters,
                   cement);
      continue;
    }
    cement.necks.push_back({all.centre[a], all.centre[b], share * all.radius[a], share * all.radius[b]});
  }
  return cement;
}

}  // namespace arenite::cement
