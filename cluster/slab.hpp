#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "handles.hpp"
#include "ranks.hpp"
#include "solid/elements/elements.hpp"

namespace arenite::cluster {

/// What every rank is told of a sample and its clamps.
struct Problem {
  std::array<int, 3> cells{};  ///< none: there is no other sample
  std::array<elements::Modes<3>, 4> modes{};
  decltype(elements::Voxels::table) table{};
  double tolerance = 0, reference = 0;
  int max_iterations = 0;
};

/// A rank's part of a sample, and what it does with it. Nodes are those of two meshes: the coarse one has every second
/// node of the fine one, which goes on beyond a sample of an odd number of cells by one that is empty.
struct Slab {
  std::array<int, 3> cells;              ///< of the whole sample
  std::vector<std::uint8_t> prescribed;  ///< by level of the whole sample
  Mesh coarse, fine;
  Box own;                  ///< fine nodes
  Box reach;                ///< cells: those of its nodes and those of its coarse cells
  elements::Voxels voxels;  ///< these
  statics::FieldIn<3, double> u, force;
  std::vector<std::uint8_t> levels;  ///< what is prescribed in those of `voxels`
  statics::InverseDiagonalIn<3> inverse;
  Vector ghosted;

  /// Every rank calls it; the first one has the whole sample, the others nothing.
  Slab(const Problem& problem, const std::vector<std::uint8_t>& whole_prescribed, const elements::Voxels* whole);

  elements::Kind kind(std::int64_t x, std::int64_t y, std::int64_t z) const { return voxels.kind(node(x, y, z)); }
  /// In the grid of `voxels`.
  std::ptrdiff_t node(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return voxels.grid.index(static_cast<int>(x - reach.low[0]), static_cast<int>(y - reach.low[1]),
                             static_cast<int>(z - reach.low[2]));
  }
  /// What is prescribed at a level of the fine mesh.
  std::uint8_t prescribed_at(std::int64_t level) const {
    return level <= cells[2] ? prescribed[static_cast<std::size_t>(level)] : std::uint8_t{statics::nothing_prescribed};
  }

  // On vectors of the fine mesh.
  void stiffness(::Vec u, ::Vec to);         ///< K u, without the rows that are prescribed
  void unsmoothed(::Vec r, ::Vec to) const;  ///< D^-1 r, D the block diagonal
  void keep_free(::Vec u) const;             ///< nothing where it is prescribed or where no cell is

  /// A vector of the first rank's field, and the way back.
  void hand_out(const statics::FieldIn<3, double>& whole, const statics::Grid& grid, ::Vec to) const;
  void hand_in(::Vec from, const statics::Grid& grid, statics::FieldIn<3, double>& whole) const;
};

}  // namespace arenite::cluster
