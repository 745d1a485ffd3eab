#include "thermal/thermography/residual_correlation.hpp"

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

/// Sums over frames and rows of products of values so many frames apart.
std::vector<double> products(const MatrixXd& value, Index lags) {
  std::vector<double> sums;
  for (Index k = 1; k <= lags; ++k) sums.push_back(value.leftCols(value.cols() - k).cwiseProduct(value.rightCols(value.cols() - k)).sum());
  return sums;
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

ResidualCorrelation residual_correlation(const MatrixXd& residual, const MatrixXd& fitted) {
  ResidualCorrelation result;
  const auto frames = static_cast<double>(residual.cols()), functions = static_cast<double>(fitted.rows());
  const double squares = residual.squaredNorm();
  if (residual.size() == 0 || !(squares > 0)) return result;
  const Index lags = residual.cols() / 4;
  const std::vector<double> seen = products(residual, lags), taken = products(fitted, lags);
  const double lost_in_noise = std::max(1e-3, 2 / std::sqrt(frames * independent_pixels(residual, {})));
  double sum = 1;
  // In white noise the fit takes just this from each lag; of correlated noise, strongest where the fit is, as much more (Marriott and Pope 1954).
  for (int turn = 0; turn < 8; ++turn) {
    result.lag.clear();
    double next = 1;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double r = seen[k] / squares + sum * taken[k] / (frames - functions);
      if (r < lost_in_noise) break;
      result.lag.push_back(std::min(r, 0.999));
      next += 2 * result.lag.back();
    }
    sum = std::min(next, frames / (4 * functions + 4));
  }
  result.pixels = independent_pixels(residual, result.lag);
  return result;
}

}  // namespace arenite::thermography
