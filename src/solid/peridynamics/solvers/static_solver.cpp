#include <algorithm>
#include <cmath>
#include <utility>

#include "core/vec.hpp"
#include "solid/peridynamics/solvers/coarse_space.hpp"
#include "solid/peridynamics/solvers/residual.hpp"
#include "solid/peridynamics/solvers/static_solver.hpp"

namespace arenite::peridynamics {
/// Preconditioned conjugate gradients. The preconditioner: Chebyshev steps on the 2 x 2 block diagonal, a correction on
/// the coarse space cut by grain, and the same steps again, all in single precision. Symmetric and positive, as
/// conjugate gradients ask.
struct StaticSolver::State {
  static constexpr int degree = 4;
  /// The part of the spectrum of D^-1 A that the smoother deals with. No bond network exceeds 2: a bond's energy is at
  /// most twice that of its two ends held apart.
  static constexpr double lowest = 0.1, highest = 2.0;
  struct Coefficient {
    float a, b;
  };

  std::vector<std::uint8_t> prescribed;
  InverseDiagonal inverse;
  CoarseSpace coarse;
  Field<float> r, p, f, z, other, left;
  std::array<Coefficient, degree> coefficient;

  State(const Bonds& bonds, Aggregates aggregates, std::vector<std::uint8_t> rows,
        const BlockDiagonal<double>& diagonal)
      : prescribed(std::move(rows)),
        inverse(inverse_diagonal(bonds, diagonal, prescribed)),
        coarse(bonds, std::move(aggregates), diagonal, prescribed) {
    for (Field<float>* field : {&r, &p, &f, &z, &other, &left}) *field = Field<float>(bonds.grid.padded_size());
    const double centre = (highest + lowest) / 2, half = (highest - lowest) / 2;
    double rho = half / centre;
    coefficient[0] = {0, static_cast<float>(1 / centre)};
    for (unsigned k = 1; k < degree; ++k) {
      const double next = 1 / (2 * centre / half - rho);
      coefficient[k] = {static_cast<float>(next * rho), static_cast<float>(2 * next / half)};
      rho = next;
    }
  }

  /// z := M r, where z comes in as the first step from zero.
  void precondition(const Bonds& bonds) {
    const Kernels& k = kernels(bonds.law);
    const auto step = [&](Coefficient c) {
      k.chebyshev(bonds, plane(z), plane(other), plane(r), inverse.plane(), c.a, c.b);
      std::swap(z, other);
    };
    set_zero(other);  // from zero the first step has no force: `move` has taken it; the second looks back at zero
    for (unsigned s = 1; s < degree; ++s) step(coefficient[s]);
    k.residual(bonds, plane(z), plane(r), plane(left));
    coarse.correct(plane(left), plane(z));
    for (const Coefficient c : coefficient) step(c);
  }

  /// r := residual of u, worked out anew in double; returns its norm.
  double fresh_residual(const Bonds& bonds, const Field<double>& u, const Field<double>* body) {
    const double square = kernels(bonds.law).imbalance(bonds, prescribed.data(), plane(u), plane(r));
    if (!body) return std::sqrt(square);
    bonds.grid.each([&](std::ptrdiff_t i, int y) {
      const auto rows = prescribed[y];
      if (!(rows & x_prescribed)) r.x[i] += static_cast<float>(body->x[i]);
      if (!(rows & y_prescribed)) r.y[i] += static_cast<float>(body->y[i]);
    });
    return std::sqrt(square_norm(bonds.grid, r));
  }

