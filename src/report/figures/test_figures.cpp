#include "report/figures/test_figures.hpp"

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/fields/state_curves.hpp"
#include "grains/fields/test_curves.hpp"

namespace arenite::report::figures {
namespace {

using statistics::Columns;
using Values = std::vector<double>;

constexpr std::size_t many_rows = 400;  // of more a running mean is drawn over them
constexpr double largest_ratio = 2;     // beyond it the sides are all but unloaded
constexpr std::size_t few_cycles = 50;  // whose points are marked

/// Over `rows` rows, fewer at the ends, of what is known there.
Values running_mean(const Values& values, std::size_t rows) {
  Values sum{0}, count{0}, mean;
  for (const double v : values) {
    sum.push_back(sum.back() + (std::isfinite(v) ? v : 0));
    count.push_back(count.back() + (std::isfinite(v) ? 1 : 0));
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t half = std::min({rows / 2, k, values.size() - 1 - k});
    mean.push_back((sum[k + half + 1] - sum[k - half]) / (count[k + half + 1] - count[k - half]));
  }
  return mean;
}

Values known_up_to(Values values, double most) {
  for (double& v : values)
    if (!(v < most)) v = statistics::unknown;
  return values;
}

struct Ratio {
  const char *name, *label, *symbol;
};
constexpr Ratio ratios[] = {{"mu", "shear over normal stress", "\u03bc"},
                            {"q_over_p", "q/p from the forces on the sides", "q/p"},
                            {"axial_stress", "stress along the axis", "stress"}};

/// The plateau over the strains that it was taken from, with its band.
void add_critical_state(Panel& panel, const fields::CriticalState& state, double factor) {
  const auto interval = statistics::confidence_95(state.ratio);
  panel.series.push_back({.colour = "accent",
                          .x = {factor * state.from, factor * state.to},
                          .y = {state.ratio.value, state.ratio.value},
                          .low = {interval.low, interval.low},
                          .high = {interval.high, interval.high},
                          .line = Line::solid,
                          .is_read = false});
}

/// Half of the 95 % interval is told as what its mean is uncertain by.
Said with_half_interval(const char* symbol, const statistics::Measured& m) {
  const auto interval = statistics::confidence_95(m);
  return said(symbol, {m.value, 0.5 * (interval.high - interval.low)});
}

/// Whether all strain is that of the axis, as in a box with fixed sides.
bool is_confined(const fields::TestCurves& curves) {
  for (std::size_t k = 0; k < curves.strain.size(); ++k)
    if (!(std::abs(curves.volume[k] - curves.strain[k]) <= 1e-9)) return false;
  return !curves.sheared && curves.confined;
}

/// Strains of sides are in per cent, shear strains are numbers.
double factor_of(const fields::TestCurves& curves) { return curves.sheared ? 1 : 100; }

Panel against_strain(const fields::TestCurves& curves, const StageData& data, Axis y) {
  Panel panel{.x = {.label = curves.strain_name + " in \u201c" + data.stage.name + "\u201d",
                    .unit = curves.sheared ? "" : "%",
                    .brief = curves.strain_name},
              .y = std::move(y)};
  const Values* time = data.stage.history.find("time");
  for (const Snapshot* state : data.states)
    panel.now.x.push_back(factor_of(curves) * fields::at_time(*time, curves.strain, state->time));
  return panel;
}

Panel ratio_panel(const fields::TestCurves& curves, const StageData& data, const Values& strain) {
  const auto& [name, label, symbol] = *std::ranges::find(ratios, curves.ratio_name(), &Ratio::name);
  const Scale scale = scale_of(curves.ratio, curves.ratio_unit());
  Panel panel = against_strain(curves, data, {.label = label, .unit = scale.unit, .brief = symbol});
  add_curve(panel, strain,
            curves.confined ? known_up_to(curves.ratio, largest_ratio) : scaled(curves.ratio, 1 / scale.factor),
            "strong");
  return panel;
}

/// Volumetric strain, or, where all strain is volumetric, pressure.
Panel second_panel(const fields::TestCurves& curves, const StageData& data, const Values& strain) {
  if (!is_confined(curves)) {
    Panel panel = against_strain(curves, data, {.label = "volumetric strain", .unit = "%"});
    panel.references.push_back({.y = 0});
    add_curve(panel, strain, scaled(curves.volume, 100), "strong");
    return panel;
  }
  const Values pressure = fields::loading_of({data.stage, data.before})->curves["p"];
  const Scale scale = scale_of(pressure, "Pa");
  Panel panel = against_strain(curves, data, {.label = "pressure p", .unit = scale.unit, .brief = "p"});
  add_curve(panel, strain, scaled(pressure, 1 / scale.factor), "strong");
  return panel;
}

bool is_strain(const std::string& name) { return name.find("strain") != std::string::npos; }

/// "axial_strain_maximum" as words, with the symbols that quantities have.
std::string words_of(std::string name) {
  static constexpr std::pair<const char*, const char*> symbols[] = {{"q_over_p", "q/p"},
                                                                    {"mu", "\u03bc"},
                                                                    {"sigma_xx", "\u03c3_{xx}"},
                                                                    {"sigma_yy", "\u03c3_{yy}"},
                                                                    {"tau", "\u03c4"},
                                                                    {"theta_c", "\u03b8_{c}"},
                                                                    {"a_c", "a_{c}"},
                                                                    {"a_n", "a_{n}"},
                                                                    {"a_t", "a_{t}"}};
  for (const auto& [key, symbol] : symbols)
    if (name == key) return symbol;
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// Every cycle where the stage noted each, otherwise those whose states are stored.
std::optional<Columns> cycles_of(const fields::Test& test) {
  const auto* numbers = fields::loading_of(test) ? test.stage.cycles.find("cycle") : nullptr;
  if (numbers && numbers->size() > 3) return fields::every_cycle(test);
  if (fields::has_history(test.stage) && fields::whole_cycles(test.stage).size() > 1)
    return fields::curves_of_cycles(test);
  return {};
}

/// Those of the test, and what else its history has.
Columns all_curves(const fields::Test& test) {
  auto loading = fields::loading_of(test);
  Columns known = loading ? std::move(loading->curves) : Columns{};
  for (const History::Column& column : test.stage.history.columns)
    if (!known.has(column.name)) known.put(column.name, column.unit.c_str(), "", column.values);
  return known;
}

}  // namespace

CurveAxis axis_of(const statistics::Column& column) {
  const std::string words = words_of(column.name);
  if (is_strain(column.name)) return {{.label = words, .unit = "%"}, 0.01};
  const Scale scale = scale_of(column.values, column.meaning.unit.empty() ? "1" : column.meaning.unit);
  return {{.label = words, .unit = scale.unit}, scale.factor};
}

void add_curve(Panel& panel, const Values& x, Values y, const std::string& colour) {
  Series curve{.colour = colour, .x = x, .y = std::move(y), .line = Line::solid};
  if (x.size() > many_rows) {
    Series all = curve;
    all.weight = 0.45, all.opacity = 0.3, all.is_read = false;
    panel.series.push_back(std::move(all));
    curve.y = running_mean(curve.y, x.size() / 100);
  }
  panel.series.push_back(std::move(curve));
}

Panel one_against_another(const StageData& data, const std::string& x_name, const std::string& y_name) {
  const Columns known = all_curves({data.stage, data.before});
  const bool of_test = x_name == "test" && y_name == "test", sheared = known.has("mu");
  const std::string names[] = {of_test ? (sheared ? "shear_strain" : "axial_strain") : x_name,
                               of_test ? (sheared ? "mu" : "q_over_p") : y_name};
  std::vector<std::string> missing;
  for (const std::string& name : names)
    if (!known.has(name)) missing.push_back(name);
  if (!missing.empty())
    throw refusal("the stage {} has no {} to draw; there are {}", data.stage.name, list_of(missing, " and no "),
                  list_of(mapped(known.list, &statistics::Column::name), ", "));
  const CurveAxis across = axis_of(*known.find(names[0])), up = axis_of(*known.find(names[1]));
  Panel panel{.x = across.axis, .y = up.axis};
  const Values x = scaled(known[names[0]], 1 / across.factor), y = scaled(known[names[1]], 1 / up.factor);
  add_curve(panel, x, y, "strong");
  const Values& time = *data.stage.history.find("time");
  for (const Snapshot* state : data.states) {
    panel.now.x.push_back(fields::at_time(time, x, state->time));
    panel.now.y.push_back(fields::at_time(time, y, state->time));
  }
  return panel;
}

Drawings test_curves(const StageData& data) {
  const auto curves = fields::test_curves({data.stage, data.before});
  if (!curves) return {};
  const double factor = factor_of(*curves);
  const Values strain = scaled(curves->strain, factor);
  Drawing drawing;
  drawing.panels.push_back(ratio_panel(*curves, data, strain));
  if (curves->confined) drawing.panels.push_back(second_panel(*curves, data, strain));
  if (const auto state = fields::critical_state(*curves)) {
    add_critical_state(drawing.panels.front(), *state, factor);
    drawing.key.push_back({.name = "critical state, 95\u202f%",
                           .colour = "accent",
                           .numbers = {with_half_interval(curves->sheared ? "\u03bc" : "q/p", state->ratio),
                                       with_half_interval("\u03c6", state->solid_fraction)}});
  }
  return {drawing};
}

Drawings cycles(const StageData& data) {
  const fields::Test test{data.stage, data.before};
  const auto found = cycles_of(test);
  if (!found) return {};
  const auto loading = fields::loading_of(test);
  const std::string strain = loading && loading->sheared ? "shear_strain" : "axial_strain";
  if (!found->has(strain + "_maximum")) return {};
  Drawing drawing;
  Panel panel{{.label = "cycle in \u201c" + data.stage.name + "\u201d", .brief = "cycle"},
              {.label = words_of(strain), .unit = "%"}};
  const Values& cycle = (*found)["cycle"];
  for (const auto& [end, name, colour] :
       {std::tuple{"_maximum", "maximum of the load", "line 1"}, {"_minimum", "minimum of the load", "line 0"}}) {
    panel.series.push_back({.name = name,
                            .colour = colour,
                            .x = cycle,
                            .y = scaled((*found)[strain + end], 100),
                            .line = Line::solid,
                            .points = cycle.size() <= few_cycles});
    drawing.key.push_back({name, colour});
  }
  drawing.panels.push_back(std::move(panel));
  return {drawing};
}

}  // namespace arenite::report::figures
