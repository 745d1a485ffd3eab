#include "solid/peridynamics/solvers/static_solve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solid/peridynamics/solvers/reference.hpp"

namespace arenite::peridynamics {

namespace {

void set_zero(Field<float>& a) {
  std::fill_n(a.x.data(), a.x.size(), 0.0f);
  std::fill_n(a.y.data(), a.y.size(), 0.0f);
}

}  // namespace

struct StaticSolver::State {
  std::vector<std::uint8_t> prescribed;
  TwoLevel preconditioner;
  Field<float> r, p, f, z;

  State(const Bonds& bonds, Pieces pieces, std::vector<std::uint8_t> rows)
      : prescribed(std::move(rows)),
        preconditioner(bonds, std::move(pieces), prescribed),
        r(bonds.grid.padded_size()),
        p(bonds.grid.padded_size()),
        f(bonds.grid.padded_size()),
        z(bonds.grid.padded_size()) {}

  /// r := residual of u, worked out anew in double; returns its norm.
  double fresh_residual(const Bonds& bonds, const Field<double>& u, const Field<double>* body) {
    const double square = kernels().imbalance(bonds, prescribed.data(), plane(u), plane(r));
    if (!body) return std::sqrt(square);
    const Grid& grid = bonds.grid;
    for (int y = 0; y < grid.height; ++y) {
      const auto rows = prescribed[static_cast<std::size_t>(y)];
      for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
        if (!(rows & x_prescribed)) r.x[i] += static_cast<float>(body->x[i]);
        if (!(rows & y_prescribed)) r.y[i] += static_cast<float>(body->y[i]);
      }
    }
    return std::sqrt(square_norm(grid, r));
  }

  /// u and r move along p, and z becomes the first step of the preconditioner; returns the norm of r.
  double move(const Bonds& bonds, double alpha, Field<double>& u) {
    return std::sqrt(kernels().conjugate_step(bonds, static_cast<float>(alpha), plane(p), plane(f), plane(u), plane(r),
                                              preconditioner.inverse(), preconditioner.first_step(), plane(z)));
  }
};

StaticSolver::StaticSolver(const Bonds& bonds, Pieces pieces, std::vector<std::uint8_t> prescribed)
    : state_(std::make_unique<State>(bonds, std::move(pieces), std::move(prescribed))) {}
StaticSolver::~StaticSolver() = default;

StaticReport StaticSolver::solve(const Bonds& bonds, Field<double>& u, double tolerance, int max_iterations,
                                 const Watch& watch, const Field<double>* body) {
  State& s = *state_;
  const Kernels& k = kernels();
  StaticReport report;
  report.coarse_unknowns = s.preconditioner.coarse().unknowns();
  report.repairs = s.preconditioner.coarse().repairs();
  report.loose_nodes = s.preconditioner.loose_nodes();
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
    s.preconditioner.apply(bonds, s.r, s.z);
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

}  // namespace arenite::peridynamics
