#include "geometry/close_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace arenite::geometry {

namespace {

/// Disks sorted into square cells; outside a fixed side they count to the nearest cell.
struct Cells {
  int nx, ny;
  std::vector<std::int32_t> start, member;
};

int cell_index(double v, double v0, double length, int n) {
  return std::clamp(static_cast<int>(std::floor((v - v0) / length * n)), 0, n - 1);
}

int cells_along(double length, double cell) {
  return std::max(1, static_cast<int>(std::min(length / cell, 30000.0)));
}

Cells sort_into_cells(std::span<const double> x, std::span<const double> y, const Box& box, double cell) {
  Cells cells{cells_along(box.width, cell), cells_along(box.height, cell), {}, {}};
  const auto n = x.size();
  std::vector<std::int32_t> of(n);
  cells.start.assign(static_cast<std::size_t>(cells.nx) * cells.ny + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    of[i] = cell_index(y[i], box.y0, box.height, cells.ny) * cells.nx + cell_index(x[i], box.x0, box.width, cells.nx);
    ++cells.start[of[i] + 1];
  }
  for (std::size_t c = 1; c < cells.start.size(); ++c) cells.start[c] += cells.start[c - 1];
  cells.member.resize(n);
  auto next = cells.start;
  for (std::size_t i = 0; i < n; ++i) cells.member[next[of[i]]++] = static_cast<std::int32_t>(i);
  return cells;
}

/// Neighbouring cell rows (or columns) of one cell, each once even where a periodic box is fewer than three cells wide.
int neighbours_along(int c, int n, bool periodic, int (&out)[3]) {
  int count = 0;
  for (int d = -1; d <= 1; ++d) {
    int k = c + d;
    if (periodic) k = (k + n) % n;
    if (k < 0 || k >= n || std::find(out, out + count, k) != out + count) continue;
    out[count++] = k;
  }
  return count;
}

}  // namespace

std::vector<Pair> close_pairs(std::span<const double> x, std::span<const double> y, std::span<const double> radius,
                              const Box& box, double gap) {
  std::vector<Pair> pairs;
  if (x.empty()) return pairs;
  const double largest = *std::max_element(radius.begin(), radius.end());
  const Cells cells = sort_into_cells(x, y, box, 2 * largest + gap);
  std::vector<std::int32_t> partners;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(x.size()); ++i) {
    partners.clear();
    int columns[3], rows[3];
    const int nc = neighbours_along(cell_index(x[i], box.x0, box.width, cells.nx), cells.nx, box.periodic_x, columns);
    const int nr = neighbours_along(cell_index(y[i], box.y0, box.height, cells.ny), cells.ny, box.periodic_y, rows);
    for (int r = 0; r < nr; ++r)
      for (int c = 0; c < nc; ++c) {
        const int cell = rows[r] * cells.nx + columns[c];
        for (int k = cells.start[cell]; k < cells.start[cell + 1]; ++k) {
          const std::int32_t j = cells.member[k];
          if (j <= i) continue;
          double dx = x[i] - x[j], dy = y[i] - y[j];
          if (box.periodic_x) dx -= box.width * std::nearbyint(dx / box.width);
          if (box.periodic_y) dy -= box.height * std::nearbyint(dy / box.height);
          const double reach = radius[i] + radius[j] + gap;
          if (dx * dx + dy * dy <= reach * reach) partners.push_back(j);
        }
      }
    std::sort(partners.begin(), partners.end());
    for (const auto j : partners) pairs.push_back({i, j});
    if (pairs.size() > 1'000'000 + 256 * x.size())
      throw InputError("grains lie so deep in each other, or the gap is so wide, that they have hundreds of neighbours each; correct the unit of the radii, or the gap");
  }
  return pairs;
}

}  // namespace arenite::geometry
