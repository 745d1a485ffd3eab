#include "solid/peridynamics/load.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/problems.hpp"
#include "solid/peridynamics/hinges.hpp"
#include "solid/peridynamics/solvers/dynamics.hpp"
#include "solid/peridynamics/solvers/residual.hpp"
#include "solid/peridynamics/solvers/static_solver.hpp"
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
    prescribed = prescribed_rows(map.height, o.loading, o.lower);
    aggregates = cut_into_aggregates(map, bonds, prescribed);
    support = prune(bonds, aggregates, prescribed, tie);
    top_displacement = o.strain * gauge() * direction_of(o.loading);
  }

  double gauge() const { return (map.height - 1) * map.dx; }

  /// Uniform strain where the sample carries; the clamp's displacement where it hangs on one only.
  Field<double> first_guess() const {
    const Grid& grid = bonds.grid;
    Field<double> u(grid.padded_size());
    auto phase = map.phase.begin();
    grid.each([&](std::ptrdiff_t i, int y) {
      if (*phase++ == Phase::empty) return;
      double share = static_cast<double>(y) / (grid.height - 1);
      if (!prescribed[y] && tie[i] != Tie::both) share = tie[i] == Tie::above ? 1 : 0;
      u.set(i, share * top_displacement);
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

/// Iterations after which a static solve is given up: 50 for the six decades of the usual tolerance, more for more.
int usual_cap(double tolerance) { return static_cast<int>(std::ceil(50 * std::max(1.0, std::log10(tolerance) / -6))); }

StaticReport find_equilibrium(Specimen& s, Field<double>& u) {
  const LoadOptions& o = s.options;
  if (o.method == Method::static_solve) {
    const int most = o.max_iterations > 0 ? o.max_iterations : usual_cap(o.tolerance);
    StaticSolver solver(s.bonds, std::move(s.aggregates), s.prescribed);
    return o.exact_stretch ? solve_exact_stretch(s.bonds, s.map.dx, s.prescribed, solver, u, o.tolerance, most, o.watch)
                           : solver.solve(s.bonds, u, o.tolerance, most, o.watch);
  }
  const int most = o.max_iterations > 0 ? o.max_iterations : 1'000'000;
  const Dynamics dynamics{s.bonds, s.prescribed, s.map.dx, o.exact_stretch, o.tolerance, most, o.watch};
  return o.method == Method::relaxation ? adaptive_relaxation(dynamics, u) : damped_dynamics(dynamics, u);
}

Vec2 row_sum(const Grid& grid, const Field<double>& f, int y) {
  Vec2 sum;
  for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) sum += f.at(i);
  return sum;
}

/// Mean slope of a displacement along an axis, by least squares over the carrying nodes of the middle half.
double slope(const Specimen& s, const Buffer<double>& u, bool along_x) {
  const Grid& grid = s.bonds.grid;
  double n = 0, sp = 0, spp = 0, su = 0, spu = 0;
  for (int y = grid.height / 4; y < grid.height - grid.height / 4; ++y)
    for (int x = grid.width / 4; x < grid.width - grid.width / 4; ++x) {
      const std::ptrdiff_t i = grid.index(x, y);
      if (s.tie[i] != Tie::both) continue;
      const double p = along_x ? x : y;
      n += 1;
      sp += p;
      spp += p * p;
      su += u[i];
      spu += p * u[i];
    }
  const double spread = n * spp - sp * sp;
  return spread > 0 ? (n * spu - sp * su) / spread : 0;
}

void judge(const Specimen& s, const Field<double>& u, LoadResult& result) {
  LoadReport& r = result.report;
  const Field<double> f = s.force(u);
  r.top_force = -row_sum(s.bonds.grid, f, s.map.height - 1);
  r.bottom_force = -row_sum(s.bonds.grid, f, 0);
  const bool shear = s.options.loading == Loading::shear;
  const double force = shear ? r.top_force.x : r.top_force.y;
  double sum = 0;
  for (const double stress : shear ? result.field.xy : result.field.yy) sum += stress;
  if (force != 0) r.identity_defect = sum * s.map.dx * s.map.dx / (force * s.gauge()) - 1;
  r.modulus = std::abs(force) / (s.map.width * s.map.dx * s.options.strain);
  const double axial = shear ? 0 : slope(s, u.y, false);
  if (axial != 0) r.poisson = -slope(s, u.x, true) / axial;
}

std::string sentence_of(const LoadReport& r, const LoadOptions& o) {
  std::string text;
  switch (r.ending) {
    case Ending::empty: return "the map is all void: there is nothing to load";
    case Ending::severed:
      text = fmt::format("{} nodes are connected to the lower clamp, {} to the upper one, and none to both; no stress",
                         r.support.held_below, r.support.held_above);
      break;
    case Ending::solved:
      text = fmt::format("equilibrium to a relative residual of {:.1e} in {} iterations", r.residual, r.iterations);
      break;
    case Ending::stopped:
      text = fmt::format("stopped at a relative residual of {:.1e} after {} iterations", r.residual, r.iterations);
      break;
    case Ending::not_converged:
      text = fmt::format("no equilibrium: relative residual {:.1e} after {} iterations, above the tolerance of {:.0e}",
                         r.residual, r.iterations, o.tolerance);
      break;
  }
  if (r.support.floating > 0)
    text += fmt::format("; {} floating nodes in {} islands without stress", r.support.floating, r.support.islands);
  if (r.ending != Ending::severed && r.support.held_below + r.support.held_above > 0)
    text +=
        fmt::format("; {} nodes held on one side only, without stress", r.support.held_below + r.support.held_above);
  if (!r.hinges.empty()) {
    const auto carrying = std::find_if(r.hinges.begin(), r.hinges.end(), [](const Hinge& h) { return h.carries; });
    const Hinge& h = carrying != r.hinges.end() ? *carrying : r.hinges.front();
    text +=
        fmt::format("; {} hinges, one at node ({}, {}) with {} nodes behind it", r.hinges.size(), h.x, h.y, h.nodes);
    if (h.carries) text += ": it transmits the load";
  }
  return text;
}

void check(const LoadOptions& o) {
  if (!(o.strain > 0) || !(o.strain < 1))
    throw refusal("the strain is {:g}; give one between 0 and 1 (the loading sets its direction)", o.strain);
  if (!(o.tolerance > 0) || !(o.tolerance < 1))
    throw refusal("the tolerance of the residual is {:g}; give one between 0 and 1", o.tolerance);
}

}  // namespace

LoadResult load(const PhaseMap& map, const LoadOptions& options) {
  check(options);
  Specimen s(map, options);
  LoadResult result;
  LoadReport& r = result.report;
  r.support = s.support;
  Field<double> u = s.first_guess();
  if (s.support.carrying > 0) {
    static_cast<StaticReport&>(r) = find_equilibrium(s, u);
    r.ending = r.converged ? Ending::solved : r.stopped ? Ending::stopped : Ending::not_converged;
    const bool suspicious = r.ending == Ending::not_converged || r.loose_nodes > 0 ||
                            (options.method == Method::static_solve && r.iterations > 25);
    if (options.look_for_hinges || suspicious) r.hinges = find_hinges(s.bonds);
  } else {
    const bool any = std::any_of(map.phase.begin(), map.phase.end(), [](Phase p) { return p != Phase::empty; });
    r.ending = any ? Ending::severed : Ending::empty;
  }
  result.field = node_stress(s.bonds, map.dx, u, options.exact_stretch);
  if (s.support.carrying > 0) judge(s, u, result);
  r.sentence = sentence_of(r, options);
  return result;
}

EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options) {
  EffectiveModuli m;
  bool going = true;
  const auto run = [&](std::size_t k, const PhaseMap& sample, Loading loading) {
    if (!going) return;
    LoadOptions o = options;
    o.loading = loading;
    if (loading == Loading::shear) o.lower = LowerEdge::fixed;
    if (options.watch)
      o.watch = [&, k](Progress p) {
        p.share = (static_cast<double>(k) + p.share) / 3;
        return options.watch(p);
      };
    m.reports[k] = load(sample, o).report;
    going = m.reports[k].ending != Ending::stopped;
  };
  run(0, transposed(map), Loading::tension);
  run(1, map, Loading::tension);
  run(2, map, Loading::shear);
  if (!going) return m;
  m.young_x = m.reports[0].modulus;
  m.poisson_xy = m.reports[0].poisson;
  m.young_y = m.reports[1].modulus;
  m.poisson_yx = m.reports[1].poisson;
  m.shear = m.reports[2].modulus;
  return m;
}

}  // namespace arenite::peridynamics
