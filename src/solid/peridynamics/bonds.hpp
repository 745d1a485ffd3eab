#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/pages.hpp"
#include "model/phase_map.hpp"
#include "solid/peridynamics/lattice.hpp"
#include "solid/peridynamics/options.hpp"
#include "solid/statics/aggregates.hpp"
#include "solid/statics/block_diagonal.hpp"
#include "solid/statics/couplings.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::peridynamics {

using statics::Aggregates;
using statics::Block;
using statics::BlockDiagonal;
using statics::BlockPlane;
using statics::Coupling;
using statics::Field;
using statics::Grid;
using statics::Hats;
using statics::hats_at;
using statics::Plane;
using statics::pointers;
using statics::Prescribed;
using statics::set_zero;
using enum statics::Prescribed;

/// Type of a bond, by what its two nodes are (P II.D): both matrix; both in one particle; otherwise interface. A void
/// node has no bonds.
enum BondType : unsigned { no_bond = 0, matrix_bond = 1, interface_bond = 2, particle_bond = 3 };

/// From a node of a grid to its neighbour along a half bond.
inline std::ptrdiff_t step_of(const Grid& grid, int d) { return half_bonds[d].x + half_bonds[d].y * grid.stride; }

/// Throws InputError where a parameter of bonds is not positive for a type of bond.
void check_by_type(const char* parameter, const char* unit, double matrix, double interface, double particle);

/// All bonds of a sample: one word a node, two bits of type for each of its 14 half bonds, those in direction d at bits
/// 2d and 2d + 1. Nothing else is stored; a broken bond is one whose bits are cleared.
struct Bonds {
  /// What the 28 bonds of a node are, for 8 nodes at once: the kernels skip the empty and hasten over the uniform.
  enum Group : std::uint8_t { empty = 0, mixed = 4 };  // 1..3: all of that BondType

  static constexpr int dimension = 2;
  static constexpr bool rests_when_strained = false;  ///< nodes at surfaces lack bonds

  Grid grid;
  Buffer<std::uint32_t> words;      ///< padded
  Buffer<std::uint8_t> group;       ///< grid.groups a row, not padded
  std::array<float, 4> relative{};  ///< modulus by type over `scale`
  double scale = 0;                 ///< micromodulus factor times the modulus of reference, Pa
  BondLawChoice law;

  unsigned type(std::ptrdiff_t node, int d) const { return words[node] >> (2 * d) & 3u; }
  void break_bond(std::ptrdiff_t node, int d) { words[node] &= ~(3u << (2 * d)); }
  std::uint8_t group_at(int x, int y) const {
    return group[static_cast<std::ptrdiff_t>(y) * grid.groups + x / Grid::lanes];
  }
  std::ptrdiff_t step(int d) const { return step_of(grid, d); }
  /// Force over e (e . du)/|e|^3 of a bond of this type, Pa.
  double modulus(unsigned t) const { return scale * static_cast<double>(relative[t]); }
};

/// Bonds of a sample. With `stop_at_voids` no bond passes through the square of a void node, or between two that meet
/// at a corner. Throws InputError for a map narrower than a node's neighbourhood (7 nodes) or a modulus that is not
/// positive. Moduli are held relative to the matrix's in single precision (exact for ratios such as 4 or 100).
Bonds make_bonds(const PhaseMap& map, const Stiffness& stiffness, const BondLawChoice& law = {},
                 bool stop_at_voids = false);

/// How many bonds between solid nodes pass through voids.
std::size_t bonds_across_voids(const PhaseMap& map);

/// Marks groups anew after bonds were broken in rows [first, last].
void classify_groups(Bonds& bonds, int first, int last);

/// Whether a cut crosses a bond from one place to another, in nodes.
bool crosses(const Cut& cut, Vec2 from, Vec2 to);

/// Breaks every bond that a cut crosses.
void make_cuts(Bonds& bonds, const std::vector<Cut>& cuts);

/// One whole bond: the node that it starts from, at (x, y), its other end j, its direction (index into half_bonds) and
/// its type.
struct Bond {
  std::ptrdiff_t i, j;
  std::int32_t x, y;
  int d;
  unsigned type;
  Offset step() const { return half_bonds[d]; }
};

/// Every bond that `words` (as those of Bonds) hold in row y once, handed to `visit(Bond)`; a visitor may clear its
/// bits.
template <class Visit>
void each_bond_of_row(const Grid& grid, const Buffer<std::uint32_t>& words, int y, const Visit& visit) {
  for (int x = 0; x < grid.width; ++x) {
    const std::ptrdiff_t i = grid.index(x, y);
    const std::uint32_t word = words[i];
    if (!word) continue;
    for (int d = 0; d < bonds_per_node; ++d)
      if (const unsigned type = word >> (2 * d) & 3u) visit(Bond{i, i + step_of(grid, d), x, y, d, type});
  }
}
template <class Visit> void each_bond_of_row(const Bonds& bonds, int y, const Visit& visit) {
  each_bond_of_row(bonds.grid, bonds.words, y, visit);
}

/// The same for all rows, upwards.
template <class Visit> void each_bond(const Bonds& bonds, const Visit& visit) {
  for (int y = 0; y < bonds.grid.height; ++y) each_bond_of_row(bonds, y, visit);
}

/// Displacements and node stresses sigma_i = 1/(2 V_i) sum f_ij (x) xi_ij, V_i = dx^2 (P II.C), in the map's order,
/// with the linearised stretch or P's.
StressField node_stress(const Bonds& bonds, double dx, const Field<double>& u, bool exact_stretch);

/// f := force of the bonds on every node per unit thickness, N/m, with P's stretch along the turned bond (P eq. 4 and
/// 6).
void exact_force(const Bonds& bonds, double dx, const Field<double>& u, Field<double>& f);

}  // namespace arenite::peridynamics
