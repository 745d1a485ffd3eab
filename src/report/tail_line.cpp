#include "report/tail_line.hpp"

#include <cmath>

#include "report/run_density.hpp"
#include "statistics/measured.hpp"

namespace arenite::report {
namespace {

double mean_number(const std::vector<Numbers>& runs, const std::string& path) {
  std::vector<double> values;
  for (const Numbers& run : runs)
    if (const double value = number_at(run, path); std::isfinite(value)) values.push_back(value);
  return values.empty() ? statistics::unknown : statistics::mean_of(values).value;
}

/// ln of the level of exp(-slope x) that fits the density best in its logarithm, points of weight w; NaN without any.
double level_of(const statistics::Curve& density, double slope, const std::vector<double>& weight) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < density.x.size(); ++k)
    if (weight[k] > 0 && density.y[k] > 0) sum += weight[k] * (std::log(density.y[k]) + slope * density.x[k]), count += weight[k];
  return count > 0 ? sum / count : statistics::unknown;
}

/// In so many steps: on a linear axis an exponential is no straight line.
statistics::Curve line_between(double low, double high, double slope, double level, int steps) {
  statistics::Curve line;
  if (!std::isfinite(level)) return line;
  for (int k = 0; k <= steps; ++k) {
    line.x.push_back(low + (high - low) * k / steps);
    line.y.push_back(std::exp(level - slope * line.x.back()));
    line.error.push_back(statistics::unknown);
  }
  return line;
}

/// Of a share above x: each point weighs as much as there is between it and the next.
statistics::Curve regression(double slope, const statistics::Curve& share) {
  std::vector<double> weight(share.x.size(), 0.0);
  double high = 1;
  for (std::size_t k = 0; k + 1 < share.x.size(); ++k) {
    if (share.x[k] < 1 || !(share.y[k] > 0)) continue;
    weight[k] = share.y[k] - share.y[k + 1];
    high = share.x[k];
  }
  return line_between(1, high, slope, level_of(share, slope, weight), 40);
}

}  // namespace

statistics::Curve tail_line(const std::vector<Numbers>& runs, const std::string& path, const statistics::Curve& density) {
  const double slope = mean_number(runs, path + ".slope"), low = mean_number(runs, path + ".low"),
               high = mean_number(runs, path + ".high");
  if (!std::isfinite(slope)) return regression(mean_number(runs, path + ".beta_line"), density);
  std::vector<double> weight;
  for (const double x : density.x) weight.push_back(x > low && x < high ? 1 : 0);
  return line_between(low, high, slope, level_of(density, slope, weight), 1);
}

}  // namespace arenite::report
