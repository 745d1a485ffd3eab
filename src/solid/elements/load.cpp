#include "solid/elements/load.hpp"

#include <cstdint>
#include <vector>

#include "core/problems.hpp"
#include "core/threads.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/stress.hpp"
#include "solid/elements/support.hpp"
#include "solid/statics/static_solver.hpp"

namespace arenite::elements {
/// Images of porous matter without grains take a few times as many iterations as packings.
template <int D> int most_iterations(const SolveOptions& options) {
  if (options.max_iterations > 0) return options.max_iterations;
  return statics::usual_cap(options.tolerance, D);
}

/// With wider cells a sample in space takes a few iterations more, in as much time; where it is large they spare
/// memory.
template <int D> int coarse_side(const SolveOptions& options, std::size_t elements) {
  if (options.cell > 0) return options.cell;
  if (D == 2) return Aggregates::cell;
  constexpr std::size_t large = std::size_t{1} << 23;
  return elements < large ? 8 : elements < 8 * large ? 12 : 16;
}

template <int D> FieldIn<D, double> forces_of(const ElementsIn<D>& elements, const FieldIn<D, double>& u) {
  FieldIn<D, double> force(elements.grid.padded_size());
  const std::vector<std::uint8_t> free(static_cast<std::size_t>(elements.grid.levels()), statics::nothing_prescribed);
  kernels_of(elements).force(elements, free.data(), statics::pointers(u), statics::pointers(force));
  return force;
}

namespace {

template <int D>
statics::StaticReport solve_here(const MapIn<D>& map, const ElementsIn<D>& elements,
                                 const std::vector<std::uint8_t>& prescribed, const LoadOptions& options,
                                 FieldIn<D, double>& u) {
  statics::StaticSolver<ElementsIn<D>> solver(
      elements, cut_into_aggregates<D>(map, elements, prescribed, coarse_side<D>(options, elements.count())),
      prescribed);
  return solver.solve(elements, u, options.tolerance, most_iterations<D>(options), options.watch);
}

statics::StaticReport equilibrium(const PhaseMap& map, const Elements& elements,
                                  const std::vector<std::uint8_t>& prescribed, const LoadOptions& options,
                                  FieldIn<2, double>& u) {
  return solve_here<2>(map, elements, prescribed, options, u);
}
statics::StaticReport equilibrium(const VoxelMap& map, const Voxels& elements,
                                  const std::vector<std::uint8_t>& prescribed, const LoadOptions& options,
                                  FieldIn<3, double>& u) {
  if (!options.solver) return solve_here<3>(map, elements, prescribed, options, u);
  return options.solver->solve(elements, prescribed, u, options.tolerance, most_iterations<3>(options), options.watch);
}

template <int D> statics::LoadResultIn<D> load_in(const MapIn<D>& map, const LoadOptions& options) {
  statics::check_load(options.strain, options.tolerance);
  const ThreadPool pool(D > 2 ? options.threads : 1);
  ElementsIn<D> elements = make_elements<D>(map, options.material, false, &pool);
  if (elements.cells[D - 1] < 2)
    throw refusal("one {0} lies between the clamps, which hold all of it; give two {0}s or more{1}",
                  D == 2 ? "row" : "layer", D == 2 ? "" : ", or load it as a picture");
  const Grid& grid = elements.grid;
  const auto prescribed = statics::prescribed_levels<D>(grid.levels(), options.loading, options.lower);
  Buffer<statics::Tie> tie;
  statics::LoadResultIn<D> result;
  statics::LoadReportIn<D>& r = result.report;
  r.support = prune(elements, tie);
  const double gauge = elements.cells[D - 1] * map.dx;
  FieldIn<D, double> u =
      statics::uniform_strain<D>(grid, tie, options.strain * gauge * statics::direction_of<D>(options.loading));
  if (r.support.carrying > 0) {
    static_cast<statics::StaticReport&>(r) = equilibrium(map, elements, prescribed, options, u);
    r.ending = statics::ending_of(r);
  } else {
    r.ending = r.support.solid > 0 ? statics::Ending::severed : statics::Ending::empty;
  }
  result.field = element_stress<D>(map, elements, u);
  if (r.support.carrying > 0) {
    double section = 1;
    for (std::size_t axis = 0; axis + 1 < D; ++axis) section *= elements.cells[axis] * map.dx;
    statics::judge<D>({grid, tie, options.loading, options.strain, map.dx, gauge, section}, u, forces_of(elements, u),
                      result);
  }
  r.sentence = statics::sentence_of(r.ending, r, r.support, options.tolerance, D == 2 ? "nodes" : "voxels");
  return result;
}

}  // namespace

statics::LoadResult load(const PhaseMap& map, const LoadOptions& options) { return load_in<2>(map, options); }
statics::LoadResultIn<3> load(const VoxelMap& map, const LoadOptions& options) { return load_in<3>(map, options); }

statics::EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options) {
  return statics::effective_moduli(map, options, load);
}

template int most_iterations<2>(const SolveOptions& options);
template int most_iterations<3>(const SolveOptions& options);
template int coarse_side<2>(const SolveOptions& options, std::size_t elements);
template int coarse_side<3>(const SolveOptions& options, std::size_t elements);
template FieldIn<2, double> forces_of(const Elements& elements, const FieldIn<2, double>& u);
template FieldIn<3, double> forces_of(const Voxels& elements, const FieldIn<3, double>& u);

}  // namespace arenite::elements
