#pragma once
#include <array>
#include <cstdint>

#include "solid/elements/modes.hpp"
#include "solid/statics/couplings.hpp"

namespace arenite::elements {

/// Elements of a coarse cell with the same aggregates, counted at up to three places along each axis.
struct CellShares {
  /// What the work of a mode is multiplied with: the members of Modes, and what turning takes of `shear`.
  enum Stiffness : std::uint8_t { axial, cross, shear, along, across, trilinear, third_shear, two_thirds_shear, count };
  static constexpr int most_places = 3;
  using Weights = Vector<double, 4>;  ///< of the places along x
  /// Sums of their stiffnesses: [stiffness][place along z, along y].
  std::array<std::array<Weights, most_places * most_places>, count> at;
};

/// Products along an axis of the two hats of a cell (of p) with the two of the same or the next cell (of q), each as a
/// mode has it that changes sign along the axis or does not.
struct AxisProducts {
  int places = 1, of_p = 2, of_q = 2;  ///< how many, and hats that are not zero
  /// [2 whether p's mode changes sign + q's][place][2 hat of p + hat of q]
  std::array<std::array<std::array<double, 4>, CellShares::most_places>, 4> at{};
};
using CellProducts = std::array<const AxisProducts*, 3>;

/// Adds what the elements couple of two aggregates whose hats are products of one along each axis.
using CellKernel = void (*)(const CellShares&, const CellProducts&, statics::CouplingIn<3>& to);
CellKernel cell_kernel();

}  // namespace arenite::elements
