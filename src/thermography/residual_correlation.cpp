#include "thermography/residual_correlation.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::thermography {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Pixels that vary independently, from the mean square correlation of pairs less what chance gives it (Bartlett).
double independent_pixels(const MatrixXd& residual, const std::vector<double>& lag) {
  const Index all = residual.rows(), every = std::max<Index>(1, all / 128), count = (all + every - 1) / every;
  if (count < 2) return 1;
  MatrixXd some(count, residual.cols());
  for (Index i = 0; i < count; ++i) some.row(i) = residual.row(i * every).normalized();
  const MatrixXd pairs = some * some.transpose();
  const auto n = static_cast<double>(count);
  double chance = 1;
  for (const double r : lag) chance += 2 * r * r;
  const double square = (pairs.squaredNorm() - n) / (n * (n - 1)) - chance / static_cast<double>(residual.cols());
  return static_cast<double>(all) / (1 + (static_cast<double>(all) - 1) * std::max(square, 0.0));
}

std::vector<double> plain(const MatrixXd& residual, Index lags) {
  std::vector<double> seen;
  const double squares = residual.squaredNorm();
  for (Index k = 1; k <= lags; ++k)
    seen.push_back(residual.leftCols(residual.cols() - k).cwiseProduct(residual.rightCols(residual.cols() - k)).sum() / squares);
  return seen;
}

}  // namespace

double ResidualCorrelation::widening(const Eigen::VectorXd& weight) const {
  double sum = weight.squaredNorm();
  for (std::size_t k = 1; k <= lag.size() && static_cast<Index>(k) < weight.size(); ++k) {
    const auto far = static_cast<Index>(k);
    sum += 2 * lag[k - 1] * weight.head(weight.size() - far).dot(weight.tail(weight.size() - far));
  }
  return std::max(sum / weight.squaredNorm(), 1.0);
}

double chi_squared_above(double numbers, double deviations) {
  const double variance = 2 / (9 * numbers);
  return std::pow(1 - variance + deviations * std::sqrt(variance), 3);
}

ResidualCorrelation residual_correlation(const MatrixXd& residual, double fitted) {
  ResidualCorrelation result;
  const auto frames = static_cast<double>(residual.cols());
  if (residual.size() == 0 || !(residual.squaredNorm() > 0)) return result;
  const std::vector<double> seen = plain(residual, residual.cols() / 4);
  const double lost_in_noise = std::max(1e-3, 2 / std::sqrt(frames * independent_pixels(residual, {})));
  double sum = 1;
  // A fit takes `fitted` of the frames' freedoms with it, where noise is strongest: each lag falls short by so much (Marriott and Pope 1954).
  for (int turn = 0; turn < 8; ++turn) {
    result.lag.clear();
    const double short_by = fitted / frames * sum;
    for (const double r : seen) {
      if (r + short_by < lost_in_noise) break;
      result.lag.push_back(std::min(r + short_by, 0.999));
    }
    double next = 1;
    for (const double r : result.lag) next += 2 * r;
    sum = std::min(next, frames / (4 * fitted + 4));
  }
  result.pixels = independent_pixels(residual, result.lag);
  return result;
}

}  // namespace arenite::thermography
