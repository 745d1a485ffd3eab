#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "model/domain.hpp"

namespace arenite::fields {

/// Points on a regular grid: the centres of equal cells of an upright box, along x first, then along y, then along z.
template <int D> struct GridIn {
  Vec<D> low, high;  ///< corners of the box, m
  Cells<D> count;    ///< of cells along each axis

  std::size_t size() const {
    std::size_t points = 1;
    for (int axis = 0; axis < D; ++axis) points *= static_cast<std::size_t>(count[axis]);
    return points;
  }
  double extent(int axis) const { return high[axis] - low[axis]; }
  Vec<D> step() const {
    return by_axis<D>([&](int axis) { return extent(axis) / count[axis]; });
  }
  /// m^D.
  double cell_volume() const {
    double volume = 1;
    for (int axis = 0; axis < D; ++axis) volume *= extent(axis) / count[axis];
    return volume;
  }
  double place(int axis, int cell) const { return low[axis] + (cell + 0.5) * extent(axis) / count[axis]; }
  Vec<D> point(Cells<D> at) const {
    return by_axis<D>([&](int axis) { return place(axis, at[axis]); });
  }
  std::size_t index(Cells<D> at) const {
    std::size_t k = 0;
    for (int axis = D - 1; axis >= 0; --axis)
      k = k * static_cast<std::size_t>(count[axis]) + static_cast<std::size_t>(at[axis]);
    return k;
  }
  /// Places of the points along an axis, m.
  std::vector<double> lines(int axis) const {
    std::vector<double> places;
    for (int cell = 0; cell < count[axis]; ++cell) places.push_back(place(axis, cell));
    return places;
  }
};
using Grid = GridIn<2>;

/// Of the points of a block of cells whose cells along higher axes are these already.
template <int axis, int D, class Visit>
void points_along(const GridIn<D>& grid, const Cells<D>& from, const Cells<D>& to, std::size_t row, Vec<D>& point,
                  const Visit& visit) {
  row *= static_cast<std::size_t>(grid.count[axis]);
  for (std::int32_t cell = from[axis]; cell < to[axis]; ++cell) {
    point[axis] = grid.place(axis, cell);
    const std::size_t k = row + static_cast<std::size_t>(cell);
    if constexpr (axis == 0) visit(k, point);
    else points_along<axis - 1>(grid, from, to, k, point, visit);
  }
}

/// Calls visit(index, point) for the points of a grid in an upright box.
template <int D, class Visit> void for_points_in(const GridIn<D>& grid, Vec<D> low, Vec<D> high, const Visit& visit) {
  const Vec<D> step = grid.step();
  const auto first = [&](const Vec<D>& corner) {
    return by_axis<D>([&](int axis) {
      return static_cast<std::int32_t>(std::clamp(std::ceil((corner[axis] - grid.low[axis]) / step[axis] - 0.5), 0.0,
                                                  static_cast<double>(grid.count[axis])));
    });
  };
  Vec<D> point;
  points_along<D - 1>(grid, first(low), first(high), 0, point, visit);
}

}  // namespace arenite::fields
