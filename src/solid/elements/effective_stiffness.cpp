#include "solid/elements/effective_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/threads.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/support.hpp"
#include "solid/statics/static_solver.hpp"

namespace arenite::elements {
namespace {

/// Bulk and shear modulus of C_11 and C_66 in modes.
template <int D> elasticity::BulkAndShear<D> moduli_of(const Modes<D>& m) {
  const double scale = 1 << (2 * (D - 1));
  return {scale * (m.axial + (D - 1) * m.cross) / D, scale * m.shear};
}

template <int D> elasticity::BoundsIn<D> bounds_of(const ElementsIn<D>& elements) {
  std::array<double, 4> count{};
  elements.each([&](int x, int y, int z) { count[elements.kind(elements.grid.index(x, y, z))] += 1; });
  std::vector<elasticity::PhaseShare<D>> shares;
  for (const Kind kind : {none, matrix, interface, particle})
    shares.push_back({count[kind] / static_cast<double>(elements.count()), moduli_of<D>(elements.modes[kind])});
  return elasticity::bounds(shares);
}

/// The forces that a uniform strain itself leaves: its displacements are linear beyond the period too.
template <int D> FieldIn<D, double> forces_of_strain(const ElementsIn<D>& elements, const Voigt<D>& strain, double dx) {
  const Grid& grid = elements.grid;
  std::array<Vec<D>, D> gradient{};  // half of the strains of shear each way: no rotation
  for (std::size_t k = 0; k < strain.size(); ++k) {
    const auto [a, b] = voigt_axes<D>[k];
    gradient[static_cast<std::size_t>(a)][b] = gradient[static_cast<std::size_t>(b)][a] =
        a == b ? strain[k] : strain[k] / 2;
  }
  FieldIn<D, double> linear(grid.padded_size());
  for (int z = D > 2 ? -1 : 0; z <= (D > 2 ? grid.depth : 0); ++z)
    for (int y = -1; y <= grid.height; ++y)
      for (int x = -1; x <= grid.width; ++x) {
        const std::array<int, 3> at{x, y, z};
        Vec<D> u;
        for (std::size_t axis = 0; axis < D; ++axis) u += (at[axis] * dx) * gradient[axis];
        linear.set(grid.index(x, y, z), u);
      }
  return forces_of(elements, linear);
}

/// Coarse cells that fit a period, as near to what was asked for as there are.
template <int D> int side_in_period(const std::array<int, 3>& cells, int wanted) {
  for (const int more : {0, 1, -1, 2, -2, 3, -3, 4})
    if (const int side = wanted + more; side >= 3)
      if (std::all_of(cells.begin(), cells.begin() + D, [&](int count) { return count % side == 0; })) return side;
  return wanted;
}

template <int D> EffectiveStiffness<D> effective_stiffness_in(const MapIn<D>& map, const SolveOptions& options) {
  statics::check_load(1e-4, options.tolerance);
  const ThreadPool pool(D > 2 ? options.threads : 1);
  ElementsIn<D> elements = make_elements<D>(map, options.material, true, &pool);
  EffectiveStiffness<D> result;
  result.bounds = bounds_of(elements);
  result.support = prune_periodic(elements);
  if (result.support.carrying == 0) return result;
  const Grid& grid = elements.grid;
  const std::vector<std::uint8_t> free(static_cast<std::size_t>(grid.levels()), statics::nothing_prescribed);
  const int side = side_in_period<D>(elements.cells, coarse_side<D>(options, elements.count()));
  statics::StaticSolver<ElementsIn<D>> solver(elements, cut_into_aggregates<D>(map, elements, free, side), free);
  const int longest = *std::max_element(elements.cells.begin(), elements.cells.end());
  for (std::size_t k = 0; k < voigt_count<D>; ++k) {
    Voigt<D> strain{};
    strain[k] = 1;
    const FieldIn<D, double> body = forces_of_strain(elements, strain, map.dx);
    FieldIn<D, double> u(grid.padded_size());
    // One material answers with itself: what is left is the rounding of the displacements.
    const double rounding = 1e-12 * elements.modes[particle].axial * map.dx * longest;
    const double left = std::sqrt(statics::square_norm(grid, body) / static_cast<double>(elements.count()));
    if (left < rounding) result.solves[k].converged = true;
    else
      result.solves[k] = solver.solve(elements, u, options.tolerance, most_iterations<D>(options),
                                      statics::of_part(options.watch, k, voigt_count<D>), &body);
    if (result.solves[k].stopped) return result;
    const Voigt<D> stress = mean_stress(elements, u, strain, map.dx);
    for (std::size_t row = 0; row < stress.size(); ++row) result.stiffness[row][k] = stress[row];
  }
  return result;
}

}  // namespace

EffectiveStiffness<2> effective_stiffness(const PhaseMap& map, const SolveOptions& options) {
  return effective_stiffness_in<2>(map, options);
}
EffectiveStiffness<3> effective_stiffness(const VoxelMap& map, const SolveOptions& options) {
  return effective_stiffness_in<3>(map, options);
}

}  // namespace arenite::elements
