#include "report/tail_line.hpp"

#include <cmath>

#include "report/run_density.hpp"
#include "statistics/measured.hpp"

namespace arenite::report {
namespace {

double mean_number(const std::vector<std::string>& numbers_json, const std::string& path) {
  std::vector<double> values;
  for (const std::string& text : numbers_json)
    if (const double value = number_at(text, path); std::isfinite(value)) values.push_back(value);
  return values.empty() ? statistics::unknown : statistics::mean_of(values).value;
}

}  // namespace

statistics::Curve tail_line(const std::vector<std::string>& numbers_json, const std::string& path, const statistics::Curve& density) {
  const double slope = mean_number(numbers_json, path + ".slope"), low = mean_number(numbers_json, path + ".low"),
               high = mean_number(numbers_json, path + ".high");
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < density.x.size(); ++k)
    if (density.x[k] > low && density.x[k] < high && density.y[k] > 0) sum += std::log(density.y[k]) + slope * density.x[k], ++count;
  if (count == 0) return {};
  const double level = std::exp(sum / count);
  return {{low, high}, {level * std::exp(-slope * low), level * std::exp(-slope * high)}, {statistics::unknown, statistics::unknown}};
}

}  // namespace arenite::report
