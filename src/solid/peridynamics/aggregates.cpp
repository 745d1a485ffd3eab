#include "solid/peridynamics/aggregates.hpp"

#include <algorithm>
#include <array>

#include "core/joined_sets.hpp"

namespace arenite::peridynamics {
namespace {

/// Owner of every node, -1 for void: its grain; for matrix the grain that a flood through the matrix reaches it from
/// first; for matrix that touches no grain, one number beyond the grains.
Buffer<std::int32_t> owners(const PhaseMap& map, const Grid& grid) {
  Buffer<std::int32_t> owner(grid.padded_size(), -1);
  constexpr std::int32_t unowned = -2;
  std::size_t k = 0;
  grid.each([&](std::ptrdiff_t i, int) {
    owner[i] = map.phase[k] == Phase::particle ? map.grain[k] : map.phase[k] == Phase::matrix ? unowned : -1;
    ++k;
  });
  std::vector<std::ptrdiff_t> front;
  const std::array<std::ptrdiff_t, 4> sides{1, -1, grid.stride, -grid.stride};
  const auto flood_from = [&](std::ptrdiff_t i) {
    for (const auto step : sides)
      if (owner[i + step] == unowned) {
        owner[i + step] = owner[i];
        front.push_back(i + step);
      }
  };
  auto phase = map.phase.begin();
  grid.each([&](std::ptrdiff_t i, int) {
    if (*phase++ == Phase::particle) flood_from(i);
  });
  for (std::size_t n = 0; n < front.size(); ++n) flood_from(front[n]);
  std::replace(owner.begin(), owner.end(), unowned, static_cast<std::int32_t>(map.grain_class.size()));
  return owner;
}

/// A cell of the sample: its first node and how many it has each way.
struct Cell {
  int x0, y0, wide, high;
};

/// Joins the nodes of one cell (by their places in it, y * cell + x) that a bond ties and one owner has.
void join_nodes(const Bonds& bonds, const Buffer<std::int32_t>& owner, const Cell& c, JoinedSets& sets) {
  const Grid& grid = bonds.grid;
  sets.part(static_cast<std::size_t>(Aggregates::cell * Aggregates::cell));
  for (int y = 0; y < c.high; ++y)
    for (int x = 0; x < c.wide; ++x) {
      const std::ptrdiff_t i = grid.index(c.x0 + x, c.y0 + y);
      if (owner[i] < 0) continue;
      // Deep inside a grain the two nearest neighbours already tie all nodes together.
      const bool inside = bonds.group_at(c.x0 + x, c.y0 + y) == particle_bond;
      const std::uint32_t word = bonds.words[i];
      for (int d = 0; d < (inside ? 4 : bonds_per_node); d += inside ? 3 : 1) {
        const Offset e = half_bonds[d];
        if (!(word >> (2 * d) & 3u) || static_cast<unsigned>(x + e.x) >= static_cast<unsigned>(c.wide) ||
            y + e.y >= c.high)
          continue;
        if (owner[i + bonds.step(d)] == owner[i])
          sets.join(y * Aggregates::cell + x, (y + e.y) * Aggregates::cell + x + e.x);
      }
    }
}

/// Numbers the aggregates of one cell in the order of their first node.
void add_aggregates(const Grid& grid, const Buffer<std::int32_t>& owner, const Cell& c, JoinedSets& sets,
                    Aggregates& aggregates) {
  std::array<std::int32_t, Aggregates::cell * Aggregates::cell> aggregate;
  for (int y = 0; y < c.high; ++y)
    for (int x = 0; x < c.wide; ++x) {
      const std::ptrdiff_t i = grid.index(c.x0 + x, c.y0 + y);
      if (owner[i] < 0) continue;
      const std::int32_t k = y * Aggregates::cell + x, root = sets.find(k);
      if (root == k) {
        aggregate[k] = aggregates.count();
        aggregates.list.push_back({owner[i], c.x0 / Aggregates::cell, c.y0 / Aggregates::cell});
      }
      const std::int32_t p = aggregate[root];
      aggregates.of_node[i] = p;
      ++aggregates.list[p].nodes;
    }
}

}  // namespace

Aggregates cut_into_aggregates(const PhaseMap& map, const Bonds& bonds, const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = bonds.grid;
  auto owner = owners(map, grid);
  for (int y = 0; y < grid.height; ++y)
    if (prescribed[y] == both_prescribed) std::fill_n(owner.data() + grid.row(y), grid.width, -1);

  Aggregates aggregates;
  aggregates.of_node.assign(grid.padded_size(), Aggregates::none);
  JoinedSets sets;
  for (int y0 = 0; y0 < grid.height; y0 += Aggregates::cell)
    for (int x0 = 0; x0 < grid.width; x0 += Aggregates::cell) {
      const Cell c{x0, y0, std::min(Aggregates::cell, grid.width - x0), std::min(Aggregates::cell, grid.height - y0)};
      join_nodes(bonds, owner, c, sets);
      add_aggregates(grid, owner, c, sets, aggregates);
    }
  return aggregates;
}

}  // namespace arenite::peridynamics
