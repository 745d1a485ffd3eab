#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "geometry/rectangle.hpp"

namespace arenite::geometry {

/// Cells of at least `size` in a box, at most `most` along a side, counted along x first; points outside, and those
/// without a place, belong to the border cells.
template <int D> struct CellGrid {
  Vec<D> corner, inverse;  ///< inverse: of a cell's sides, 1/m
  std::array<std::int32_t, D> count;

  CellGrid(const Box<D>& box, double size, double most = 4096) : corner(box.corner) {
    for (int axis = 0; axis < D; ++axis) {
      count[axis] = static_cast<std::int32_t>(std::clamp(box.size[axis] / size, 1.0, most));
      inverse[axis] = count[axis] / box.size[axis];
    }
  }
  /// Of a coordinate along one axis.
  std::int32_t along(int axis, double x) const {
    return static_cast<std::int32_t>(std::max(0.0, std::min(count[axis] - 1.0, (x - corner[axis]) * inverse[axis])));
  }
  /// The same counted on beyond the box, as periodic images need it.
  std::int32_t free_along(int axis, double x) const {
    return static_cast<std::int32_t>(std::floor((x - corner[axis]) * inverse[axis]));
  }
  std::int32_t cell(Vec<D> place) const {
    std::int32_t at = 0;
    for (int axis = D - 1; axis >= 0; --axis) at = at * count[axis] + along(axis, place[axis]);
    return at;
  }
  std::size_t size() const {
    std::size_t cells = 1;
    for (const std::int32_t n : count) cells *= static_cast<std::size_t>(n);
    return cells;
  }
};

/// Items begin .. end-1 sorted into cells, each cell's in their order: those of cell c are item[first[c]] ..
/// item[first[c + 1] - 1].
struct SortedCells {
  std::vector<std::int32_t> first, item;

  /// `cell_of(k)` is the cell of item k, of so many.
  template <class CellOf>
  SortedCells(std::size_t cells, std::size_t begin, std::size_t end, CellOf&& cell_of)
      : first(cells + 1, 0),
        item(end - begin) {
    std::vector<std::int32_t> cell(end - begin);
    for (std::size_t k = begin; k < end; ++k) ++first[static_cast<std::size_t>(cell[k - begin] = cell_of(k)) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next = first;
    for (std::size_t k = begin; k < end; ++k) item[next[cell[k - begin]]++] = static_cast<std::int32_t>(k);
  }

  /// Calls `see` for the items of the cell of a place and those around it, row by row.
  template <int D, class See> void for_near(const CellGrid<D>& grid, Vec<D> place, See&& see) const {
    const auto row = [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t k = begin; k < end; ++k) see(item[k]);
    };
    near<D - 1, false>(grid, place, 0, row);
  }
  /// The same without the cells around it that come before it, where items are sorted by cell: `see(begin, end)` of
  /// those of each row.
  template <int D, class See> void for_later(const CellGrid<D>& grid, Vec<D> place, See&& see) const {
    near<D - 1, true>(grid, place, 0, see);
  }

 private:
  template <int Axis, bool later, int D, class See>
  void near(const CellGrid<D>& grid, const Vec<D>& place, std::int32_t row, See& see) const {
    const std::int32_t middle = grid.along(Axis, place[Axis]), before = std::max(middle - 1, 0),
                       to = std::min(middle + 1, grid.count[Axis] - 1);
    row *= grid.count[Axis];
    if constexpr (Axis == 0) {
      see(first[row + (later ? middle : before)], first[row + to + 1]);
    } else {
      if constexpr (later) near<Axis - 1, true>(grid, place, row + middle, see);
      for (std::int32_t c = later ? middle + 1 : before; c <= to; ++c) near<Axis - 1, false>(grid, place, row + c, see);
    }
  }
};

/// Points in cells of a width, to ask which lie near a place. The points must outlive it.
class PointGrid {
 public:
  PointGrid(std::span<const Vec2> points, double width)
      : points_(points),
        grid_(box_of(points), width),
        cells_(grid_.size(), 0, points.size(), [&](std::size_t k) { return grid_.cell(points[k]); }) {}

  /// Calls visit(index, squared distance) for every point no farther than `reach`.
  template <class Visit> void within(Vec2 place, double reach, Visit visit) const {
    const auto at = [&](double x, std::int32_t row) {
      return static_cast<std::size_t>(row * grid_.count[0] + grid_.along(0, x));
    };
    for (std::int32_t row = grid_.along(1, place.y - reach); row <= grid_.along(1, place.y + reach); ++row)
      for (std::int32_t k = cells_.first[at(place.x - reach, row)]; k < cells_.first[at(place.x + reach, row) + 1];
           ++k) {
        const std::int32_t item = cells_.item[static_cast<std::size_t>(k)];
        const Vec2 away = points_[static_cast<std::size_t>(item)] - place;
        if (const double square = dot(away, away); square <= reach * reach) visit(item, square);
      }
  }

 private:
  static Box<2> box_of(std::span<const Vec2> points) {
    if (points.empty()) return {};
    const Rectangle box = bounds(points);
    return {{box.x_min, box.y_min}, {box.width(), box.height()}};
  }

  std::span<const Vec2> points_;
  CellGrid<2> grid_;
  SortedCells cells_;
};

}  // namespace arenite::geometry
