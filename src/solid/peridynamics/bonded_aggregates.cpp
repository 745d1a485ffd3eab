#include "solid/peridynamics/bonded_aggregates.hpp"

#include "core/joined_sets.hpp"

namespace arenite::peridynamics {
namespace {

/// Joins the nodes of one cell (by their places in it, y * cell + x) that a bond ties and one owner has.
void join_nodes(const Bonds& bonds, const Buffer<std::int32_t>& owner, const statics::Cell& c, JoinedSets& sets) {
  const Grid& grid = bonds.grid;
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

}  // namespace

Aggregates cut_into_aggregates(const PhaseMap& map, const Bonds& bonds, const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = bonds.grid;
  const auto of_map = statics::owners_in(map);
  Buffer<std::int32_t> owner(grid.padded_size(), -1);
  auto own = of_map.begin();
  grid.each([&](std::ptrdiff_t i, int y) {
    if (prescribed[y] != both_prescribed) owner[i] = *own;
    ++own;
  });
  return statics::cut_by_owner(grid, owner,
                               [&](const statics::Cell& c, JoinedSets& sets) { join_nodes(bonds, owner, c, sets); });
}

}  // namespace arenite::peridynamics
