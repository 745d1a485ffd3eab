#include "grains/fields/regime/until.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/expression.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/unit_names.hpp"
#include "grains/dem/history/history.hpp"
#include "grains/fields/discharge.hpp"
#include "grains/fields/driven.hpp"
#include "grains/fields/laboratory/curves_in_space.hpp"
#include "grains/fields/laboratory/triaxial.hpp"
#include "grains/fields/loading.hpp"

namespace arenite::fields {
namespace {

constexpr std::string_view largest_of = "largest_";  // what max(NAME) is called where it is evaluated

Dimension dimension_of_unit(std::string_view unit) {
  return unit.empty() || unit == "1" ? dimension::none : parse_unit(unit).dimension;
}

/// The parts of a text between such words.
std::vector<std::string_view> parted(std::string_view text, std::string_view word) {
  std::vector<std::string_view> parts;
  for (std::size_t at; (at = text.find(word)) != text.npos; text.remove_prefix(at + word.size()))
    parts.push_back(trimmed(text.substr(0, at)));
  parts.push_back(trimmed(text));
  return parts;
}

/// With a variable's name for each max(NAME).
std::string with_largest(std::string text) {
  constexpr std::string_view call = "max(";
  for (std::size_t at = 0; (at = text.find(call, at)) != text.npos; ++at) {
    const std::size_t end = text.find(')', at);
    if (end == text.npos) break;
    const std::string_view inside = trimmed(std::string_view(text).substr(at + call.size(), end - at - call.size()));
    if (is_plain_name(inside)) text.replace(at, end + 1 - at, std::string(largest_of) + std::string(inside));
  }
  return text;
}

/// Of a text that max(NAME) still stands in.
bool is_named_in(std::string_view text, std::string_view name) {
  for (std::size_t at = 0; (at = text.find(name, at)) != text.npos; ++at) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_name_character(text[at - 1])) && (end == text.size() || !is_name_character(text[end])))
      return true;
  }
  return false;
}

/// The columns of a history and of its curves; a curve hides a column of its name.
struct NamedValues {
  std::string name, unit;
  const std::vector<double>* values;
};
std::vector<NamedValues> named_values(const std::optional<statistics::Columns>& curves, const History& history) {
  std::vector<NamedValues> all;
  if (curves)
    for (const auto& curve : curves->list) all.push_back({curve.name, curve.meaning.unit, &curve.values});
  for (const auto& column : history.columns)
    if (std::ranges::count(all, column.name, &NamedValues::name) == 0)
      all.push_back({column.name, column.unit, &column.values});
  return all;
}

double largest_finite(const std::vector<double>& values) {
  double largest = statistics::unknown;
  for (const double v : values)
    if (std::isfinite(v) && !(v <= largest)) largest = v;
  return largest;
}

/// What the limit comes to in the last row; unknown where it cannot be computed yet.
double limit_now(const std::string& limit, const std::vector<NamedValues>& all) {
  Variables variables;
  const auto add = [&](std::string name, double value, const NamedValues& of) {
    if (is_named_in(limit, name)) variables.push_back({std::move(name), {value, dimension_of_unit(of.unit), of.unit}});
  };
  for (const NamedValues& each : all) {
    add(each.name, each.values->back(), each);
    add(std::string(largest_of) + each.name, largest_finite(*each.values), each);
  }
  try {
    return evaluate(limit, variables).value;
  } catch (const InputError&) { return statistics::unknown; }  // such as a share of a stress that is not there yet
}

/// Two rows of a sample that is pressed and sheared, or pressed along y alone, of which every curve can be told.
History two_rows(History rows, bool uniaxial) {
  for (auto& column : rows.columns) column.values = {1, 2};
  const auto set = [&](std::string_view name, std::vector<double> values) {
    const auto at = std::ranges::find(rows.columns, name, &History::Column::name);
    if (at != rows.columns.end()) at->values = std::move(values);
  };
  set("left_position", {0, 0}), set("bottom_position", {0, 0});
  set("right_position", {2, 1.9}), set("top_position", {2, 1.8});
  set("back_position", {0, 0}), set("front_position", {2, 1.7});
  if (uniaxial)
    for (const char* name : {"left_force", "right_force"}) set(name, {0, 0});
  return rows;
}

std::optional<statistics::Columns> curves_of(const StageResult& rows, const dem::Stage& /*stage*/,
                                             const Packing* strains_since) {
  if (auto of = loading_of({rows, strains_since})) return std::move(of->curves);
  return {};
}
std::optional<statistics::Columns> curves_of(const SphereResult& rows, const dem::Stage& stage,
                                             const PackingIn<3>* /*strains_since*/) {
  auto curves = curves_in_space(rows, closing_axis(stage));
  if (!curves) curves.emplace();
  if (const auto* time = rows.history.find("time")) put_discharge_rates(rows.history, *time, *curves);
  return curves;
}

void add_numbers(const std::optional<statistics::Columns>& curves, const History& history,
                 std::vector<HistoryNumber>& numbers) {
  for (const NamedValues& each : named_values(curves, history))
    if (std::ranges::count(numbers, each.name, &HistoryNumber::name) == 0)
      numbers.push_back({each.name, dimension_of_unit(each.unit)});
}

