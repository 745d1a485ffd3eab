#include "report/study/study_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "core/mapped.hpp"
#include "report/study/default_figures.hpp"

namespace arenite::report {
namespace {

using figures::Drawing;
using figures::Line;
using figures::Series;
using Values = std::vector<double>;

struct Reach {
  double low = statistics::unknown, high = statistics::unknown;
  void add(double value) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
};

bool can_show(const FigureAxis& axis, double value) { return std::isfinite(value) && (!axis.logarithmic || value > 0); }

bool within(const FigureAxis& axis, double value) {
  return value >= axis.low.value_or(value) && value <= axis.high.value_or(value);
}

bool is_density(const Figure& figure) { return !figure.curves.empty() && figure.curve_x.empty(); }

/// As far as it is asked to reach, otherwise past all values by a twentieth.
figures::Axis axis_of(const FigureAxis& axis, const std::string& name, const Reach& reach,
                      const campaign::CollectedTable& table) {
  const double size = reach.high > reach.low ? reach.high - reach.low : std::abs(reach.high) + 1e-12;
  const double part = std::pow(reach.high / reach.low, 0.04), more = 0.05 * size;
  const double low = axis.logarithmic ? reach.low / part : reach.low - more,
               high = axis.logarithmic ? reach.high * part : reach.high + more;
  return {.label = axis.label.empty() ? label_of(table, name) : axis.label,
          .unit = axis.unit,
          .logarithmic = axis.logarithmic,
          .low = axis.low.value_or(low),
          .high = axis.high.value_or(high)};
}

/// What can be shown of a curve; a density is broken where it cannot.
struct Shown {
  const FigureCurve* curve;
  Values x, y, error;

  void add(double at, double value, double of) { x.push_back(at), y.push_back(value), error.push_back(of); }
  bool is_broken() const { return !y.empty() && std::isnan(y.back()); }
};

Shown shown_of(const Figure& figure, const FigureCurve& curve) {
  Shown shown{&curve, {}, {}, {}};
  for (std::size_t k = 0; k < curve.points.x.size(); ++k) {
    const double at = curve.points.x[k] / figure.x_axis.factor, value = curve.points.y[k] / figure.y_axis.factor,
                 error = curve.points.error[k] / figure.y_axis.factor;
    if (!can_show(figure.x_axis, at) || !within(figure.x_axis, at)) continue;
    const bool is_aside = is_density(figure) && !curve.fit && !within(figure.y_axis, value);
    if (can_show(figure.y_axis, value) && !is_aside) shown.add(at, value, std::isfinite(error) ? error : 0);
    else if (is_density(figure) && !shown.y.empty() && !shown.is_broken()) shown.add(at, statistics::unknown, 0);
  }
  if (shown.is_broken()) shown.x.pop_back(), shown.y.pop_back(), shown.error.pop_back();
  return shown;
}

/// Those that have points.
std::vector<Shown> all_shown(const Figure& figure, const std::vector<FigureCurve>& curves) {
  std::vector<Shown> all;
  for (const FigureCurve& curve : curves)
    if (Shown shown = shown_of(figure, curve); !shown.x.empty()) all.push_back(std::move(shown));
  return all;
}

void reach_of(const Figure& figure, const std::vector<Shown>& all, Reach& x, Reach& y) {
  for (const Shown& shown : all)
    for (std::size_t k = 0; k < shown.x.size(); ++k) {
      const double value = shown.y[k], low = value - shown.error[k];
      if (std::isnan(value)) continue;
      x.add(shown.x[k]);
      y.add(value);
      y.add(value + shown.error[k]);
      if (can_show(figure.y_axis, low)) y.add(figure.y_axis.logarithmic ? std::max(low, 0.3 * value) : low);
    }
  for (const FigureReference& reference : figure.references) {
    if (reference.x) x.add(*reference.x);
    if (reference.y) y.add(*reference.y);
  }
}

/// Shades where curves are values of one key, distinct colours otherwise; in a plot a film's points have the colour of
/// what was simulated.
class Colours {
 public:
  Colours(const Figure& figure, const std::vector<Shown>& all) : figure_(figure) {
    std::set<std::size_t> groups;
    for (const Shown& shown : all) {
      if (shown.curve->beside || shown.curve->source) continue;
      groups.insert(shown.curve->group);
      if (!shown.curve->film && !shown.curve->fit) ++simulated_;
    }
    groups_.assign(groups.begin(), groups.end());
  }

