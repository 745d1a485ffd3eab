#include "solid/peridynamics/couplings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solid/peridynamics/bond_blocks.hpp"

namespace arenite::peridynamics {
namespace {

constexpr int cell = Aggregates::cell;
constexpr std::array<std::size_t, 3> upper{0, 1, 3};  // where a coupling has xx, xy and yy

/// What one node's bonds to one aggregate sum to: block times hats of the other ends.
struct Reach {
  std::int32_t q;
  std::array<Hats, 3> sum;
};

/// Sums of block times hats over the 14 half bonds of a node whose bonds all stay in its cell, for unit modulus.
struct InnerSums {
  static constexpr int low = 2, high = cell - horizon;  ///< such nodes: low <= x < high, y < high
  std::array<std::array<Hats, 3>, cell * cell> at{};
  InnerSums() {
    for (int y = 0; y < high; ++y)
      for (int x = low; x < high; ++x)
        for (const Offset e : half_bonds) {
          const Hats& other = hats_at(x + e.x, y + e.y);
          const double k = 1 / std::pow(length(e), 3);
          auto& sum = at[y * cell + x];
          sum[0] += k * e.x * e.x * other;
          sum[1] += k * e.x * e.y * other;
          sum[2] += k * e.y * e.y * other;
        }
  }
  static bool holds(int x, int y) { return x >= low && x < high && y < high; }
};

struct BondSum : statics::CouplingSum {
  const Bonds& bonds;
  const Aggregates& aggregates;
  BondBlocks blocks;

  BondSum(const Bonds& b, const Aggregates& p)
      : CouplingSumIn(p.list.size()),
        bonds(b),
        aggregates(p),
        blocks(bond_blocks(b)) {}

  /// A node that only slides along x; the bonds between it and the rows above all start here.
  void add_sliding_node(std::ptrdiff_t i, int x, int y, double diagonal_xx) {
    const std::int32_t p = aggregates.of_node[i];
    const Hats& own = hats_at(x, y);
    for (unsigned a = 0; a < 4; ++a) self(p).block[0][a] += own[a] * (0.5 * diagonal_xx * own);
    for (unsigned d = 0; d < bonds_per_node; ++d) {
      const unsigned type = bonds.words[i] >> (2 * d) & 3u;
      const Offset e = half_bonds[d];
      const std::int32_t q = aggregates.of_node[i + bonds.step(static_cast<int>(d))];
      if (type == no_bond || q < 0) continue;
      const Hats& other = hats_at(x + e.x, y + e.y);
      Coupling& to = q == p ? self(p) : between(p, q);
      for (unsigned a = 0; a < 4; ++a) {
        to.block[0][a] -= own[a] * blocks[d][type].xx * other;
        if (e.y > 0) to.block[1][a] -= own[a] * blocks[d][type].xy * other;
      }
    }
  }

  /// A node's bonds inside its own aggregate, whose block times hats is `modulus` times `sums`. They appear as they are
  /// and transposed; half of the diagonal goes to each.
  void add_within(std::int32_t p, const Hats& own, const std::array<double, 3>& diagonal, double modulus,
                  const std::array<Hats, 3>& sums) {
    for (unsigned c = 0; c < 3; ++c) {
      const Hats row = 0.5 * diagonal[c] * own - modulus * sums[c];
      for (unsigned a = 0; a < 4; ++a) self(p).block[upper[c]][a] += own[a] * row;
    }
  }

  /// A node deep inside one grain and one cell: its bonds are all alike and reach its own aggregate only.
  void add_inner_node(std::ptrdiff_t i, int x, int y, double modulus, const std::array<double, 3>& diagonal) {
    static const InnerSums inner_sums;  // not before main: it asks for the hats of another source
    add_within(aggregates.of_node[i], hats_at(x, y), diagonal, modulus, inner_sums.at[y * cell + x]);
  }

  void add_node(std::ptrdiff_t i, int x, int y, const std::array<double, 3>& diagonal) {
    const std::int32_t p = aggregates.of_node[i];
    const std::uint32_t word = bonds.words[i];
    std::array<Reach, bonds_per_node> reach;
    unsigned reached = 1;
    reach[0] = {p, {}};
    unsigned at = 0;
    for (unsigned d = 0; d < bonds_per_node; ++d) {
      const unsigned type = word >> (2 * d) & 3u;
      if (type == no_bond) continue;
      const Offset e = half_bonds[d];
      const std::int32_t q = aggregates.of_node[i + bonds.step(static_cast<int>(d))];
      if (q < 0) continue;
      if (reach[at].q != q) {
        for (at = 0; at < reached && reach[at].q != q;) ++at;
        if (at == reached) reach[reached++] = {q, {}};
      }
      const Hats& other = hats_at(x + e.x, y + e.y);
      const Block& block = blocks[d][type];
      reach[at].sum[0] += block.xx * other;
      reach[at].sum[1] += block.xy * other;
      reach[at].sum[2] += block.yy * other;
    }
    const Hats& own = hats_at(x, y);
    add_within(p, own, diagonal, 1, reach[0].sum);
    for (unsigned k = 1; k < reached; ++k) {
      Coupling& to = between(p, reach[k].q);
      for (unsigned c = 0; c < 3; ++c)
        for (unsigned a = 0; a < 4; ++a) to.block[upper[c]][a] -= own[a] * reach[k].sum[c];
    }
  }
};

}  // namespace

std::vector<Coupling> couplings(const Bonds& bonds, const Aggregates& aggregates, const BlockDiagonal<double>& diagonal,
                                const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = bonds.grid;
  BondSum sum(bonds, aggregates);
  for (int y0 = 0; y0 < grid.height; y0 += cell)
    for (int x0 = 0; x0 < grid.width; x0 += cell)
      for (int y = y0; y < std::min(y0 + cell, grid.height); ++y)
        for (int x = x0; x < std::min(x0 + cell, grid.width); ++x) {
          const std::ptrdiff_t i = grid.index(x, y);
          if (aggregates.of_node[i] < 0 || prescribed[y]) continue;
          const std::array<double, 3> own{diagonal.xx[i], diagonal.xy[i], diagonal.yy[i]};
          const bool inside = bonds.group_at(x, y) == particle_bond;
          if (inside && InnerSums::holds(x - x0, y - y0) && aggregates.of_node[i + horizon * grid.stride] >= 0)
            sum.add_inner_node(i, x - x0, y - y0, bonds.modulus(particle_bond), own);
          else sum.add_node(i, x - x0, y - y0, own);
        }
  for (Coupling& c : sum.selves()) c.block[2] = c.block[1];
  for (Coupling& c : sum.crosses()) c.block[2] = c.block[1];
  for (int y = 0; y < grid.height; ++y)
    if (prescribed[y] == y_prescribed)
      for (int x = 0; x < grid.width; ++x)
        if (const std::ptrdiff_t i = grid.index(x, y); aggregates.of_node[i] >= 0)
          sum.add_sliding_node(i, x % cell, y % cell, diagonal.xx[i]);
  for (Coupling& within : sum.selves())
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = 0; b < 4; ++b) {
        if (b <= a)
          for (const unsigned c : {0u, 3u})
            within.block[c][a][b] = within.block[c][b][a] = within.block[c][a][b] + within.block[c][b][a];
        within.block[1][a][b] += within.block[2][b][a];
        within.block[2][b][a] = within.block[1][a][b];
      }
  return sum.taken();
}

}  // namespace arenite::peridynamics
