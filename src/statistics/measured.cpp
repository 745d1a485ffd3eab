#include "statistics/measured.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <numbers>

namespace arenite::statistics {

namespace {

using namespace boost::math::policies;
/// What is not known stays so: no exceptions.
using Quiet = policy<domain_error<ignore_error>, overflow_error<ignore_error>, evaluation_error<ignore_error>,
                     promote_double<false>>;
using Student = boost::math::students_t_distribution<double, Quiet>;

double square(double x) { return x * x; }

double plain_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double squares_about(const std::vector<double>& values, double mean) {
  double sum = 0;
  for (const double v : values) sum += square(v - mean);
  return sum;
}

}  // namespace

double student_share(double t, double freedom) { return cdf(Student(freedom), t); }

double student_quantile(double p, double freedom) { return quantile(Student(freedom), p); }

double fisher_survival(double f, double freedom_between, double freedom_within) {
  return boost::math::ibeta(0.5 * freedom_within, 0.5 * freedom_between,
                            freedom_within / (freedom_within + freedom_between * f), Quiet());
}

Interval confidence_95(const Measured& m) {
  if (!std::isfinite(m.error) || !(m.freedom > 0)) return {};
  const double half = m.error > 0 ? student_quantile(0.975, m.freedom) * m.error : 0;
  return {m.value - half, m.value + half};
}

Measured mean_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  const double n = static_cast<double>(values.size()), mean = plain_mean(values);
  if (values.size() == 1) return {mean};
  return {mean, std::sqrt(squares_about(values, mean) / (n - 1) / n), n - 1};
}

Measured mean_of_angles(std::vector<double> values, double period) {
  const double turn = 2 * std::numbers::pi / period;
  double x = 0, y = 0;
  for (const double v : values) x += std::cos(turn * v), y += std::sin(turn * v);
  const double along = std::atan2(y, x) / turn;
  for (double& v : values) v = along + std::remainder(v - along, period);
  Measured mean = mean_of(values);
  mean.value -= period * std::floor(mean.value / period);
  return mean;
}

Measured product(const std::vector<std::pair<Measured, double>>& factors) {
  double value = 1, variance = 0, fourth = 0;
  bool known = false;
  for (const auto& [m, power] : factors) {
    value *= std::pow(m.value, power);
    if (!std::isfinite(m.error)) continue;
    known = true;
    const double part = square(power * m.error / m.value);
    variance += part;
    if (std::isfinite(m.freedom)) fourth += square(part) / m.freedom;
  }
  if (!known) return {value};
  const double freedom = fourth > 0 ? square(variance) / fourth : std::numeric_limits<double>::infinity();
  return {value, std::abs(value) * std::sqrt(variance), freedom};
}

double chance_of_equal_means(const std::vector<std::vector<double>>& groups) {
  std::vector<double> all;
  double within = 0, between = 0;
  for (const auto& group : groups) {
    if (group.empty()) return unknown;
    all.insert(all.end(), group.begin(), group.end());
    within += squares_about(group, plain_mean(group));
  }
  if (groups.size() < 2 || all.size() <= groups.size() || !(within > 0)) return unknown;
  const double mean = plain_mean(all);
  for (const auto& group : groups) between += static_cast<double>(group.size()) * square(plain_mean(group) - mean);
  const double of_groups = static_cast<double>(groups.size() - 1),
               of_values = static_cast<double>(all.size() - groups.size());
  return fisher_survival(between / of_groups / (within / of_values), of_groups, of_values);
}

}  // namespace arenite::statistics
