#include "thermal/thermography/load_signal.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::thermography {
namespace {

constexpr double least_share = 0.5;

struct Fit {
  double left = 0;                  ///< squares that the fit leaves
  double cosine = 0, sine = 0;
};

/// `time` is held against its middle, so that the columns are nearly orthogonal; phases are then of that moment.
Fit fit_at(double frequency, const Eigen::VectorXd& time, const Eigen::VectorXd& signal) {
  Eigen::MatrixXd columns(time.size(), 4);
  const Eigen::ArrayXd angle = 2 * std::numbers::pi * frequency * time.array();
  columns << Eigen::VectorXd::Ones(time.size()), time, angle.cos().matrix(), angle.sin().matrix();
  const Eigen::Matrix4d normal = columns.transpose() * columns;
  const Eigen::Vector4d x = normal.ldlt().solve(columns.transpose() * signal);
  return {(signal - columns * x).squaredNorm(), x(2), x(3)};
}

double left_by_line(const Eigen::VectorXd& time, const Eigen::VectorXd& signal) {
  const double mean = signal.mean(), slope = time.dot(signal) / time.squaredNorm();
  return (signal - (mean + (slope * time).array()).matrix()).squaredNorm();
}

}  // namespace

std::optional<LoadSignal> fit_load_signal(const std::vector<double>& time, const std::vector<double>& signal, double told) {
  if (time.size() != signal.size() || time.size() < 8 || !(told > 0)) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(time.size());
  const Eigen::Map<const Eigen::VectorXd> at(time.data(), n), values(signal.data(), n);
  const double middle = at.mean(), length = time.back() - time.front();
  const Eigen::VectorXd t = (at.array() - middle).matrix();
  const double nyquist = 0.5 * static_cast<double>(n - 1) / length, first = std::max(told / 2, 2 / length), last = std::min(2 * told, 0.95 * nyquist);
  double step = 1 / (8 * length), best = 0, least = left_by_line(t, values);
  const double all = least;
  for (double f = first; f <= last; f += step)
    if (const double left = fit_at(f, t, values).left; left < least) least = left, best = f;
  if (best == 0 || !(least < (1 - least_share) * all)) return std::nullopt;
  for (; step > 1e-9 * best; step /= 2)
    for (const double f : {best - step, best + step})
      if (const double left = fit_at(f, t, values).left; left < least) least = left, best = f;
  const Fit fit = fit_at(best, t, values);
  const double amplitude = std::hypot(fit.cosine, fit.sine), noise = std::sqrt(fit.left / static_cast<double>(n - 4));
  const double phase = std::atan2(fit.sine, fit.cosine) + 2 * std::numbers::pi * best * middle;
  return LoadSignal{best, std::sqrt(6.0 / static_cast<double>(n)) * noise / (std::numbers::pi * length * amplitude), std::remainder(phase, 2 * std::numbers::pi)};
}

}  // namespace arenite::thermography
