#pragma once
#include <Eigen/Cholesky>

#include <vector>

#include "grains/texture/view.hpp"

namespace arenite::texture {

/// Mean forces by direction, as the sum of k forms of it that fits them best: of normal equations, row by row, whose
/// pivots differ by rounding alone from nothing where there are fewer directions than forms; then not known.
/// Anisotropies of forces do not inherit that of the counts.
template <int k> std::vector<double> fitted(const double* normal, const double* right, double rounding) {
  const Eigen::LDLT<Eigen::Matrix<double, k, k>> factors(Eigen::Map<const Eigen::Matrix<double, k, k>>{normal});
  const Eigen::Matrix<double, k, 1> pivots = factors.vectorD();
  if (!(pivots.minCoeff() > rounding * pivots.maxCoeff())) return std::vector<double>(k, unknown);
  const Eigen::Matrix<double, k, 1> form = factors.solve(Eigen::Map<const Eigen::Matrix<double, k, 1>>{right});
  return {form.data(), form.data() + k};
}

/// What the direction of the load follows from: what was said, or the forces.
template <int D> Trait by_load_axis(const ViewIn<D>& view) {
  return view.axis_is_given ? Trait::none : Trait::by_forces;
}

/// Directions of one set of contacts: a_c, the fabric tensor, anisotropies of forces, and by name what is of the plane
/// (angles, modes, sectors) or of space (axes, P_4, parts of the half sphere).
Numbers fabric_of(const View& view, const Items& items);
Numbers fabric_of(const SphereView& view, const Items& items);

}  // namespace arenite::texture
