#include "peridynamics/solvers/static_solve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "peridynamics/solvers/reference.hpp"

namespace arenite::peridynamics {

struct StaticSolver::State {
  std::vector<std::uint8_t> prescribed;
  TwoLevel preconditioner;
  Field<double> r, p, f;
  Field<float> rough, z;

  State(const Bonds& bonds, Pieces pieces, std::vector<std::uint8_t> rows)
      : prescribed(std::move(rows)),
        preconditioner(bonds, std::move(pieces), prescribed),
        r(bonds.grid.padded_size()),
        p(bonds.grid.padded_size()),
        f(bonds.grid.padded_size()),
        rough(bonds.grid.padded_size()),
        z(bonds.grid.padded_size()) {}

  void add_to_residual(const Bonds& bonds, const Field<double>& body) {
    const Grid& grid = bonds.grid;
    for (int y = 0; y < grid.height; ++y) {
      const auto rows = prescribed[static_cast<std::size_t>(y)];
      for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
        if (!(rows & x_prescribed)) r.x[i] += body.x[i];
        if (!(rows & y_prescribed)) r.y[i] += body.y[i];
      }
    }
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
  const double reference = residual_reference(bonds, s.prescribed, u, s.p, s.f);
  set_zero(s.p);
  set_zero(s.f);
  if (!(reference > 0)) {
    report.converged = std::isfinite(reference);
    return report;
  }
  const auto fresh_residual = [&] {
    k.force(bonds, s.prescribed.data(), plane(u), plane(s.r));
    if (body) s.add_to_residual(bonds, *body);
  };
  const auto move = [&](double alpha) {
    return std::sqrt(k.conjugate_step(bonds, alpha, plane(s.p), plane(s.f), plane(u), plane(s.r),
                                      s.preconditioner.inverse(), s.preconditioner.first_step(), plane(s.rough),
                                      plane(s.z))) /
           reference;
  };
  // The residual that the recurrence carries is replaced by a fresh one at the end; if the two differ, a second pass
  // starts from there.
  Reporter reporter(watch, tolerance);
  for (int pass = 0; pass < 2 && !report.converged && !report.stopped; ++pass) {
    fresh_residual();
    report.residual = move(0);
    if (pass == 0) report.history.push_back(report.residual);
    double last = 0;
    while (report.residual > tolerance && report.iterations < max_iterations) {
      if (!reporter.goes_on(report.iterations, report.residual)) {
        report.stopped = true;
        break;
      }
      s.preconditioner.apply(bonds, s.rough, s.z);
      const double rz = k.dot(bonds, plane(s.rough), plane(s.z));
      if (!(rz > 0) || !std::isfinite(rz)) break;
      k.direct(bonds, last > 0 ? rz / last : 0.0, plane(s.z), plane(s.p));
      last = rz;
      const double curvature = -k.force(bonds, s.prescribed.data(), plane(s.p), plane(s.f));
      if (!(curvature > 0)) break;
      report.residual = move(rz / curvature);
      ++report.iterations;
      report.history.push_back(report.residual);
    }
    fresh_residual();
    report.residual = std::sqrt(square_norm(bonds.grid, s.r)) / reference;
    report.converged = report.residual <= 1.01 * tolerance;
    if (report.iterations >= max_iterations) break;
  }
  return report;
}

}  // namespace arenite::peridynamics
