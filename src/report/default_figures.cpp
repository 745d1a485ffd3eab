#include "report/default_figures.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "core/mapped.hpp"
#include "core/text.hpp"

namespace arenite::report {
namespace {

constexpr std::size_t most_figures = 8, most_curves = 8;

/// What one asks of a run first, in the order of the page.
constexpr std::string_view known_numbers =
    "modulus_Pa strength_Pa poisson discharge.rate_kg_s surface.mean_angle_deg surface.angle_deg "
    "surface.runout_over_width floor.pressure_Pa critical_state.mu critical_state.q_over_p "
    "critical_state.solid_fraction solid_fraction coordination.all coordination.Z fabric.a_c "
    "stress_details.pressure_Pa stress_details.deviator_Pa force.mean_N sigma_norm.P0 S_m "
    "agreement.simulation_peak_to_peak.all.correlation";

struct Swept {
  std::size_t place = 0;  ///< among the table's keys
  std::string label, name;
  std::size_t values = 0;
  bool numeric = false;
};

/// Swept keys but the seed, those with numbers and the most of them first.
std::vector<Swept> swept_keys(const campaign::CollectedTable& table) {
  std::vector<Swept> keys;
  for (std::size_t k = 0; k < table.keys.size(); ++k) {
    if (table.keys[k].name == "seed") continue;
    std::set<std::string> values;
    for (const auto& row : table.rows) values.insert(row.values[k]);
    const bool numeric =
        std::ranges::all_of(values, [](const std::string& v) { return parse_number<double>(v).has_value(); });
    keys.push_back({k, label_of(table, table.keys[k].name), table.keys[k].name, values.size(), numeric});
  }
  std::ranges::stable_sort(
      keys, [](const Swept& a, const Swept& b) { return a.numeric != b.numeric ? a.numeric : a.values > b.values; });
  return keys;
}

/// Over more than a decade and without zero.
bool is_wide(const campaign::CollectedTable& table, const Swept& key) {
  const auto [low, high] = std::ranges::minmax(
      mapped(table.rows, [&](const auto& row) { return parse_number<double>(row.values[key.place]).value_or(0); }));
  return low > 0 && high >= 30 * low;
}

/// Known numbers that the runs have; of a study of another kind, what it has.
std::vector<std::string> main_numbers(const campaign::CollectedTable& table) {
  std::vector<std::string> found;
  for (const std::string_view name : split_blanks(known_numbers))
    if (found.size() < most_figures && std::ranges::count(table.names, name) > 0) found.emplace_back(name);
  for (const std::string& name : table.names)
    if (found.size() < 3 && std::ranges::count(found, name) == 0) found.push_back(name);
  return found;
}

/// "Saturation S_m" with its index as labels have it: "Saturation S_{m}".
std::string with_indices(const std::string& words) {
  static const std::regex letter_with_index("\\b([A-Za-z])_([a-z]+)\\b");
  return std::regex_replace(words, letter_with_index, "$1_{$2}");
}

}  // namespace

std::string label_of(const campaign::CollectedTable& table, const std::string& name) {
  const auto with_unit = [](const std::string& words, const std::string& unit) {
    return unit.empty() ? words : words + ", " + unit;
  };
  for (const auto& key : table.keys)
    if (key.name == name) return with_unit(name, key.unit);
  const auto at = table.meanings.find(name);
  return at == table.meanings.end()
             ? name
             : with_unit(with_indices(at->second.sentence.substr(0, at->second.sentence.find_first_of(",:;"))),
                         at->second.unit);
}

std::vector<Figure> default_figures(const campaign::CollectedTable& table) {
  const auto keys = swept_keys(table);
  if (keys.empty() || !keys.front().numeric || keys.front().values < 2) return {};
  std::vector<Figure> figures;
  for (const std::string& name : main_numbers(table)) {
    Figure figure;
    figure.id = name;
    std::ranges::replace(figure.id, '.', '-');
    figure.title = label_of(table, name);
    if (const auto at = table.meanings.find(name); at != table.meanings.end())
      figure.caption = at->second.sentence + ".";
    figure.x = keys.front().name;
    figure.x_axis = {keys.front().label, is_wide(table, keys.front()), {}, {}};
    figure.y = {name};
    if (keys.size() > 1 && keys[1].values > 1 && keys[1].values <= most_curves)
      figure.by = keys[1].name, figure.by_label = keys[1].label;
    figures.push_back(std::move(figure));
  }
  return figures;
}

Numbers runs_table(const campaign::CollectedTable& table,
                   const std::function<std::string(const std::string& run)>& link) {
  const auto numbers = main_numbers(table);
  const auto columns = mapped(numbers, [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(table.names, name) - table.names.begin());
  });
  const auto row_of = [&](const campaign::CollectedTable::Row& row) {
    const auto number_in = [&](std::size_t c) {
      const auto number = c < row.numbers.size() ? row.numbers[c] : statistics::Estimate();
      return std::isfinite(number.value) ? Numbers{number.value, number.error} : Numbers();
    };
    return Numbers{{"run", row.run},
                   {"status", row.status},
                   {"link", link ? link(row.run) : ""},
                   {"values", row.values},
                   {"numbers", mapped(columns, number_in)}};
  };
  return {{"keys", mapped(table.keys, [&](const auto& key) { return label_of(table, key.name); })},
          {"names", mapped(numbers, [&](const std::string& name) { return label_of(table, name); })},
          {"rows", mapped(table.rows, row_of)}};
}

}  // namespace arenite::report
