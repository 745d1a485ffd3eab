#include "statistics/run_means.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/mapped.hpp"
#include "statistics/measured.hpp"
#include "statistics/sectors.hpp"

namespace arenite::statistics {
namespace {

struct KeptDensity {
  std::vector<double> edge, density;
  bool shared = false;

  double at(double x) const {
    const auto above = std::upper_bound(edge.begin(), edge.end(), x);
    if (above == edge.begin() || above == edge.end()) return 0;
    return density[static_cast<std::size_t>(above - edge.begin()) - 1];
  }
};

/// At a dotted path.
const Numbers* find(const Numbers& root, std::string path) {
  std::replace(path.begin(), path.end(), '.', '/');
  return root.at_path("/" + path);
}

KeptDensity read(const Numbers& j) {
  KeptDensity d;
  const bool middles = j.is_tree() && j.contains("x") && j.contains("y");
  if (middles ? j["x"].empty() : !j.is_tree() || !j.contains("density")) return d;
  d.density = j[middles ? "y" : "density"].get<std::vector<double>>();
  d.shared = middles || j.contains("low");
  if (!d.shared) {
    d.edge = j.value("edge", std::vector<double>{});
    return d;
  }
  const double low = middles ? 0 : j["low"].get<double>(),
               width = middles ? 2 * j["x"].front().get<double>() : j["width"].get<double>();
  const std::size_t bins = middles ? j["x"].size() : d.density.size();
  for (std::size_t k = 0; k <= bins; ++k) d.edge.push_back(low + static_cast<double>(k) * width);
  return d;
}

/// Middles of the bins that the mean is given in.
std::vector<double> places(const std::vector<KeptDensity>& densities) {
  std::vector<double> x;
  if (densities.front().shared) {
    const auto& edge =
        std::ranges::max_element(densities, {}, [](const KeptDensity& d) { return d.edge.back(); })->edge;
    for (std::size_t k = 0; k + 1 < edge.size(); ++k) x.push_back(0.5 * (edge[k] + edge[k + 1]));
    return x;
  }
  const double low = std::ranges::min(mapped(densities, [](const KeptDensity& d) { return d.edge.front(); }));
  const double high = std::ranges::max(mapped(densities, [](const KeptDensity& d) { return d.edge.back(); }));
  constexpr int bins = 40;
  if (!(low > 0)) return x;
  for (int k = 0; k < bins; ++k) x.push_back(low * std::pow(high / low, (k + 0.5) / bins));
  return x;
}

std::vector<KeptDensity> densities_of(const std::vector<Numbers>& runs, const std::string& path) {
  std::vector<KeptDensity> densities;
  for (const Numbers& run : runs) {
    const Numbers* found = find(run, path);
    KeptDensity d = found ? read(*found) : KeptDensity{};
    if (!d.density.empty() && d.edge.size() == d.density.size() + 1) densities.push_back(std::move(d));
  }
  return densities;
}

/// Mean of the lists, place by place.
SampleMean mean_of_lists(std::vector<double> x, const std::vector<std::vector<double>>& lists) {
  SampleMean mean;
  mean.x = std::move(x);
  mean.samples = lists.size();
  for (std::size_t k = 0; k < mean.x.size(); ++k) {
    const auto one = mean_of(mapped(lists, [&](const auto& list) { return list[k]; }));
    mean.y.push_back(one.value);
    mean.error.push_back(one.error);
  }
  return mean;
}

std::vector<double> middles_of_sectors(std::size_t n) {
  std::vector<double> x;
  for (std::size_t k = 0; k < n; ++k) x.push_back((static_cast<double>(k) + 0.5) * 180 / static_cast<double>(n));
  return x;
}

/// Counts in sectors of half a turn as counts in n of them: each gives to those that it overlaps.
std::vector<double> shared_out(const std::vector<double>& counts, std::size_t n) {
  if (n == 0 || n == counts.size()) return counts;
  const double from = 1.0 / static_cast<double>(counts.size()), to = 1.0 / static_cast<double>(n);
  std::vector<double> shared(n, 0.0);
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const double low = std::max(static_cast<double>(i) * from, static_cast<double>(k) * to);
      const double high = std::min(static_cast<double>(i + 1) * from, static_cast<double>(k + 1) * to);
      if (high > low) shared[k] += counts[i] * (high - low) / from;
    }
  return shared;
}

double mean_number(const std::vector<Numbers>& runs, const std::string& path) {
  std::vector<double> values;
  for (const Numbers& run : runs)
    if (const double value = number_at(run, path); std::isfinite(value)) values.push_back(value);
  return values.empty() ? unknown : mean_of(values).value;
}

/// ln of the level of exp(-slope x) that fits the density best in its logarithm, points of weight w; NaN without any.
double level_of(const Curve& density, double slope, const std::vector<double>& weight) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < density.x.size(); ++k)
    if (weight[k] > 0 && density.y[k] > 0)
      sum += weight[k] * (std::log(density.y[k]) + slope * density.x[k]), count += weight[k];
  return count > 0 ? sum / count : unknown;
}

