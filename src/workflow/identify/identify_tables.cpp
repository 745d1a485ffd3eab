#include "workflow/identify/identify_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/unit_names.hpp"

namespace arenite::workflow {
namespace {

using Labels = std::vector<std::string>;
const Labels group_labels{"group", "material", "glue", "diameter"},
    test_labels{"curve", "specimen", "test", "load", "repeat", "cycle", "max_force"};

/// "load", "load_kN", "Load [kN]".
bool is_label(const std::string& title, const Labels& labels) {
  const std::string name = lower_case(title);
  return std::any_of(labels.begin(), labels.end(),
                     [&](const std::string& label) { return name == label || name.starts_with(label + "_"); });
}

/// Rows that say the same in all these columns, in the order of their first.
std::vector<RowGroup> rows_by(const io::LaboratoryTable& table, const std::vector<std::size_t>& rows,
                              const std::vector<std::size_t>& columns, bool with_titles) {
  std::vector<RowGroup> groups;
  for (const std::size_t row : rows) {
    std::string name;
    for (const std::size_t c : columns)
      name +=
          fmt::format("{}{}{}", name.empty() ? "" : ", ", with_titles ? table.title(c) + " " : "", table.cell(row, c));
    auto it = std::find_if(groups.rbegin(), groups.rend(), [&](const RowGroup& g) { return g.name == name; });
    if (it == groups.rend()) groups.push_back({name, {}}), it = groups.rbegin();
    it->rows.push_back(row);
  }
  return groups;
}

std::vector<std::size_t> label_columns(const io::LaboratoryTable& table, const Labels& labels,
                                       std::optional<std::size_t> taken) {
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < table.columns(); ++c)
    if (c != taken && is_label(table.title(c), labels)) columns.push_back(c);
  return columns;
}

/// Half of the last digit of a number as it is written, in its own unit.
double half_digit(std::string_view cell) {
  const auto exponent_at = cell.find_first_of("eE");
  const std::string_view digits = cell.substr(0, exponent_at);
  const auto point = digits.find('.');
  const double places = point == std::string_view::npos ? 0 : static_cast<double>(digits.size() - point - 1);
  const double exponent =
      exponent_at == std::string_view::npos ? 0 : io::to_number(cell.substr(exponent_at + 1)).value_or(0);
  return 0.5 * std::pow(10, exponent - places);
}

/// The columns of numbers of a table that has labels in its first column and a group in every other; empty if it is no
/// such table.
std::vector<std::size_t> group_columns(const io::LaboratoryTable& table) {
  if (!is_label(table.title(0), test_labels) && !is_label(table.title(0), group_labels)) return {};
  std::vector<std::size_t> columns;
  for (std::size_t c = 1; c < table.columns(); ++c)
    if (!is_label(table.title(c), test_labels) && !is_label(table.title(c), group_labels)) columns.push_back(c);
  return columns;
}

/// The tests of a group by what tells them apart: columns curve, specimen, test, load, repeat or cycle other than
/// `taken`; "load_kN -3, repeat 1".
std::vector<RowGroup> tests_of(const io::LaboratoryTable& table, const RowGroup& group,
                               std::optional<std::size_t> taken) {
  return rows_by(table, group.rows, label_columns(table, test_labels, taken), true);
}

}  // namespace

