#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/fields/kernel.hpp"
#include "model/packing.hpp"

namespace arenite::fields {

/// Points on a regular grid: the centres of equal cells of a rectangle, row by row from the bottom, each row from the left.
struct Grid {
  geometry::Rectangle bounds;
  int columns = 1, rows = 1;

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  double cell_area() const { return bounds.area() / (static_cast<double>(columns) * rows); }
  Vec2 point(int column, int row) const {
    return {bounds.x_min + (column + 0.5) * bounds.width() / columns, bounds.y_min + (row + 0.5) * bounds.height() / rows};
  }
};

/// Cells over the whole box, as square as whole numbers allow and no wider than `spacing`, m.
Grid grid_over(const Domain& domain, double spacing);

/// Choices that the definitions leave open.
struct CoarseGraining {
  KernelShape kernel = KernelShape::lucy;
  double width = 0;                 ///< standard deviation of the kernel along one axis, m
  std::optional<double> tilt_rate;  ///< rate of change of `Domain::tilt`, m/s; unset: the tilt moves with the width of the cell alone
};

/// Continuum fields of one state at the points of a grid; all arrays have its size.
struct CoarseFields {
  Grid grid;
  std::vector<double> density;             ///< rho, mass over volume, pores included, kg/m^3
  std::vector<double> solid_fraction;      ///< area of grains over area, grains counted at their centres
  std::vector<Vec2> momentum;              ///< p, kg/(m^2 s)
  std::vector<Vec2> velocity;              ///< V = p/rho, m/s; NaN where no grain is in reach
  std::vector<Tensor2> velocity_gradient;  ///< dV_a/dx_b, 1/s; NaN where V is
  std::vector<Tensor2> contact_stress;     ///< Pa, tension positive; first index that of the force
  std::vector<Tensor2> kinetic_stress;     ///< Pa, tension positive, so not positive on its diagonal
  std::vector<Vec2> wall_force;            ///< of walls and boundaries on the grains, over volume, N/m^3
};

/// Coarse-grained fields of a state (I. Goldhirsch, Granular Matter 12, 239, 2010), with phi the kernel and L the thickness:
///   rho(r) = sum m_i phi(r - r_i)/L,   p(r) = sum m_i v_i phi(r - r_i)/L,   V = p/rho,
///   contact stress(r) = sum over contacts f (x) l / L times the mean of phi(r - .) along the line from r_i to r_i + l,
///   kinetic stress(r) = -sum m_i (v_i - V(r)) (x) (v_i - V(r)) phi(r - r_i)/L,
/// f the force on grain i and l its branch vector, to the centre of j or to the contact point on a wall. They obey the balances of mass and
/// momentum exactly: drho/dt + div p = 0 and dp_a/dt = d/dx_b (stress_ab - rho V_a V_b) + wall force (T. Weinhart et al., Granular Matter
/// 14, 289, 2012) + rho g. Integrals over a periodic cell are mass, momentum and the Love-Weber sum; near walls what the kernel smears lies
/// beyond them too. Images of a periodic cell that deforms move with it: at the rates of its edges and of its tilt. Throws InputError
/// without a box, a positive thickness, grid and width.
CoarseFields coarse_grain(const Packing& packing, const Grid& grid, const CoarseGraining& choice);

}  // namespace arenite::fields
