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

const io::Quantity separation_quantity{{"separation_force", "mean_separation_force", "pull_off_force"}, dimension::force, ""};
constexpr const char* needs = "has no columns for an adhesion; give displacement (or time) and force (a record), or separation_force (a table), or a table with the specimen in its first column and the "
                              "separation forces of one glue in each other";
constexpr double no_trace = 50;  // k/gamma above which cohesion does not show in the mechanics (T 2.4.3)

Finding force_finding(const Measured& force) { return {"separation_force", "N", 1, force}; }

std::vector<Finding> findings_of(const Measured& force, const AdhesionRequest& request) {
  std::vector<Finding> findings{force_finding(force)};
  if (!request.stiffness || !request.radii) return findings;
  const double radius = identify::effective_radius(request.effective_radius, request.radii->first, request.radii->second);
  const Measured gamma = identify::surface_energy(force, *request.stiffness, radius);
  const auto at = identify::threshold(gamma.value, request.stiffness->value, radius);
  findings.push_back({"surface_energy", "kN/mm", 1e6, gamma});
  findings.push_back({"threshold_force", "N", 1, {at.force, force.error, force.freedom}});
  findings.push_back({"overlap_without_force", "um", 1e-6, {at.free_overlap}});
  findings.push_back({"stiffness_over_surface_energy", "", 1, {request.stiffness->value / gamma.value}});
  return findings;
}

void add_group(Identification& found, const std::string& name, const std::vector<std::pair<std::string, Measured>>& forces, const AdhesionRequest& request) {
  std::vector<double> values;
  for (const auto& [test, force] : forces) values.push_back(force.value);
  const Measured force = forces.size() == 1 ? forces.front().second : statistics::mean_of(values);
  Group group{name.empty() ? "all" : name, values.size(), findings_of(force, request)};
  if (forces.size() > 1)
    for (const auto& [test, each] : forces) group.tests.push_back({test, {force_finding(each)}});
  if (request.stiffness && request.radii && group.findings.back().value.value > no_trace)
    found.notes.push_back(fmt::format("{}: with k/gamma above {:.0f} cohesion is not expected to show in a packing's mechanics", group.name, no_trace));
  found.groups.push_back(std::move(group));
}

/// The peaks of one group's records.
std::vector<std::pair<std::string, Measured>> peaks_of(const io::LaboratoryTable& table, const RowGroup& group, std::size_t force_column, const std::vector<double>& x,
                                                       const std::vector<double>& y, std::vector<std::string>& notes) {
  std::vector<std::pair<std::string, Measured>> peaks;
  for (const auto& test : tests_of(table, group, force_column)) {
    const auto peak = identify::pull_off(curve_of(table, test, x, y));
    const std::string name = test.name.empty() ? fmt::format("record {}", peaks.size() + 1) : test.name;
    if (!peak.separated)
      notes.push_back(fmt::format("{}{}{}: the record ends before the force has fallen to half of its peak; the joint may have held more", group.name, group.name.empty() ? "" : ", ", name));
    peaks.emplace_back(name, peak.force);
  }
  return peaks;
}

}  // namespace

Identification identify_adhesion(const std::string& file, const AdhesionRequest& request) {
  io::LaboratoryTable table(file);
  Identification found{"adhesion", file, {}};
  const auto force = table.find(quantity::force), displacement = table.find(quantity::displacement), time = table.find(quantity::time);
  if (force && (displacement || time)) {
    const auto x = displacement ? table.values(*displacement, quantity::displacement) : table.values(*time, quantity::time);
    const auto y = table.values(*force, quantity::force);
    for (const auto& group : groups_of(table)) add_group(found, group.name, peaks_of(table, group, *force, x, y, found.notes), request);
  } else {
    for (const auto& group : value_groups(table, separation_quantity, needs)) {
      std::vector<std::pair<std::string, Measured>> forces;
      for (std::size_t k = 0; k < group.values.size(); ++k) {
        if (!(group.values[k] > 0))
          throw InputError(file, group.lines[k], fmt::format("{}{}{}: the separation force is {:.4g} N; write tension as a positive force", group.name, group.tests[k].empty() ? "" : ", ", group.tests[k], group.values[k]));
        forces.emplace_back(group.tests[k], Measured{group.values[k]});
      }
      add_group(found, group.name, forces, request);
    }
  }
  if (!request.stiffness || !request.radii) found.notes.push_back("the surface energy needs the stiffness of the pair and the radii: --k \"27.35 kN/mm\" --radius \"6.2 mm\"");
  found.notes.insert(found.notes.end(), table.notes().begin(), table.notes().end());
  compare_with_stated(request.stated, found);
  return found;
}

}  // namespace arenite::study