  std::string of(const FigureCurve& curve) const {
    if (curve.beside) return "strong";
    const bool ordered = !figure_.by.empty();
    const auto group = static_cast<std::size_t>(std::ranges::find(groups_, curve.group) - groups_.begin());
    if (ordered && groups_.size() > 2)
      return fmt::format("scale {}", static_cast<double>(group) / static_cast<double>(groups_.size() - 1));
    const bool is_hollow = curve.film && !curve.source && figure_.kind == FigureKind::plot;
    const std::size_t part = is_hollow ? curve.part % std::max<std::size_t>(1, simulated_) : curve.part;
    return fmt::format("line {}", ordered ? group : part);
  }

 private:
  const Figure& figure_;
  std::vector<std::size_t> groups_;
  std::size_t simulated_ = 0;
};

/// All curves but the first of a value are dashed, a film's in a plot are dotted.
Line line_of(const Figure& figure, const FigureCurve& curve) {
  if (curve.film && figure.kind == FigureKind::plot) return Line::dotted;
  return !figure.by.empty() && curve.part > 0 ? Line::dashed : Line::solid;
}

/// Upright crosses are what the source measured where it also simulated.
const char* mark_of(const FigureCurve& curve) {
  if (curve.source) return curve.film ? "plus" : "times";
  return curve.beside ? "diamond" : curve.film ? "hollow" : "";
}

/// Points with no neighbour that is known.
Series lone_points(const Shown& shown, const std::string& colour) {
  Series lone{.colour = colour, .points = true, .weight = 0.6, .is_read = false};
  const auto is_known = [&](std::size_t k) { return k < shown.y.size() && std::isfinite(shown.y[k]); };
  for (std::size_t k = 0; k < shown.x.size(); ++k)
    if (is_known(k) && !is_known(k - 1) && !is_known(k + 1)) {
      lone.x.push_back(shown.x[k]);
      lone.y.push_back(shown.y[k]);
      lone.error.push_back(shown.error[k]);
    }
  return lone;
}

/// Densities are lines in their bands, others points with error bars, joined where the figure says so; what is fitted
/// is a line, and what the source gives are crosses.
void add_curve(figures::Panel& panel, const Figure& figure, const Shown& shown, const std::string& colour) {
  const FigureCurve& curve = *shown.curve;
  if (curve.fit) {
    panel.series.push_back({.colour = "strong",
                            .x = shown.x,
                            .y = shown.y,
                            .line = curve.film ? Line::dotted : Line::dashed,
                            .weight = 0.9,
                            .is_read = false});
    return;
  }
  Series series{.name = curve.name, .colour = colour, .x = shown.x, .y = shown.y, .error = shown.error};
  if (!curve.source && is_density(figure) && figure.lines) {
    series.line = line_of(figure, curve);
    if (std::ranges::any_of(shown.error, [](double e) { return e > 0; }))
      for (std::size_t k = 0; k < shown.x.size(); ++k) {
        const double low = shown.y[k] - shown.error[k];
        series.low.push_back(figure.y_axis.logarithmic ? std::max(low, *panel.y.low) : low);
        series.high.push_back(shown.y[k] + shown.error[k]);
      }
    panel.series.push_back(std::move(series));
    if (Series lone = lone_points(shown, colour); !lone.x.empty()) panel.series.push_back(std::move(lone));
    return;
  }
  const bool is_upright = curve.beside && std::ranges::all_of(shown.x, [&](double x) { return x == shown.x.front(); });
  series.points = true;
  series.mark = mark_of(curve);
  if (figure.lines && !curve.source && !is_upright) series.line = line_of(figure, curve);
  panel.series.push_back(std::move(series));
}

/// An entry for every curve, where there are several or it has a name.
std::vector<figures::KeyEntry> key_of(const Figure& figure, const std::vector<Shown>& all, const Colours& colours) {
  std::vector<figures::KeyEntry> key;
  for (const Shown& shown : all) {
    const FigureCurve& curve = *shown.curve;
    if (curve.fit) continue;
    const bool has_mark = curve.source || curve.beside;
    key.push_back({.name = curve.name,
                   .colour = colours.of(curve),
                   .line = has_mark ? Line::solid : line_of(figure, curve),
                   .mark = has_mark ? mark_of(curve) : ""});
  }
  if (key.size() == 1 && key.front().name.empty()) key.clear();
  return key;
}

Drawing plot_of(const Figure& figure, const std::vector<Shown>& all, const campaign::CollectedTable& table) {
  Reach x, y;
  reach_of(figure, all, x, y);
  const std::string name = !figure.curves.empty() ? figure.curves.front() : figure.y.empty() ? "" : figure.y.front();
  const Colours colours(figure, all);
  figures::Panel panel{
      .x = axis_of(figure.x_axis, figure.x, x, table), .y = axis_of(figure.y_axis, name, y, table), .near = true};
  for (const FigureReference& r : figure.references)
    panel.references.push_back({r.x, r.y, r.slope, r.label, "source", Line::dashed});
  for (const Shown& shown : all) add_curve(panel, figure, shown, colours.of(*shown.curve));
  return {.panels = {std::move(panel)}, .key = key_of(figure, all, colours)};
}

/// Two to four round numbers.
Values rings_of_counts(double largest) {
  const double power = std::pow(10, std::floor(std::log10(largest / 2)));
  double step = power;
  for (const double digit : {2., 5.})
    if (2 * digit * power <= largest * (1 + 1e-9)) step = digit * power;
  Values rings;
  for (int k = 1; k * step <= largest * (1 + 1e-9); ++k) rings.push_back(k * step);
  return rings;
}

/// Of fractions over the isotropic one, which is among them.
Values rings_of_shares(double largest) {
  const double step = largest > 6 ? 2 : largest > 2.5 ? 1 : 0.5;
  Values rings;
  for (int k = 1; k * step <= largest * (1 + 1e-9); ++k) rings.push_back(k * step);
  if (std::ranges::find(rings, 1.) == rings.end()) rings.insert(rings.begin(), 1);
  return rings;
}

Drawing rose_of(const Figure& figure, const std::vector<Shown>& all) {
  const Colours colours(figure, all);
  figures::Outlines outlines{.reach = figure.counts ? 1e-9 : 1.3, .isotropic = !figure.counts};
  for (const Shown& shown : all) {
    for (std::size_t k = 0; k < shown.x.size(); ++k)
      outlines.reach = std::max(outlines.reach, shown.y[k] + shown.error[k]);
    outlines.series.push_back({.name = shown.curve->name,
                               .colour = colours.of(*shown.curve),
                               .x = shown.x,
                               .y = shown.y,
                               .error = shown.error,
                               .line = line_of(figure, *shown.curve)});
  }
  outlines.rings = figure.counts ? rings_of_counts(outlines.reach) : rings_of_shares(outlines.reach);
  if (figure.counts) outlines.corner = "N_{c}";
  auto key = key_of(figure, all, colours);
  std::erase_if(key, [](const auto& entry) { return entry.name.empty(); });
  return {.key = std::move(key), .outlines = std::move(outlines)};
}

Drawing map_of(const Figure& figure, const std::vector<Shown>& all, const campaign::CollectedTable& table) {
  std::set<double> columns;
  for (const Shown& shown : all) columns.insert(shown.x.begin(), shown.x.end());
  figures::Cells cells{.x = axis_of(figure.x_axis, figure.x, {}, table)};
  cells.x.low = cells.x.high = {};
  for (const double x : columns) cells.x.names.push_back(fmt::format("{:.3g}", x));
  for (const Shown& shown : all) {
    cells.y.names.push_back(shown.curve->name);
    for (const double x : columns) {
      const auto k = static_cast<std::size_t>(std::ranges::find(shown.x, x) - shown.x.begin());
      cells.values.push_back(k < shown.x.size() ? shown.y[k] : statistics::unknown);
      cells.error.push_back(k < shown.x.size() ? shown.error[k] : statistics::unknown);
    }
  }
  return {.cells = std::move(cells)};
}

}  // namespace

Drawing drawing_of(const Figure& figure, const std::vector<FigureCurve>& curves,
                   const campaign::CollectedTable& table) {
  const auto all = all_shown(figure, curves);
  if (all.empty()) return {};
  if (figure.kind == FigureKind::rose) return rose_of(figure, all);
  return figure.kind == FigureKind::map ? map_of(figure, all, table) : plot_of(figure, all, table);
}

}  // namespace arenite::report
