#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/parameters.hpp"
#include "core/vec.hpp"
#include "geometry/rectangle.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// What a point is smeared out into.
enum class KernelShape {
  lucy,  ///< 5/(pi c^2) (1 + 3 r/c)(1 - r/c)^3, zero beyond c: two continuous derivatives (L. B. Lucy, Astron. J. 82,
         ///< 1013, 1977)
  gaussian  ///< exp(-r^2/2w^2)/(2 pi w^2): smooth to all orders, reaches far
};

/// A coarse-graining function of the plane: not negative, the same in all directions, of integral 1. `width` is the
/// standard deviation along one axis for either shape, m, so that fields of one width compare; for Lucy's function c =
/// sqrt(56/5) width.
class Kernel {
 public:
  /// Throws InputError unless the width is positive and finite.
  Kernel(KernelShape shape, double width);

  /// Distance beyond which the function is zero, or below 2.1e-16 of its maximum (Gaussian, 8.5 widths), m.
  double reach() const { return reach_; }

  /// phi at a vector from the centre, 1/m^2.
  double value(Vec2 d) const;

  /// Gradient of phi there, 1/m^3.
  Vec2 gradient(Vec2 d) const;

  /// Mean of phi along a straight line, integral over s in [0, 1] of phi(from + s (to - from)), in closed form, 1/m^2.
  double line_mean(Vec2 from, Vec2 to) const;

 private:
  KernelShape shape_;
  double width_, reach_;
};

/// Points on a regular grid: the centres of equal cells of a rectangle, row by row from the bottom, each row from the
/// left.
struct Grid {
  geometry::Rectangle bounds;
  int columns = 1, rows = 1;

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  double cell_area() const { return bounds.area() / (static_cast<double>(columns) * rows); }
  std::vector<double> lines_x() const;  ///< places of the columns
  std::vector<double> lines_y() const;  ///< and of the rows
  Vec2 point(int column, int row) const {
    return {bounds.x_min + (column + 0.5) * bounds.width() / columns,
            bounds.y_min + (row + 0.5) * bounds.height() / rows};
  }
};

/// Cells over the whole box, as square as whole numbers allow and no wider than `spacing`, m.
Grid grid_over(const Domain& domain, double spacing);

/// Choices that the definitions leave open.
struct CoarseGraining {
  KernelShape kernel = KernelShape::lucy;
  double width = 0;
  std::optional<double> spacing;    ///< of the points of a grid that is made over the box; the width unless given
  std::optional<double> tilt_rate;  ///< of `Domain::tilt`; unset: the tilt moves with the width of the cell alone
};
void declare(ParameterVisitor& visitor, CoarseGraining& choice);

/// Continuum fields of one state at the points of a grid; all arrays have its size.
struct CoarseFields {
  Grid grid;
  std::vector<double> density;             ///< rho, mass over volume, pores included, kg/m^3
  std::vector<double> solid_fraction;      ///< area of grains over area, grains counted at their centres
  std::vector<Vec2> momentum;              ///< p, kg/(m^2 s)
  std::vector<Vec2> velocity;              ///< V = p/rho, m/s; NaN where no grain is in reach
  std::vector<Tensor2> velocity_gradient;  ///< dV_a/dx_b, 1/s; NaN where V is
  std::vector<Tensor2> contact_stress;     ///< Pa, tension positive; first index that of the force
  std::vector<Tensor2>
      kinetic_stress;  ///< of fluctuations about the mean flow, Pa, tension positive, so not positive on its diagonal
  std::vector<Tensor2> gradient_stress;  ///< of the mean flow's own differences within the width, Pa
  std::vector<Vec2> wall_force;          ///< of walls and boundaries on the grains, over volume, N/m^3
  /// Contact and kinetic stress at a point, Pa.
  Tensor2 stress(std::size_t point) const {
    Tensor2 whole = contact_stress[point];
    return whole += kinetic_stress[point];
  }
};

/// Coarse-grained fields of a state (I. Goldhirsch, Granular Matter 12, 239, 2010), with phi the kernel and L the
/// thickness:
///   rho(r) = sum m_i phi(r - r_i)/L,   p(r) = sum m_i v_i phi(r - r_i)/L,   V = p/rho,
///   contact stress(r) = sum over contacts f (x) l / L times the mean of phi(r - .) along the line from r_i to r_i + l,
///   kinetic stress(r) = -sum m_i (v_i - V(r_i)) (x) (v_i - V(r_i)) phi(r - r_i)/L,
///   gradient stress(r) = the same with V(r) in place of V(r_i), less the kinetic stress,
/// f the force on grain i and l its branch vector, to the centre of j or to the contact point on a wall. About V(r)
/// alone a flow without any fluctuation would have a kinetic stress, which grows with the width (R. Artoni and P.
/// Richard, Phys. Rev. E 91, 032202, 2015). They obey the balances of mass and momentum exactly: drho/dt + div p = 0
/// and dp_a/dt = d/dx_b (stress_ab - rho V_a V_b) + wall force (T. Weinhart et al., Granular Matter 14, 289, 2012) +
/// rho g, stress the sum of all three. Integrals over a periodic cell are mass, momentum and the Love-Weber sum; near
/// walls what the kernel smears lies beyond them too. Images of a periodic cell that deforms move with it: at the rates
/// of its edges and of its tilt. Throws InputError without a box, a positive thickness, grid and width.
CoarseFields coarse_grain(const Packing& packing, const Grid& grid, const CoarseGraining& choice);

/// How fast a stage sheared its cell at a time, 1/s, from its history; 0 where it did not.
double shear_rate_at(const History& history, double time);

/// Whether a state has what fields need: grains, a box and its thickness.
bool has_fields(const Packing& packing);

/// The same at points over its whole box, `choice.spacing` apart.
CoarseFields coarse_grain(const Packing& packing, const CoarseGraining& choice);

/// Fields of a state over its whole box, smeared by Lucy's function of that width, at points so far apart (m).
CoarseFields coarse_fields(const Packing& packing, double shear_rate, double width, double spacing);

}  // namespace arenite::fields
