#include "solid/statics/loading.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/problems.hpp"

namespace arenite::statics {

template <int D> Vec<D> direction_of(Loading loading) {
  Vec<D> direction;
  if (loading == Loading::shear) direction[0] = 1;
  else direction[D - 1] = loading == Loading::tension ? 1 : -1;
  return direction;
}

template <int D> std::vector<std::uint8_t> prescribed_levels(int levels, Loading loading, LowerEdge lower) {
  if (loading == Loading::shear && lower == LowerEdge::sliding)
    throw InputError("a sliding lower edge carries no shear; fix it, or choose tension or compression");
  std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(levels), nothing_prescribed);
  prescribed.front() = lower == LowerEdge::sliding ? normal_component<D> : every_component<D>;
  prescribed.back() = every_component<D>;
  return prescribed;
}

void check_load(double strain, double tolerance) {
  if (!(strain > 0) || !(strain < 1))
    throw refusal("the strain is {:g}; give one between 0 and 1 (the loading sets its direction)", strain);
  if (!(tolerance > 0) || !(tolerance < 1))
    throw refusal("the tolerance of the residual is {:g}; give one between 0 and 1", tolerance);
}

int usual_cap(double tolerance, int dimension) {
  return (dimension == 3 ? 4 : 1) * static_cast<int>(std::ceil(50 * std::max(1.0, std::log10(tolerance) / -6)));
}

template <int D> FieldIn<D, double> uniform_strain(const Grid& grid, const Buffer<Tie>& tie, Vec<D> top) {
  FieldIn<D, double> u(grid.padded_size());
  const int last = grid.levels() - 1;
  grid.each([&](std::ptrdiff_t i, int level) {
    double share = static_cast<double>(level) / last;
    const bool clamped = level == 0 || level == last;
    if (!clamped && tie[i] != Tie::both) share = tie[i] == Tie::above ? 1 : 0;
    u.set(i, share * top);
  });
  return u;
}

namespace {

/// Mean slope of a displacement along an axis, by least squares over the carrying nodes of the middle half.
double slope(const LoadedSample& s, const Buffer<double>& u, std::size_t axis) {
  const std::array<int, 3> size = s.grid.size();
  const auto skipped = [&](std::size_t a) { return size[a] / 4; };
  double n = 0, sp = 0, spp = 0, su = 0, spu = 0;
  for (int z = skipped(2); z < size[2] - skipped(2); ++z)
    for (int y = skipped(1); y < size[1] - skipped(1); ++y)
      for (int x = skipped(0); x < size[0] - skipped(0); ++x) {
        const std::ptrdiff_t i = s.grid.index(x, y, z);
        if (s.tie[i] != Tie::both) continue;
        const double p = std::array{x, y, z}[axis];
        n += 1;
        sp += p;
        spp += p * p;
        su += u[i];
        spu += p * u[i];
      }
  const double spread = n * spp - sp * sp;
  return spread > 0 ? (n * spu - sp * su) / spread : 0;
}

/// The stress along the load.
const std::vector<double>& stress_along(const StressField& field, bool shear) { return shear ? field.xy : field.yy; }
const std::vector<float>& stress_along(const VoxelStress& field, bool shear) { return shear ? field.xz : field.zz; }

}  // namespace

template <int D>
void judge(const LoadedSample& s, const FieldIn<D, double>& u, const FieldIn<D, double>& f, LoadResultIn<D>& result) {
  LoadReportIn<D>& r = result.report;
  const double of_node = D == 2 ? 1 : s.dx;  // an element of side dx has dx^(D-2) times the stiffness of unit side
  s.grid.each([&](std::ptrdiff_t i, int level) {
    if (level == 0) r.bottom_force -= of_node * f.at(i);
    if (level == s.grid.levels() - 1) r.top_force -= of_node * f.at(i);
  });
  const bool shear = s.loading == Loading::shear;
  const double force = shear ? r.top_force[0] : r.top_force[D - 1];
  double sum = 0;
  for (const auto stress : stress_along(result.field, shear)) sum += static_cast<double>(stress);
  for (int axis = 0; axis < D; ++axis) sum *= s.dx;
  if (force != 0) r.identity_defect = sum / (force * s.gauge) - 1;
  r.modulus = std::abs(force) / (s.section * s.strain);
  const double axial = shear ? 0 : slope(s, u[D - 1], D - 1);
  double lateral = 0;
  for (int axis = 0; axis + 1 < D; ++axis) lateral += slope(s, u[axis], static_cast<std::size_t>(axis)) / (D - 1);
  if (axial != 0) r.poisson = -lateral / axial;
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
    m.reports[k] = load(sample, loading, of_part(watch, k, m.reports.size()));
    LoadReport& report = m.reports[k];
    going = report.ending != Ending::stopped;
    if (report.ending == Ending::not_converged)
      report.modulus = report.poisson = std::numeric_limits<double>::quiet_NaN();
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

template Vec2 direction_of<2>(Loading loading);
template Vec3 direction_of<3>(Loading loading);
template std::vector<std::uint8_t> prescribed_levels<2>(int levels, Loading loading, LowerEdge lower);
template std::vector<std::uint8_t> prescribed_levels<3>(int levels, Loading loading, LowerEdge lower);
template FieldIn<2, double> uniform_strain(const Grid& grid, const Buffer<Tie>& tie, Vec2 top);
template FieldIn<3, double> uniform_strain(const Grid& grid, const Buffer<Tie>& tie, Vec3 top);
template void judge(const LoadedSample& sample, const FieldIn<2, double>& u, const FieldIn<2, double>& force,
                    LoadResult& result);
template void judge(const LoadedSample& sample, const FieldIn<3, double>& u, const FieldIn<3, double>& force,
                    LoadResultIn<3>& result);

}  // namespace arenite::statics
