#include "report/study/study_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "io/table/table.hpp"
#include "statistics/difference.hpp"
#include "statistics/run_means.hpp"

namespace arenite::report {
namespace {

using StudyTable = campaign::CollectedTable;
using Row = StudyTable::Row;

double number_of(const std::string& text) { return io::to_number(text).value_or(statistics::unknown); }

std::size_t key_of(const StudyTable& table, const std::string& key, const Figure& figure) {
  const std::size_t k = index_of(table.keys, key);
  if (k == table.keys.size()) throw refusal("figure {}: `{}` is not swept by the study", figure.id, key);
  return k;
}

/// Whether a figure's `where` wants this run.
bool is_wanted(const StudyTable& table, const Row& row, const Figure& figure) {
  return std::ranges::all_of(figure.where, [&](const auto& where) {
    const std::string& here = row.values[key_of(table, where.first, figure)];
    return std::ranges::any_of(
        where.second, [&](const std::string& value) { return value == here || number_of(value) == number_of(here); });
  });
}

/// The rows of one curve: those that are wanted and have this value of `by`.
struct Group {
  std::string value, name;  ///< its name in the key
  std::vector<const Row*> rows;
};

/// By the values of `by`, numbers by size; one group where the figure has none.
std::vector<Group> groups_of(const StudyTable& table, const Figure& figure) {
  std::vector<Group> groups;
  if (figure.by.empty()) groups.emplace_back();
  const std::size_t k = figure.by.empty() ? 0 : key_of(table, figure.by, figure);
  for (const Row& row : table.rows) {
    if (!is_wanted(table, row, figure)) continue;
    const std::string value = figure.by.empty() ? "" : row.values[k];
    auto at = std::ranges::find(groups, value, &Group::value);
    if (at == groups.end()) at = groups.insert(at, {value, {}, {}});
    at->rows.push_back(&row);
  }
  if (figure.by.empty()) return groups;
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return number_of(a.value) < number_of(b.value); });
  for (Group& group : groups) {
    const std::string& unit = table.keys[k].unit;
    const std::string with_unit = unit.empty() ? group.value : group.value + " " + unit;
    group.name = group.value.empty()       ? figure.by_empty
                 : figure.by_label.empty() ? with_unit
                                           : figure.by_label + " = " + with_unit;
  }
  return groups;
}

/// The k-th of what is drawn, in a group.
std::string name_of(const Figure& figure, const Group& group, std::size_t k) {
  const std::string name = k < figure.names.size() ? figure.names[k] : "";
  return name.empty() || group.name.empty() ? name + group.name : name + ", " + group.name;
}

void add_curve(std::vector<FigureCurve>& curves, FigureCurve curve) {
  if (!curve.points.x.empty()) curves.push_back(std::move(curve));
}

statistics::SampleMean mean_of(const Figure& figure, const std::vector<Numbers>& found, const std::string& path) {
  const statistics::Sectors sectors{static_cast<std::size_t>(figure.sectors.value_or(0)), !figure.counts};
  if (figure.kind == FigureKind::rose || !figure.curve_x.empty())
    return statistics::mean_list(found, figure.curve_x, path, sectors);
  return figure.survival ? statistics::mean_survival(found, path) : statistics::mean_density(found, path);
}

/// Curves of lists and densities, with what is fitted to them; errors become deviations where the figure asks for
/// these.
std::vector<FigureCurve> list_curves(const Figure& figure, const StudyTable& table, const NumbersOf& numbers) {
  std::vector<FigureCurve> curves;
  std::size_t place = 0;
  for (const Group& group : groups_of(table, figure)) {
    for (std::size_t k = 0; k < figure.curves.size(); ++k) {
      const bool film = is_of_film(figure.curves[k]);
      const auto found =
          mapped(group.rows, [&](const Row* row) { return numbers(row->run, figure.curves[k], figure); });
      statistics::SampleMean mean = mean_of(figure, found, figure.curves[k]);
      if (figure.spread == Spread::deviation)
        for (double& error : mean.error) error = statistics::deviation_of_samples(error, mean.samples);
      FigureCurve curve{.name = name_of(figure, group, k),
                        .points = mean,
                        .group = place,
                        .part = k,
                        .film = film,
                        .fewest = mean.samples,
                        .most = mean.samples};
      FigureCurve fit{.group = place, .part = k, .film = film, .fit = true};
      if (k < figure.fits.size() && !figure.fits[k].empty())
        fit.points = statistics::tail_line(found, figure.fits[k], mean);
      add_curve(curves, std::move(curve));
      add_curve(curves, std::move(fit));
    }
    ++place;
  }
  return curves;
}

/// A number of a mean row, or one of its keys, or a number written out; "1/NAME" and "27.35/NAME" are a number over it.
statistics::Estimate value_of(const StudyTable& table, const Row& row, const std::string& name) {
  const std::size_t slash = name.find('/');
  if (const double over = number_of(name.substr(0, slash)); slash != std::string::npos && std::isfinite(over)) {
    return statistics::inverse_of(value_of(table, row, name.substr(slash + 1)), over);
  }
  if (const std::size_t k = index_of(table.keys, name); k < table.keys.size()) return {number_of(row.values[k])};
  const auto at = std::find(table.names.begin(), table.names.end(), name);
  if (at == table.names.end()) return {number_of(name)};
  return row.numbers[static_cast<std::size_t>(at - table.names.begin())];
}

