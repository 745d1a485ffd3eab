#include "solid/peridynamics/space/bonds_in_space.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/joined_sets.hpp"
#include "core/problems.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/kernels/space_kernels.hpp"
#include "solid/peridynamics/padded_labels.hpp"

namespace arenite::peridynamics {
namespace {

/// Whether a bond is of the shell whose weight makes the lattice isotropic.
bool is_weighted(SpaceOffset e, int reach) {
  const int longest = std::max({std::abs(e.x), std::abs(e.y), std::abs(e.z)});
  return longest == 2 && e.square() == (reach == 2 ? 4 : 9);
}

/// visit(i, j, d, type) for every bond that a node starts.
template <class Visit> void each_bond_from(const SpaceBonds& bonds, std::ptrdiff_t i, const Visit& visit) {
  for (std::size_t d = 0; d < bonds.count(); ++d)
    if (const unsigned type = bonds.type(i, d)) visit(i + bonds.step(d), d, type);
}
template <class Visit> void each_space_bond(const SpaceBonds& bonds, const Visit& visit) {
  bonds.grid.each([&](std::ptrdiff_t i, int) {
    each_bond_from(bonds, i, [&](std::ptrdiff_t j, std::size_t d, unsigned type) { visit(i, j, d, type); });
  });
}

void free_node(SpaceBonds& bonds, std::ptrdiff_t i) {
  for (std::size_t d = 0; d < bonds.count(); ++d) {
    bonds.break_bond(i, d);
    bonds.break_bond(i - bonds.step(d), d);
  }
}

/// Frees the nodes whose bonds lie in one plane, until there are none; returns whether there were any.
bool free_loose_nodes(SpaceBonds& bonds, const std::vector<std::uint8_t>& prescribed) {
  for (bool any = false;; any = true) {
    const auto diagonal = block_diagonal(bonds);
    const auto inverse = statics::inverse_diagonal(bonds.grid, diagonal, prescribed);
    if (inverse.loose == 0) return any;
    bonds.grid.each([&](std::ptrdiff_t i, int level) {
      if (prescribed[static_cast<std::size_t>(level)] == statics::every_component<3>) return;
      const auto own = diagonal.at(i), back = inverse.blocks.at(i);
      if (own.xx + own.yy + own.zz > 0 && !(back.xx + back.yy + back.zz > 0)) free_node(bonds, i);
    });
  }
}

}  // namespace

std::vector<SpaceOffset> space_half_bonds(int reach) {
  std::vector<SpaceOffset> list;
  each_half_bond_in_space(reach, [&](SpaceOffset e) { list.push_back(e); });
  return list;
}

void mark_groups(SpaceBonds& bonds) {
  const Grid& grid = bonds.grid;
  bonds.holds_any.assign(static_cast<std::size_t>(bonds.group(0, 0, grid.depth)), 0);
  const auto mark = [&](std::ptrdiff_t i) {
    const std::ptrdiff_t inside = i - grid.row(0, 0), z = inside / grid.layer, y = inside % grid.layer / grid.stride;
    const std::ptrdiff_t g = inside % grid.layer % grid.stride / Grid::vector;
    bonds.holds_any[static_cast<std::size_t>(
        bonds.group(static_cast<int>(g), static_cast<int>(y), static_cast<int>(z)))] = 1;
  };
  grid.each([&](std::ptrdiff_t i, int) {
    bool any = false;
    each_bond_from(bonds, i, [&](std::ptrdiff_t j, std::size_t, unsigned) { mark(j), any = true; });
    if (any) mark(i);
  });
}

std::vector<double> bond_stiffness_in_space(int reach) {
  const auto half = space_half_bonds(reach);
  // C_1111 and C_1122 are sums over half bonds; isotropic where C_1111 = 3 C_1122.
  double c11 = 0, c12 = 0, of_shell11 = 0, of_shell12 = 0;
  for (const SpaceOffset e : half) {
    const double cube = std::pow(e.square(), 1.5), xx = e.x * e.x, yy = e.y * e.y, zz = e.z * e.z;
    const double own11 = (xx * xx + yy * yy + zz * zz) / 3 / cube, own12 = (xx * yy + yy * zz + zz * xx) / 3 / cube;
    (is_weighted(e, reach) ? of_shell11 : c11) += own11;
    (is_weighted(e, reach) ? of_shell12 : c12) += own12;
  }
  const double weight = (3 * c12 - c11) / (of_shell11 - 3 * of_shell12), c = 0.4 / (c12 + weight * of_shell12);
  std::vector<double> stiffness;
  for (const SpaceOffset e : half)
    stiffness.push_back(c * (is_weighted(e, reach) ? weight : 1) / std::pow(e.square(), 1.5));
  return stiffness;
}

SpaceBonds make_space_bonds(const VoxelMap& map, const Stiffness& stiffness, int reach) {
  arenite::check(map);
  check_by_type("Young modulus", "Pa", stiffness.matrix, stiffness.interface, stiffness.particle);
  if (reach != 2 && reach != 3)
    throw refusal("the horizon of bonds in space is {} voxels; give 2 (32 bonds a node) or 3 (122)", reach);
  if (std::min({map.width, map.height, map.depth}) < 2)
    throw refusal(
        "one layer of voxels has bonds in one plane; give two layers or more each way, or load it as a picture");
  SpaceBonds bonds;
  bonds.reach = reach;
  bonds.half = space_half_bonds(reach);
  bonds.stiffness = bond_stiffness_in_space(reach);
  for (double& k : bonds.stiffness) k *= stiffness.matrix;
  bonds.relative = {0.0f, 1.0f, static_cast<float>(stiffness.interface / stiffness.matrix),
                    static_cast<float>(stiffness.particle / stiffness.matrix)};
  const Grid& grid = bonds.grid = Grid(map.width, map.height, map.depth, reach);
  const auto labels = padded_labels(map, grid);
  for (std::size_t w = 0; w <= (bonds.count() - 1) / 16; ++w)
    bonds.words[w] = Buffer<std::uint32_t>(grid.padded_size());
  for (std::size_t d = 0; d < bonds.count(); ++d) {
    const std::ptrdiff_t step = bonds.step(d);
    std::uint32_t* const words = bonds.words[d / 16].data();
    for (int z = 0; z < grid.depth; ++z)
      for (int y = 0; y < grid.height; ++y)
        for (std::ptrdiff_t i = grid.row(y, z), end = i + grid.width; i < end; ++i) {
          const std::int32_t own = labels[i], other = labels[i + step];
          const unsigned within = own == 1 ? matrix_bond : own > 1 ? particle_bond : no_bond;
          const unsigned across = own != 0 && other != 0 ? interface_bond : no_bond;
          words[i] |= (own == other ? within : across) << (2 * (d % 16));
        }
  }
  mark_groups(bonds);
  return bonds;
}

statics::Support prune_in_space(SpaceBonds& bonds, const VoxelMap& map, const std::vector<std::uint8_t>& prescribed,
                                Buffer<statics::Tie>& tie) {
  using statics::Tie;
  const Grid& grid = bonds.grid;
  JoinedSets sets(grid.padded_size());
  Buffer<std::uint8_t> ties(grid.padded_size());
  do {
    sets.part(grid.padded_size());
    ties.assign(grid.padded_size(), 0);
    each_space_bond(bonds, [&](std::ptrdiff_t i, std::ptrdiff_t j, std::size_t, unsigned) {
      sets.join(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
    });
    grid.each([&](std::ptrdiff_t i, int level) {
      const auto by = level == 0 ? Tie::below : level == grid.depth - 1 ? Tie::above : Tie::none;
      ties[sets.find(static_cast<std::int32_t>(i))] |= static_cast<std::uint8_t>(by);
    });
    grid.each([&](std::ptrdiff_t i, int) {
      if (ties[sets.find(static_cast<std::int32_t>(i))] != static_cast<std::uint8_t>(Tie::both)) free_node(bonds, i);
    });
  } while (free_loose_nodes(bonds, prescribed));
  mark_groups(bonds);
  statics::Support support;
  tie = Buffer<Tie>(grid.padded_size());
  auto phase = map.phase.begin();
  grid.each([&](std::ptrdiff_t i, int) {
    if (*phase++ == Phase::empty) return;
    const auto root = sets.find(static_cast<std::int32_t>(i));
    tie[i] = static_cast<Tie>(ties[root]);
    support.islands += tie[i] == Tie::none && root == i;
    ++(tie[i] == Tie::both    ? support.carrying
       : tie[i] == Tie::above ? support.held_above
       : tie[i] == Tie::below ? support.held_below
                              : support.floating);
  });
  support.solid = support.carrying + support.held_below + support.held_above + support.floating;
  return support;
}

statics::Aggregates cut_space_bonds(const VoxelMap& map, const SpaceBonds& bonds,
                                    const std::vector<std::uint8_t>& prescribed, int side) {
  const Grid& grid = bonds.grid;
  const auto of_map = statics::owners_in(map);
  Buffer<std::int32_t> owner(grid.padded_size(), -1);
  Buffer<std::uint8_t> bonded(grid.padded_size());
  each_space_bond(bonds, [&](std::ptrdiff_t i, std::ptrdiff_t j, std::size_t, unsigned) { bonded[i] = bonded[j] = 1; });
  auto own = of_map.begin();
  grid.each([&](std::ptrdiff_t i, int level) {
    if (bonded[i] && prescribed[static_cast<std::size_t>(level)] != statics::every_component<3>) owner[i] = *own;
    ++own;
  });
  const auto join = [&](const statics::Cell& c, JoinedSets& sets) {
    for (int z = 0; z < c.deep; ++z)
      for (int y = 0; y < c.high; ++y)
        for (int x = 0; x < c.wide; ++x) {
          const std::ptrdiff_t i = grid.index(c.x0 + x, c.y0 + y, c.z0 + z);
          if (owner[i] < 0) continue;
          each_bond_from(bonds, i, [&](std::ptrdiff_t j, std::size_t d, unsigned) {
            const auto [ex, ey, ez] = bonds.half[d];
            const int right = x + ex, back = y + ey, up = z + ez;
            if (owner[j] == owner[i] && right >= 0 && right < c.wide && back >= 0 && back < c.high && up < c.deep)
              sets.join((z * side + y) * side + x, (up * side + back) * side + right);
          });
        }
  };
  return statics::cut_by_owner(grid, owner, join, side);
}

statics::BlockDiagonalIn<3, double> block_diagonal(const SpaceBonds& bonds) {
  statics::BlockDiagonalIn<3, double> sum(bonds.grid.padded_size());
  each_space_bond(bonds, [&](std::ptrdiff_t i, std::ptrdiff_t j, std::size_t d, unsigned type) {
    const auto [x, y, z] = bonds.half[d];
    const double k = bonds.stiffness_of(d, type);
    for (const std::ptrdiff_t n : {i, j}) {
      sum.xx[n] += k * x * x, sum.xy[n] += k * x * y, sum.xz[n] += k * x * z;
      sum.yy[n] += k * y * y, sum.yz[n] += k * y * z, sum.zz[n] += k * z * z;
    }
  });
  return sum;
}

double linear_force(const SpaceBonds& bonds, const statics::FieldIn<3, double>& u, statics::FieldIn<3, double>& f) {
  const std::vector<std::uint8_t> free(static_cast<std::size_t>(bonds.grid.levels()), statics::nothing_prescribed);
  return kernels_of(bonds).force(bonds, free.data(), statics::pointers(u), statics::pointers(f));
}

VoxelStress node_stress(const SpaceBonds& bonds, double dx, const statics::FieldIn<3, double>& u) {
  const Grid& grid = bonds.grid;
  statics::BlockDiagonalIn<3, double> sum(grid.padded_size());
  each_space_bond(bonds, [&](std::ptrdiff_t i, std::ptrdiff_t j, std::size_t d, unsigned type) {
    const auto [x, y, z] = bonds.half[d];
    const Vec3 du = u.at(j) - u.at(i);
    const double tension = bonds.stiffness_of(d, type) * (x * du.x + y * du.y + z * du.z) / (2 * dx);
    for (const std::ptrdiff_t n : {i, j}) {
      sum.xx[n] += tension * x * x, sum.xy[n] += tension * x * y, sum.xz[n] += tension * x * z;
      sum.yy[n] += tension * y * y, sum.yz[n] += tension * y * z, sum.zz[n] += tension * z * z;
    }
  });
  VoxelStress field;
  field.width = grid.width, field.height = grid.height, field.depth = grid.depth, field.dx = dx;
  const auto compact = [&](const Buffer<double>& padded, std::vector<float>& values) {
    grid.each([&](std::ptrdiff_t i, int) { values.push_back(static_cast<float>(padded[i])); });
  };
  compact(u.x, field.ux), compact(u.y, field.uy), compact(u.z, field.uz);
  compact(sum.xx, field.xx), compact(sum.yy, field.yy), compact(sum.zz, field.zz);
  compact(sum.yz, field.yz), compact(sum.xz, field.xz), compact(sum.xy, field.xy);
  return field;
}

}  // namespace arenite::peridynamics