  /// u and r move along p, and z becomes the first step of the preconditioner; returns the norm of r.
  double move(const Bonds& bonds, double alpha, Field<double>& u) {
    return std::sqrt(kernels(bonds.law).conjugate_step(bonds, static_cast<float>(alpha), plane(p), plane(f), plane(u),
                                                       plane(r), inverse.plane(), coefficient[0].b, plane(z)));
  }
};

StaticSolver::StaticSolver(const Bonds& bonds, Aggregates aggregates, std::vector<std::uint8_t> prescribed)
    : state_(std::make_unique<State>(bonds, std::move(aggregates), std::move(prescribed), block_diagonal(bonds))) {}
StaticSolver::~StaticSolver() = default;

StaticReport StaticSolver::solve(const Bonds& bonds, Field<double>& u, double tolerance, int max_iterations,
                                 const Watch& watch, const Field<double>* body) {
  State& s = *state_;
  const Kernels& k = kernels(bonds.law);
  StaticReport report;
  report.repairs = s.coarse.repairs();
  report.loose_nodes = s.inverse.loose;
  const double reference = residual_reference(bonds, s.prescribed, u, s.z, s.r);
  if (!(reference > 0)) {
    report.converged = std::isfinite(reference);
    return report;
  }
  // Directions and residuals are kept in single precision. Each time the residual has come down by `trusted` it is
  // worked out anew from the field, which is kept in double; the direction goes on.
  constexpr double trusted = 1e-2;
  const auto renew = [&] {
    report.residual = s.fresh_residual(bonds, u, body) / reference;
    s.move(bonds, 0, u);
    return report.residual;
  };
  set_zero(s.p);
  set_zero(s.f);
  double renewed = renew(), last = 0;
  report.history.push_back(renewed);
  Reporter reporter(watch, tolerance);
  while (report.residual > tolerance && report.iterations < max_iterations) {
    if (!reporter.goes_on(report.iterations, report.residual)) {
      report.stopped = true;
      break;
    }
    s.precondition(bonds);
    const double rz = k.dot(bonds, plane(s.r), plane(s.z));
    if (!(rz > 0) || !std::isfinite(rz)) break;
    k.direct(bonds, static_cast<float>(last > 0 ? rz / last : 0.0), plane(s.z), plane(s.p));
    last = rz;
    const double curvature = -k.force_float(bonds, s.prescribed.data(), plane(s.p), plane(s.f));
    if (!(curvature > 0)) break;
    report.residual = s.move(bonds, rz / curvature, u) / reference;
    ++report.iterations;
    if (report.residual <= std::max(tolerance, trusted * renewed)) renewed = renew();
    report.history.push_back(report.residual);
  }
  report.residual = s.fresh_residual(bonds, u, body) / reference;
  report.converged = !report.stopped && report.residual <= 1.01 * tolerance;
  return report;
}

namespace {

/// Keeps of the force on every node what its bonds can resist, and nothing where displacements are prescribed.
void hold_to_bonds(const Grid& grid, const BlockDiagonal<double>& diagonal, const std::vector<std::uint8_t>& prescribed,
                   Field<double>& f) {
  grid.each([&](std::ptrdiff_t i, int y) {
    const auto rows = prescribed[y];
    if (rows & x_prescribed) f.x[i] = 0;
    if (rows & y_prescribed) f.y[i] = 0;
    const double xx = diagonal.xx[i], xy = diagonal.xy[i], yy = diagonal.yy[i], trace = xx + yy;
    if (rows || xx * yy - xy * xy > 1e-9 * trace * trace || !(trace > 0)) return;
    f.set(i, Vec2{xx * f.x[i] + xy * f.y[i], xy * f.x[i] + yy * f.y[i]} / trace);
  });
}

}  // namespace

StaticReport solve_exact_stretch(const Bonds& bonds, double dx, const std::vector<std::uint8_t>& prescribed,
                                 StaticSolver& solver, Field<double>& u, double tolerance, int max_iterations,
                                 const Watch& watch) {
  const Grid& grid = bonds.grid;
  Field<double> body(grid.padded_size()), linear(grid.padded_size()), best;
  const double reference = residual_reference(bonds, prescribed, u, body, linear);
  const auto diagonal = block_diagonal(bonds);
  StaticReport total = solver.solve(bonds, u, tolerance, max_iterations, watch);
  if (!(reference > 0) || !total.converged) return total;
  const Watch later = [&](const Progress& p) {
    return !watch || watch({1, total.iterations + p.iterations, total.residual, 0, 0, 0});
  };
  double least = HUGE_VAL;
  for (int round = 0; round < 20; ++round) {
    exact_force(bonds, dx, u, body);
    hold_to_bonds(grid, diagonal, prescribed, body);
    total.residual = std::sqrt(square_norm(grid, body)) / reference;
    total.converged = total.residual <= tolerance;
    if (total.converged) return total;
    if (!(total.residual < least)) break;
    least = total.residual;
    best = u;
    kernels(bonds.law).force(bonds, prescribed.data(), plane(u), plane(linear));
    for (std::ptrdiff_t i = grid.row(0), end = grid.row(grid.height); i < end; ++i)
      body.set(i, body.at(i) - linear.at(i));
    const StaticReport more = solver.solve(bonds, u, 0.1 * tolerance, max_iterations, later, &body);
    total.iterations += more.iterations;
    total.history.insert(total.history.end(), more.history.begin(), more.history.end());
    if (more.stopped) {
      total.stopped = true;
      total.converged = false;
      return total;
    }
  }
  u = best;
  total.residual = least;
  return total;
}

}  // namespace arenite::peridynamics
