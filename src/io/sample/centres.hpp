#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mapped.hpp"
#include "geometry/cell_grid.hpp"
#include "geometry/close_pairs.hpp"
#include "io/sample/formats.hpp"

namespace arenite::io {

/// Finds the grain whose centre, or a periodic image of it, is a point, to the six digits that YADE writes.
template <int D> class Centres {
 public:
  Centres(const std::vector<RawGrain>& rows, const Laid<D>& laid)
      : rows_(rows),
        cell_(laid.cell),
        largest_(rows.empty() ? 0 : std::ranges::max_element(rows, {}, &RawGrain::radius)->radius),
        places_(mapped(rows, [&](const RawGrain& g) { return laid.cell.wrapped(laid.frame.of(g.place)); })),
        grid_(geometry::around(std::span<const Vec<D>>(places_)), std::max(2 * largest_, 1e-9), most_cells),
        cells_(grid_.size(), 0, places_.size(), [&](std::size_t k) { return grid_.cell(places_[k]); }) {}

  /// Index of the grain, or -1.
  std::int64_t find(Vec<D> p) const {
    constexpr double slack = 1e-3;
    double digits = 0;
    for (int axis = 0; axis < D; ++axis) digits += 1e-5 * std::abs(p[axis]);
    const Vec<D> base = cell_.wrapped(p);
    std::int64_t found = -1;
    cell_.each_near_cell([&](Cells<D> cells) {
      const Vec<D> image = base + cell_.way(cells);
      cells_.for_near(grid_, image, [&](std::int32_t g) {
        const double reach = digits + slack * rows_[static_cast<std::size_t>(g)].radius;
        if (found < 0 && norm(places_[static_cast<std::size_t>(g)] - image) <= reach) found = g;
      });
    });
    return found;
  }

 private:
  static constexpr double most_cells = D == 2 ? 4096 : 64;  // along a side
  const std::vector<RawGrain>& rows_;
  const DomainIn<D>& cell_;
  double largest_;
  std::vector<Vec<D>> places_;
  geometry::CellGrid<D> grid_;
  geometry::SortedCells cells_;
};

}  // namespace arenite::io
