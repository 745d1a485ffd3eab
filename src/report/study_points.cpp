#include "report/study_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "io/table.hpp"

namespace arenite::report {
namespace {

using Table = study::CollectedTable;

double number_of(const std::string& text) { return io::to_number(text).value_or(statistics::unknown); }

std::size_t key_place(const Table& table, const std::string& key) {
  for (std::size_t k = 0; k < table.keys.size(); ++k)
    if (table.keys[k].name == key) return k;
  return table.keys.size();
}

std::size_t key_of(const Table& table, const std::string& key, const Figure& figure) {
  const std::size_t k = key_place(table, key);
  if (k == table.keys.size()) throw InputError(fmt::format("figure {}: `{}` is not swept by the study", figure.id, key));
  return k;
}

/// A number of a mean row, or one of its keys, or a number written out; "1/NAME" and "27.35/NAME" are a number over it.
study::Estimate value_of(const Table& table, const Table::Row& row, const std::string& name) {
  const std::size_t slash = name.find('/');
  if (const double over = number_of(name.substr(0, slash)); slash != std::string::npos && std::isfinite(over)) {
    const study::Estimate e = value_of(table, row, name.substr(slash + 1));
    return {over / e.value, e.error ? std::optional(std::abs(over) * *e.error / (e.value * e.value)) : std::nullopt};
  }
  if (const std::size_t k = key_place(table, name); k < table.keys.size()) return {number_of(row.values[k]), std::nullopt};
  const auto at = std::find(table.names.begin(), table.names.end(), name);
  if (at == table.names.end()) return {number_of(name), std::nullopt};
  const auto number = row.numbers[static_cast<std::size_t>(at - table.names.begin())];
  return number.value_or(study::Estimate{statistics::unknown, std::nullopt});
}

/// The swept keys but the seed.
std::vector<std::string> keys_of(const Table& table) {
  std::vector<std::string> keys;
  for (const auto& key : table.keys)
    if (key.name != "seed") keys.push_back(key.name);
  return keys;
}

}  // namespace

bool is_wanted(const Table& table, const Table::Row& row, const Figure& figure) {
  for (const auto& [key, values] : figure.where) {
    const std::string& here = row.values[key_of(table, key, figure)];
    const bool fits = std::any_of(values.begin(), values.end(), [&](const std::string& value) { return value == here || number_of(value) == number_of(here); });
    if (!fits) return false;
  }
  return true;
}

std::vector<std::string> groups_of(const Table& table, const Figure& figure) {
  if (figure.by.empty()) return {""};
  const std::size_t k = key_of(table, figure.by, figure);
  std::vector<std::string> values;
  for (const auto& row : table.rows)
    if (is_wanted(table, row, figure) && std::find(values.begin(), values.end(), row.values[k]) == values.end()) values.push_back(row.values[k]);
  std::stable_sort(values.begin(), values.end(), [](const std::string& a, const std::string& b) { return number_of(a) < number_of(b); });
  return values;
}

std::vector<const Table::Row*> rows_of(const Table& table, const Figure& figure, const std::string& group) {
  std::vector<const Table::Row*> rows;
  for (const auto& row : table.rows)
    if (is_wanted(table, row, figure) && (figure.by.empty() || row.values[key_of(table, figure.by, figure)] == group)) rows.push_back(&row);
  return rows;
}

std::string unit_of(const Table& table, const Figure& figure) { return figure.by.empty() ? "" : table.keys[key_of(table, figure.by, figure)].unit; }

MeanRows::MeanRows(const Table& runs) : table(averaged(runs, keys_of(runs))), runs_(runs) {
  std::vector<std::size_t> keys;
  for (std::size_t k = 0; k < runs.keys.size(); ++k)
    if (runs.keys[k].name != "seed") keys.push_back(k);
  for (const auto& row : runs.rows) {
    std::vector<std::string> values;
    for (const std::size_t k : keys) values.push_back(row.values[k]);
    of_values_[values].push_back(&row);
  }
}

std::size_t MeanRows::samples(const Table::Row& mean, const std::string& y) const {
  const auto at = of_values_.find(mean.values);
  if (at == of_values_.end()) return 0;
  return static_cast<std::size_t>(std::count_if(at->second.begin(), at->second.end(), [&](const auto* row) { return std::isfinite(value_of(runs_, *row, y).value); }));
}

void MeanRows::set_points(FigureCurve& curve, const std::vector<const Table::Row*>& rows, const Figure& figure, const std::string& y) const {
  struct Point {
    double x, y, error;
  };
  std::vector<Point> points;
  for (const auto* row : rows) {
    const auto at = value_of(table, *row, figure.x), value = value_of(table, *row, y);
    if (!std::isfinite(at.value) || !std::isfinite(value.value)) continue;
    const std::size_t n = samples(*row, y);
    const double scale = figure.spread == Spread::deviation ? std::sqrt(static_cast<double>(n)) : 1;
    points.push_back({at.value, value.value, n > 1 ? scale * value.error.value_or(statistics::unknown) : statistics::unknown});
    curve.fewest = curve.fewest == 0 ? n : std::min(curve.fewest, n);
    curve.most = std::max(curve.most, n);
  }
  std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  for (const Point& p : points) {
    curve.points.x.push_back(p.x);
    curve.points.y.push_back(p.y);
    curve.points.error.push_back(p.error);
  }
}

}  // namespace arenite::report
