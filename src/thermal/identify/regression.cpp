#include "thermal/identify/regression.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/correlation.hpp"

namespace arenite::identify {
namespace {

constexpr std::size_t enough_for_correlation = 10;

/// Correlation of neighbouring residuals, 0 to 0.99. What n residuals of a fit show falls short of the noise's by
/// about (1 + 4 r)/n (Marriott and Pope 1954), which is put back.
double neighbour_correlation(const std::vector<double>& residuals) {
  if (residuals.size() < enough_for_correlation) return 0;
  double products = 0, squares = 0;
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    squares += residuals[k] * residuals[k];
    if (k > 0) products += residuals[k] * residuals[k - 1];
  }
  if (!(squares > 0)) return 0;
  const double n = static_cast<double>(residuals.size()), seen = products / squares;
  if (seen * std::sqrt(n) < 1.645) return 0;  // white noise shows as much in 1 of 20 cases
  return std::clamp(seen + (1 + 4 * seen) / n, 0.0, 0.99);
}

}  // namespace

Regression regress(const std::vector<double>& x, const std::vector<double>& y, bool through_origin) {
  const std::size_t unknowns = through_origin ? 1 : 2;
  if (x.size() <= unknowns) return {};
  const double n = static_cast<double>(x.size());
  auto m = statistics::second_moments(x, y);
  if (through_origin) {
    m.xx += n * m.mean_x * m.mean_x, m.xy += n * m.mean_x * m.mean_y, m.yy += n * m.mean_y * m.mean_y;
    m.mean_x = m.mean_y = 0;
  }
  if (!(m.xx > 0)) return {};
  const double slope = m.xy / m.xx, intercept = m.mean_y - slope * m.mean_x;
  std::vector<double> residuals;
  double squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    residuals.push_back(y[k] - intercept - slope * x[k]);
    squares += residuals.back() * residuals.back();
  }
  Regression r;
  r.correlation = neighbour_correlation(residuals);
  const double widening = (1 + r.correlation) / (1 - r.correlation);
  const double freedom = std::max(1.0, n / widening - static_cast<double>(unknowns));
  const double variance = squares / (n - static_cast<double>(unknowns)) * widening;
  r.slope = {slope, std::sqrt(variance / m.xx), freedom};
  r.intercept = through_origin ? statistics::Measured{0} : statistics::Measured{intercept, std::sqrt(variance * (1 / n + m.mean_x * m.mean_x / m.xx)), freedom};
  if (m.yy > 0) r.r2 = 1 - squares / m.yy;
  return r;
}

}  // namespace arenite::identify