std::vector<RowGroup> groups_of(const io::LaboratoryTable& table) {
  std::vector<std::size_t> rows(table.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows_by(table, rows, label_columns(table, group_labels, {}), false);
}

namespace {

/// Nothing where the table holds no records.
std::optional<std::vector<RecordGroup>> records_of(io::LaboratoryTable& table,
                                                   const std::vector<io::Quantity>& against) {
  const auto force_column = table.find(quantity::force);
  const auto at =
      std::ranges::find_if(against, [&](const io::Quantity& quantity) { return table.find(quantity).has_value(); });
  if (!force_column || at == against.end()) return std::nullopt;
  const auto x = table.values(*table.find(*at), *at), force = table.values(*force_column, quantity::force);
  return mapped(groups_of(table), [&](const RowGroup& group) {
    RecordGroup records{group.name, {}};
    for (const RowGroup& test : tests_of(table, group, force_column)) {
      auto& curve = records.tests.emplace_back(identify::Curve{table.file(), test.name, {}, {}, {}});
      for (const std::size_t row : test.rows)
        curve.x.push_back(x[row]), curve.y.push_back(force[row]), curve.line.push_back(table.line(row));
    }
    return records;
  });
}

std::vector<TestGroup> tabulated_tests(io::LaboratoryTable& table, const io::Quantity& quantity, const char* needs,
                                       const Refusal& refusal) {
  std::vector<TestGroup> groups;
  const auto add = [&](TestGroup& group, const std::string& test, std::size_t row, double value) {
    if (!(value > 0)) throw InputError(table.file(), table.line(row), refusal(group.name, test, value));
    group.tests.push_back({test, {value}});
  };
  if (const auto column = table.find(quantity)) {
    const auto values = table.values(*column, quantity);
    for (const auto& rows : groups_of(table)) {
      TestGroup& group = groups.emplace_back(TestGroup{rows.name, {}});
      for (const auto& test : tests_of(table, rows, column))
        for (const std::size_t row : test.rows) add(group, test.name, row, values[row]);
    }
    return groups;
  }
  const bool half_a_record =
      table.find(quantity::force) || table.find(quantity::displacement) || table.find(quantity::time);
  const auto columns = group_columns(table);
  const bool load_is_label =
      table.find(quantity::force) == std::optional<std::size_t>(0) && is_label(table.title(0), test_labels);
  if (columns.empty() || (half_a_record && !load_is_label)) throw InputError(table.file(), table.header_line(), needs);
  for (const std::size_t c : columns) {
    TestGroup& group = groups.emplace_back(TestGroup{table.title(c), {}});
    const auto values = table.values(c, quantity, true);
    for (std::size_t row = 0; row < values.size(); ++row)
      if (std::isfinite(values[row]))
        add(group, table.title(0) + " " + std::string(table.cell(row, 0)), row, values[row]);
    if (group.tests.empty())
      throw refusal_at(table.file(), table.header_line(), "column {} holds no value; fill or remove it",
                       table.title(c));
  }
  return groups;
}

}  // namespace

std::vector<TestGroup> tests_in(io::LaboratoryTable& table, const TestsWanted& wanted) {
  if (const auto records = records_of(table, wanted.against))
    return mapped(*records, [&](const RecordGroup& group) { return TestGroup{group.name, wanted.cut(group)}; });
  return tabulated_tests(table, wanted.tabulated, wanted.needs, wanted.refusal);
}

identify::Identification finished(identify::Identification found, const io::LaboratoryTable& source,
                                  const std::string& file) {
  found.notes.insert(found.notes.end(), source.notes().begin(), source.notes().end());
  if (file.empty()) return found;
  io::LaboratoryTable table(file);
  std::vector<identify::Group*> groups;
  for (auto& group : found.groups) groups.push_back(&group);
  if (found.all) groups.push_back(&*found.all);
  std::vector<std::string> names;
  for (const auto* group : groups) names.push_back(group->name);
  bool any = false;
  for (auto* group : groups) {
    for (auto& finding : group->findings) {
      const std::string mean = "mean_" + finding.name;
      const io::Quantity quantity{
          {finding.name, mean}, parse_unit(finding.unit.empty() ? "1" : finding.unit).dimension, finding.unit};
      const auto column = table.find(quantity);
      if (!column) continue;
      const auto values = table.values(*column, quantity, true);
      for (std::size_t row = 0; row < values.size(); ++row) {
        any = true;
        if (table.cell(row, 0) != group->name || !std::isfinite(values[row])) continue;
        const std::string_view cell = table.cell(row, *column);
        const double written = io::to_number(cell).value_or(0);
        finding.stated = identify::Stated{
            values[row], half_digit(cell) * (written != 0 ? std::abs(values[row] / written) : finding.scale())};
      }
    }
  }
  if (!any)
    throw InputError(
        file, table.header_line(),
        "states none of the quantities found; name a column stiffness, separation_force or surface_energy");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string name(table.cell(row, 0));
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string near = nearest(name, names);
    throw refusal_at(file, table.line(row), "\"{}\" is not one of the groups of {}; {}", name, found.file,
                     near.empty() ? "use the same names" : fmt::format("did you mean \"{}\"?", near));
  }
  return found;
}

}  // namespace arenite::workflow
