#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

#include "core/parameters.hpp"
#include "core/tensor.hpp"
#include "core/vec.hpp"
#include "grains/fields/coarse/grid.hpp"
#include "grains/fields/coarse/kernel.hpp"
#include "model/domain.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// Cells over the whole box, as square as whole numbers allow and no wider than `spacing`, m. Throws InputError for a
/// spacing that is none, and for more points than memory is for: `most_points` of the plane and of space.
template <int D> GridIn<D> grid_over(const Container<D>& domain, double spacing);
constexpr std::array most_points{32e6, 4e6};

/// Choices that the definitions leave open.
struct CoarseGraining {
  KernelShape kernel = KernelShape::lucy;
  double width = 0;
  std::optional<double> spacing;    ///< of the points of a grid that is made over the box; the width unless given
  std::optional<double> tilt_rate;  ///< of `Domain::tilt`; unset: the tilt moves with the width of the cell alone
};
void declare(ParameterVisitor& visitor, CoarseGraining& choice);

/// Continuum fields of one state at the points of a grid; all arrays have its size.
template <int D> struct CoarseFieldsIn {
  GridIn<D> grid;
  std::vector<double> density;               ///< rho, mass over volume, pores included, kg/m^3
  std::vector<double> solid_fraction;        ///< area or volume of grains over all, grains counted at their centres
  std::vector<Vec<D>> momentum;              ///< p, kg/(m^2 s)
  std::vector<Vec<D>> velocity;              ///< V = p/rho, m/s; NaN where no grain is in reach
  std::vector<Tensor<D>> velocity_gradient;  ///< dV_a/dx_b, 1/s; NaN where V is
  std::vector<Tensor<D>> contact_stress;     ///< Pa, tension positive; first index that of the force
  std::vector<Tensor<D>>
      kinetic_stress;  ///< of fluctuations about the mean flow, Pa, tension positive, so not positive on its diagonal
  std::vector<Tensor<D>> gradient_stress;  ///< of the mean flow's own differences within the width, Pa
  std::vector<Vec<D>> wall_force;          ///< of walls and boundaries on the grains, over volume, N/m^3
  /// Contact and kinetic stress at a point, Pa.
  Tensor<D> stress(std::size_t point) const {
    Tensor<D> whole = contact_stress[point];
    return whole += kinetic_stress[point];
  }
};
using CoarseFields = CoarseFieldsIn<2>;

/// Coarse-grained fields of a state (I. Goldhirsch, Granular Matter 12, 239, 2010), with phi the kernel and L the
/// thickness, in space 1:
///   rho(r) = sum m_i phi(r - r_i)/L,   p(r) = sum m_i v_i phi(r - r_i)/L,   V = p/rho,
///   contact stress(r) = sum over contacts f (x) l / L times the mean of phi(r - .) along the line from r_i to r_i + l,
///   kinetic stress(r) = -sum m_i (v_i - V(r_i)) (x) (v_i - V(r_i)) phi(r - r_i)/L,
///   gradient stress(r) = the same with V(r) in place of V(r_i), less the kinetic stress,
/// f the force on grain i and l its branch vector, to the centre of j or to the contact point on a wall. About V(r)
/// alone a flow without any fluctuation would have a kinetic stress, which grows with the width (R. Artoni and P.
/// Richard, Phys. Rev. E 91, 032202, 2015). They obey the balances of mass and momentum exactly: drho/dt + div p = 0
/// and dp_a/dt = d/dx_b (stress_ab - rho V_a V_b) + wall force (T. Weinhart et al., Granular Matter 14, 289, 2012) +
/// rho g, stress the sum of all three. Bonds and pulls across gaps bear as contacts do. Integrals over a
/// periodic cell are mass, momentum and the Love-Weber sum; near walls what the kernel smears lies beyond them too.
/// Images of a periodic cell that deforms move with it: at the rates of its edges and of its tilt. Throws InputError
/// without a box, a positive thickness, grid and width.
template <int D>
CoarseFieldsIn<D> coarse_grain(const PackingIn<D>& packing, const std::type_identity_t<GridIn<D>>& grid,
                               const CoarseGraining& choice);

/// How fast a stage sheared its cell at a time, 1/s, from its history; 0 where it did not.
double shear_rate_at(const History& history, double time);

/// Whether a state has what fields need: grains, a box and, of disks, its thickness.
template <int D> bool has_fields(const PackingIn<D>& packing);

/// The same at points over its whole box, `choice.spacing` apart.
template <int D> CoarseFieldsIn<D> coarse_grain(const PackingIn<D>& packing, const CoarseGraining& choice);

/// Fields of a state at the points of a grid, smeared by Lucy's function of that width (m).
template <int D>
CoarseFieldsIn<D> coarse_fields(const PackingIn<D>& packing, double shear_rate, double width, const GridIn<D>& grid);

}  // namespace arenite::fields
