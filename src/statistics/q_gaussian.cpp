#include "statistics/q_gaussian.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "statistics/jackknife.hpp"
#include "statistics/tails.hpp"

namespace arenite::statistics {
namespace {

constexpr double lowest_q = -2, highest_q = 2.95;

/// Centre, ln beta, q.
using Parameters = Eigen::Vector3d;

double log_gamma_quotient(double a, double b) { return std::lgamma(a) - std::lgamma(b); }

/// ln C_q, the integral of the density's shape for beta = 1.
double log_normalisation(double q) {
  const double log_root_pi = 0.5 * std::log(std::numbers::pi), e = q - 1;
  if (std::abs(e) < 1e-6) return log_root_pi;
  if (e > 0) return log_root_pi - 0.5 * std::log(e) + log_gamma_quotient((3 - q) / (2 * e), 1 / e);
  return std::log(2.0) + log_root_pi - std::log(3 - q) - 0.5 * std::log(-e) +
         log_gamma_quotient(-1 / e, (3 - q) / (-2 * e));
}

/// One set of parameters, ready for many x.
class Density {
 public:
  explicit Density(const Parameters& p)
      : centre_(p[0]),
        beta_(std::exp(p[1])),
        e_(p[2] - 1),
        height_(std::exp(0.5 * p[1] - log_normalisation(p[2]))) {}
  double operator()(double x) const {
    const double d2 = beta_ * (x - centre_) * (x - centre_);
    if (std::abs(e_) < 1e-6) return height_ * std::exp(-d2);
    const double base = 1 + e_ * d2;
    return base > 0 ? height_ * std::exp(-std::log(base) / e_) : 0;
  }

 private:
  double centre_, beta_, e_, height_;
};

struct Points {
  std::vector<double> x, y;
};

std::vector<double> residuals(const Points& points, const Parameters& p) {
  const Density f(p);
  std::vector<double> rest;
  for (std::size_t i = 0; i < points.x.size(); ++i) rest.push_back(points.y[i] - f(points.x[i]));
  return rest;
}

double cost(const Points& points, const Parameters& p) {
  double sum = 0;
  for (const double rest : residuals(points, p)) sum += rest * rest;
  return sum;
}

/// Solves (A + lambda diag A) d = g by Cramer's rule; false where A is singular.
bool solve(Eigen::Matrix3d a, double lambda, const Parameters& g, Parameters& d) {
  a.diagonal() *= 1 + lambda;
  const double whole = a.determinant();
  if (!(std::abs(whole) > 0) || !std::isfinite(whole)) return false;
  for (Eigen::Index k = 0; k < 3; ++k) {
    Eigen::Matrix3d m = a;
    m.col(k) = g;
    d[k] = m.determinant() / whole;
  }
  return true;
}

/// Slope of the density by each parameter at every point.
std::vector<Parameters> slopes(const Points& points, const Parameters& p) {
  const Parameters step{1e-5 * std::exp(-0.5 * p[1]), 1e-5, 1e-5};
  std::vector<Parameters> result(points.x.size());
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Parameters shift = step[k] * Parameters::Unit(k);
    const Density up(p + shift), down(p - shift);
    for (std::size_t i = 0; i < points.x.size(); ++i)
      result[i][k] = (up(points.x[i]) - down(points.x[i])) / (2 * step[k]);
  }
  return result;
}

Eigen::Matrix3d normal_matrix(const std::vector<Parameters>& slope) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  for (const Parameters& s : slope) normal += s * s.transpose();
  return normal;
}

/// Slopes times what the density leaves of y.
Parameters gradient(const std::vector<Parameters>& slope, const std::vector<double>& rest) {
  Parameters g = Parameters::Zero();
  for (std::size_t i = 0; i < slope.size(); ++i) g += slope[i] * rest[i];
  return g;
}

