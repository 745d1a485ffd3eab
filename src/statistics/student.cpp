#include "statistics/student.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/bracketed_root.hpp"

namespace arenite::statistics {
namespace {

/// The continued fraction of the incomplete beta function (DLMF 8.17.22) by Lentz's method, for x below (a + 1)/(a + b + 2).
double beta_fraction(double a, double b, double x) {
  constexpr double tiny = 1e-300;
  double c = 1, d = 1 - (a + b) * x / (a + 1);
  if (std::abs(d) < tiny) d = tiny;
  d = 1 / d;
  double value = d;
  const auto step = [&](double term) {
    d = 1 + term * d;
    c = 1 + term / c;
    if (std::abs(d) < tiny) d = tiny;
    if (std::abs(c) < tiny) c = tiny;
    d = 1 / d;
    value *= c * d;
    return std::abs(c * d - 1);
  };
  for (int m = 1; m < 10000; ++m) {
    step(m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)));
    if (step(-(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))) < 1e-16) break;
  }
  return value;
}

}  // namespace

double regularised_beta(double a, double b, double x) {
  if (!(x > 0)) return 0;
  if (!(x < 1)) return 1;
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
  return x < (a + 1) / (a + b + 2) ? front * beta_fraction(a, b, x) / a : 1 - front * beta_fraction(b, a, 1 - x) / b;
}

double student_share(double t, double freedom) {
  if (freedom > 1e7) return 0.5 * std::erfc(-t / std::numbers::sqrt2);
  const double tail = 0.5 * regularised_beta(0.5 * freedom, 0.5, freedom / (freedom + t * t));
  return t > 0 ? 1 - tail : tail;
}

double student_quantile(double p, double freedom) {
  if (p == 0.5) return 0;
  if (p < 0.5) return -student_quantile(1 - p, freedom);
  const auto excess = [&](double t) { return student_share(t, freedom) - p; };
  double high = 1;
  while (excess(high) < 0 && high < std::numeric_limits<double>::max() / 4) high *= 2;
  return bracketed_root(excess, 0.0, 0.5 - p, high, excess(high), 1e-14 * high, 0);
}

double fisher_share_above(double f, double freedom_between, double freedom_within) {
  return regularised_beta(0.5 * freedom_within, 0.5 * freedom_between, freedom_within / (freedom_within + freedom_between * f));
}

}  // namespace arenite::statistics
