#include "campaign/collect.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "campaign/key_words.hpp"
#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "io/table/table.hpp"
#include "recipe/document.hpp"
#include "statistics/measured.hpp"

namespace arenite::campaign {
namespace {

using Flat = std::vector<FlatNumber>;

constexpr std::size_t most_items = 4;

bool is_number(const Numbers& j) { return j.is_number() || j.is_truth(); }

double number_in(const Numbers* j) { return j && is_number(*j) ? j->get<double>() : statistics::unknown; }

/// Tensors and pairs, not curves.
bool is_short(const Numbers& list) {
  return list.size() <= most_items && std::all_of(list.begin(), list.end(), [](const Numbers& item) {
           return is_number(item) || (item.is_list() && is_short(item));
         });
}

/// A value and the error beside it, or a list of them.
void flatten_value(const Numbers& value, const Numbers* error, const std::string& name, const Meaning* meaning,
                   Flat& out) {
  if (!value.is_list()) return out.push_back({name, {number_in(&value), number_in(error)}, meaning});
  for (std::size_t i = 0; i < value.size(); ++i)
    flatten_value(value[i], error && error->is_list() && i < error->size() ? &(*error)[i] : nullptr,
                  name + "." + std::to_string(i), meaning, out);
}

void flatten(const Numbers& j, const std::string& name, const Meaning* of_group, Flat& out) {
  const auto is_value = [](const Numbers& node) { return is_number(node) || (node.is_list() && is_short(node)); };
  const Meaning* meaning = j.meaning() ? j.meaning() : of_group;
  if (is_value(j)) return flatten_value(j, nullptr, name, meaning, out);
  if (const Numbers* value = j.at_path("/value"); j.is_tree() && value && (is_number(*value) || value->is_list())) {
    if (is_value(*value)) flatten_value(*value, j.at_path("/error"), name, meaning, out);
    return;
  }
  for (const auto& [key, inner] : j.items())
    if (key != "provenance") flatten(inner, name.empty() ? key : name + "." + key, meaning, out);
  for (const Numbers& item : j)
    if (j.is_list() && item.is_tree() && item.contains("name") && item["name"].is_text())
      flatten(item, name + "." + item["name"].get<std::string>(), meaning, out);
}

using Row = CollectedTable::Row;

/// The unit of a quantity such as "350 mm"; empty for anything else.
std::string unit_of(const std::string& text) {
  try {
    return parse_quantity(text).unit;
  } catch (const InputError&) { return {}; }
}

/// A column whose quantities all have one unit gets it into its head.
void move_unit_to_head(CollectedTable& table, std::size_t k) {
  std::string unit;
  for (const Row& row : table.rows) {
    if (row.values[k].empty()) continue;
    const std::string here = unit_of(row.values[k]);
    if (here.empty() || (!unit.empty() && here != unit)) return;
    unit = here;
  }
  table.keys[k].unit = unit;
  for (Row& row : table.rows)
    if (std::string& value = row.values[k]; !value.empty()) value = trimmed(std::string(value, 0, value.rfind(unit)));
}

/// The value as a person would write it: texts without quotes.
std::string cell_of(const std::string& literal) {
  const recipe::Node value = recipe::parse_value(literal);
  return value.kind == recipe::Node::Kind::text ? value.text : literal;
}

/// Whether a step of the name ends with the unit: "modulus_Pa", "energies_J.elastic", "work_J_per_m", "rate_grains_s".
bool says(const std::string& name, const std::string& unit) {
  const auto ends_a_step = [&](const char* over) {
    std::string text;
    for (const char c : unit.substr(unit.starts_with("1/") ? 2 : 0))
      text += c == '/' ? over : c == ' ' ? "_" : c == '^' ? "" : std::string(1, c);
    return (name + ".").find("_" + text + ".") != std::string::npos;
  };
  return ends_a_step("_") || ends_a_step("_per_");
}

std::string head(const std::string& name, const std::string& unit) {
  return io::quoted_cell(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

/// Of the runs' numbers, column by column; of angles with a period as directions.
Row mean_of(const std::vector<const Row*>& group, std::vector<std::string> values, const CollectedTable& table) {
  Row mean;
  mean.values = std::move(values);
  mean.runs = group.size();
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    std::vector<double> parts;
    for (const Row* row : group)
      if (std::isfinite(row->numbers[c].value)) parts.push_back(row->numbers[c].value);
    const auto meaning = table.meanings.find(table.names[c]);
    const double period = meaning == table.meanings.end() ? 0 : meaning->second.period;
    const statistics::Measured of_all =
        period > 0 ? statistics::mean_of_angles(parts, period) : statistics::mean_of(parts);
    mean.numbers.push_back({of_all.value, of_all.error});
  }
  return mean;
}

}  // namespace

Flat flat_numbers(const Numbers& numbers) {
  Flat flat;
  flatten(numbers, "", nullptr, flat);
  return flat;
}

CollectedTable collect(const Study& study, const StudyFolder& folder) {
  CollectedTable table;
  std::unordered_map<std::string, std::size_t> column;
  for (const auto& key : study.keys) table.keys.push_back({key, {}, words_of_key(study.tree, key)});
  for (const StudyRun& run : study.runs) {
    const RunResult result = result_of(folder, run);
    Row row;
    row.run = run.name;
    row.status = word_for(result.state.kind);
    for (const auto& key : study.keys) {
      const auto at =
          std::find_if(run.values.begin(), run.values.end(), [&](const auto& value) { return value.first == key; });
      row.values.push_back(at == run.values.end() ? "" : cell_of(at->second));
    }
    for (const auto& [name, estimate, meaning] : flat_numbers(result.numbers)) {
      const auto [at, is_new] = column.emplace(name, table.names.size());
      if (is_new) table.names.push_back(name);
      row.numbers.resize(std::max(row.numbers.size(), at->second + 1));
      row.numbers[at->second] = estimate;
      if (meaning) table.meanings.emplace(name, *meaning);
    }
    table.rows.push_back(std::move(row));
  }
  for (Row& row : table.rows) row.numbers.resize(table.names.size());
  for (std::size_t k = 0; k < table.keys.size(); ++k) move_unit_to_head(table, k);
  return table;
}

CollectedTable averaged(const CollectedTable& table, const std::vector<std::string>& keys) {
  CollectedTable result;
  result.means = true;
  result.names = table.names;
  result.meanings = table.meanings;
  std::vector<std::size_t> places;
  const auto known = mapped(table.keys, &CollectedTable::Key::name);
  for (const auto& key : keys) {
    const auto at = std::find(known.begin(), known.end(), key);
    if (at == known.end())
      throw InputError(fmt::format("{} {}: is not swept; the swept keys are: {}", option("by"), key, list_of(known)));
    places.push_back(static_cast<std::size_t>(at - known.begin()));
    result.keys.push_back(table.keys[places.back()]);
  }
  std::vector<std::pair<std::vector<std::string>, std::vector<const Row*>>> groups;
  std::map<std::vector<std::string>, std::size_t> group_of;
  for (const Row& row : table.rows) {
    if (row.status != "done") continue;
    const auto values = mapped(places, [&](std::size_t k) { return row.values[k]; });
    const auto [at, is_new] = group_of.emplace(values, groups.size());
    if (is_new) groups.push_back({values, {}});
    groups[at->second].second.push_back(&row);
  }
  for (auto& [values, group] : groups) result.rows.push_back(mean_of(group, values, table));
  return result;
}

std::string CollectedTable::unit_of_number(const std::string& name) const {
  const auto at = meanings.find(name);
  return at == meanings.end() ? std::string() : at->second.unit;
}

std::string CollectedTable::csv() const {
  // A column of errors only where there are any.
  std::vector<bool> has_error(names.size(), false);
  for (const Row& row : rows)
    for (std::size_t c = 0; c < names.size(); ++c)
      if (std::isfinite(row.numbers[c].error)) has_error[c] = true;
  std::vector<std::string> cells;
  const auto line = [&cells] {
    const std::string text = fmt::format("{}\n", list_of(cells, ","));
    cells.clear();
    return text;
  };
  if (!means) cells = {"run", "status"};
  for (const Key& key : keys) cells.push_back(head(key.name, key.unit));
  if (means) cells.emplace_back("runs");
  for (std::size_t c = 0; c < names.size(); ++c) {
    const std::string unit = unit_of_number(names[c]);
    cells.push_back(head(names[c], says(names[c], unit) ? "" : unit));
    if (has_error[c]) cells.push_back(head(names[c] + "_error", says(names[c], unit) ? "" : unit));
  }
  std::string text = line();
  for (const Row& row : rows) {
    if (!means) cells = {row.run, row.status};
    for (const auto& value : row.values) cells.push_back(io::quoted_cell(value));
    if (means) cells.push_back(std::to_string(row.runs));
    for (std::size_t c = 0; c < names.size(); ++c) {
      cells.push_back(number(row.numbers[c].value));
      if (has_error[c]) cells.push_back(number(row.numbers[c].error));
    }
    text += line();
  }
  return text;
}

std::string CollectedTable::json() const {
  Numbers list = Numbers::list();
  for (const Row& row : rows) {
    Numbers one = means ? Numbers{{"runs", row.runs}} : Numbers{{"run", row.run}, {"status", row.status}};
    Numbers swept = Numbers::tree(), numbers = Numbers::tree();
    for (std::size_t k = 0; k < keys.size(); ++k) {
      if (row.values[k].empty()) continue;
      const recipe::Node value = recipe::parse_value(row.values[k]);
      Numbers plain = value.kind == recipe::Node::Kind::integer ? Numbers(value.integer)
                      : value.kind == recipe::Node::Kind::real  ? Numbers(value.real)
                                                                : Numbers(row.values[k]);
      swept[keys[k].name] =
          keys[k].unit.empty() ? std::move(plain) : Numbers{{"value", std::move(plain)}, {"unit", keys[k].unit}};
    }
    for (std::size_t c = 0; c < names.size(); ++c) {
      const auto [value, error] = row.numbers[c];
      if (!std::isfinite(value)) continue;
      numbers[names[c]] = Numbers{{"value", value}};
      if (std::isfinite(error)) numbers[names[c]]["error"] = error;
      if (const std::string unit = unit_of_number(names[c]); !unit.empty()) numbers[names[c]]["unit"] = unit;
    }
    one["values"] = std::move(swept);
    one["numbers"] = std::move(numbers);
    list.push_back(std::move(one));
  }
  return to_json(list, 1) + "\n";
}

}  // namespace arenite::campaign