/// Levenberg-Marquardt; false if it does not settle within the bounds of q.
bool minimise(const Points& points, Parameters& p, int iterations) {
  double lambda = 1e-3, now = cost(points, p);
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const std::vector<Parameters> slope = slopes(points, p);
    const Eigen::Matrix3d normal = normal_matrix(slope);
    const Parameters g = gradient(slope, residuals(points, p));
    const double before = now;
    Parameters d;
    for (bool better = false; !better; lambda *= 10) {
      if (lambda > 1e9 || !solve(normal, lambda, g, d)) return p[2] > lowest_q && p[2] < highest_q;
      const Parameters trial{p[0] + d[0], p[1] + std::clamp(d[1], -1.0, 1.0),
                             std::clamp(p[2] + std::clamp(d[2], -0.3, 0.3), lowest_q, highest_q)};
      const double then = cost(points, trial);
      better = then < now;
      if (!better) continue;
      now = then;
      p = trial;
      lambda /= 100;
    }
    if (before - now <= 1e-12 * now) break;
  }
  return p[2] > lowest_q && p[2] < highest_q;
}

/// Half the second derivatives of the cost, by differences of its gradient: unlike the normal matrix they hold where
/// the density is not a good one.
Eigen::Matrix3d curvature(const Points& points, const Parameters& p) {
  Eigen::Matrix3d result;
  for (Eigen::Index l = 0; l < 3; ++l) {
    const double h = l == 0 ? 1e-4 * std::exp(-0.5 * p[1]) : 1e-4;
    const Parameters shift = h * Parameters::Unit(l), up = p + shift, down = p - shift;
    result.col(l) = (gradient(slopes(points, down), residuals(points, down)) -
                     gradient(slopes(points, up), residuals(points, up))) /
                    (2 * h);
  }
  return result;
}

Points points_of(const Bins& bins, const Counts& counts) {
  Points points{{}, density(bins, counts)};
  for (std::size_t k = 0; k < bins.count; ++k) points.x.push_back(bins.centre(k));
  return points;
}

double r2_of(const Points& points, const Parameters& p) {
  double mean = 0, variance = 0;
  for (const double y : points.y) mean += y / static_cast<double>(points.y.size());
  for (const double y : points.y) variance += (y - mean) * (y - mean);
  return 1 - cost(points, p) / variance;
}

}  // namespace

double q_gaussian_density(double x, double centre, double beta, double q) {
  return Density(Parameters(centre, std::log(beta), q))(x);
}

QGaussian fit_q_gaussian(const BlockCounts& counts, const std::vector<double>& replicate_mean) {
  QGaussian fit;
  if (counts.bins.count < 10) return fit;
  const Points points = points_of(counts.bins, counts.all);
  const auto peak = std::max_element(points.y.begin(), points.y.end());
  Parameters p{points.x[static_cast<std::size_t>(peak - points.y.begin())], std::log(std::numbers::pi * *peak * *peak),
               1.2};
  if (!minimise(points, p, 100)) return fit;
  const std::vector<Parameters> slope = slopes(points, p);
  const Eigen::Matrix3d half_hessian = curvature(points, p);
  std::vector<std::vector<double>> replicates;
  for (std::size_t b = 0; b < counts.block.size(); ++b) {
    const Counts rest = counts.without(b);
    if (!(total(rest) > 0)) continue;
    const double m = replicate_mean[b];
    std::vector<double> change = density(counts.bins, rest);  // one Newton step away from the fit to all
    for (std::size_t k = 0; k < change.size(); ++k) change[k] -= points.y[k];
    Parameters d;
    if (solve(half_hessian, 0, gradient(slope, change), d))
      replicates.push_back({p[2] + d[2], std::exp(p[1] + d[1]) * m * m, (p[0] + d[0]) / m});
  }
  const auto estimates = with_errors({p[2], std::exp(p[1]), p[0]}, replicates);
  fit.q = estimates[0];
  fit.beta = estimates[1];
  fit.centre = estimates[2];
  fit.r2 = r2_of(points, p);
  return fit;
}

Numbers numbers(const QGaussian& fit) {
  Numbers j = Numbers::tree();
  put(j, "q", fit.q, "", "Exponent of the tails; 1: a Gaussian");
  put(j, "beta", fit.beta, "", "Width, 1/(2 variance) of a Gaussian");
  put(j, "centre", fit.centre, "", "mu, where the pdf is highest", Trait::detail);
  put(j, "r2", fit.r2, "", "Fraction of the variance of the pdf over the bins explained by the fit");
  return j;
}

}  // namespace arenite::statistics
