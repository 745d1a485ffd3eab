#include "geometry/close_pairs.hpp"

#include <algorithm>

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

/// Calls `see` for the cell of a place and those around it, in a row of them already chosen along the later axes.
template <int Axis, int D, class See>
void for_cells(const CellGrid<D>& grid, const Box<D>& box, const Vec<D>& place, std::int32_t row, See& see) {
  for (const auto at : Neighbours(grid.along(Axis, place[Axis]), grid.count[Axis], box.periodic[Axis])) {
    const std::int32_t cell = row * grid.count[Axis] + at;
    if constexpr (Axis == 0) see(cell);
    else for_cells<Axis - 1>(grid, box, place, cell, see);
  }
}

/// So many of a width fill a box.
template <int D> double cells_of(const Box<D>& box, double width) {
  double cells = 1;
  for (int axis = 0; axis < D; ++axis) cells *= std::max(1.0, box.size[axis] / width);
  return cells;
}

}  // namespace

template <int D>
std::vector<Pair> close_pairs(std::span<const Vec<D>> centre, std::span<const double> radius, const Box<D>& box,
                              double gap) {
  std::vector<Pair> pairs;
  if (centre.empty()) return pairs;
  // A trifle wider than pairs reach, so that rounding parts none of them by a whole cell.
  const double reach = (2 * *std::max_element(radius.begin(), radius.end()) + gap) * (1 + 1e-12);
  double width = reach;  // wider where a few of them lie far apart, so that cells do not outnumber them
  while (cells_of(box, width) > 64 * static_cast<double>(centre.size()) + 4096) width *= 1.5;
  const CellGrid<D> grid(box, width, D == 2 ? 30000 : 1000);
  const SortedCells cells(grid.size(), 0, centre.size(), [&](std::size_t i) { return grid.cell(centre[i]); });
  std::vector<std::int32_t> partners;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(centre.size()); ++i) {
    partners.clear();
    const auto look_into = [&](std::int32_t cell) {
      for (auto k = cells.first[cell]; k < cells.first[cell + 1]; ++k) {
        const std::int32_t j = cells.item[k];
        if (j <= i) continue;
        const Vec<D> d = box.nearest_image(centre[i] - centre[j]);
        const double apart = radius[i] + radius[j] + gap;
        if (dot(d, d) <= apart * apart) partners.push_back(j);
      }
    };
    for_cells<D - 1>(grid, box, centre[i], 0, look_into);
    std::sort(partners.begin(), partners.end());
    for (const auto j : partners) pairs.push_back({i, j});
    if (pairs.size() > 1'000'000 + 256 * centre.size())
      throw InputError(
          "grains lie so deep in each other, or the gap is so wide, that they have hundreds of neighbours each; "
          "correct the unit of the radii, or the gap");
  }
  return pairs;
}

template std::vector<Pair> close_pairs<2>(std::span<const Vec2>, std::span<const double>, const Box<2>&, double);
template std::vector<Pair> close_pairs<3>(std::span<const Vec3>, std::span<const double>, const Box<3>&, double);

}  // namespace arenite::geometry
