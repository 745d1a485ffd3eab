#include "peridynamics/solvers/pieces.hpp"

#include <algorithm>
#include <array>

#include "peridynamics/kernels/kernels.hpp"

namespace arenite::peridynamics {

namespace {

/// Owner of every node, -1 for void: its grain; for matrix the grain that a flood through the matrix reaches it from
/// first; for matrix that touches no grain, one number beyond the grains.
Buffer<std::int32_t> owners(const PhaseMap& map, const Grid& grid) {
  Buffer<std::int32_t> owner(grid.padded_size());
  constexpr std::int32_t unowned = -2;
  std::fill_n(owner.data(), owner.size(), -1);
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const auto i = map.index(x, y);
      owner[grid.index(x, y)] = map.phase[i] == Phase::particle ? map.grain[i]
                                : map.phase[i] == Phase::matrix ? unowned
                                                                : -1;
    }
  std::vector<std::ptrdiff_t> front;
  const std::array<std::ptrdiff_t, 4> sides{1, -1, grid.stride, -grid.stride};
  const auto flood_from = [&](std::ptrdiff_t i) {
    for (const auto step : sides)
      if (owner[i + step] == unowned) {
        owner[i + step] = owner[i];
        front.push_back(i + step);
      }
  };
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x)
      if (map.phase[map.index(x, y)] == Phase::particle) flood_from(grid.index(x, y));
  for (std::size_t k = 0; k < front.size(); ++k) flood_from(front[k]);
  std::replace(owner.data(), owner.data() + owner.size(), unowned, static_cast<std::int32_t>(map.grain_class.size()));
  return owner;
}

/// Union-find over the nodes of one cell.
struct CellSets {
  std::array<std::int16_t, Pieces::cell * Pieces::cell> parent;
  std::int16_t find(std::int16_t a) {
    while (parent[static_cast<unsigned>(a)] != a)
      a = parent[static_cast<unsigned>(a)] = parent[static_cast<unsigned>(parent[static_cast<unsigned>(a)])];
    return a;
  }
  void unite(std::int16_t a, std::int16_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent[static_cast<unsigned>(std::max(a, b))] = std::min(a, b);
  }
};

}  // namespace

Pieces cut_into_pieces(const PhaseMap& map, const Bonds& bonds, const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = bonds.grid;
  auto owner = owners(map, grid);
  for (int y = 0; y < grid.height; ++y)
    if (prescribed[static_cast<std::size_t>(y)] == both_prescribed)
      std::fill_n(owner.data() + grid.row(y), grid.width, -1);

  Pieces pieces;
  pieces.of_node = Buffer<std::int32_t>(grid.padded_size());
  std::fill_n(pieces.of_node.data(), pieces.of_node.size(), Pieces::none);
  constexpr int cell = Pieces::cell;
  CellSets sets;
  std::array<std::int32_t, cell * cell> piece;
  for (int y0 = 0; y0 < grid.height; y0 += cell)
    for (int x0 = 0; x0 < grid.width; x0 += cell) {
      const int wide = std::min(cell, grid.width - x0), high = std::min(cell, grid.height - y0);
      for (unsigned k = 0; k < sets.parent.size(); ++k) sets.parent[k] = static_cast<std::int16_t>(k);
      for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
          const std::ptrdiff_t i = grid.index(x0 + x, y0 + y);
          if (owner[i] < 0) continue;
          // Deep inside a grain the two nearest neighbours already tie all nodes together.
          const bool inside =
              bonds.group[static_cast<std::ptrdiff_t>(y0 + y) * grid.groups + (x0 + x) / Grid::lanes] == particle_bond;
          const std::uint32_t word = bonds.words[i];
          for (int d = 0; d < (inside ? 4 : bonds_per_node); d += inside ? 3 : 1) {
            const Offset e = half_bonds[static_cast<unsigned>(d)];
            if (!(word >> (2 * d) & 3u) || static_cast<unsigned>(x + e.x) >= static_cast<unsigned>(wide) ||
                y + e.y >= high)
              continue;
            if (owner[i + bonds.step(d)] == owner[i])
              sets.unite(static_cast<std::int16_t>(y * cell + x),
                         static_cast<std::int16_t>((y + e.y) * cell + x + e.x));
          }
        }
      for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
          const std::ptrdiff_t i = grid.index(x0 + x, y0 + y);
          if (owner[i] < 0) continue;
          const auto k = static_cast<std::int16_t>(y * cell + x), root = sets.find(k);
          if (root == k) {
            piece[static_cast<unsigned>(k)] = pieces.count();
            pieces.owner.push_back(owner[i]);
            pieces.cell_x.push_back(x0 / cell);
            pieces.cell_y.push_back(y0 / cell);
            pieces.nodes.push_back(0);
          }
          const std::int32_t p = piece[static_cast<unsigned>(root)];
          pieces.of_node[i] = p;
          ++pieces.nodes[static_cast<std::size_t>(p)];
        }
    }
  return pieces;
}

}  // namespace arenite::peridynamics
