#include "geometry/close_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "geometry/cell_grid.hpp"

namespace arenite::geometry {
namespace {

/// A cell's row (or column) with its neighbours, each once even where a periodic box is fewer than three cells wide.
struct Neighbours {
  std::int32_t at[3];
  int count = 0;
  Neighbours(std::int32_t c, std::int32_t n, bool periodic) {
    for (std::int32_t k = c - 1; k <= c + 1; ++k) {
      const std::int32_t image = periodic ? (k + n) % n : k;
      if (image >= 0 && image < n && std::find(begin(), end(), image) == end()) at[count++] = image;
    }
  }
  const std::int32_t* begin() const { return at; }
  const std::int32_t* end() const { return at + count; }
};

}  // namespace

std::vector<Pair> close_pairs(std::span<const double> x, std::span<const double> y, std::span<const double> radius, const Box& box, double gap) {
  std::vector<Pair> pairs;
  if (x.empty()) return pairs;
  // A trifle wider than pairs reach, so that rounding parts none of them by a whole cell.
  const double reach = (2 * *std::max_element(radius.begin(), radius.end()) + gap) * (1 + 1e-12);
  const CellGrid grid(box.x0, box.y0, box.width, box.height, reach, 30000);
  const SortedCells cells(grid, 0, x.size(), [&](std::size_t i) { return grid.cell(x[i], y[i]); });
  std::vector<std::int32_t> partners;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(x.size()); ++i) {
    partners.clear();
    for (const auto row : Neighbours(grid.row(y[i]), grid.rows, box.periodic_y))
      for (const auto column : Neighbours(grid.column(x[i]), grid.columns, box.periodic_x)) {
        const std::int32_t cell = row * grid.columns + column;
        for (auto k = cells.first[cell]; k < cells.first[cell + 1]; ++k) {
          const std::int32_t j = cells.item[k];
          if (j <= i) continue;
          double dx = x[i] - x[j], dy = y[i] - y[j];
          if (box.periodic_x) dx -= box.width * std::nearbyint(dx / box.width);
          if (box.periodic_y) dy -= box.height * std::nearbyint(dy / box.height);
          const double apart = radius[i] + radius[j] + gap;
          if (dx * dx + dy * dy <= apart * apart) partners.push_back(j);
        }
      }
    std::sort(partners.begin(), partners.end());
    for (const auto j : partners) pairs.push_back({i, j});
    if (pairs.size() > 1'000'000 + 256 * x.size())
      throw InputError(
          "grains lie so deep in each other, or the gap is so wide, that they have hundreds of neighbours each; correct the unit of the radii, or the gap");
  }
  return pairs;
}

}  // namespace arenite::geometry
