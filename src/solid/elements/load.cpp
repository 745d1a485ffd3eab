#include "solid/elements/load.hpp"

#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/support.hpp"
#include "solid/statics/static_solver.hpp"

namespace arenite::elements {
namespace {

/// Uniform strain where the sample carries; the clamp's displacement where it hangs on one only.
Field<double> first_guess(const Elements& elements, const Buffer<statics::Tie>& tie, Vec2 top) {
  const Grid& grid = elements.grid;
  Field<double> u(grid.padded_size());
  grid.each([&](std::ptrdiff_t i, int y) {
    double share = static_cast<double>(y) / (grid.height - 1);
    const bool clamped = y == 0 || y == grid.height - 1;
    if (!clamped && tie[i] != statics::Tie::both) share = tie[i] == statics::Tie::above ? 1 : 0;
    u.set(i, share * top);
  });
  return u;
}

}  // namespace

statics::LoadResult load(const PhaseMap& map, const LoadOptions& options) {
  statics::check_load(options.strain, options.tolerance);
  Elements elements = make_elements(map, options.material);
  const Grid& grid = elements.grid;
  const auto prescribed = statics::prescribed_rows(grid.height, options.loading, options.lower);
  Buffer<statics::Tie> tie;
  statics::LoadResult result;
  statics::LoadReport& r = result.report;
  r.support = prune(elements, tie);
  const double gauge = map.height * map.dx;
  Field<double> u = first_guess(elements, tie, options.strain * gauge * statics::direction_of(options.loading));
  if (r.support.carrying > 0) {
    statics::StaticSolver<Elements> solver(elements, cut_into_aggregates(map, elements, prescribed), prescribed);
    const int most = options.max_iterations > 0 ? options.max_iterations : statics::usual_cap(options.tolerance);
    static_cast<statics::StaticReport&>(r) = solver.solve(elements, u, options.tolerance, most, options.watch);
    r.ending = statics::ending_of(r);
  } else {
    r.ending = r.support.solid > 0 ? statics::Ending::severed : statics::Ending::empty;
  }
  result.field = pixel_stress(map, elements, u);
  if (r.support.carrying > 0) {
    Field<double> force(grid.padded_size());
    const std::vector<std::uint8_t> none(static_cast<std::size_t>(grid.height), statics::nothing_prescribed);
    kernels_of(elements).force(elements, none.data(), pointers(u), pointers(force));
    statics::judge({grid, tie, options.loading, options.strain, map.dx, gauge, map.width * map.dx}, u, force, result);
  }
  r.sentence = statics::sentence_of(r, options.tolerance);
  return result;
}

statics::EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options) {
  return statics::effective_moduli(map, options, load);
}

}  // namespace arenite::elements
