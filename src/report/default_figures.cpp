#include "report/study_page.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/mapped.hpp"
#include "core/text.hpp"

namespace arenite::report {
namespace {

constexpr std::size_t most_figures = 8, most_curves = 8;

/// In the order of the page.
const std::vector<MainNumber>& known_numbers() {
  static const std::vector<MainNumber> numbers{
      {"modulus_Pa", "modulus E, Pa"},
      {"strength_Pa", "strength, Pa"},
      {"poisson", "Poisson's ratio"},
      {"discharge.rate_kg_s", "rate of discharge, kg/s"},
      {"surface.mean_angle_deg", "mean angle of the surface, deg"},
      {"surface.angle_deg", "angle of repose, deg"},
      {"surface.runout_over_width", "run-out over the first width"},
      {"floor.pressure_Pa", "pressure at the floor, Pa"},
      {"critical_state.mu", "critical friction"},
      {"critical_state.q_over_p", "critical q/p"},
      {"critical_state.solid_fraction", "critical solid fraction"},
      {"solid_fraction", "solid fraction"},
      {"coordination.all", "coordination z"},
      {"coordination.Z", "neighbours Z"},
      {"fabric.a_c", "anisotropy a_{c}"},
      {"stress_details.pressure_Pa", "pressure p, Pa"},
      {"stress_details.deviator_Pa", "deviator q, Pa"},
      {"force.mean_N", "mean force, N"},
      {"sigma_norm.P0", "grains above the mean stress"},
      {"S_m", "matrix in the pores S_{m}"},
      {"agreement.simulation_peak_to_peak.all.correlation", "correlation with the simulation"},
  };
  return numbers;
}

std::string label_of(const campaign::CollectedTable::Key& key) { return key.unit.empty() ? key.name : key.name + ", " + key.unit; }

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
    const bool numeric = std::ranges::all_of(values, [](const std::string& v) { return parse_number<double>(v).has_value(); });
    keys.push_back({k, label_of(table.keys[k]), table.keys[k].name, values.size(), numeric});
  }
  std::ranges::stable_sort(keys, [](const Swept& a, const Swept& b) { return a.numeric != b.numeric ? a.numeric : a.values > b.values; });
  return keys;
}

/// Over two decades and without zero.
bool is_wide(const campaign::CollectedTable& table, const Swept& key) {
  double low = 0, high = 0;
  for (const auto& row : table.rows) {
    const double v = parse_number<double>(row.values[key.place]).value_or(0);
    low = low == 0 ? v : std::min(low, v);
    high = std::max(high, v);
  }
  return low > 0 && high >= 30 * low;
}

}  // namespace

std::vector<MainNumber> main_numbers(const campaign::CollectedTable& table) {
  std::vector<MainNumber> found;
  for (const MainNumber& number : known_numbers())
    if (found.size() < most_figures && std::ranges::count(table.names, number.name) > 0) found.push_back(number);
  for (const std::string& name : table.names)  // of a study of another kind, what it has
    if (found.size() < 3 && std::ranges::none_of(found, [&](const MainNumber& n) { return n.name == name; })) found.push_back({name, name});
  return found;
}

std::vector<Figure> default_figures(const campaign::CollectedTable& table) {
  const auto keys = swept_keys(table);
  if (keys.empty() || !keys.front().numeric || keys.front().values < 2) return {};
  std::vector<Figure> figures;
  for (const MainNumber& number : main_numbers(table)) {
    Figure figure;
    figure.id = number.name;
    std::ranges::replace(figure.id, '.', '-');
    figure.title = number.label.substr(0, number.label.find(','));
    figure.title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(figure.title.front())));
    figure.x = keys.front().name;
    figure.x_axis = {keys.front().label, is_wide(table, keys.front()), {}, {}};
    figure.y = {number.name};
    figure.y_axis.label = number.label;
    if (keys.size() > 1 && keys[1].values > 1 && keys[1].values <= most_curves) figure.by = keys[1].name, figure.by_label = keys[1].label;
    figures.push_back(std::move(figure));
  }
  return figures;
}

Numbers runs_table(const campaign::CollectedTable& table, const std::function<std::string(const std::string& run)>& link) {
  const auto numbers = main_numbers(table);
  const auto columns =
      mapped(numbers, [&](const MainNumber& number) { return static_cast<std::size_t>(std::ranges::find(table.names, number.name) - table.names.begin()); });
  const auto row_of = [&](const campaign::CollectedTable::Row& row) {
    const auto number_in = [&](std::size_t c) {
      const auto number = c < row.numbers.size() ? row.numbers[c] : statistics::Estimate();
      return std::isfinite(number.value) ? Numbers{number.value, number.error} : Numbers();
    };
    return Numbers{
        {"run", row.run}, {"status", row.status}, {"link", link ? link(row.run) : ""}, {"values", row.values}, {"numbers", mapped(columns, number_in)}};
  };
  return {{"keys", mapped(table.keys, label_of)}, {"names", mapped(numbers, &MainNumber::label)}, {"rows", mapped(table.rows, row_of)}};
}

}  // namespace arenite::report
