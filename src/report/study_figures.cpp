#include "report/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "io/table.hpp"
#include "report/run_density.hpp"
#include "report/tail_line.hpp"

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

bool is_wanted(const Table& table, const Table::Row& row, const Figure& figure) {
  for (const auto& [key, values] : figure.where) {
    const std::string& here = row.values[key_of(table, key, figure)];
    const bool fits = std::any_of(values.begin(), values.end(), [&](const std::string& value) { return value == here || number_of(value) == number_of(here); });
    if (!fits) return false;
  }
  return true;
}

/// Values of `by` among the wanted rows, numbers by size; one empty value where the figure has no `by`.
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

/// A number of a mean row, or one of its keys; "1/NAME" and "27.35/NAME" are a number over it.
study::Estimate value_of(const Table& table, const Table::Row& row, const std::string& name) {
  const std::size_t slash = name.find('/');
  if (const double over = number_of(name.substr(0, slash)); slash != std::string::npos && std::isfinite(over)) {
    const study::Estimate e = value_of(table, row, name.substr(slash + 1));
    return {over / e.value, e.error ? std::optional(std::abs(over) * *e.error / (e.value * e.value)) : std::nullopt};
  }
  if (const std::size_t k = key_place(table, name); k < table.keys.size()) return {number_of(row.values[k]), std::nullopt};
  const auto at = std::find(table.names.begin(), table.names.end(), name);
  const auto number = at == table.names.end() ? std::nullopt : row.numbers[static_cast<std::size_t>(at - table.names.begin())];
  return number.value_or(study::Estimate{statistics::unknown, std::nullopt});
}

statistics::Curve points_of(const Table& table, const std::vector<const Table::Row*>& rows, const Figure& figure, const std::string& y) {
  struct Point {
    double x, y, error;
  };
  std::vector<Point> points;
  for (const auto* row : rows) {
    const auto at = value_of(table, *row, figure.x), value = value_of(table, *row, y);
    if (std::isfinite(at.value) && std::isfinite(value.value)) points.push_back({at.value, value.value, row->runs > 1 ? value.error.value_or(statistics::unknown) : statistics::unknown});
  }
  std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  statistics::Curve curve;
  for (const Point& p : points) {
    curve.x.push_back(p.x);
    curve.y.push_back(p.y);
    curve.error.push_back(p.error);
  }
  return curve;
}

/// `unit`: of the values of `by`.
std::string name_of(const Figure& figure, const std::string& group, const std::string& unit, std::size_t k) {
  std::string name = k < figure.names.size() ? figure.names[k] : "";
  if (figure.by.empty()) return name;
  const std::string with_unit = unit.empty() ? group : group + " " + unit;
  const std::string value = group.empty() ? figure.by_empty : figure.by_label.empty() ? with_unit : figure.by_label + " = " + with_unit;
  return name.empty() ? value : name + ", " + value;
}

}  // namespace

std::vector<FigureCurve> curves_of(const Figure& figure, const Table& table, const NumbersOf& numbers) {
  std::vector<std::string> keys;
  for (const auto& key : table.keys)
    if (key.name != "seed") keys.push_back(key.name);
  std::vector<FigureCurve> curves;
  const bool densities = !figure.curves.empty();
  if (!densities && figure.y.empty()) return curves;
  const Table means = densities ? Table{} : averaged(table, keys);
  const Table& from = densities ? table : means;
  const std::string unit = figure.by.empty() ? "" : from.keys[key_of(from, figure.by, figure)].unit;
  std::size_t place = 0;
  for (const std::string& group : groups_of(from, figure)) {
    const auto rows = rows_of(from, figure, group);
    const std::size_t here = place++;
    for (std::size_t k = 0; k < (densities ? figure.curves : figure.y).size(); ++k) {
      FigureCurve curve{name_of(figure, group, unit, k), {}, here, k}, fit{"", {}, here, k, false, true};
      if (densities) {
        curve.film = is_of_film(figure.curves[k]);
        std::vector<std::string> texts;
        for (const auto* row : rows) texts.push_back(numbers(row->run, figure.curves[k]));
        const bool lists = figure.kind == FigureKind::rose || !figure.curve_x.empty();
        curve.points = lists ? mean_list(texts, figure.curve_x, figure.curves[k]) : mean_density(texts, figure.curves[k]);
        if (figure.share_above) curve.points = share_above(curve.points);
        if (k < figure.fits.size()) fit.points = tail_line(texts, figure.fits[k], curve.points);
      } else {
        curve.points = points_of(from, rows, figure, figure.y[k]);
      }
      for (FigureCurve* one : {&curve, &fit})
        if (!one->points.x.empty()) curves.push_back(std::move(*one));
    }
  }
  return curves;
}

bool is_of_film(const std::string& path) { return path.starts_with("film."); }

std::vector<std::string> filmed_runs(const std::vector<Figure>& figures, const Table& table) {
  std::vector<std::string> runs;
  for (const Figure& figure : figures)
    for (const auto& row : table.rows)
      if (figure.kind == FigureKind::film && row.status == "done" && is_wanted(table, row, figure) && std::find(runs.begin(), runs.end(), row.run) == runs.end())
        runs.push_back(row.run);
  return runs;
}

std::string run_of(const Figure& figure, const Table& table) {
  for (const auto& row : table.rows)
    if (row.status == "done" && is_wanted(table, row, figure)) return row.run;
  return "";
}

}  // namespace arenite::report
