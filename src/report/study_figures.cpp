#include "report/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/run_density.hpp"
#include "report/study_points.hpp"
#include "report/tail_line.hpp"

namespace arenite::report {
namespace {

using Table = study::CollectedTable;

/// `unit`: of the values of `by`.
std::string name_of(const Figure& figure, const std::string& group, const std::string& unit, std::size_t k) {
  std::string name = k < figure.names.size() ? figure.names[k] : "";
  if (figure.by.empty()) return name;
  const std::string with_unit = unit.empty() ? group : group + " " + unit;
  const std::string value = group.empty() ? figure.by_empty : figure.by_label.empty() ? with_unit : figure.by_label + " = " + with_unit;
  return name.empty() ? value : name + ", " + value;
}

/// Points as they are drawn: errors become deviations where the figure asks for these.
void set_points(FigureCurve& curve, SampleMean mean, const Figure& figure) {
  const double n = static_cast<double>(mean.samples);
  if (figure.spread == Spread::deviation)
    for (double& error : mean.error) error *= std::sqrt(n);
  curve.fewest = curve.most = mean.samples;
  curve.points = std::move(mean);
}

SampleMean mean_of(const Figure& figure, const std::vector<Numbers>& found, const std::string& path) {
  const Sectors sectors{static_cast<std::size_t>(figure.sectors.value_or(0)), !figure.counts};
  if (figure.kind == FigureKind::rose || !figure.curve_x.empty()) return mean_list(found, figure.curve_x, path, sectors);
  return figure.share_above ? mean_share_above(found, path) : mean_density(found, path);
}

void add_curve(std::vector<FigureCurve>& curves, FigureCurve curve) {
  if (!curve.points.x.empty()) curves.push_back(std::move(curve));
}

/// Curves of lists and densities, with what is fitted to them.
std::vector<FigureCurve> list_curves(const Figure& figure, const Table& table, const NumbersOf& numbers) {
  std::vector<FigureCurve> curves;
  const std::string unit = unit_of(table, figure);
  std::size_t place = 0;
  for (const std::string& group : groups_of(table, figure)) {
    const auto rows = rows_of(table, figure, group);
    const std::size_t here = place++;
    for (std::size_t k = 0; k < figure.curves.size(); ++k) {
      const bool film = is_of_film(figure.curves[k]);
      std::vector<Numbers> found;
      for (const auto* row : rows) found.push_back(numbers(row->run, figure.curves[k], figure));
      FigureCurve curve{.name = name_of(figure, group, unit, k), .group = here, .part = k, .film = film};
      set_points(curve, mean_of(figure, found, figure.curves[k]), figure);
      FigureCurve fit{.group = here, .part = k, .film = film, .fit = true};
      if (k < figure.fits.size() && !figure.fits[k].empty()) fit.points = tail_line(found, figure.fits[k], curve.points);
      add_curve(curves, std::move(curve));
      add_curve(curves, std::move(fit));
    }
  }
  return curves;
}

/// Curves of points, each the mean of runs that differ in their seed alone.
std::vector<FigureCurve> point_curves(const Figure& figure, const Table& table) {
  std::vector<FigureCurve> curves;
  const MeanRows means(table);
  const std::string unit = unit_of(means.table, figure);
  std::size_t place = 0;
  for (const std::string& group : groups_of(means.table, figure)) {
    const auto rows = rows_of(means.table, figure, group);
    const std::size_t here = place++;
    for (std::size_t k = 0; k < figure.y.size(); ++k) {
      FigureCurve curve{.name = name_of(figure, group, unit, k), .group = here, .part = k};
      means.set_points(curve, rows, figure, figure.y[k]);
      add_curve(curves, std::move(curve));
    }
  }
  return curves;
}

/// What stands beside: other runs or numbers, and what the source gives.
void add_beside(std::vector<FigureCurve>& curves, const Figure& figure, const Table& table) {
  for (const BesideCurve& beside : figure.beside) {
    Figure alone;
    alone.id = figure.id, alone.x = beside.x, alone.y = {beside.y}, alone.where = beside.where, alone.spread = figure.spread, alone.names = {beside.name};
    for (FigureCurve& curve : point_curves(alone, table)) {
      curve.beside = true;
      curves.push_back(std::move(curve));
    }
  }
  for (const SourcePoints& points : figure.source_points) {
    FigureCurve curve{.name = points.name, .part = static_cast<std::size_t>(points.part.value_or(0)), .film = points.film, .source = true};
    curve.points = {points.x, points.y, std::vector<double>(points.x.size(), statistics::unknown)};
    add_curve(curves, std::move(curve));
  }
}

}  // namespace

std::vector<FigureCurve> curves_of(const Figure& figure, const Table& table, const NumbersOf& numbers) {
  if (figure.curves.empty() && figure.y.empty()) return {};
  auto curves = figure.curves.empty() ? point_curves(figure, table) : list_curves(figure, table, numbers);
  add_beside(curves, figure, table);
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