/// In so many steps: on a linear axis an exponential is no straight line.
Curve line_between(double low, double high, double slope, double level, int steps) {
  Curve line;
  if (!std::isfinite(level)) return line;
  for (int k = 0; k <= steps; ++k) {
    line.x.push_back(low + (high - low) * k / steps);
    line.y.push_back(std::exp(level - slope * line.x.back()));
    line.error.push_back(unknown);
  }
  return line;
}

/// Of a survival function: each point weighs as much as there is between it and the next.
Curve regression(double slope, const Curve& share) {
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

double deviation_of_samples(double standard_error, std::size_t samples) {
  return standard_error * std::sqrt(static_cast<double>(samples));
}

SampleMean mean_density(const std::vector<Numbers>& runs, const std::string& path) {
  const auto densities = densities_of(runs, path);
  if (densities.empty()) return {};
  auto x = places(densities);
  const auto lists =
      mapped(densities, [&](const KeptDensity& d) { return mapped(x, [&](double at) { return d.at(at); }); });
  return mean_of_lists(std::move(x), lists);
}

SampleMean mean_survival(const std::vector<Numbers>& runs, const std::string& path) {
  const auto densities = densities_of(runs, path);
  if (densities.empty()) return {};
  const auto middles = places(densities);
  const std::size_t n = middles.size();
  if (n < 2) return {};
  const double width = (middles.back() - middles.front()) / static_cast<double>(n - 1);
  std::vector<std::vector<double>> lists;
  for (const KeptDensity& d : densities) {
    auto& list = lists.emplace_back(n);
    double above = 0;
    for (std::size_t k = n; k-- > 0;) list[k] = above += d.at(middles[k]) * width;
  }
  return mean_of_lists(mapped(middles, [&](double at) { return std::round((at - 0.5 * width) * 1e9) * 1e-9; }), lists);
}

SampleMean mean_list(const std::vector<Numbers>& runs, const std::string& path_x, const std::string& path,
                     Sectors sectors) {
  std::vector<std::vector<double>> lists;
  std::vector<double> x;
  for (const Numbers& run : runs) {
    const Numbers* found = find(run, path);
    if (!found || !found->is_list()) continue;
    auto list = found->get<std::vector<double>>();
    if (path_x.empty()) list = shared_out(list, sectors.count);
    if (!lists.empty() && list.size() != lists.front().size()) continue;
    lists.push_back(std::move(list));
    if (const Numbers* at = path_x.empty() ? nullptr : find(run, path_x); at && x.empty())
      x = at->get<std::vector<double>>();
  }
  if (lists.empty()) return {};
  if (path_x.empty()) x = middles_of_sectors(lists.front().size());
  if (x.size() != lists.front().size()) return {};
  SampleMean mean = mean_of_lists(std::move(x), lists);
  const double whole = std::accumulate(mean.y.begin(), mean.y.end(), 0.0);
  if (path_x.empty() && sectors.shares && whole > 0)
    for (auto* values : {&mean.y, &mean.error}) *values = over_isotropic(std::move(*values), whole);
  return mean;
}

double number_at(const Numbers& run, const std::string& path) {
  const Numbers* found = find(run, path);
  if (found && found->is_tree() && found->contains("value")) found = &(*found)["value"];
  return found && found->is_number() ? found->get<double>() : unknown;
}

bool has_numbers(const Numbers& run, const std::string& path) { return find(run, path) != nullptr; }

Curve tail_line(const std::vector<Numbers>& runs, const std::string& path, const Curve& density) {
  const double slope = mean_number(runs, path + ".slope"), low = mean_number(runs, path + ".low"),
               high = mean_number(runs, path + ".high");
  if (!std::isfinite(slope)) return regression(mean_number(runs, path + ".beta_line"), density);
  const auto weight = mapped<double>(density.x, [&](double x) { return x > low && x < high; });
  return line_between(low, high, slope, level_of(density, slope, weight), 1);
}

}  // namespace arenite::statistics
