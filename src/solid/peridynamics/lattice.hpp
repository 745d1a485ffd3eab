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
inline constexpr std::array<Offset, 14> half_bonds{
    {{1, 0}, {2, 0}, {3, 0}, {0, 1}, {0, 2}, {0, 3}, {1, 1}, {2, 2}, {-1, 1}, {-2, 2}, {2, 1}, {-2, 1}, {1, 2}, {-1, 2}}};
inline constexpr int bonds_per_node = 14;

/// |e| of a half bond.
inline double length(Offset e) { return std::sqrt(static_cast<double>(e.x * e.x + e.y * e.y)); }

/// The plane-stress micromodulus c = 6E/(pi h^3 (1 - nu)), nu = 1/3 (P eq. 5), times dx^3/E: with linearised stretch
/// the force of a bond on its node is (this) E e (e . du)/|e|^3 per unit thickness, e in nodes, whatever dx.
inline constexpr double nominal_micromodulus = 1.0 / (3.0 * 3.14159265358979323846);

/// Elastic constants of the infinite homogeneous lattice for E = 1: exact sums over the 28 bonds.
struct LatticeModuli {
  double c1111, c1122;              ///< c1212 = c1122 in any bond lattice
  double young_axis, poisson_axis;  ///< along x or y
  double young_diagonal, poisson_diagonal;
};
LatticeModuli lattice_moduli(double micromodulus = nominal_micromodulus);

/// Factor on the micromodulus that makes the lattice's Young modulus along its axes the one asked for (0.9394877).
double calibration_factor();

}  // namespace arenite::peridynamics
