#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pages.hpp"
#include "model/voxel_map.hpp"
#include "solid/peridynamics/options.hpp"
#include "solid/peridynamics/space/lattice_in_space.hpp"
#include "solid/statics/aggregates.hpp"
#include "solid/statics/block_diagonal.hpp"
#include "solid/statics/discretisation.hpp"
#include "solid/statics/grid.hpp"
#include "solid/statics/loading.hpp"

namespace arenite::peridynamics {

/// All bonds of a sample in space, a node a voxel: two bits of type (BondType) for each half bond of a node, 16 of them
/// a word.
struct SpaceBonds {
  static constexpr int dimension = 3;
  static constexpr bool rests_when_strained = false;  ///< nodes at surfaces lack bonds
  static constexpr std::size_t most_words = 4;

  statics::Grid grid;
  int reach = 2;                  ///< the horizon in spacings
  std::vector<SpaceOffset> half;  ///< half bonds
  std::vector<double> stiffness;  ///< of each, for a modulus of reference: the force over e (e . du), Pa
  std::array<Buffer<std::uint32_t>, most_words> words;  ///< padded
  std::vector<std::uint8_t> holds_any;                  ///< of 16 nodes of a row: whether one of them has a bond
  std::array<float, 4> relative{};                      ///< modulus by type over that of reference

  std::size_t count() const { return half.size(); }
  unsigned type(std::ptrdiff_t node, std::size_t d) const { return words[d / 16][node] >> (2 * (d % 16)) & 3u; }
  void break_bond(std::ptrdiff_t node, std::size_t d) { words[d / 16][node] &= ~(3u << (2 * (d % 16))); }
  std::ptrdiff_t step(std::size_t d) const { return half[d].x + half[d].y * grid.stride + half[d].z * grid.layer; }
  /// Force over e (e . du) of a bond of this type, Pa.
  double stiffness_of(std::size_t d, unsigned type) const { return stiffness[d] * static_cast<double>(relative[type]); }
  std::ptrdiff_t group(int g, int y, int z) const {
    return (static_cast<std::ptrdiff_t>(z) * grid.height + y) * grid.row_vectors() + g;
  }
};

/// The half bonds of a horizon, in the order of `words`.
std::vector<SpaceOffset> space_half_bonds(int reach);

/// The force over e (e . du) of every half bond, for E = 1: c w/|e|^3, where one shell, (200) of 32 bonds and (221) of
/// 122, has a weight w with which the lattice is isotropic, and c makes Young's modulus 1 and Poisson's ratio 1/4.
std::vector<double> bond_stiffness_in_space(int reach);

/// Throws InputError for a map narrower than a node's neighbourhood, a modulus that is not positive or a horizon that
/// is neither 2 nor 3.
SpaceBonds make_space_bonds(const VoxelMap& map, const Stiffness& stiffness, int reach);

/// Marks anew what the kernels skip, after bonds were broken or mended.
void mark_groups(SpaceBonds& bonds);

/// Takes out what bonds do not join to both clamps, and nodes that could move freely because their bonds lie in one
/// plane or line; `tie` says what every node is tied to, padded.
statics::Support prune_in_space(SpaceBonds& bonds, const VoxelMap& map, const std::vector<std::uint8_t>& prescribed,
                                Buffer<statics::Tie>& tie);

/// Nodes a side of the coarse cells.
inline constexpr int space_cell = 8;

/// Nodes by the grains that own them, matrix flooded to grains, that bonds hold together.
statics::Aggregates cut_space_bonds(const VoxelMap& map, const SpaceBonds& bonds,
                                    const std::vector<std::uint8_t>& prescribed, int side);

/// f := force of the bonds on every node, clamped ones too, in the units of `stiffness_of`; returns sum u . f.
double linear_force(const SpaceBonds& bonds, const statics::FieldIn<3, double>& u, statics::FieldIn<3, double>& f);

/// Displacements and the stresses of nodes, sigma_i = 1/(2 V_i) sum f_ij (x) xi_ij (P II.C), V_i = dx^3.
VoxelStress node_stress(const SpaceBonds& bonds, double dx, const statics::FieldIn<3, double>& u);

// What the static solver asks (statics/discretisation.hpp), beside couplings and kernels_of.

statics::BlockDiagonalIn<3, double> block_diagonal(const SpaceBonds& bonds);
/// A bond's energy is at most twice that of its two ends held apart.
inline statics::Smoothing smoothing_of(const SpaceBonds&) { return {4, 0.1, 2}; }

}  // namespace arenite::peridynamics
