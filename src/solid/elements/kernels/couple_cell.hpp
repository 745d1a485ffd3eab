#pragma once
#include <cstddef>
#include <cstdint>

#include "core/lanes.hpp"
#include "solid/elements/cell_products.hpp"

/// Sums over the elements of a cell, axis by axis: an amplitude of a hat is a product of one number along each axis, so
/// that a sum over places in space is taken along x for all of the other places, then along y, then along z.
namespace arenite::elements {
namespace {

/// A stiffness between two modes, by what they are along x.
struct WorkAlongX {
  std::uint8_t stiffness, x;
};
/// All work of two components on each other that is alike along y and z: 2 whether p's mode changes sign + q's.
struct WorkInPlane {
  std::uint8_t block, y, z, count;
  bool is_first;  ///< of the block and of what p's mode is along z
  WorkAlongX along_x[2];
};

/// What work_of (modes.hpp) says, sorted.
struct CellWork {
  WorkInPlane groups[36]{};
  WorkAlongX rows[32]{};
  int group_count = 0, row_count = 0;

  constexpr CellWork() {
    using enum CellShares::Stiffness;
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned b = 0; b < 3; ++b) {
        const unsigned of_a = 1u << a, of_b = 1u << b;
        if (a == b) {
          for (unsigned mode = 1; mode < 7; ++mode) {
            const bool is_single = mode == 1 || mode == 2 || mode == 4;
            if (is_single) add(a, b, mode, mode, mode == of_a ? axial : shear);
            else if (mode & of_a) add(a, b, mode, mode, along);
            else add(a, b, mode, mode, two_thirds_shear);
          }
          add(a, b, 7, 7, trilinear);
        } else {
          const unsigned other = 7 & ~(of_a | of_b);
          add(a, b, of_a, of_b, cross);
          add(a, b, of_b, of_a, shear);
          add(a, b, of_a | other, of_b | other, across);
          add(a, b, of_b | other, of_a | other, third_shear);
        }
      }
  }

 private:
  constexpr void add(unsigned a, unsigned b, unsigned of_p, unsigned of_q, CellShares::Stiffness stiffness) {
    const auto pair = [&](unsigned axis) {
      return static_cast<std::uint8_t>(2 * (of_p >> axis & 1) + (of_q >> axis & 1));
    };
    const WorkAlongX work{stiffness, pair(0)};
    int row = 0;
    while (row < row_count && (rows[row].stiffness != work.stiffness || rows[row].x != work.x)) ++row;
    if (row == row_count) rows[row_count++] = work;
    const auto block = static_cast<std::uint8_t>(3 * a + b);
    int group = 0;
    while (group < group_count &&
           (groups[group].block != block || groups[group].y != pair(1) || groups[group].z != pair(2)))
      ++group;
    if (group == group_count) {
      groups[group_count++] = {block, pair(1), pair(2), 0, true, {}};
      for (int before = 0; before < group; ++before)
        if (groups[before].block == block && groups[before].z == pair(2)) groups[group].is_first = false;
    }
    groups[group].along_x[groups[group].count++] = work;
  }
};
constexpr CellWork cell_work;

inline void couple_cell(const CellShares& shares, const CellProducts& products, statics::CouplingIn<3>& to) {
  using V = Lanes<double, 4>;
  constexpr int most = CellShares::most_places;
  const AxisProducts &x = *products[0], &y = *products[1], &z = *products[2];
  V along_x[CellShares::count][4][most * most];
  for (int n = 0; n < cell_work.row_count; ++n) {
    const auto [stiffness, modes] = cell_work.rows[n];
    for (int k = 0; k < z.places; ++k)
      for (int j = 0; j < y.places; ++j) {
        const CellShares::Weights& weights = shares.at[stiffness][static_cast<std::size_t>(most * k + j)];
        V sum = V(weights[0]) * V::load(x.at[modes][0].data());
        for (int i = 1; i < x.places; ++i)
          sum = fma(V(weights[i]), V::load(x.at[modes][static_cast<std::size_t>(i)].data()), sum);
        along_x[stiffness][modes][most * k + j] = sum;
      }
  }
  // By what p's mode is along z: what q's is there is then settled.
  V in_plane[9][2][most][4];
  std::uint8_t along_z[9][2];
  for (int n = 0; n < cell_work.group_count; ++n) {
    const WorkInPlane& work = cell_work.groups[n];
    const auto& factors = y.at[work.y];
    along_z[work.block][work.z >> 1] = work.z;
    for (int k = 0; k < z.places; ++k) {
      const auto row = [&](int term, int j) {
        return along_x[work.along_x[term].stiffness][work.along_x[term].x][most * k + j];
      };
      V rows[most];
      for (int j = 0; j < y.places; ++j) rows[j] = work.count == 2 ? row(0, j) + row(1, j) : row(0, j);
      for (int own = 0; own < y.of_p; ++own)
        for (int other = 0; other < y.of_q; ++other) {
          V& hats = in_plane[work.block][work.z >> 1][k][2 * own + other];
          V sum = work.is_first ? V(0.0) : hats;
          for (int j = 0; j < y.places; ++j)
            sum = fma(V(factors[static_cast<std::size_t>(j)][static_cast<std::size_t>(2 * own + other)]), rows[j], sum);
          hats = sum;
        }
    }
  }
  const auto add = [&](std::size_t block, int own_y, int other_y, int own_z, int other_z) {
    V sum(0.0);
    for (int mode = 0; mode < 2; ++mode) {
      const auto& factors = z.at[along_z[block][mode]];
      for (int k = 0; k < z.places; ++k)
        sum = fma(V(factors[static_cast<std::size_t>(k)][static_cast<std::size_t>(2 * own_z + other_z)]),
                  in_plane[block][mode][k][2 * own_y + other_y], sum);
    }
    double hats[4];
    sum.store(hats);
    for (int own_x = 0; own_x < 2; ++own_x) {
      auto& of = to.block[block][static_cast<std::size_t>(own_x + 2 * own_y + 4 * own_z)];
      for (int other_x = 0; other_x < 2; ++other_x)
        of[other_x + 2 * other_y + 4 * other_z] += hats[2 * own_x + other_x];
    }
  };
  for (std::size_t block = 0; block < 9; ++block)
    for (int own_z = 0; own_z < z.of_p; ++own_z)
      for (int other_z = 0; other_z < z.of_q; ++other_z)
        for (int own_y = 0; own_y < y.of_p; ++own_y)
          for (int other_y = 0; other_y < y.of_q; ++other_y) add(block, own_y, other_y, own_z, other_z);
}

}  // namespace
}  // namespace arenite::elements
