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

/// Calls `see` for every so many cells on of at most `most` along each axis, along x first.
template <int axis, int D, class See> void each_image(Cells<D> most, Cells<D>& cells, const See& see) {
  for (cells[axis] = -most[axis]; cells[axis] <= most[axis]; ++cells[axis])
    if constexpr (axis == 0) see(cells);
    else each_image<axis - 1>(most, cells, see);
}

}  // namespace

template <int D> void PeriodicImagesIn<D>::add(Vec<D> place, double r, std::int32_t grain) {
  centre.push_back(place);
  radius.push_back(r);
  of.push_back(grain);
}

template <int D> std::vector<geometry::Pair> PeriodicImagesIn<D>::close_pairs(double gap) const {
  if (centre.empty()) return {};
  auto box = geometry::around(std::span<const Vec<D>>(centre));
  for (int axis = 0; axis < D; ++axis) box.size[axis] = std::max(box.size[axis], radius[0]);
  return geometry::close_pairs<D>(centre, radius, box, gap);
}

template <int D>
PeriodicImagesIn<D> images_of(std::span<const Vec<D>> centre, std::span<const double> radius, const DomainIn<D>& d,
                              double gap) {
  const double largest = radius.empty() ? 0 : *std::max_element(radius.begin(), radius.end());
  PeriodicImagesIn<D> images;
  for (std::size_t g = 0; g < centre.size(); ++g)
    images.add(d.wrapped(centre[g]), radius[g], static_cast<std::int32_t>(g));
  for (std::size_t g = 0; g < centre.size(); ++g) {
    const double reach = radius[g] + largest + gap;
    auto most = by_axis<D>([&](int axis) { return turns(reach, d.extent(axis), d.periodic[axis]); });
    if (d.periodic[0] && d.tilt != 0) most.x += most.y;
    Cells<D> cells;
    each_image<D - 1>(most, cells, [&](const Cells<D>& on) {
      const Vec<D> p = images.centre[g] + d.way(on);
      if (on != Cells<D>{} && d.is_near(p, reach)) images.add(p, radius[g], static_cast<std::int32_t>(g));
    });
    if (images.centre.size() > 1'000'000 + 256 * centre.size())
      throw InputError(
          "grains or the gap are so wide compared with the periodic cell that each grain has hundreds of images; "
          "correct the unit of the radii, the gap or the cell");
  }
  return images;
}

template <int D>
std::vector<geometry::Pair> pairs_within(const GrainsIn<D>& grains, const std::type_identity_t<DomainIn<D>>& domain,
                                         double gap) {
  const PeriodicImagesIn<D> images = images_of(grains, domain, gap);
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

template struct PeriodicImagesIn<2>;
template struct PeriodicImagesIn<3>;
template PeriodicImagesIn<2> images_of<2>(std::span<const Vec2>, std::span<const double>, const Domain&, double);
template PeriodicImagesIn<3> images_of<3>(std::span<const Vec3>, std::span<const double>, const DomainIn<3>&, double);
template std::vector<geometry::Pair> pairs_within<2>(const Grains&, const Domain&, double);
template std::vector<geometry::Pair> pairs_within<3>(const GrainsIn<3>&, const DomainIn<3>&, double);

}  // namespace arenite
