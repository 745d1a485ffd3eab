#include "workflow/identify/identify_curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "thermal/identify/constants.hpp"
#include "workflow/identify/identify_tables.hpp"

namespace arenite::workflow {
namespace {

using identify::Finding;
using identify::Group;
using identify::Identification;
using statistics::Measured;

const io::Quantity stiffness_quantity{{"stiffness", "k"}, dimension::stiffness, "kN/mm"};
constexpr const char* needs_of_stiffness =
    "has no columns for a stiffness; give displacement and force (a record), or stiffness (a table), or a table with "
    "the load or specimen in its first column and the stiffnesses of one group in each other";

using Tests = decltype(TestGroup::tests);

std::vector<double> values_of(const Tests& tests) {
  return mapped(tests, [](const auto& test) { return test.second.value; });
}

/// Its findings are those of the tests' mean, or of the only one; the first of them is what each test has, too.
template <class Findings> Group group_of(const std::string& name, const Tests& tests, const Findings& findings) {
  Group group{name.empty() ? "all" : name, tests.size(),
              findings(tests.size() == 1 ? tests.front().second : statistics::mean_of(values_of(tests)))};
  if (tests.size() == 1) return group;
  for (const auto& [test, each] : tests) {
    group.tests.push_back({test, 0, {group.findings.front()}});
    group.tests.back().findings.front().value = each;
  }
  return group;
}

/// Slopes of one group's cycles; the weakest fit goes to `worst_r2`.
Tests slopes_of(const RecordGroup& group, const identify::StiffnessOptions& options, double& worst_r2) {
  Tests slopes;
  for (const auto& test : group.tests) {
    const auto cycles = identify::cycles_of(test, options);
    for (std::size_t c = 0; c < cycles.size(); ++c) {
      const std::string number = cycles.size() > 1 ? fmt::format("cycle {}", c + 1) : "";
      slopes.emplace_back(fmt::format("{}{}{} to {:.4g} kN", test.name, test.name.empty() || number.empty() ? "" : ", ",
                                      number, cycles[c].peak / 1e3),
                          cycles[c].stiffness);
      worst_r2 = std::min(worst_r2, cycles[c].r2);
    }
  }
  return slopes;
}

void add_all(Identification& found, const std::vector<TestGroup>& groups, const StiffnessRequest& request) {
  if (groups.size() < 2) return;
  std::vector<double> all;
  const auto values = mapped(groups, [](const TestGroup& group) { return values_of(group.tests); });
  for (const auto& each : values) all.insert(all.end(), each.begin(), each.end());
  found.all = Group{"all", all.size(), identify::stiffness_findings(statistics::mean_of(all), request.length)};
  const double chance = statistics::chance_of_equal_means(values);
  if (std::isfinite(chance))
    found.notes.push_back(
        fmt::format("equal groups would differ this much in {:.2g} % of cases (analysis of variance){}", 100 * chance,
                    chance < 0.05 ? ": they are not equal, and the error of the mean of all is too small" : ""));
}

}  // namespace

Identification identify_stiffness(const std::string& file, const StiffnessRequest& request) {
  io::LaboratoryTable table(file);
  Identification found{"stiffness", file, {}};
  double worst_r2 = 1;
  const auto slopes = [&](const RecordGroup& group) { return slopes_of(group, request.curve, worst_r2); };
  const auto refusal = [](const auto&, const auto&, double value) {
    return fmt::format("the stiffness is {:.4g} N/m; it must be above 0", value);
  };
  const auto groups =
      tests_in(table, {{quantity::displacement}, slopes, stiffness_quantity, needs_of_stiffness, refusal});
  if (worst_r2 < 0.99)
    found.notes.push_back(fmt::format(
        "the records are not linear (smallest R^2 {:.3f}): k is the mean slope between preload and peak", worst_r2));
  for (const auto& [name, tests] : groups)
    found.groups.push_back(
        group_of(name, tests, [&](const Measured& k) { return identify::stiffness_findings(k, request.length); }));
  add_all(found, groups, request);
  return finished(std::move(found), table, request.stated);
}

namespace {

const io::Quantity separation_quantity{
    {"separation_force", "mean_separation_force", "pull_off_force"}, dimension::force, ""};
constexpr const char* needs_of_adhesion =
    "has no columns for an adhesion; give displacement (or time) and force (a record), or separation_force (a table), "
    "or a table with the specimen in its first column and the separation forces of one glue in each other";

std::optional<identify::Pair> pair_of(const AdhesionRequest& request) {
  if (!request.stiffness || !request.radii) return std::nullopt;
  return identify::Pair{*request.stiffness, identify::effective_radius(request.effective_radius, request.radii->first,
                                                                       request.radii->second)};
}

void add_group(Identification& found, const std::string& name, const Tests& forces, const AdhesionRequest& request) {
  const auto pair = pair_of(request);
  found.groups.push_back(
      group_of(name, forces, [&](const Measured& force) { return identify::adhesion_findings(force, pair); }));
  const Group& group = found.groups.back();
  if (pair && group.findings.back().value.value > identify::no_trace_of_cohesion)
    found.notes.push_back(
        fmt::format("{}: with k/gamma above {:.0f} cohesion is not expected to affect the mechanics of a packing",
                    group.name, identify::no_trace_of_cohesion));
}

/// The peaks of one group's records.
Tests peaks_of(const RecordGroup& group, std::vector<std::string>& notes) {
  Tests peaks;
  for (const auto& test : group.tests) {
    const auto peak = identify::pull_off(test);
    const std::string name = test.name.empty() ? fmt::format("record {}", peaks.size() + 1) : test.name;
    if (!peak.separated)
      notes.push_back(fmt::format(
          "{}{}{}: the record ends before the force has fallen to half of its peak; the glue may have held more",
          group.name, group.name.empty() ? "" : ", ", name));
    peaks.emplace_back(name, peak.force);
  }
  return peaks;
}

}  // namespace

Identification identify_adhesion(const std::string& file, const AdhesionRequest& request) {
  io::LaboratoryTable table(file);
  Identification found{"adhesion", file, {}};
  const auto peaks = [&](const RecordGroup& group) { return peaks_of(group, found.notes); };
  const auto refusal = [](const std::string& group, const std::string& test, double value) {
    return fmt::format("{}{}{}: the separation force is {:.4g} N; write tension as a positive force", group,
                       test.empty() ? "" : ", ", test, value);
  };
  const auto groups = tests_in(
      table, {{quantity::displacement, quantity::time}, peaks, separation_quantity, needs_of_adhesion, refusal});
  for (const auto& group : groups) add_group(found, group.name, group.tests, request);
  if (!request.stiffness || !request.radii)
    found.notes.push_back("the surface energy needs the stiffness of the pair and the radii: " + option("k") +
                          " \"27.35 kN/mm\" " + option("radius") + " \"6.2 mm\"");
  return finished(std::move(found), table, request.stated);
}

}  // namespace arenite::workflow