/// Means over runs that differ in their seed alone, which know of how many runs each is.
class MeanRows {
 public:
  explicit MeanRows(const StudyTable& runs) : runs_(runs) {
    std::vector<std::string> names;
    std::vector<std::size_t> keys;
    for (std::size_t k = 0; k < runs.keys.size(); ++k)
      if (runs.keys[k].name != "seed") names.push_back(runs.keys[k].name), keys.push_back(k);
    table = averaged(runs, names);
    for (const Row& row : runs.rows) {
      of_values_[mapped(keys, [&](std::size_t k) { return row.values[k]; })].push_back(&row);
    }
  }

  StudyTable table;

  /// Points of `figure.x` and y by rising x, with their errors or deviations and the number of runs.
  void set_points(FigureCurve& curve, const std::vector<const Row*>& rows, const Figure& figure,
                  const std::string& y) const {
    struct Point {
      double x, y, error;
    };
    std::vector<Point> points;
    for (const Row* row : rows) {
      const auto at = value_of(table, *row, figure.x), value = value_of(table, *row, y);
      if (!std::isfinite(at.value) || !std::isfinite(value.value)) continue;
      const std::size_t n = samples(*row, y);
      const double scatter =
          figure.spread == Spread::deviation ? statistics::deviation_of_samples(value.error, n) : value.error;
      points.push_back({at.value, value.value, n > 1 ? scatter : own_error(*row, y)});
      curve.fewest = curve.fewest == 0 ? n : std::min(curve.fewest, n);
      curve.most = std::max(curve.most, n);
    }
    std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    curve.points = {mapped(points, &Point::x), mapped(points, &Point::y), mapped(points, &Point::error)};
  }

 private:
  /// Of one run what it says of itself.
  double own_error(const Row& mean, const std::string& y) const {
    const auto at = of_values_.find(mean.values);
    if (at == of_values_.end()) return statistics::unknown;
    const auto known =
        std::ranges::find_if(at->second, [&](const Row* row) { return std::isfinite(value_of(runs_, *row, y).value); });
    return known == at->second.end() ? statistics::unknown : value_of(runs_, **known, y).error;
  }

  std::size_t samples(const Row& mean, const std::string& y) const {
    const auto at = of_values_.find(mean.values);
    if (at == of_values_.end()) return 0;
    return static_cast<std::size_t>(std::ranges::count_if(
        at->second, [&](const Row* row) { return std::isfinite(value_of(runs_, *row, y).value); }));
  }

  const StudyTable& runs_;
  std::map<std::vector<std::string>, std::vector<const Row*>> of_values_;
};

/// Curves of points, each the mean of runs that differ in their seed alone.
std::vector<FigureCurve> point_curves(const Figure& figure, const StudyTable& table) {
  std::vector<FigureCurve> curves;
  const MeanRows means(table);
  std::size_t place = 0;
  for (const Group& group : groups_of(means.table, figure)) {
    for (std::size_t k = 0; k < figure.y.size(); ++k) {
      FigureCurve curve{.name = name_of(figure, group, k), .group = place, .part = k};
      means.set_points(curve, group.rows, figure, figure.y[k]);
      add_curve(curves, std::move(curve));
    }
    ++place;
  }
  return curves;
}

/// What stands beside: other runs or numbers, and what the source gives.
void add_beside(std::vector<FigureCurve>& curves, const Figure& figure, const StudyTable& table) {
  for (const BesideCurve& beside : figure.beside) {
    Figure alone;
    alone.id = figure.id, alone.x = beside.x, alone.y = {beside.y}, alone.where = beside.where,
    alone.spread = figure.spread, alone.names = {beside.name};
    for (FigureCurve& curve : point_curves(alone, table)) {
      curve.beside = true;
      curves.push_back(std::move(curve));
    }
  }
  for (const SourcePoints& points : figure.source_points) {
    FigureCurve curve{.name = points.name,
                      .part = static_cast<std::size_t>(points.part.value_or(0)),
                      .film = points.film,
                      .source = true};
    curve.points = {points.x, points.y, std::vector<double>(points.x.size(), statistics::unknown)};
    add_curve(curves, std::move(curve));
  }
}

bool is_shown(const StudyTable& table, const Row& row, const Figure& figure) {
  return row.status == "done" && is_wanted(table, row, figure);
}

}  // namespace

std::vector<FigureCurve> curves_of(const Figure& figure, const StudyTable& table, const NumbersOf& numbers) {
  if (figure.curves.empty() && figure.y.empty()) return {};
  auto curves = figure.curves.empty() ? point_curves(figure, table) : list_curves(figure, table, numbers);
  add_beside(curves, figure, table);
  return curves;
}

std::vector<std::string> filmed_runs(const std::vector<Figure>& figures, const StudyTable& table) {
  std::vector<std::string> runs;
  for (const Figure& figure : figures)
    for (const Row& row : table.rows)
      if (figure.kind == FigureKind::film && is_shown(table, row, figure) &&
          std::find(runs.begin(), runs.end(), row.run) == runs.end())
        runs.push_back(row.run);
  return runs;
}

std::string run_of(const Figure& figure, const StudyTable& table) {
  const auto at =
      std::find_if(table.rows.begin(), table.rows.end(), [&](const Row& row) { return is_shown(table, row, figure); });
  return at == table.rows.end() ? "" : at->run;
}

}  // namespace arenite::report
