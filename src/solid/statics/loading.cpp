#include "solid/statics/loading.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/problems.hpp"

namespace arenite::statics {

Vec2 direction_of(Loading loading) {
  constexpr Vec2 directions[] = {{0, 1}, {0, -1}, {1, 0}};
  return directions[static_cast<std::size_t>(loading)];
}

std::vector<std::uint8_t> prescribed_rows(int height, Loading loading, LowerEdge lower) {
  if (loading == Loading::shear && lower == LowerEdge::sliding)
    throw InputError("a sliding lower edge carries no shear; fix it, or choose tension or compression");
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(height), nothing_prescribed);
  rows.front() = lower == LowerEdge::sliding ? y_prescribed : both_prescribed;
  rows.back() = both_prescribed;
  return rows;
}

void check_load(double strain, double tolerance) {
  if (!(strain > 0) || !(strain < 1))
    throw refusal("the strain is {:g}; give one between 0 and 1 (the loading sets its direction)", strain);
  if (!(tolerance > 0) || !(tolerance < 1))
    throw refusal("the tolerance of the residual is {:g}; give one between 0 and 1", tolerance);
}

int usual_cap(double tolerance) { return static_cast<int>(std::ceil(50 * std::max(1.0, std::log10(tolerance) / -6))); }

namespace {

Vec2 row_sum(const Grid& grid, const Field<double>& f, int y) {
  Vec2 sum;
  for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) sum += f.at(i);
  return sum;
}

/// Mean slope of a displacement along an axis, by least squares over the carrying nodes of the middle half.
double slope(const LoadedSample& s, const Buffer<double>& u, bool along_x) {
  const Grid& grid = s.grid;
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

}  // namespace

void judge(const LoadedSample& s, const Field<double>& u, const Field<double>& f, LoadResult& result) {
  LoadReport& r = result.report;
  r.top_force = -row_sum(s.grid, f, s.grid.height - 1);
  r.bottom_force = -row_sum(s.grid, f, 0);
  const bool shear = s.loading == Loading::shear;
  const double force = shear ? r.top_force.x : r.top_force.y;
  double sum = 0;
  for (const double stress : shear ? result.field.xy : result.field.yy) sum += stress;
  if (force != 0) r.identity_defect = sum * s.dx * s.dx / (force * s.gauge) - 1;
  r.modulus = std::abs(force) / (s.width * s.strain);
  const double axial = shear ? 0 : slope(s, u.y, false);
  if (axial != 0) r.poisson = -slope(s, u.x, true) / axial;
}

Ending ending_of(const StaticReport& report) {
  return report.converged ? Ending::solved : report.stopped ? Ending::stopped : Ending::not_converged;
}

std::string sentence_of(Ending ending, const StaticReport& r, const Support& support, double tolerance,
                        const char* parts) {
  std::string text;
  switch (ending) {
    case Ending::empty: return "the map is all void: there is nothing to load";
    case Ending::severed:
      text = fmt::format("{} {} are connected to the lower clamp, {} to the upper one, and none to both; no stress",
                         support.held_below, parts, support.held_above);
      break;
    case Ending::solved:
      text = fmt::format("equilibrium to a relative residual of {:.1e} in {} iterations", r.residual, r.iterations);
      break;
    case Ending::stopped:
      text = fmt::format("stopped at a relative residual of {:.1e} after {} iterations", r.residual, r.iterations);
      break;
    case Ending::not_converged:
      text = fmt::format("no equilibrium: relative residual {:.1e} after {} iterations, above the tolerance of {:.0e}",
                         r.residual, r.iterations, tolerance);
      break;
  }
  if (support.floating > 0)
    text += fmt::format("; {} floating {} in {} islands without stress", support.floating, parts, support.islands);
  if (const std::size_t held = support.held_below + support.held_above; ending != Ending::severed && held > 0)
    text += fmt::format("; {} {} held on one side only, without stress", held, parts);
  return text;
}

std::string sentence_of(const LoadReport& r, double tolerance) {
  std::string text = sentence_of(r.ending, r, r.support, tolerance, "nodes");
  if (!r.hinges.empty() && r.ending != Ending::empty) {
    const auto carrying = std::find_if(r.hinges.begin(), r.hinges.end(), [](const Hinge& h) { return h.carries; });
    const Hinge& h = carrying != r.hinges.end() ? *carrying : r.hinges.front();
    text +=
        fmt::format("; {} hinges, one at node ({}, {}) with {} nodes behind it", r.hinges.size(), h.x, h.y, h.nodes);
    if (h.carries) text += ": it transmits the load";
  }
  return text;
}

EffectiveModuli effective_moduli(const PhaseMap& map, const Watch& watch,
                                 const std::function<LoadReport(const PhaseMap&, Loading, const Watch&)>& load) {
  EffectiveModuli m;
  bool going = true;
  const auto run = [&](std::size_t k, const PhaseMap& sample, Loading loading) {
    if (!going) return;
    Watch part;
    if (watch)
      part = [&watch, k](Progress p) {
        p.share = (static_cast<double>(k) + p.share) / 3;
        return watch(p);
      };
    m.reports[k] = load(sample, loading, part);
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

}  // namespace arenite::statics
