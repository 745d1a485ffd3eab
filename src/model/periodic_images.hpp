#pragma once
#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/close_pairs.hpp"
#include "geometry/rectangle.hpp"
#include "model/packing.hpp"

namespace arenite {

/// What holds a sample as a rectangle.
inline geometry::Rectangle box_of(const Domain& d) {
  return {d.wall[left].position, d.wall[right].position, d.wall[bottom].position, d.wall[top].position};
}

/// One periodic image: so many widths and heights away, and by how much that moves a point, m.
struct ImageShift {
  int columns = 0, rows = 0;
  Vec2 shift;
};

/// Calls `visit` for every image of a cell (the cell itself among them) in which something that fills `extent` overlaps
/// `window`. Rows of a tilted cell are moved along x by `Domain::tilt` each (Lees-Edwards). Where nothing is periodic
/// that is at most the thing itself.
template <class Visit>
void for_each_image(const Domain& domain, const geometry::Rectangle& extent, const geometry::Rectangle& window,
                    Visit&& visit) {
  const auto range = [](double low, double high, double period, bool periodic) {
    if (periodic)
      return std::pair{static_cast<int>(std::ceil(low / period)), static_cast<int>(std::floor(high / period))};
    return std::pair{0, low <= 0 && high >= 0 ? 0 : -1};
  };
  const auto [row0, row1] =
      range(window.y_min - extent.y_max, window.y_max - extent.y_min, domain.height(), domain.periodic[1]);
  for (int row = row0; row <= row1; ++row) {
    const double along = row * domain.tilt;
    const auto [column0, column1] = range(window.x_min - extent.x_max - along, window.x_max - extent.x_min - along,
                                          domain.width(), domain.periodic[0]);
    for (int column = column0; column <= column1; ++column)
      visit(ImageShift{column, row, {column * domain.width() + along, row * domain.height()}});
  }
}

/// Disks or spheres in their cell, followed by those of their periodic images that can be within a gap of one in it.
template <int D> struct PeriodicImagesIn {
  std::vector<Vec<D>> centre;    ///< m
  std::vector<double> radius;    ///< m
  std::vector<std::int32_t> of;  ///< the disk or sphere

  void add(Vec<D> centre, double r, std::int32_t grain);
  /// All pairs of them and their images with a surface gap of at most this, m.
  std::vector<geometry::Pair> close_pairs(double gap) const;
};
using PeriodicImages = PeriodicImagesIn<2>;

/// `gap`: the widest that is asked about, m. Throws InputError for grains far larger than the cell.
template <int D>
PeriodicImagesIn<D> images_of(std::span<const Vec<D>> centre, std::span<const double> radius, const DomainIn<D>& domain,
                              double gap);
inline PeriodicImages images_of(const std::vector<Vec2>& centre, std::span<const double> radius, const Domain& domain,
                                double gap) {
  return images_of<2>(std::span(centre), radius, domain, gap);
}
template <int D>
PeriodicImagesIn<D> images_of(const GrainsIn<D>& grains, const std::type_identity_t<DomainIn<D>>& domain, double gap) {
  return images_of<D>(std::span<const Vec<D>>(grains.position), grains.radius, domain, gap);
}

/// Every pair of grains whose surface gap (nearest image, sheared cells too) is at most `gap`, m, by (i, j), i < j.
template <int D>
std::vector<geometry::Pair> pairs_within(const GrainsIn<D>& grains, const std::type_identity_t<DomainIn<D>>& domain,
                                         double gap);

}  // namespace arenite
