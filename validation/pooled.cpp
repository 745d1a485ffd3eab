#include "validation/pooled.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "statistics/correlation.hpp"

namespace arenite::validation {
namespace {

constexpr double degree = std::numbers::pi / 180;

std::string seed_of(const Run& run) { return run.text("seed"); }

Value mean_of(const std::vector<double>& values) { return values.empty() ? Value() : statistics::mean_of(values); }

}  // namespace

PooledMode pooled_mode(const std::vector<Run>& runs, const std::string& set, int m) {
  const std::string path = set.empty() ? "fabric" : "fabric.sets." + set, mode = path + ".modes." + std::to_string(m);
  std::complex<double> sum = 0;
  std::map<std::string, std::pair<std::complex<double>, double>> seeds;  // sum and contacts
  PooledMode pooled;
  double samples = 0;
  for (const Run& run : runs) {
    const double contacts = run(path + ".contacts"), amplitude = run(mode + ".amplitude"),
                 phase = run(mode + ".phase_deg");
    if (!std::isfinite(contacts * amplitude * phase)) continue;
    const auto vector = contacts * std::polar(amplitude, m * phase * degree);
    sum += vector;
    pooled.contacts += contacts;
    samples += 1;
    auto& seed = seeds[seed_of(run)];
    seed.first += vector;
    seed.second += contacts;
  }
  if (pooled.contacts == 0) return pooled;
  const std::complex<double> mean = sum / pooled.contacts;
  const double phase = std::arg(mean) / m / degree, n = static_cast<double>(seeds.size());
  double along = 0, across = 0;  // squares of what seeds add to the mean beyond their share of it
  for (const auto& [name, seed] : seeds) {
    const auto excess = (seed.first - seed.second * mean) * std::polar(1 / pooled.contacts, -std::arg(mean));
    along += excess.real() * excess.real();
    across += excess.imag() * excess.imag();
  }
  const double spread = n > 1 ? std::sqrt(n / (n - 1)) : statistics::unknown;
  pooled.amplitude = {std::abs(mean), spread * std::sqrt(along), n - 1};
  pooled.phase_deg = {phase < 0 ? phase + 360.0 / m : phase, spread * std::sqrt(across) / std::abs(mean) / m / degree,
                      n - 1};
  pooled.noise = 0.886 / std::sqrt(pooled.contacts);
  pooled.noise_of_one = pooled.noise * std::sqrt(samples);
  return pooled;
}

Value pooled_along(const std::vector<Run>& runs, const std::string& set, int m, double axis_deg) {
  const std::string path = set.empty() ? "fabric" : "fabric.sets." + set, mode = path + ".modes." + std::to_string(m);
  std::map<std::string, std::pair<double, double>> seeds;  // sum and contacts
  double sum = 0, all = 0;
  for (const Run& run : runs) {
    const double contacts = run(path + ".contacts"),
                 along =
                     contacts * run(mode + ".amplitude") * std::cos(m * (run(mode + ".phase_deg") - axis_deg) * degree);
    if (!std::isfinite(along)) continue;
    sum += along;
    all += contacts;
    auto& seed = seeds[seed_of(run)];
    seed.first += along;
    seed.second += contacts;
  }
  if (all == 0) return {};
  double squares = 0;
  for (const auto& [name, seed] : seeds) squares += std::pow((seed.first - seed.second * sum / all) / all, 2);
  const double n = static_cast<double>(seeds.size());
  return {sum / all, n > 1 ? std::sqrt(squares * n / (n - 1)) : statistics::unknown, n - 1};
}

double angle_between(double a_deg, double b_deg, double period) {
  return std::abs(std::remainder(a_deg - b_deg, period));
}

Value angle_from(const PooledMode& mode, double wanted_deg, double period) {
  return {angle_between(mode.phase_deg.value, wanted_deg, period), mode.phase_deg.error, mode.phase_deg.freedom};
}

Value mean_over_seeds(const std::vector<Run>& runs, const Number& number) {
  std::map<std::string, std::pair<double, double>> seeds;
  for (const Run& run : runs)
    if (const double value = number.of(run); std::isfinite(value)) {
      auto& [sum, count] = seeds[seed_of(run)];
      sum += value;
      count += 1;
    }
  std::vector<double> means;
  for (const auto& [seed, sum] : seeds) means.push_back(sum.first / sum.second);
  return mean_of(means);
}

Value slope_over_seeds(const std::vector<Run>& runs, const Number& x, const Number& y) {
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> seeds;
  for (const Run& run : runs) {
    const double at = x.of(run), value = y.of(run);
    if (!std::isfinite(at) || !std::isfinite(value)) continue;
    seeds[seed_of(run)].first.push_back(at);
    seeds[seed_of(run)].second.push_back(value);
  }
  std::vector<double> slopes;
  for (const auto& [seed, xy] : seeds)
    if (const double slope = statistics::fit_line(xy.first, xy.second).slope; std::isfinite(slope))
      slopes.push_back(slope);
  return mean_of(slopes);
}

Value paired_change(const std::vector<Run>& some, const std::vector<Run>& others, const Number& number) {
  std::vector<double> changes;
  for (const Run& one : some)
    for (const Run& other : others)
      if (const double change = number.of(one) / number.of(other) - 1;
          seed_of(one) == seed_of(other) && std::isfinite(change))
        changes.push_back(change);
  return mean_of(changes);
}

Hump hump_over_seeds(const std::vector<Run>& runs, const Number& x, const Number& y) {
  std::map<std::string, std::map<double, double>> seeds;
  for (const Run& run : runs)
    if (const double at = x.of(run), value = y.of(run); std::isfinite(at) && std::isfinite(value))
      seeds[seed_of(run)][at] = value;
  std::vector<double> rises, falls;
  for (const auto& [seed, own] : seeds) {
    std::map<double, std::vector<double>> others;
    for (const auto& [other, values] : seeds)
      for (const auto& [at, value] : values)
        if ((other != seed || seeds.size() == 1) && own.contains(at)) others[at].push_back(value);
    if (others.size() < 3 || others.size() < own.size()) continue;
    const auto greatest =
        std::ranges::max_element(others, {}, [](const auto& point) { return mean_of(point.second).value; });
    rises.push_back(own.at(greatest->first) - own.begin()->second);
    falls.push_back(own.at(greatest->first) - own.rbegin()->second);
  }
  return {mean_of(rises), mean_of(falls)};
}

PooledTail pooled_tail(const std::vector<Run>& runs, const std::string& name) {
  return {mean_over_seeds(runs, name + ".log_likelihood_ratio"), mean_over_seeds(runs, name + ".line_r2"),
          mean_over_seeds(runs, name + ".beta")};
}

}  // namespace arenite::validation
