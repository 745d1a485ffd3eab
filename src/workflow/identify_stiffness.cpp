#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "workflow/identify.hpp"
#include "workflow/identify_parts.hpp"

namespace arenite::study {
namespace {

using identify::Finding;
using identify::Group;
using identify::Identification;
using statistics::Measured;

constexpr double kN_per_mm = 1e6;
const io::Quantity stiffness_quantity{{"stiffness", "k"}, dimension::stiffness, "kN/mm"};
constexpr const char* needs = "has no columns for a stiffness; give displacement and force (a record), or stiffness (a table), or a table with the load or specimen in its first column and the "
                              "stiffnesses of one group in each other";

Finding stiffness_finding(const Measured& k) { return {"stiffness", "kN/mm", kN_per_mm, k}; }

std::vector<Finding> findings_of(const Measured& k, const StiffnessRequest& request) {
  std::vector<Finding> findings{stiffness_finding(k)};
  if (request.length) findings.push_back({"stiffness_per_length", "MPa", 1e6, statistics::product({{k, 1}, {{*request.length}, -1}})});
  return findings;
}

/// Slopes of one group's cycles; the weakest fit goes to `worst_r2`.
std::vector<std::pair<std::string, Measured>> slopes_of(const io::LaboratoryTable& table, const RowGroup& group, std::size_t force_column, const std::vector<double>& x,
                                                        const std::vector<double>& y, const StiffnessRequest& request, double& worst_r2) {
  std::vector<std::pair<std::string, Measured>> slopes;
  for (const auto& test : tests_of(table, group, force_column)) {
    const auto cycles = identify::cycles_of(curve_of(table, test, x, y), request.curve);
    for (std::size_t c = 0; c < cycles.size(); ++c) {
      const std::string number = cycles.size() > 1 ? fmt::format("cycle {}", c + 1) : "";
      slopes.emplace_back(fmt::format("{}{}{} to {:.4g} kN", test.name, test.name.empty() || number.empty() ? "" : ", ", number, cycles[c].peak / 1e3), cycles[c].stiffness);
      worst_r2 = std::min(worst_r2, cycles[c].r2);
    }
  }
  return slopes;
}

/// Adds a group; its values go to `values` for what all have in common.
void add_group(Identification& found, const std::string& name, const std::vector<std::pair<std::string, Measured>>& slopes, const StiffnessRequest& request,
               std::vector<std::vector<double>>& values) {
  std::vector<double> k;
  for (const auto& [test, slope] : slopes) k.push_back(slope.value);
  Group group{name, k.size(), findings_of(k.size() == 1 ? slopes.front().second : statistics::mean_of(k), request)};
  if (k.size() > 1)
    for (const auto& [test, slope] : slopes) group.tests.push_back({test, {stiffness_finding(slope)}});
  found.groups.push_back(std::move(group));
  values.push_back(std::move(k));
}

void add_all(Identification& found, const std::vector<std::vector<double>>& values, const StiffnessRequest& request) {
  if (values.size() < 2) return;
  std::vector<double> all;
  for (const auto& group : values) all.insert(all.end(), group.begin(), group.end());
  found.all = Group{"all", all.size(), findings_of(statistics::mean_of(all), request)};
  const double chance = statistics::chance_of_equal_means(values);
  if (std::isfinite(chance))
    found.notes.push_back(fmt::format("groups alike would differ by as much in {:.2g} % of cases (analysis of variance){}", 100 * chance, chance < 0.05 ? ": they are not alike, and the error of the mean of all is too small" : ""));
}

}  // namespace

Identification identify_stiffness(const std::string& file, const StiffnessRequest& request) {
  io::LaboratoryTable table(file);
  Identification found{"stiffness", file, {}};
  std::vector<std::vector<double>> values;
  const auto force = table.find(quantity::force), displacement = table.find(quantity::displacement);
  if (force && displacement) {
    const auto x = table.values(*displacement, quantity::displacement), y = table.values(*force, quantity::force);
    double worst_r2 = 1;
    const auto groups = groups_of(table);
    for (const auto& group : groups)
      add_group(found, group.name.empty() ? "all" : group.name, slopes_of(table, group, *force, x, y, request, worst_r2), request, values);
    if (worst_r2 < 0.99) found.notes.push_back(fmt::format("the records are not straight (least R^2 {:.3f}): k is the mean slope between preload and peak", worst_r2));
  } else {
    for (const auto& group : value_groups(table, stiffness_quantity, needs)) {
      std::vector<std::pair<std::string, Measured>> slopes;
      for (std::size_t k = 0; k < group.values.size(); ++k) {
        if (!(group.values[k] > 0)) throw InputError(file, group.lines[k], fmt::format("the stiffness is {:.4g} N/m; it must be above 0", group.values[k]));
        slopes.emplace_back(group.tests[k], Measured{group.values[k]});
      }
      add_group(found, group.name.empty() ? "all" : group.name, slopes, request, values);
    }
  }
  add_all(found, values, request);
  found.notes.insert(found.notes.end(), table.notes().begin(), table.notes().end());
  compare_with_stated(request.stated, found);
  return found;
}

}  // namespace arenite::study
