#pragma once
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Cells of at least `size`, row by row, over a rectangle; points outside belong to the border cells.
struct CellGrid {
  double x0, y0, inverse_x, inverse_y;
  std::int32_t columns, rows;

  CellGrid(double left, double bottom, double right, double top, double size)
      : x0(left), y0(bottom) {
    columns = std::clamp(static_cast<std::int32_t>((right - left) / size), 1, 4096);
    rows = std::clamp(static_cast<std::int32_t>((top - bottom) / size), 1, 4096);
    inverse_x = columns / (right - left);
    inverse_y = rows / (top - bottom);
  }
  std::int32_t column(double x) const {
    return static_cast<std::int32_t>(std::clamp((x - x0) * inverse_x, 0.0, columns - 1.0));
  }
  std::int32_t row(double y) const {
    return static_cast<std::int32_t>(std::clamp((y - y0) * inverse_y, 0.0, rows - 1.0));
  }
  std::int32_t cell(double x, double y) const { return row(y) * columns + column(x); }
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

inline CellGrid grid_of(const Sample& s) {
  const auto& w = s.domain.wall;
  const double cell = reach_of(s);
  return {w[left].position, w[bottom].position, w[right].position, w[top].position, cell};
}

/// Disks sorted into cells: those of cell c are item[first[c]] .. item[first[c + 1] - 1].
struct Cells {
  std::vector<std::int32_t> first, item;
  Cells(const CellGrid& grid, const std::vector<DiskRecord>& record, std::size_t begin, std::size_t end)
      : first(grid.size() + 1, 0), item(end - begin) {
    for (std::size_t k = begin; k < end; ++k) ++first[static_cast<std::size_t>(grid.cell(record[k].x, record[k].y)) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next = first;
    for (std::size_t k = begin; k < end; ++k)
      item[static_cast<std::size_t>(next[static_cast<std::size_t>(grid.cell(record[k].x, record[k].y))]++)] =
          static_cast<std::int32_t>(k);
  }
};

}  // namespace arenite::dem