Packing one_grain() {
  Packing packing;
  packing.materials = {{"", 1, 1, 0}};
  packing.grains.resize(1);
  packing.grains.radius = {1};
  packing.domain.thickness = 1;
  return packing;
}

}  // namespace

std::vector<HistoryNumber> history_numbers(const dem::Stage& stage, const Domain& domain, bool bonded, bool cohesive) {
  std::vector<HistoryNumber> numbers;
  for (const bool uniaxial : {false, true}) {
    StageResult result;
    result.began = 0;
    result.snapshots.emplace_back().packing = one_grain();
    result.history = two_rows(dem::history_columns<2>(stage, domain, bonded, cohesive), uniaxial);
    add_driven(result, stage);
    add_numbers(curves_of(result, stage, nullptr), result.history, numbers);
  }
  return numbers;
}

std::vector<HistoryNumber> history_numbers_in_space(const dem::Stage& stage, const DomainIn<3>& domain, bool bonded,
                                                    bool cohesive) {
  std::vector<HistoryNumber> numbers;
  SphereResult result;
  result.began = 0;
  PackingIn<3>& packing = result.snapshots.emplace_back().packing;
  packing.materials = one_grain().materials;
  packing.grains.resize(1);
  packing.grains.radius = {1};
  packing.domain = domain;
  result.history = two_rows(dem::history_columns<3>(stage, domain, bonded, cohesive), false);
  add_driven(result, stage);
  add_numbers(curves_of(result, stage, nullptr), result.history, numbers);
  return numbers;
}

Until::Comparison Until::comparison_in(std::string_view text) {
  const std::size_t at = text.find_first_of("<>");
  if (at == text.npos || text.find_first_of("<>=", at + 1) != text.npos)
    throw refusal("\"{}\" is no condition; write a number, < or >, and its limit: axial_strain > 20 %", text);
  Comparison comparison{std::string(trimmed(text.substr(0, at))), text[at] == '>',
                        with_largest(std::string(trimmed(text.substr(at + 1)))), std::string(text)};
  if (!is_plain_name(comparison.name))
    throw refusal("\"{}\" must begin with the name of one number, such as axial_strain > 20 %", text);
  return comparison;
}

Until::Until(std::string_view text) {
  for (const std::string_view alternative : parted(text, " or "))
    any_.push_back(mapped(parted(alternative, " and "), [](std::string_view each) { return comparison_in(each); }));
}

void Until::check(const std::vector<HistoryNumber>& known) const {
  const auto names = mapped(known, &HistoryNumber::name);
  Variables variables;
  for (const auto& [name, dimension] : known)
    for (const std::string& each : {name, std::string(largest_of) + name})
      variables.push_back({each, {1, dimension, si_unit(dimension)}});
  for (const auto& all : any_)
    for (const Comparison& each : all) {
      const auto at = std::ranges::find(known, each.name, &HistoryNumber::name);
      if (at == known.end()) {
        const std::string near = nearest(each.name, names);
        throw refusal("the history of this stage has no number \"{}\"; {}it has: {}", each.name,
                      near.empty() ? "" : fmt::format("did you mean {}? ", near), list_of(names));
      }
      const Dimension limit = evaluate(each.limit, variables).dimension;
      if (limit != at->dimension)
        throw refusal("\"{}\" compares {} with {}", each.text, describe(at->dimension), describe(limit));
    }
}

template <int D>
std::optional<std::string> Until::met(const History& so_far, double began, const dem::Stage& stage,
                                      const PackingIn<D>* strains_since, const PackingIn<D>& sample) const {
  StageResultIn<D> rows;
  rows.began = began;
  rows.history = so_far;
  rows.snapshots.emplace_back().packing = sample;
  if (strains_since) rows.asked.box = strains_since->domain.extents();
  add_driven(rows, stage);
  const auto curves = curves_of(rows, stage, strains_since);
  const auto all = named_values(curves, rows.history);
  const auto value_if_met = [&](const Comparison& each) -> std::optional<std::string> {
    const auto at = std::ranges::find(all, each.name, &NamedValues::name);
    if (at == all.end() || at->values->empty()) return {};
    const double now = at->values->back(), limit = limit_now(each.limit, all);
    const bool holds = each.above ? now > limit : now < limit && largest_finite(*at->values) >= limit;
    if (!holds) return {};
    const bool bare = at->unit.empty() || at->unit == "1";
    return fmt::format("{} ({} = {:.6g}{})", each.text, each.name, now, bare ? "" : " " + at->unit);
  };
  for (const auto& conditions : any_) {
    std::vector<std::string> held;
    for (const Comparison& each : conditions)
      if (auto value = value_if_met(each)) held.push_back(std::move(*value));
    if (held.size() == conditions.size()) return list_of(held, " and ");
  }
  return {};
}

template std::optional<std::string> Until::met(const History&, double, const dem::Stage&, const Packing*,
                                               const Packing&) const;
template std::optional<std::string> Until::met(const History&, double, const dem::Stage&, const PackingIn<3>*,
                                               const PackingIn<3>&) const;

}  // namespace arenite::fields
