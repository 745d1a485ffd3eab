#include "solid/peridynamics/load.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "solid/peridynamics/bonded_aggregates.hpp"
#include "solid/peridynamics/dynamics.hpp"
#include "solid/peridynamics/exact_stretch.hpp"
#include "solid/peridynamics/hinges.hpp"
#include "solid/peridynamics/support.hpp"

namespace arenite::peridynamics {
namespace {

/// A sample with what carries, ready to be solved.
struct Specimen {
  const PhaseMap& map;
  const LoadOptions& options;
  Bonds bonds;
  std::vector<std::uint8_t> prescribed;
  Aggregates aggregates;
  Buffer<Tie> tie;
  Support support;
  Vec2 top_displacement;

  Specimen(const PhaseMap& m, const LoadOptions& o)
      : map(m),
        options(o),
        bonds(make_bonds(m, o.stiffness, o.law, o.stop_at_voids)) {
    prescribed = statics::prescribed_levels<2>(map.height, o.loading, o.lower);
    aggregates = cut_into_aggregates(map, bonds, prescribed);
    support = prune(bonds, aggregates, prescribed, tie);
    top_displacement = o.strain * gauge() * statics::direction_of<2>(o.loading);
  }

  double gauge() const { return (map.height - 1) * map.dx; }

  Field<double> first_guess() const {
    Field<double> u = statics::uniform_strain(bonds.grid, tie, top_displacement);
    auto phase = map.phase.begin();
    bonds.grid.each([&](std::ptrdiff_t i, int) {
      if (*phase++ == Phase::empty) u.set(i, {});
    });
    return u;
  }

  Field<double> force(const Field<double>& u) const {
    Field<double> f(bonds.grid.padded_size());
    if (options.exact_stretch) exact_force(bonds, map.dx, u, f);
    else linear_force(bonds, u, f);
    return f;
  }
};

StaticReport find_equilibrium(Specimen& s, Field<double>& u) {
  const LoadOptions& o = s.options;
  if (o.method == Method::static_solve) {
    const int most = o.max_iterations > 0 ? o.max_iterations : statics::usual_cap(o.tolerance);
    StaticSolver solver(s.bonds, std::move(s.aggregates), s.prescribed);
    return o.exact_stretch ? solve_exact_stretch(s.bonds, s.map.dx, s.prescribed, solver, u, o.tolerance, most, o.watch)
                           : solver.solve(s.bonds, u, o.tolerance, most, o.watch);
  }
  const int most = o.max_iterations > 0 ? o.max_iterations : usual_steps;
  const Dynamics dynamics{s.bonds, s.prescribed, s.map.dx, o.exact_stretch, o.tolerance, most, o.watch};
  return o.method == Method::relaxation ? adaptive_relaxation(dynamics, u) : damped_dynamics(dynamics, u);
}

}  // namespace

LoadResult load(const PhaseMap& map, const LoadOptions& options) {
  statics::check_load(options.strain, options.tolerance);
  Specimen s(map, options);
  LoadResult result;
  LoadReport& r = result.report;
  r.support = s.support;
  Field<double> u = s.first_guess();
  if (s.support.carrying > 0) {
    static_cast<StaticReport&>(r) = find_equilibrium(s, u);
    r.ending = statics::ending_of(r);
    const bool suspicious = r.ending == Ending::not_converged || r.loose_nodes > 0 ||
                            (options.method == Method::static_solve && r.iterations > 25);
    if (options.look_for_hinges || suspicious) r.hinges = find_hinges(s.bonds);
  } else {
    const bool any = std::any_of(map.phase.begin(), map.phase.end(), [](Phase p) { return p != Phase::empty; });
    r.ending = any ? Ending::severed : Ending::empty;
  }
  result.field = node_stress(s.bonds, map.dx, u, options.exact_stretch);
  if (s.support.carrying > 0)
    statics::judge({s.bonds.grid, s.tie, options.loading, options.strain, map.dx, s.gauge(), section_of(map)}, u,
                   s.force(u), result);
  r.sentence = statics::sentence_of(r, options.tolerance);
  return result;
}

EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options) {
  return statics::effective_moduli(map, options, load);
}

}  // namespace arenite::peridynamics
