#pragma once
#include <array>
#include <cmath>

namespace arenite::peridynamics {

/// Step from a node to a neighbour, in nodes.
struct Offset {
  int x, y;
};

/// Horizon h in units of dx (P II.C): 28 neighbours.
inline constexpr int horizon = 3;

/// One of each pair +-e of the 28 neighbours, grouped by direction; a bond belongs to the node that it starts from.
inline constexpr std::array<Offset, 14> half_bonds{{{1, 0},
                                                    {2, 0},
                                                    {3, 0},
                                                    {0, 1},
                                                    {0, 2},
                                                    {0, 3},
                                                    {1, 1},
                                                    {2, 2},
                                                    {-1, 1},
                                                    {-2, 2},
                                                    {2, 1},
                                                    {-2, 1},
                                                    {1, 2},
                                                    {-1, 2}}};
inline constexpr int bonds_per_node = 14;

/// |e| of a half bond.
inline double length(Offset e) { return std::sqrt(static_cast<double>(e.x * e.x + e.y * e.y)); }

/// The plane-stress micromodulus c = 6E/(pi h^3 (1 - nu)), nu = 1/3 (P eq. 5), times dx^3/E: with linearised stretch
/// the force of a bond on its node is (this) E e (e . du)/|e|^3 per unit thickness, e in nodes, whatever dx.
inline constexpr double nominal_micromodulus = 1.0 / (3.0 * 3.14159265358979323846);

/// Factor on the micromodulus that makes the lattice's Young modulus along its axes, c11 - c12^2/c11, the one asked for
/// (0.9394877). The elastic constants of the infinite homogeneous lattice are exact sums over the 28 bonds.
inline double calibration_factor() {
  double c11 = 0, c12 = 0;
  for (const auto e : half_bonds) {
    const double l3 = std::pow(length(e), 3), xx = e.x * e.x, yy = e.y * e.y;
    c11 +=
        nominal_micromodulus * (xx * xx + yy * yy) / 2 / l3;  // both axes, so that a half of the bonds stands for all
    c12 += nominal_micromodulus * xx * yy / l3;
  }
  return 1 / (c11 - c12 * c12 / c11);
}

}  // namespace arenite::peridynamics
