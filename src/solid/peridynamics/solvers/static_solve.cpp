#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/vec.hpp"
#include "solid/peridynamics/solvers/coarse_space.hpp"
#include "solid/peridynamics/solvers/solvers.hpp"

namespace arenite::peridynamics {
namespace {

/// The preconditioner of the static solve: Chebyshev steps on the 2 x 2 block diagonal, a correction on the coarse space cut by grain, and the same
/// steps again, all in single precision. Symmetric and positive, as conjugate gradients ask.
class TwoLevel {
 public:
  TwoLevel(const Bonds& bonds, Pieces pieces, const std::vector<std::uint8_t>& prescribed)
      : TwoLevel(bonds, std::move(pieces), prescribed, block_diagonal(bonds)) {}

  /// z := M r, where z comes in as first_step() times D^-1 r.
  void apply(const Bonds& bonds, const Field<float>& r, Field<float>& z) {
    const Kernels& k = kernels(bonds.law);
    const auto step = [&](Coefficient c) {
      k.chebyshev(bonds, plane(z), plane(other_), plane(r), inverse_.plane(), c.a, c.b);
      std::swap(z, other_);
    };
    set_zero(other_);  // from zero the first step has no force: the caller has taken it; the second looks back at zero
    for (unsigned s = 1; s < degree; ++s) step(coefficient_[s]);
    k.residual(bonds, plane(z), plane(r), plane(residual_));
    coarse_.correct(plane(residual_), plane(z));
    for (const Coefficient c : coefficient_) step(c);
  }

  float first_step() const { return coefficient_[0].b; }
  BlockPlane inverse() const { return inverse_.plane(); }
  std::size_t loose_nodes() const { return inverse_.loose; }
  const CoarseSpace& coarse() const { return coarse_; }

 private:
  static constexpr int degree = 4;
  /// The part of the spectrum of D^-1 A that the smoother deals with. No bond network exceeds 2: a bond's energy is at most twice that of its two ends
  /// held apart.
  static constexpr double lowest = 0.1, highest = 2.0;
  struct Coefficient {
    float a, b;
  };

  TwoLevel(const Bonds& bonds, Pieces pieces, const std::vector<std::uint8_t>& prescribed, const BlockDiagonal<double>& diagonal)
      : inverse_(inverse_diagonal(bonds, diagonal, prescribed)),
        coarse_(bonds, std::move(pieces), diagonal, prescribed),
        other_(bonds.grid.padded_size()),
        residual_(bonds.grid.padded_size()) {
    const double centre = (highest + lowest) / 2, half = (highest - lowest) / 2;
    double rho = half / centre;
    coefficient_[0] = {0, static_cast<float>(1 / centre)};
    for (unsigned k = 1; k < degree; ++k) {
      const double next = 1 / (2 * centre / half - rho);
      coefficient_[k] = {static_cast<float>(next * rho), static_cast<float>(2 * next / half)};
      rho = next;
    }
  }

  InverseDiagonal inverse_;
  CoarseSpace coarse_;
  Field<float> other_, residual_;
  std::array<Coefficient, degree> coefficient_;
};

}  // namespace

template <class T>
double square_norm(const Grid& grid, const Field<T>& a) {
  double sum = 0;
  grid.each([&](std::ptrdiff_t i, int) {
    const double ax = a.x[i], ay = a.y[i];
    sum += ax * ax + ay * ay;
  });
  return sum;
}

template <class T>
double residual_reference(const Bonds& bonds, const std::vector<std::uint8_t>& prescribed, const Field<double>& u, Field<T>& work, Field<T>& f) {
  const Grid& grid = bonds.grid;
  Vec2 top;
  for (std::ptrdiff_t i = grid.row(grid.height - 1), end = i + grid.width; i < end; ++i)
    if (std::abs(u.x[i]) + std::abs(u.y[i]) > std::abs(top.x) + std::abs(top.y)) top = {u.x[i], u.y[i]};
  for (int y = 0; y < grid.height; ++y) {
    const double share = static_cast<double>(y) / (grid.height - 1) - 0.5;  // about the middle: small numbers
    std::fill_n(work.x.data() + grid.row(y), grid.width, static_cast<T>(share * top.x));
    std::fill_n(work.y.data() + grid.row(y), grid.width, static_cast<T>(share * top.y));
  }
  if constexpr (std::is_same_v<T, double>) kernels(bonds.law).force(bonds, prescribed.data(), plane(work), plane(f));
  else kernels(bonds.law).force_float(bonds, prescribed.data(), plane(work), plane(f));
  return std::sqrt(square_norm(grid, f));
}

template double square_norm(const Grid&, const Field<float>&);
template double square_norm(const Grid&, const Field<double>&);
template double residual_reference(const Bonds&, const std::vector<std::uint8_t>&, const Field<double>&, Field<float>&, Field<float>&);
template double residual_reference(const Bonds&, const std::vector<std::uint8_t>&, const Field<double>&, Field<double>&, Field<double>&);

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
    const double square = kernels(bonds.law).imbalance(bonds, prescribed.data(), plane(u), plane(r));
    if (!body) return std::sqrt(square);
    bonds.grid.each([&](std::ptrdiff_t i, int y) {
      const auto rows = prescribed[static_cast<std::size_t>(y)];
      if (!(rows & x_prescribed)) r.x[i] += static_cast<float>(body->x[i]);
      if (!(rows & y_prescribed)) r.y[i] += static_cast<float>(body->y[i]);
    });
    return std::sqrt(square_norm(bonds.grid, r));
  }

  /// u and r move along p, and z becomes the first step of the preconditioner; returns the norm of r.
  double move(const Bonds& bonds, double alpha, Field<double>& u) {
    return std::sqrt(kernels(bonds.law).conjugate_step(bonds, static_cast<float>(alpha), plane(p), plane(f), plane(u), plane(r), preconditioner.inverse(),
                                                       preconditioner.first_step(), plane(z)));
  }
};

StaticSolver::StaticSolver(const Bonds& bonds, Pieces pieces, std::vector<std::uint8_t> prescribed)
    : state_(std::make_unique<State>(bonds, std::move(pieces), std::move(prescribed))) {}
StaticSolver::~StaticSolver() = default;

StaticReport StaticSolver::solve(const Bonds& bonds, Field<double>& u, double tolerance, int max_iterations, const Watch& watch, const Field<double>* body) {
  State& s = *state_;
  const Kernels& k = kernels(bonds.law);
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
