#pragma once
#include <array>
#include <cstdint>

#include "model/phase_map.hpp"
#include "solid/peridynamics/buffer.hpp"
#include "solid/peridynamics/grid.hpp"
#include "solid/peridynamics/lattice.hpp"

namespace arenite::peridynamics {

/// Type of a bond, by what its two nodes are (P II.D): both matrix; both in one particle; otherwise interface. A void
/// node has no bonds.
enum BondType : unsigned { no_bond = 0, matrix_bond = 1, interface_bond = 2, particle_bond = 3 };

/// Young moduli of the bond types, Pa (P Table I: E_p = 4 E_m, E_i = E_m).
struct Stiffness {
  double matrix = 1, interface = 1, particle = 4;
  /// The micromodulus that gives the lattice's Young modulus along its axes; otherwise P's nominal one (eq. 5).
  bool calibrated = true;
};

/// All bonds of a sample: one word a node, two bits of type for each of its 14 half bonds, those in direction d at bits
/// 2d and 2d + 1. Nothing else is stored; a broken bond is one whose bits are cleared.
struct Bonds {
  /// What the 28 bonds of a node are, for 8 nodes at once: the kernels skip the empty and hasten over the uniform.
  enum Group : std::uint8_t { empty = 0, mixed = 4 };  // 1..3: all of that BondType

  Grid grid;
  Buffer<std::uint32_t> words;      ///< padded
  Buffer<std::uint8_t> group;       ///< grid.groups a row, not padded
  std::array<float, 4> relative{};  ///< modulus by type over `scale`
  double scale = 0;                 ///< micromodulus factor times the modulus of reference, Pa

  unsigned type(std::ptrdiff_t node, int d) const { return words[node] >> (2 * d) & 3u; }
  std::ptrdiff_t step(int d) const {
    return half_bonds[static_cast<unsigned>(d)].x + half_bonds[static_cast<unsigned>(d)].y * grid.stride;
  }
  /// Force over e (e . du)/|e|^3 of a bond of this type, Pa.
  double modulus(unsigned t) const { return scale * static_cast<double>(relative[t]); }
};

/// Bonds of a sample. Throws InputError for a map narrower than a node's neighbourhood (7 nodes) or a modulus that is
/// not positive. Moduli are held relative to the matrix's in single precision (exact for ratios such as 4 or 100).
Bonds make_bonds(const PhaseMap& map, const Stiffness& stiffness);

/// Marks groups anew after bonds were broken in rows [first, last].
void classify_groups(Bonds& bonds, int first, int last);

}  // namespace arenite::peridynamics
