#include "report/run_density.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "statistics/measured.hpp"

namespace arenite::report {
namespace {

using Json = nlohmann::json;

struct Density {
  std::vector<double> edge, density;
  bool shared = false;

  double at(double x) const {
    const auto above = std::upper_bound(edge.begin(), edge.end(), x);
    if (above == edge.begin() || above == edge.end()) return 0;
    return density[static_cast<std::size_t>(above - edge.begin()) - 1];
  }
};

const Json* find(const Json& root, const std::string& path) {
  const Json* at = &root;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');) {
    if (!at->is_object() || !at->contains(part)) return nullptr;
    at = &(*at)[part];
  }
  return at;
}

Density read(const Json& j) {
  Density d;
  if (j.is_object() && j.contains("x") && j.contains("y")) {
    const auto middle = j["x"].get<std::vector<double>>();
    if (middle.empty()) return d;
    d.density = j["y"].get<std::vector<double>>();
    d.shared = true;
    const double width = 2 * middle.front();
    for (std::size_t k = 0; k <= middle.size(); ++k) d.edge.push_back(static_cast<double>(k) * width);
    return d;
  }
  if (!j.is_object() || !j.contains("density")) return d;
  d.density = j["density"].get<std::vector<double>>();
  d.shared = j.contains("low");
  if (!d.shared) {
    d.edge = j.value("edge", std::vector<double>{});
    return d;
  }
  for (std::size_t k = 0; k <= d.density.size(); ++k) d.edge.push_back(j["low"].get<double>() + static_cast<double>(k) * j["width"].get<double>());
  return d;
}

/// Middles of the bins that the mean is given in.
std::vector<double> places(const std::vector<Density>& densities) {
  std::vector<double> x;
  if (densities.front().shared) {
    const auto& edge = std::max_element(densities.begin(), densities.end(), [](const Density& a, const Density& b) { return a.edge.back() < b.edge.back(); })->edge;
    for (std::size_t k = 0; k + 1 < edge.size(); ++k) x.push_back(0.5 * (edge[k] + edge[k + 1]));
    return x;
  }
  double low = densities.front().edge.front(), high = low;
  for (const Density& d : densities) {
    low = std::min(low, d.edge.front());
    high = std::max(high, d.edge.back());
  }
  constexpr int bins = 40;
  if (!(low > 0)) return x;
  for (int k = 0; k < bins; ++k) x.push_back(low * std::pow(high / low, (k + 0.5) / bins));
  return x;
}

}  // namespace

statistics::Curve mean_density(const std::vector<std::string>& numbers_json, const std::string& path) {
  std::vector<Density> densities;
  for (const std::string& text : numbers_json) {
    const Json j = Json::parse(text, nullptr, false);
    const Json* found = j.is_discarded() ? nullptr : find(j, path);
    Density d = found ? read(*found) : Density{};
    if (!d.density.empty() && d.edge.size() == d.density.size() + 1) densities.push_back(std::move(d));
  }
  statistics::Curve curve;
  if (densities.empty()) return curve;
  for (const double x : places(densities)) {
    std::vector<double> values;
    for (const Density& d : densities) values.push_back(d.at(x));
    const auto mean = statistics::mean_of(values);
    curve.x.push_back(x);
    curve.y.push_back(mean.value);
    curve.error.push_back(mean.error);
  }
  return curve;
}

statistics::Curve share_above(const statistics::Curve& density) {
  statistics::Curve curve;
  const std::size_t n = density.x.size();
  if (n < 2) return curve;
  const double width = (density.x.back() - density.x.front()) / static_cast<double>(n - 1);
  double above = 0;
  for (std::size_t k = n; k-- > 0;) {
    above += density.y[k] * width;
    curve.x.push_back(std::round((density.x[k] - 0.5 * width) * 1e9) * 1e-9);
    curve.y.push_back(above);
    curve.error.push_back(statistics::unknown);
  }
  std::reverse(curve.x.begin(), curve.x.end());
  std::reverse(curve.y.begin(), curve.y.end());
  return curve;
}

statistics::Curve mean_list(const std::vector<std::string>& numbers_json, const std::string& path_x, const std::string& path) {
  std::vector<std::vector<double>> lists;
  std::vector<double> x;
  for (const std::string& text : numbers_json) {
    const Json j = Json::parse(text, nullptr, false);
    const Json* found = j.is_discarded() ? nullptr : find(j, path);
    if (!found || !found->is_array() || (!lists.empty() && found->size() != lists.front().size())) continue;
    lists.push_back(found->get<std::vector<double>>());
    if (const Json* places = path_x.empty() ? nullptr : find(j, path_x); places && x.empty()) x = places->get<std::vector<double>>();
  }
  statistics::Curve curve;
  if (lists.empty()) return curve;
  const std::size_t n = lists.front().size();
  if (path_x.empty())
    for (std::size_t k = 0; k < n; ++k) x.push_back((static_cast<double>(k) + 0.5) * 180 / static_cast<double>(n));
  if (x.size() != n) return curve;
  double whole = 0;
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> values;
    for (const auto& list : lists) values.push_back(list[k]);
    const auto mean = statistics::mean_of(values);
    whole += mean.value;
    curve.y.push_back(mean.value);
    curve.error.push_back(mean.error);
  }
  curve.x = x;
  if (path_x.empty() && whole > 0)
    for (auto* values : {&curve.y, &curve.error})
      for (double& value : *values) value *= static_cast<double>(n) / whole;
  return curve;
}

double number_at(const std::string& numbers_json, const std::string& path) {
  const Json j = Json::parse(numbers_json, nullptr, false);
  const Json* found = j.is_discarded() ? nullptr : find(j, path);
  if (found && found->is_object() && found->contains("value")) found = &(*found)["value"];
  return found && found->is_number() ? found->get<double>() : statistics::unknown;
}

bool has_numbers(const std::string& numbers_json, const std::string& path) {
  const Json j = Json::parse(numbers_json, nullptr, false);
  return !j.is_discarded() && find(j, path);
}

}  // namespace arenite::report
