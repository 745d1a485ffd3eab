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

/// Of those images of a cell that are so many cells on along higher axes: along this axis and those below.
template <int axis, int D, class Visit>
void images_along(const Container<D>& domain, const Vec<D>& least, const Vec<D>& most, Cells<D>& cells,
                  const Visit& visit) {
  const double along = axis == 0 ? cells.y * domain.tilt : 0, period = domain.extent(axis);
  const double low = least[axis] - along, high = most[axis] - along;
  std::int32_t first = 0, last = low <= 0 && high >= 0 ? 0 : -1;
  if (domain.periodic[axis]) {
    first = static_cast<std::int32_t>(std::ceil(low / period));
    last = static_cast<std::int32_t>(std::floor(high / period));
  }
  for (cells[axis] = first; cells[axis] <= last; ++cells[axis])
    if constexpr (axis == 0) visit(cells);
    else images_along<axis - 1>(domain, least, most, cells, visit);
}

/// Calls `visit(cells)` for every image of a cell (the cell itself among them) whose way from it (Container::way) lies
/// between two vectors along each axis: what is as far away at least and at most from something in the cell. Rows of a
/// tilted cell are moved along x by the tilt each (Lees-Edwards). Where nothing is periodic that is at most the cell.
template <int D, class Visit>
void for_images_between(const Container<D>& domain, const Vec<D>& least, const Vec<D>& most, const Visit& visit) {
  Cells<D> cells;
  images_along<D - 1>(domain, least, most, cells, visit);
}

/// Calls `visit` with the ImageShift of every image in which something that fills `extent` overlaps `window`.
template <class Visit>
void for_each_image(const Domain& domain, const geometry::Rectangle& extent, const geometry::Rectangle& window,
                    Visit&& visit) {
  for_images_between<2>(domain, {window.x_min - extent.x_max, window.y_min - extent.y_max},
                        {window.x_max - extent.x_min, window.y_max - extent.y_min}, [&](const Cells<2>& image) {
                          visit(ImageShift{image.x, image.y, domain.way(image)});
                        });
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
