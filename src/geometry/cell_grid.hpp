#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace arenite::geometry {

/// Cells of at least `size`, row by row, over a rectangle, at most `most` along a side; points outside, and those without a place, belong to the border cells.
struct CellGrid {
  double x0, y0, inverse_x, inverse_y;
  std::int32_t columns, rows;

  CellGrid(double left, double bottom, double width, double height, double size, double most = 4096)
      : x0(left),
        y0(bottom),
        columns(along(width, size, most)),
        rows(along(height, size, most)) {
    inverse_x = columns / width;
    inverse_y = rows / height;
  }
  std::int32_t column(double x) const { return static_cast<std::int32_t>(std::max(0.0, std::min(columns - 1.0, (x - x0) * inverse_x))); }
  std::int32_t row(double y) const { return static_cast<std::int32_t>(std::max(0.0, std::min(rows - 1.0, (y - y0) * inverse_y))); }
  /// The same counted on beyond the rectangle, as periodic images need it.
  std::int32_t free_column(double x) const { return static_cast<std::int32_t>(std::floor((x - x0) * inverse_x)); }
  std::int32_t free_row(double y) const { return static_cast<std::int32_t>(std::floor((y - y0) * inverse_y)); }
  std::int32_t cell(double x, double y) const { return row(y) * columns + column(x); }
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }

 private:
  static std::int32_t along(double length, double size, double most) { return static_cast<std::int32_t>(std::clamp(length / size, 1.0, most)); }
};

/// Items begin .. end-1 sorted into cells, each cell's in their order: those of cell c are item[first[c]] .. item[first[c + 1] - 1].
struct SortedCells {
  std::vector<std::int32_t> first, item;

  /// `cell_of(k)` is the cell of item k.
  template <class CellOf>
  SortedCells(const CellGrid& grid, std::size_t begin, std::size_t end, CellOf&& cell_of) : first(grid.size() + 1, 0),
                                                                                            item(end - begin) {
    std::vector<std::int32_t> cell(end - begin);
    for (std::size_t k = begin; k < end; ++k) ++first[static_cast<std::size_t>(cell[k - begin] = cell_of(k)) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next = first;
    for (std::size_t k = begin; k < end; ++k) item[next[cell[k - begin]]++] = static_cast<std::int32_t>(k);
  }

  /// Calls `see` for the items of the cell of a place and those around it, row by row.
  template <class See> void for_near(const CellGrid& grid, double x, double y, See&& see) const {
    const std::int32_t row = grid.row(y), column = grid.column(x), from = std::max(column - 1, 0), to = std::min(column + 1, grid.columns - 1);
    for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r)
      for (std::int32_t k = first[r * grid.columns + from]; k < first[r * grid.columns + to + 1]; ++k) see(item[k]);
  }
};

}  // namespace arenite::geometry
