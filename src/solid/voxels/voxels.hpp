#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pages.hpp"
#include "core/vec.hpp"
#include "model/voxel_map.hpp"
#include "solid/elements/options.hpp"
#include "solid/statics/aggregates.hpp"
#include "solid/statics/block_diagonal.hpp"
#include "solid/statics/discretisation.hpp"
#include "solid/statics/grid.hpp"
#include "solid/voxels/modes.hpp"

/// Finite elements on the voxels of a sample in space: one cube a voxel, unknowns at its corners.
namespace arenite::voxels {

using elements::Constants;
using elements::Element;
using statics::Aggregates;
using statics::Grid;
using BlockDiagonal = statics::BlockDiagonalIn<3, double>;
template <class T> using Field = statics::FieldIn<3, T>;

/// What voxels are made of. A voxel of interface is one of a grain that has one of another grain beside it, or one of
/// matrix that has one of a grain there, across edges and corners too.
struct Material {
  Constants matrix{1}, interface { 1 }, particle{4};
  Element element = Element::wilson;
};

/// Kind of a voxel.
enum Kind : std::uint32_t { none = 0, matrix = 1, interface = 2, particle = 3 };

Modes modes_of(const Constants& constants, Element element);

/// A voxel map as elements. Nodes are the corners of the voxels: one more each way than there are voxels, or in a
/// periodic sample as many. The voxel whose lowest corner is node i has its kind at words[i], in bits 0 and 1.
struct Voxels {
  static constexpr int dimension = 3;
  static constexpr bool rests_when_strained = true;
  Grid grid;                                    ///< of corners
  Buffer<std::uint32_t> words;                  ///< padded
  std::array<Modes, 4> modes;                   ///< by kind, as the kernels have them: rounded to single precision
  std::array<std::array<float, 4>, 6> table{};  ///< the members of Modes, each by kind
  int width = 0, height = 0, depth = 0;         ///< of voxels

  Kind kind(std::ptrdiff_t i) const { return static_cast<Kind>(words[i] & 3u); }
  /// Steps from a voxel's lowest corner to each.
  std::array<std::ptrdiff_t, 8> corners() const;
  /// The node that a corner is, where a period has led beyond the last.
  std::ptrdiff_t node(int x, int y, int z) const {
    return grid.periodic ? grid.index(x % width, y % height, z % depth) : grid.index(x, y, z);
  }
};

/// Throws InputError for a modulus that is not positive or a Poisson's ratio outside (-1, 1/2).
Voxels make_voxels(const VoxelMap& map, const Material& material, bool periodic = false);

/// The stiffness between corners c and d of a voxel of unit side, [component of c][component of d], Pa.
std::array<std::array<double, 3>, 3> corner_block(const Modes& modes, int c, int d);

// What the static solver asks (statics/discretisation.hpp), beside couplings and kernels_of (kernels/kernels.hpp).

BlockDiagonal block_diagonal(const Voxels& voxels);
/// Up to the largest eigenvalue of D_e^-1 K_e over the kinds, which no sum of elements exceeds.
statics::Smoothing smoothing_of(const Voxels& voxels);

/// A corner belongs to the grain that most of the stiffness of its eight voxels is of, matrix flooded to grains; pieces
/// hang together by voxels. `prescribed` has one entry a layer of corners, `side` is that of a cell.
Aggregates cut_into_aggregates(const VoxelMap& map, const Voxels& voxels, const std::vector<std::uint8_t>& prescribed,
                               int side);

/// Displacement and stress in the middle of every voxel; the stress there is the mean of the element's. `strain` is
/// added to what the displacements of a periodic sample leave (Voigt's order, shears doubled).
VoxelStress voxel_stress(const VoxelMap& map, const Voxels& voxels, const Field<double>& u,
                         const std::array<double, 6>& strain = {});

}  // namespace arenite::voxels
