#pragma once
#include <cmath>
#include <utility>

#include "geometry/rectangle.hpp"
#include "model/packing.hpp"

namespace arenite::fields {

/// One periodic image: so many widths and heights away, and by how much that moves a point, m.
struct Image {
  int columns = 0, rows = 0;
  Vec2 shift;
};

/// Calls `visit` for every image of a cell (the cell itself among them) in which something that fills `extent` overlaps `window`. Rows of a
/// tilted cell are moved along x by `Domain::tilt` each (Lees-Edwards). Where nothing is periodic that is at most the thing itself.
template <class Visit> void for_each_image(const Domain& domain, const geometry::Rectangle& extent, const geometry::Rectangle& window, Visit&& visit) {
  const auto range = [](double low, double high, double period, bool periodic) {
    if (periodic) return std::pair{static_cast<int>(std::ceil(low / period)), static_cast<int>(std::floor(high / period))};
    return std::pair{0, low <= 0 && high >= 0 ? 0 : -1};
  };
  const auto [row0, row1] = range(window.y_min - extent.y_max, window.y_max - extent.y_min, domain.height(), domain.periodic_y);
  for (int row = row0; row <= row1; ++row) {
    const double along = row * domain.tilt;
    const auto [column0, column1] = range(window.x_min - extent.x_max - along, window.x_max - extent.x_min - along, domain.width(), domain.periodic_x);
    for (int column = column0; column <= column1; ++column) visit(Image{column, row, {column * domain.width() + along, row * domain.height()}});
  }
}

}  // namespace arenite::fields
