#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "solid/statics/chebyshev.hpp"
#include "solid/statics/coarse_space.hpp"
#include "solid/statics/discretisation.hpp"
#include "solid/statics/free_motions.hpp"
#include "solid/statics/halo.hpp"
#include "solid/statics/residual.hpp"
#include "solid/statics/watch.hpp"

namespace arenite::statics {

/// The preconditioner: Chebyshev steps on the block diagonal, a correction on the coarse space cut by grain, and
/// the same steps again, all in single precision. Symmetric and positive, as conjugate gradients ask.
template <Discretisation D> struct Preconditioner {
  static constexpr int dimension = D::dimension;
  using Floats = FieldIn<dimension, float>;
  using Doubles = FieldIn<dimension, double>;
  using Diagonal = BlockDiagonalIn<dimension, double>;

  std::vector<std::uint8_t> prescribed;
  InverseDiagonalIn<dimension> inverse;
  CoarseSpaceIn<dimension> coarse;
  Floats r, p, z;
  Floats spare;  ///< the smoother's older step, the residual left for the coarse space, the force of p: one at a time
  std::vector<ChebyshevStep> coefficient;
  FreeMotions<dimension> free;

  Preconditioner(const D& sample, Aggregates aggregates, std::vector<std::uint8_t> rows, Diagonal diagonal)
      : prescribed(std::move(rows)),
        inverse(inverse_of(sample, diagonal, prescribed)),
        coarse(coarse_space(sample, std::move(aggregates), std::move(diagonal), prescribed)) {
    for (Floats* field : {&r, &p, &z, &spare}) *field = Floats(sample.grid.padded_size());
    const auto [degree, lowest, highest] = smoothing_of(sample);
    coefficient = chebyshev_steps(degree, lowest, highest);
  }

  /// What works its blocks out one by one needs no list of them in double.
  static constexpr bool has_blocks = requires(const D& sample) { blocks_of(sample); };
  static Diagonal diagonal_of(const D& sample) {
    if constexpr (has_blocks) return Diagonal(0);
    else return block_diagonal(sample);
  }
  static InverseDiagonalIn<dimension> inverse_of(const D& sample, const Diagonal& diagonal,
                                                 const std::vector<std::uint8_t>& levels) {
    std::function<BlockIn<dimension>(std::ptrdiff_t)> block;
    if constexpr (has_blocks) block = blocks_of(sample);
    else block = [&](std::ptrdiff_t i) { return diagonal.at(i); };
    return inverse_diagonal<dimension>(sample.grid, block, levels, pool_of(sample));
  }
  static CoarseSpaceIn<dimension> coarse_space(const D& sample, Aggregates aggregates, Diagonal diagonal,
                                               const std::vector<std::uint8_t>& levels) {
    const GalerkinSums<dimension> sums = couplings(sample, aggregates, std::move(diagonal), levels);
    return {sample.grid, std::move(aggregates), sums, levels, pool_of(sample)};
  }

  /// Nothing holds a periodic sample against a translation, which would grow out of rounding.
  static void take_about_mean(const Grid& grid, Floats& field) {
    Vec<dimension> sum;
    double count = 0;
    grid.each([&](std::ptrdiff_t i, int) { sum += field.at(i), count += 1; });
    grid.each([&](std::ptrdiff_t i, int) { field.set(i, field.at(i) - sum / count); });
  }

  /// z := M r, where z comes in as the first step from zero.
  void apply(const D& sample) {
    const KernelsOf<D>& k = kernels_of(sample);
    const auto step = [&](ChebyshevStep c) {
      close_period(sample.grid, z);
      k.chebyshev(sample, pointers(z), pointers(spare), pointers(r), inverse.pointers(), c.keep, c.add);
      std::swap(z, spare);
    };
    set_zero(spare);  // from zero the first step has no force: `move` has taken it; the second looks back at zero
    for (std::size_t s = 1; s < coefficient.size(); ++s) step(coefficient[s]);
    close_period(sample.grid, z);
    k.residual(sample, pointers(z), pointers(r), pointers(spare));
    coarse.correct(pointers(spare), pointers(z));
    for (const ChebyshevStep c : coefficient) step(c);
    free.leave_out(sample.grid, z);
    if (!sample.grid.periodic) return;
    take_about_mean(sample.grid, z);
    set_zero(spare);  // images of a period beyond the sample, which no force overwrites, would count in sums
  }

  /// r := residual of u, worked out anew in double; returns its norm.
  double fresh_residual(const D& sample, Doubles& u, const Doubles* body) {
    close_period(sample.grid, u);
    const KernelsOf<D>& k = kernels_of(sample);
    if (!body) return std::sqrt(k.imbalance(sample, prescribed.data(), pointers(u), pointers(r)));
    // Added in double: in single precision the two would leave the rounding of each.
    Doubles force(sample.grid.padded_size());
    k.force(sample, prescribed.data(), pointers(std::as_const(u)), pointers(force));
    sample.grid.each([&](std::ptrdiff_t i, int level) {
      const auto held = prescribed[static_cast<std::size_t>(level)];
      for (int c = 0; c < dimension; ++c)
        r[c][i] = held >> c & 1 ? 0.0f : static_cast<float>(force[c][i] + (*body)[c][i]);
    });
    return std::sqrt(square_norm(sample.grid, r));
  }

  /// u and r move along p, and z becomes the first step of the preconditioner; returns the norm of r.
  double move(const D& sample, double alpha, Doubles& u) {
    return std::sqrt(kernels_of(sample).conjugate_step(sample, static_cast<float>(alpha), pointers(p), pointers(spare),
                                                       pointers(u), pointers(r), inverse.pointers(), coefficient[0].add,
                                                       pointers(z)));
  }
};

/// Linear equilibrium by conjugate gradients with the two-level preconditioner. The object keeps its set-up for many
/// right sides, and through broken bonds: the preconditioner may lag behind the bonds.
template <Discretisation D> class StaticSolver {
 public:
  using Doubles = FieldIn<D::dimension, double>;

  /// `aggregates` are those that carry, `prescribed` has one entry a level.
  StaticSolver(const D& sample, Aggregates aggregates, std::vector<std::uint8_t> prescribed)
      : state_(std::make_unique<Preconditioner<D>>(sample, std::move(aggregates), std::move(prescribed),
                                                   Preconditioner<D>::diagonal_of(sample))) {}

  /// On entry `u` holds the prescribed displacements and a first guess, on return the field at equilibrium. Residuals
  /// are relative to that of uniform strain (residual_reference), in a periodic sample to `body`: a force on every
  /// node beside that of the sample.
  StaticReport solve(const D& sample, Doubles& u, double tolerance, int max_iterations, const Watch& watch = {},
                     const Doubles* body = nullptr);

  /// That solves from now on do not make; a body force has to leave them out.
  FreeMotions<D::dimension>& free_motions() { return state_->free; }

 private:
  std::unique_ptr<Preconditioner<D>> state_;
};

template <Discretisation D>
StaticReport StaticSolver<D>::solve(const D& sample, Doubles& u, double tolerance, int max_iterations,
                                    const Watch& watch, const Doubles* body) {
  Preconditioner<D>& s = *state_;
  const KernelsOf<D>& k = kernels_of(sample);
  StaticReport report;
  report.repairs = s.coarse.repairs();
  report.loose_nodes = s.inverse.loose;
  report.coarse_nodes = static_cast<std::size_t>(s.coarse.nodes());
  const double reference = body && sample.grid.periodic ? std::sqrt(square_norm(sample.grid, *body))
                                                        : residual_reference(sample, s.prescribed, u, s.z, s.r);
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
  set_zero(s.spare);
  double renewed = renew(), last = 0;
  report.history.push_back(renewed);
  Reporter reporter(watch, tolerance);
  while (report.residual > tolerance && report.iterations < max_iterations) {
    if (!reporter.goes_on(report.iterations, report.residual)) {
      report.stopped = true;
      break;
    }
    s.apply(sample);
    const double rz = k.dot(sample, pointers(s.r), pointers(s.z));
    if (!(rz > 0) || !std::isfinite(rz)) break;
    k.direct(sample, static_cast<float>(last > 0 ? rz / last : 0.0), pointers(s.z), pointers(s.p));
    last = rz;
    close_period(sample.grid, s.p);
    const double curvature = -k.force_float(sample, s.prescribed.data(), pointers(s.p), pointers(s.spare));
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
