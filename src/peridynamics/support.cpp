#include "peridynamics/support.hpp"

#include <algorithm>
#include <numeric>

#include "peridynamics/kernels/kernels.hpp"

namespace arenite::peridynamics {

namespace {

class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::int32_t find(std::int32_t a) {
    while (at(a) != a) a = at(a) = at(at(a));
    return a;
  }
  void unite(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) at(std::max(a, b)) = std::min(a, b);
  }

 private:
  std::int32_t& at(std::int32_t a) { return parent_[static_cast<std::size_t>(a)]; }
  std::vector<std::int32_t> parent_;
};

/// Piece of a node; the lower clamp counts as one piece more, the upper as another. -1 for void.
struct Parts {
  const Bonds& bonds;
  const Pieces& pieces;
  const std::vector<std::uint8_t>& prescribed;
  int middle() const { return bonds.grid.height / 2; }
  std::int32_t of(std::ptrdiff_t i, int y) const {
    if (y < 0 || y >= bonds.grid.height || prescribed[static_cast<std::size_t>(y)] != both_prescribed)
      return pieces.of_node[i];
    return pieces.count() + (y > middle());
  }
};

}  // namespace

Support prune(Bonds& bonds, Pieces& pieces, const std::vector<std::uint8_t>& prescribed, Buffer<Tie>& tie) {
  const Grid& grid = bonds.grid;
  const Parts parts{bonds, pieces, prescribed};
  const std::int32_t below = pieces.count(), above = below + 1;
  Sets sets(static_cast<std::size_t>(above) + 1);
  // The clamps themselves never join parts: a part tied to both is known by its own ties.
  std::vector<std::uint8_t> ties(static_cast<std::size_t>(above) + 1, 0);
  for (int y = 0; y < grid.height; ++y)
    if (prescribed[static_cast<std::size_t>(y)] == y_prescribed)
      for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i)
        if (pieces.of_node[i] >= 0) ties[static_cast<std::size_t>(pieces.of_node[i])] |= 1;
  const auto join = [&](std::int32_t a, std::int32_t b) {
    if (a < below && b < below) sets.unite(a, b);
    else if (a < below) ties[static_cast<std::size_t>(a)] |= b == below ? 1 : 2;
    else if (b < below) ties[static_cast<std::size_t>(b)] |= a == below ? 1 : 2;
  };
  for (int y = 0; y < grid.height; ++y)
    for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
      const std::uint32_t word = bonds.words[i];
      if (!word) continue;
      const std::int32_t own = parts.of(i, y);
      // Where all bonds are whole and alike the nearest ones tell what hangs together.
      const auto kind = bonds.group[static_cast<std::ptrdiff_t>(y) * grid.groups + (i - grid.row(y)) / Grid::lanes];
      const bool inside = kind != Bonds::mixed;
      for (int d = 0; d < (inside ? 4 : bonds_per_node); d += inside ? 3 : 1) {
        if (!(word >> (2 * d) & 3u)) continue;
        const std::int32_t other = parts.of(i + bonds.step(d), y + half_bonds[static_cast<unsigned>(d)].y);
        if (other != own) join(own, other);
      }
    }
  std::vector<std::uint8_t> whole(ties.size(), 0);
  for (std::int32_t p = 0; p < below; ++p)
    whole[static_cast<std::size_t>(sets.find(p))] |= ties[static_cast<std::size_t>(p)];

  Support support;
  std::vector<std::int32_t> number(static_cast<std::size_t>(below), Pieces::none);
  Pieces kept;
  for (std::int32_t p = 0; p < below; ++p) {
    const auto k = static_cast<std::size_t>(p), root = static_cast<std::size_t>(sets.find(p));
    ties[k] = whole[root];
    support.islands += root == k && whole[root] == 0;
    (whole[root] == 3   ? support.carrying
     : whole[root] == 2 ? support.held_above
     : whole[root] == 1 ? support.held_below
                        : support.floating) += static_cast<std::size_t>(pieces.nodes[k]);
    if (whole[root] != 3) continue;
    number[k] = kept.count();
    kept.owner.push_back(pieces.owner[k]);
    kept.cell_x.push_back(pieces.cell_x[k]);
    kept.cell_y.push_back(pieces.cell_y[k]);
    kept.nodes.push_back(pieces.nodes[k]);
  }
  support.solid = support.carrying + support.held_above + support.held_below + support.floating;
  tie = Buffer<Tie>(grid.padded_size());
  const bool all = kept.count() == below;
  for (int y = 0; y < grid.height; ++y)
    for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
      const std::int32_t p = pieces.of_node[i];
      if (p < 0) continue;
      tie[i] = static_cast<Tie>(ties[static_cast<std::size_t>(p)]);
      if (all) continue;
      pieces.of_node[i] = number[static_cast<std::size_t>(p)];
    }
  if (all) return support;
  kept.of_node = std::move(pieces.of_node);
  pieces = std::move(kept);
  const auto carries = [&](std::ptrdiff_t i, int y) {
    return y >= 0 && y < grid.height &&
           (prescribed[static_cast<std::size_t>(y)] == both_prescribed || tie[i] == Tie::both);
  };
  for (int y = 0; y < grid.height; ++y)
    for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
      std::uint32_t& word = bonds.words[i];
      if (!word) continue;
      for (int d = 0; d < bonds_per_node; ++d)
        if (!carries(i, y) || !carries(i + bonds.step(d), y + half_bonds[static_cast<unsigned>(d)].y))
          word &= ~(3u << (2 * d));
    }
  classify_groups(bonds, 0, grid.height - 1);
  return support;
}

}  // namespace arenite::peridynamics
