#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "solid/statics/coarse_space.hpp"
#include "solid/statics/discretisation.hpp"
#include "solid/statics/residual.hpp"
#include "solid/statics/watch.hpp"

namespace arenite::statics {

/// The preconditioner: Chebyshev steps on the 2 x 2 block diagonal, a correction on the coarse space cut by grain, and
/// the same steps again, all in single precision. Symmetric and positive, as conjugate gradients ask.
template <Discretisation D> struct Preconditioner {
  struct Coefficient {
    float a, b;
  };

  std::vector<std::uint8_t> prescribed;
  InverseDiagonal inverse;
  CoarseSpace coarse;
  Field<float> r, p, f, z, other, left;
  std::vector<Coefficient> coefficient;

  Preconditioner(const D& sample, Aggregates aggregates, std::vector<std::uint8_t> rows,
                 const BlockDiagonal<double>& diagonal)
      : prescribed(std::move(rows)),
        inverse(inverse_diagonal(sample.grid, diagonal, prescribed)),
        coarse(coarse_space(sample, std::move(aggregates), diagonal, prescribed)) {
    for (Field<float>* field : {&r, &p, &f, &z, &other, &left}) *field = Field<float>(sample.grid.padded_size());
    const auto [degree, lowest, highest] = smoothing_of(sample);
    const double centre = (highest + lowest) / 2, half = (highest - lowest) / 2;
    double rho = half / centre;
    coefficient.push_back({0, static_cast<float>(1 / centre)});
    for (int k = 1; k < degree; ++k) {
      const double next = 1 / (2 * centre / half - rho);
      coefficient.push_back({static_cast<float>(next * rho), static_cast<float>(2 * next / half)});
      rho = next;
    }
  }

  static CoarseSpace coarse_space(const D& sample, Aggregates aggregates, const BlockDiagonal<double>& diagonal,
                                  const std::vector<std::uint8_t>& rows) {
    const std::vector<Coupling> sums = couplings(sample, aggregates, diagonal, rows);
    return {sample.grid, std::move(aggregates), sums, rows};
  }

  /// z := M r, where z comes in as the first step from zero.
  void apply(const D& sample) {
    const KernelsOf<D>& k = kernels_of(sample);
    const auto step = [&](Coefficient c) {
      k.chebyshev(sample, plane(z), plane(other), plane(r), inverse.plane(), c.a, c.b);
      std::swap(z, other);
    };
    set_zero(other);  // from zero the first step has no force: `move` has taken it; the second looks back at zero
    for (std::size_t s = 1; s < coefficient.size(); ++s) step(coefficient[s]);
    k.residual(sample, plane(z), plane(r), plane(left));
    coarse.correct(plane(left), plane(z));
    for (const Coefficient c : coefficient) step(c);
  }

  /// r := residual of u, worked out anew in double; returns its norm.
  double fresh_residual(const D& sample, const Field<double>& u, const Field<double>* body) {
    const double square = kernels_of(sample).imbalance(sample, prescribed.data(), plane(u), plane(r));
    if (!body) return std::sqrt(square);
    sample.grid.each([&](std::ptrdiff_t i, int y) {
      const auto rows = prescribed[y];
      if (!(rows & x_prescribed)) r.x[i] += static_cast<float>(body->x[i]);
      if (!(rows & y_prescribed)) r.y[i] += static_cast<float>(body->y[i]);
    });
    return std::sqrt(square_norm(sample.grid, r));
  }

  /// u and r move along p, and z becomes the first step of the preconditioner; returns the norm of r.
  double move(const D& sample, double alpha, Field<double>& u) {
    return std::sqrt(kernels_of(sample).conjugate_step(sample, static_cast<float>(alpha), plane(p), plane(f), plane(u),
                                                       plane(r), inverse.plane(), coefficient[0].b, plane(z)));
  }
};

/// Linear equilibrium by conjugate gradients with the two-level preconditioner. The object keeps its set-up for many
/// right sides, and through broken bonds: the preconditioner may lag behind the bonds.
template <Discretisation D> class StaticSolver {
 public:
  /// `aggregates` are those that carry, `prescribed` has one entry a row.
  StaticSolver(const D& sample, Aggregates aggregates, std::vector<std::uint8_t> prescribed)
      : state_(std::make_unique<Preconditioner<D>>(sample, std::move(aggregates), std::move(prescribed),
                                                   block_diagonal(sample))) {}

  /// On entry `u` holds the prescribed displacements and a first guess, on return the field at equilibrium. Residuals
  /// are relative to that of uniform strain (residual_reference). `body`, if given, is a force on every node beside
  /// that of the sample.
  StaticReport solve(const D& sample, Field<double>& u, double tolerance, int max_iterations, const Watch& watch = {},
                     const Field<double>* body = nullptr);

 private:
  std::unique_ptr<Preconditioner<D>> state_;
};

template <Discretisation D>
StaticReport StaticSolver<D>::solve(const D& sample, Field<double>& u, double tolerance, int max_iterations,
                                    const Watch& watch, const Field<double>* body) {
  Preconditioner<D>& s = *state_;
  const KernelsOf<D>& k = kernels_of(sample);
  StaticReport report;
  report.repairs = s.coarse.repairs();
  report.loose_nodes = s.inverse.loose;
  const double reference = residual_reference(sample, s.prescribed, u, s.z, s.r);
  if (!(reference > 0)) {
    report.converged = std::isfinite(reference);
    return report;
  }
  // Directions and residuals are kept in single precision. Each time the residual has come down by `trusted` it is
  // worked out anew from the field, which is kept in double; the direction goes on.
  constexpr double trusted = 1e-2;
  const auto renew = [&] {
    report.residual = s.fresh_residual(sample, u, body) / reference;
    s.move(sample, 0, u);
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
    s.apply(sample);
    const double rz = k.dot(sample, plane(s.r), plane(s.z));
    if (!(rz > 0) || !std::isfinite(rz)) break;
    k.direct(sample, static_cast<float>(last > 0 ? rz / last : 0.0), plane(s.z), plane(s.p));
    last = rz;
    const double curvature = -k.force_float(sample, s.prescribed.data(), plane(s.p), plane(s.f));
    if (!(curvature > 0)) break;
    report.residual = s.move(sample, rz / curvature, u) / reference;
    ++report.iterations;
    if (report.residual <= std::max(tolerance, trusted * renewed)) renewed = renew();
    report.history.push_back(report.residual);
  }
  report.residual = s.fresh_residual(sample, u, body) / reference;
  report.converged = !report.stopped && report.residual <= 1.01 * tolerance;
  return report;
}

}  // namespace arenite::statics
