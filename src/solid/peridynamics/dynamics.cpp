#include "solid/peridynamics/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solid/peridynamics/kernels/kernels.hpp"
#include "solid/statics/residual.hpp"

namespace arenite::peridynamics {
namespace {

constexpr std::int64_t look_every = 20;  ///< steps between two looks at the residual and the damping

/// Force of the bonds where displacements are free, by the stretch asked for.
void form_force(const Dynamics& s, const Field<double>& u, Field<double>& f) {
  if (!s.exact_stretch) {
    kernels(s.bonds.law).force(s.bonds, s.prescribed.data(), pointers(u), pointers(f));
    return;
  }
  exact_force(s.bonds, s.dx, u, f);
  const Grid& grid = s.bonds.grid;
  for (int y = 0; y < grid.height; ++y) {
    const auto rows = s.prescribed[y];
    if (rows & x_prescribed) std::fill_n(f.x.data() + grid.row(y), grid.width, 0.0);
    if (rows & y_prescribed) std::fill_n(f.y.data() + grid.row(y), grid.width, 0.0);
  }
}

/// older := u + a (u - older) + b M f, M a 2 x 2 block a node, or the unit matrix where `inverse` is null.
void plain_step(const Grid& grid, const Field<double>& u, Field<double>& older, const Field<double>& f,
                const BlockPlane* inverse, double a, double b) {
  for (std::ptrdiff_t i = grid.row(0), end = grid.row(grid.height); i < end; ++i) {
    Vec2 force = f.at(i);
    if (inverse) {
      const double xx = inverse->xx[i], xy = inverse->xy[i], yy = inverse->yy[i];
      force = {xx * force.x + xy * force.y, xy * force.x + yy * force.y};
    }
    older.set(i, u.at(i) + a * (u.at(i) - older.at(i)) + b * force);
  }
}

/// older := u + a (u - older) + b M f(u).
struct Step {
  const BlockPlane* inverse;  ///< M; the unit matrix where it is null
  double a = 1, b = 0;

  void operator()(const Dynamics& s, const Field<double>& u, Field<double>& older, Field<double>& f) const {
    const Kernels& k = kernels(s.bonds.law);
    if (s.exact_stretch) {
      form_force(s, u, f);
      plain_step(s.bonds.grid, u, older, f, inverse, a, b);
    } else if (inverse) {
      k.relax(s.bonds, pointers(u), pointers(older), *inverse, a, b);
    } else {
      k.stormer(s.bonds, s.prescribed.data(), pointers(u), pointers(older), a, b);
    }
  }
};

/// Steps until the residual is small; `look(u, older, f)` may set the damping anew.
template <class Look>
StaticReport step_to_rest(const Dynamics& s, Field<double>& u, const Step& step, const Look& look) {
  StaticReport report;
  Field<double> older(s.bonds.grid.padded_size()), f(s.bonds.grid.padded_size());
  const double reference = statics::residual_reference(s.bonds, s.prescribed, u, older, f);
  older = u;
  if (!(reference > 0)) {
    report.converged = std::isfinite(reference);
    return report;
  }
  statics::Reporter reporter(s.watch, s.tolerance);
  for (std::int64_t n = 0;; ++n) {
    if (n % look_every == 0 || n >= s.max_steps) {
      form_force(s, u, f);
      report.residual = std::sqrt(statics::square_norm(s.bonds.grid, f)) / reference;
      report.history.push_back(report.residual);
      report.iterations = static_cast<int>(n);
      report.converged = report.residual <= s.tolerance;
      if (report.converged || n >= s.max_steps || !std::isfinite(report.residual)) return report;
      if (!reporter.goes_on(report.iterations, report.residual)) {
        report.stopped = true;
        return report;
      }
      look(u, older, f);
    }
    step(s, u, older, f);
    std::swap(u, older);
  }
}

}  // namespace

StaticReport damped_dynamics(const Dynamics& s, Field<double>& u) {
  double stiffest = 0, softest = 0;
  for (unsigned t = 1; t < 4; ++t) {
    stiffest = std::max(stiffest, s.bonds.modulus(t));
    softest = softest > 0 ? std::min(softest, s.bonds.modulus(t)) : s.bonds.modulus(t);
  }
  double row_sum = 0;  // of e_x^2/|e|^3 over the 28 bonds: no frequency exceeds sqrt(2 row_sum k/m)
  for (const Offset e : half_bonds) row_sum += (e.x * e.x + e.y * e.y) / std::pow(length(e), 3);
  const double dt = 0.9 * 2 / std::sqrt(2 * row_sum * stiffest), viscosity = 0.9 * std::sqrt(2 * softest);
  const double half = viscosity * dt / 2;
  return step_to_rest(s, u, {nullptr, (1 - half) / (1 + half), dt * dt / (1 + half)},
                      [](const auto&, const auto&, auto&) {});
}

StaticReport adaptive_relaxation(const Dynamics& s, Field<double>& u) {
  const auto diagonal = block_diagonal(s.bonds);
  const auto inverse = statics::inverse_diagonal(s.bonds.grid, diagonal, s.prescribed);
  const BlockPlane blocks = inverse.pointers();
  const Grid& grid = s.bonds.grid;
  const double dt = 0.99 * std::sqrt(2.0);  // D^-1 A stays below 2, so no frequency exceeds sqrt(2)
  Step step{&blocks, 1, dt * dt};
  Field<double> velocity(grid.padded_size());
  const auto look = [&](const Field<double>& now, const Field<double>& older, Field<double>& f) {
    double kinetic = 0;
    for (std::ptrdiff_t i = grid.row(0), end = grid.row(grid.height); i < end; ++i) {
      const Vec2 v = now.at(i) - older.at(i);
      velocity.set(i, v);
      kinetic += v.x * (diagonal.xx[i] * v.x + 2 * diagonal.xy[i] * v.y) + diagonal.yy[i] * v.y * v.y;
    }
    const double elastic = -kernels(s.bonds.law).force(s.bonds, s.prescribed.data(), pointers(velocity), pointers(f));
    const double frequency = kinetic > 0 ? std::sqrt(std::max(0.0, elastic / kinetic)) : 0;
    const double half = frequency * dt;  // critical damping c = 2 omega, times dt/2
    step.a = (1 - half) / (1 + half);
    step.b = dt * dt / (1 + half);
  };
  return step_to_rest(s, u, step, look);
}

}  // namespace arenite::peridynamics
