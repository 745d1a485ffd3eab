#include "report/figures/test_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/fields/laboratory/axial_tests.hpp"
#include "grains/fields/laboratory/curves_in_space.hpp"
#include "grains/fields/laboratory/test_in_space.hpp"
#include "grains/fields/laboratory/triaxial.hpp"
#include "report/figures/axial_figures.hpp"

namespace arenite::report::figures {

double factor_of(const fields::TestCurves& curves) { return curves.sheared ? 1 : 100; }

namespace {

using statistics::Columns;
using Values = std::vector<double>;

constexpr std::size_t many_rows = 400;  // of more a running mean is drawn over them

struct Ratio {
  const char *name, *label, *symbol;
};
constexpr Ratio ratios[] = {{"mu", "shear over normal stress", "\u03bc"},
                            {"q_over_p", "q/p from the forces on the sides", "q/p"}};

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

Panel ratio_panel(const fields::TestCurves& curves, Panel panel, const Values& strain) {
  const auto& [name, label, symbol] = *std::ranges::find(ratios, curves.ratio_name(), &Ratio::name);
  panel.y = {.label = label, .brief = symbol};
  add_curve(panel, strain, known_up_to(curves.ratio, largest_ratio),
            known_up_to(fields::running_ratio(curves), largest_ratio), "strong");
  return panel;
}

Panel volume_panel(const fields::TestCurves& curves, Panel panel, const Values& strain) {
  panel.y = {.label = "volumetric strain", .unit = "%"};
  panel.references.push_back({.y = 0});
  add_curve(panel, strain, scaled(curves.volume, 100), "strong");
  return panel;
}

/// The axis of a test's strain, with the places of states.
template <class Stage, class States>
Panel panel_of(const fields::TestCurves& curves, const Stage& stage, const States& states, Axis y) {
  Panel panel{.x = {.label = curves.strain_name + " in \u201c" + stage.name + "\u201d",
                    .unit = curves.sheared ? "" : "%",
                    .brief = curves.strain_name},
              .y = std::move(y)};
  const Values* time = stage.history.find("time");
  for (const auto* state : states)
    panel.now.x.push_back(factor_of(curves) * fields::at_time(*time, curves.strain, state->time));
  return panel;
}

std::vector<const SnapshotIn<3>*> states_of(const SphereResult& stage) {
  return mapped(stage.snapshots, [](const SnapshotIn<3>& state) { return &state; });
}

bool is_strain(const std::string& name) { return name.find("strain") != std::string::npos; }

/// Those of the test, and what else its history has.
Columns with_history(Columns known, const History& history) {
  for (const History::Column& column : history.columns)
    if (!known.has(column.name)) known.put(column.name, column.unit.c_str(), "", column.values);
  return known;
}

Columns all_curves(const fields::Test& test) {
  auto loading = fields::loading_of(test);
  return with_history(loading ? std::move(loading->curves) : Columns{}, test.stage.history);
}

/// Two of the curves of a stage with the places of its states.
template <class Stage, class States>
Panel of_two(const Stage& stage, const Columns& known, const std::array<std::string, 2>& names, const States& states) {
  std::vector<std::string> missing;
  for (const std::string& name : names)
    if (!known.has(name)) missing.push_back(name);
  if (!missing.empty())
    throw refusal("the stage {} has no {} to draw; there are {}", stage.name, list_of(missing, " and no "),
                  list_of(mapped(known.list, &statistics::Column::name), ", "));
  const CurveAxis across = axis_of(*known.find(names[0])), up = axis_of(*known.find(names[1]));
  Panel panel{.x = across.axis, .y = up.axis};
  const Values x = scaled(known[names[0]], 1 / across.factor), y = scaled(known[names[1]], 1 / up.factor);
  add_curve(panel, x, y, "strong");
  const Values& time = *stage.history.find("time");
  for (const auto* state : states) {
    panel.now.x.push_back(fields::at_time(time, x, state->time));
    panel.now.y.push_back(fields::at_time(time, y, state->time));
  }
  return panel;
}

}  // namespace

Panel against_strain(const fields::TestCurves& curves, const StageData& data, Axis y) {
  return panel_of(curves, data.stage, data.states, std::move(y));
}

Values known_up_to(Values values, double most) {
  for (double& v : values)
    if (!(v < most)) v = statistics::unknown;
  return values;
}

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

CurveAxis axis_of(const statistics::Column& column) {
  const std::string words = words_of(column.name);
  if (is_strain(column.name)) return {{.label = words, .unit = "%"}, 0.01};
  const Scale scale = scale_of(column.values, column.meaning.unit.empty() ? "1" : column.meaning.unit);
  return {{.label = words, .unit = scale.unit}, scale.factor};
}

void add_curve(Panel& panel, const Values& x, const Values& y, const std::string& colour) {
  add_curve(panel, x, y, fields::running_mean(y), colour);
}

void add_curve(Panel& panel, const Values& x, Values y, Values mean, const std::string& colour) {
  Series curve{.colour = colour, .x = x, .y = std::move(y), .line = Line::solid};
  if (x.size() > many_rows) {
    Series all = curve;
    all.weight = 0.45, all.opacity = 0.3, all.is_read = false;
    panel.series.push_back(std::move(all));
    curve.y = std::move(mean);
  }
  panel.series.push_back(std::move(curve));
}

Panel one_against_another(const StageData& data, const std::string& x, const std::string& y) {
  const Columns known = all_curves({data.stage, data.before});
  const bool of_test = x == "test" && y == "test", sheared = known.has("mu");
  return of_two(
      data.stage, known,
      {of_test ? (sheared ? "shear_strain" : "axial_strain") : x, of_test ? (sheared ? "mu" : "q_over_p") : y},
      data.states);
}

std::optional<Panel> one_against_another(const SphereResult& stage, const std::string& x, const std::string& y) {
  auto curves = fields::curves_in_space(stage, stage.asked.closes);
  const bool of_test = x == "test" && y == "test";
  if (of_test && !curves) return {};
  const bool sheared = curves && curves->has("mu"), confined = curves && !sheared && fields::is_confined(*curves);
  const Columns known = with_history(curves ? std::move(*curves) : Columns{}, stage.history);
  const char* const ratio = sheared ? "mu" : confined ? "q_over_p" : "axial_stress";
  return of_two(stage, known, {of_test ? (sheared ? "shear_strain" : "axial_strain") : x, of_test ? ratio : y},
                states_of(stage));
}

namespace {

/// The ratio and the volume, with the critical state; panels are like `plain`, which has the strain's axis.
Drawing drawing_of_ratio(const fields::TestCurves& curves, const Panel& plain) {
  const double factor = factor_of(curves);
  const Values strain = scaled(curves.strain, factor);
  Drawing drawing;
  drawing.panels.push_back(ratio_panel(curves, plain, strain));
  drawing.panels.push_back(volume_panel(curves, plain, strain));
  const auto state = fields::critical_state(curves);
  const char* symbol = curves.sheared ? "\u03bc" : "q/p";
  if (const auto peak = fields::peak_of(curves, state)) {
    drawing.panels.front().references.push_back(
        {.x = strain[peak->row], .y = peak->ratio, .label = "peak", .colour = "accent"});
    drawing.key.push_back({"peak", "strong", {said(symbol, {peak->ratio})}});
  }
  if (state) {
    add_critical_state(drawing.panels.front(), *state, factor);
    drawing.key.push_back(
        {.name = "critical state, 95\u202f%",
         .colour = "accent",
         .numbers = {with_half_interval(symbol, state->ratio), with_half_interval("\u03c6", state->solid_fraction)}});
  }
  return drawing;
}

Drawing drawing_of_test(const fields::TestCurves& curves, const Panel& plain, const History& history) {
  return curves.confined ? drawing_of_ratio(curves, plain) : uniaxial_drawing(curves, plain, history);
}

}  // namespace

Drawings test_curves(const StageData& data) {
  const auto curves = fields::test_curves(fields::Test{data.stage, data.before});
  if (!curves) return {};
  if (fields::is_oedometric({data.stage, data.before}, *curves)) return {oedometer_drawing(*curves, data)};
  return {drawing_of_test(*curves, against_strain(*curves, data, {}), data.stage.history)};
}

Drawings test_curves(const SphereResult& stage) {
  const auto curves = fields::test_curves(stage);
  if (!curves) return {};
  return {drawing_of_test(*curves, panel_of(*curves, stage, states_of(stage), {}), stage.history)};
}

}  // namespace arenite::report::figures
