#include "solid/peridynamics/support.hpp"

#include <utility>

#include "core/joined_sets.hpp"

namespace arenite::peridynamics {
namespace {

/// Aggregate of a node; the lower clamp counts as one more, the upper as another. -1 for void.
struct Parts {
  const Bonds& bonds;
  const Aggregates& aggregates;
  const std::vector<std::uint8_t>& prescribed;
  int middle() const { return bonds.grid.height / 2; }
  std::int32_t of(std::ptrdiff_t i, int y) const {
    if (y < 0 || y >= bonds.grid.height || prescribed[y] != both_prescribed) return aggregates.of_node[i];
    return aggregates.count() + (y > middle());
  }
};

/// What each aggregate is tied to by itself, as bits of Tie. Joins in `sets` the aggregates that hang together.
std::vector<std::uint8_t> own_ties(const Bonds& bonds, const Aggregates& aggregates,
                                   const std::vector<std::uint8_t>& prescribed, JoinedSets& sets) {
  const Grid& grid = bonds.grid;
  const Parts parts{bonds, aggregates, prescribed};
  const std::int32_t below = aggregates.count();
  std::vector<std::uint8_t> ties(static_cast<std::size_t>(below), 0);
  grid.each([&](std::ptrdiff_t i, int y) {
    if (prescribed[y] == y_prescribed && aggregates.of_node[i] >= 0)
      ties[static_cast<std::size_t>(aggregates.of_node[i])] |= 1;
  });
  // The clamps themselves never join parts: a part tied to both is known by its own ties.
  const auto join = [&](std::int32_t a, std::int32_t b) {
    if (a < below && b < below) sets.join(a, b);
    else if (a < below) ties[a] |= b == below ? 1 : 2;
    else if (b < below) ties[b] |= a == below ? 1 : 2;
  };
  grid.each([&](std::ptrdiff_t i, int y) {
    if (!bonds.words[i]) return;
    const std::int32_t own = parts.of(i, y);
    // Where all bonds are whole and alike the nearest ones tell what hangs together.
    const bool inside = bonds.group_at(static_cast<int>(i - grid.row(y)), y) != Bonds::mixed;
    for (int d = 0; d < (inside ? 4 : bonds_per_node); d += inside ? 3 : 1) {
      if (!bonds.type(i, d)) continue;
      const std::int32_t other = parts.of(i + bonds.step(d), y + half_bonds[d].y);
      if (other != own) join(own, other);
    }
  });
  return ties;
}

/// Gives the aggregates that hang together the ties of all of them, and counts.
Support share_ties(const Aggregates& aggregates, JoinedSets& sets, std::vector<std::uint8_t>& ties) {
  std::vector<std::uint8_t> whole(ties.size(), 0);
  for (std::size_t p = 0; p < ties.size(); ++p)
    whole[static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(p)))] |= ties[p];
  Support support;
  for (std::size_t p = 0; p < ties.size(); ++p) {
    const auto root = static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(p)));
    ties[p] = whole[root];
    support.islands += root == p && whole[root] == 0;
    (whole[root] == 3   ? support.carrying
     : whole[root] == 2 ? support.held_above
     : whole[root] == 1 ? support.held_below
                        : support.floating) += static_cast<std::size_t>(aggregates.list[p].nodes);
  }
  support.solid = support.carrying + support.held_above + support.held_below + support.floating;
  return support;
}

/// Leaves only the aggregates that are tied to both clamps.
void keep_carrying(const Grid& grid, const std::vector<std::uint8_t>& ties, Aggregates& aggregates) {
  std::vector<std::int32_t> number(ties.size(), Aggregates::none);
  std::vector<Aggregates::Aggregate> kept;
  for (std::size_t p = 0; p < ties.size(); ++p) {
    if (ties[p] != 3) continue;
    number[p] = static_cast<std::int32_t>(kept.size());
    kept.push_back(aggregates.list[p]);
  }
  grid.each([&](std::ptrdiff_t i, int) {
    if (std::int32_t& p = aggregates.of_node[i]; p >= 0) p = number[p];
  });
  aggregates.list = std::move(kept);
}

/// Leaves only bonds between nodes that carry, clamped ones among them.
void cut_loose_bonds(Bonds& bonds, const std::vector<std::uint8_t>& prescribed, const Buffer<Tie>& tie) {
  const Grid& grid = bonds.grid;
  const auto carries = [&](std::ptrdiff_t i, int y) {
    return y >= 0 && y < grid.height && (prescribed[y] == both_prescribed || tie[i] == Tie::both);
  };
  each_bond(bonds, [&](const Bond& b) {
    if (!carries(b.i, b.y) || !carries(b.j, b.y + b.step().y)) bonds.break_bond(b.i, b.d);
  });
  classify_groups(bonds, 0, grid.height - 1);
}

}  // namespace

Support prune(Bonds& bonds, Aggregates& aggregates, const std::vector<std::uint8_t>& prescribed, Buffer<Tie>& tie) {
  const Grid& grid = bonds.grid;
  JoinedSets sets(static_cast<std::size_t>(aggregates.count()));
  std::vector<std::uint8_t> ties = own_ties(bonds, aggregates, prescribed, sets);
  const Support support = share_ties(aggregates, sets, ties);
  tie = Buffer<Tie>(grid.padded_size());
  grid.each([&](std::ptrdiff_t i, int) {
    if (aggregates.of_node[i] >= 0) tie[i] = static_cast<Tie>(ties[static_cast<std::size_t>(aggregates.of_node[i])]);
  });
  if (support.carrying == support.solid) return support;
  keep_carrying(grid, ties, aggregates);
  cut_loose_bonds(bonds, prescribed, tie);
  return support;
}

}  // namespace arenite::peridynamics
