#include "report/figures/over_runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/fields/flow_laws.hpp"

namespace arenite::report::figures {
namespace {

using statistics::Columns;
using Tests = std::vector<fields::AnyTest>;
using Values = std::vector<double>;

Axis logarithmic(std::string label, std::string brief, const Values& values) {
  const double most = largest_of(values, 0), least = least_above_zero(values, most);
  return {.label = std::move(label),
          .brief = std::move(brief),
          .logarithmic = true,
          .low = 0.8 * least,
          .high = 1.25 * most};
}

double largest_in(const Values& values) { return largest_of(values, 0); }

Series points_of(const Columns& found, const char* x, const char* y) {
  const statistics::Column& column = *found.find(y);
  return {.x = found[x], .y = column.values, .error = column.error, .points = true};
}

Series law_of(std::string name, std::pair<Values, Values> at, Line line = Line::solid) {
  return {.name = std::move(name),
          .colour = "weak",
          .x = std::move(at.first),
          .y = std::move(at.second),
          .line = line,
          .is_read = false};
}

std::string runs(std::size_t count) {
  return count == 0 ? "there is none" : count == 1 ? "there is 1" : fmt::format("there are {}", count);
}

/// Why a law is not drawn.
std::string too_few(const char* law, std::size_t count) {
  return fmt::format("{} is fitted to {} runs or more, and {}.", law, fields::least_points_of_law, runs(count));
}

bool is_empty(const Columns& found) { return found.list.front().values.empty(); }

Said in_unit(std::string symbol, const statistics::Estimate& e, double factor) {
  return said(std::move(symbol), {e.value / factor, e.error / factor});
}

/// Friction and solid fraction side by side against the first column.
Drawings both_against(const Columns& found, const Axis& x, const char* of, Axis friction, Axis solid) {
  if (is_empty(found)) return {};
  Drawing drawing;
  drawing.panels = {{.x = x, .y = std::move(friction), .series = {points_of(found, of, "mu")}},
                    {.x = x, .y = std::move(solid), .series = {points_of(found, of, "solid_fraction")}}};
  return {drawing};
}

Drawings rheology(const Tests& tests) {
  const Columns found = fields::rheology(tests);
  constexpr double least_reach = 2;
  const double most = largest_in(found["inertial_number"]);
  if (!(most > least_reach * least_above_zero(found["inertial_number"], most))) return {};  // runs of one rate
  const Axis axis = logarithmic("inertial number I", "I", found["inertial_number"]);
  return both_against(found, axis, "inertial_number", {.label = "\u03bc", .brief = "\u03bc"},
                      {.label = "solid fraction \u03c6", .brief = "\u03c6"});
}

Drawings critical_states(const Tests& tests) {
  return both_against(fields::critical_states(tests),
                      {.label = "friction of the grains \u03bc", .brief = "\u03bc of the grains", .low = 0}, "friction",
                      {.label = "critical friction \u03bc_{c}", .brief = "\u03bc_{c}"},
                      {.label = "critical solid fraction \u03c6_{c}", .brief = "\u03c6_{c}"});
}

int dimension_of(const Tests& tests) { return std::holds_alternative<fields::Test>(tests.front()) ? 2 : 3; }

/// W^(2/3), or in space W^(2/5), which the law makes a line.
Drawings beverloo(const Tests& tests) {
  const Columns found = fields::discharges(tests);
  if (is_empty(found)) return {};
  const double exponent = fields::beverloo_exponent(dimension_of(tests));
  const auto halves = std::lround(2 * exponent);
  const statistics::Column& rate = *found.find("rate");
  const auto roots = fields::roots_of_rates(rate.values, rate.error, exponent);
  const Series series{.x = scaled(found["opening"], 1e3),
                      .y = mapped(roots, &statistics::Estimate::value),
                      .error = mapped(roots, &statistics::Estimate::error),
                      .points = true};
  Panel panel{
      .x = {.label = "opening D", .unit = "mm", .brief = "D", .low = 0},
      .y = {.label = fmt::format("W^{{2/{}}}", halves), .unit = fmt::format("(kg/s)^{{2/{}}}", halves), .low = 0},
      .series = {series}};
  Drawing drawing;
  if (rate.values.size() >= fields::least_points_of_law) {
    const auto law = fields::fit_beverloo(found["opening"], rate.values, rate.error, exponent);
    const std::string name = fmt::format("W = a (D \u2212 w)^{{{}/2}}", halves);
    panel.series.push_back(law_of(name, sampled(1e3 * law.lost_width.value, 1.05 * largest_in(panel.series[0].x),
                                                [&](double d) { return law.root_at(1e-3 * d); })));
    drawing.key = {{name, "weak", {in_unit("w/mm", law.lost_width, 1e-3)}}};
  } else {
    drawing.note = too_few("Beverloo\u2019s law", rate.values.size());
  }
  drawing.panels = {panel};
  return {drawing};
}

/// Which of the two power laws is not drawn, and why.
std::string missing_runout(const fields::RunoutLaws& laws, const Values& aspect_ratio) {
  const auto count = [&](auto holds) { return static_cast<std::size_t>(std::ranges::count_if(aspect_ratio, holds)); };
  std::vector<std::string> missing;
  if (!laws.low)
    missing.push_back(fmt::format("of a \u2264 {} {}", fields::runout_bend,
                                  runs(count([](double a) { return a <= fields::runout_bend; }))));
  if (!laws.high)
    missing.push_back(fmt::format("of a \u2265 {} {}", fields::runout_bend,
                                  runs(count([](double a) { return a >= fields::runout_bend; }))));
  if (missing.empty()) return {};
  return fmt::format("A power law is fitted to {} runs or more of unlike a; {}.", fields::least_points_of_law,
                     list_of(missing));
}

Drawings runout(const Tests& tests) {
  constexpr double low_ends = 3, high_begins = 1.5;  // each law is drawn a little beyond where the two meet
  const Columns found = fields::runouts(tests);
  if (is_empty(found)) return {};
  const Values &a = found["aspect_ratio"], &way = found["runout"];
  Panel panel{.x = logarithmic("aspect ratio a", "a", a),
              .y = logarithmic("run-out (L_{\u221e} \u2212 L_{0})/L_{0}", "run-out", way),
              .series = {points_of(found, "aspect_ratio", "runout")}};
  Drawing drawing;
  const auto laws = fields::fit_runout(a, way);
  const auto add = [&](const std::optional<statistics::PowerLaw>& law, double from, double to, Line line) {
    if (!law) return;
    const std::string name = fmt::format("\u221d a^{{{:.2f}}}", law->exponent.value);
    panel.series.push_back(law_of(name, sampled(from, to, [&](double at) { return law->at(at); }), line));
    drawing.key.push_back({name, "weak", {said("n", law->exponent)}, line});
  };
  add(laws.low, least_above_zero(a, largest_in(a)), low_ends, Line::solid);
  add(laws.high, high_begins, largest_in(a), Line::dashed);
  drawing.note = missing_runout(laws, a);
  drawing.panels = {panel};
  return {drawing};
}

/// Beside the pressure of a liquid.
Drawings janssen(const Tests& tests) {
  const Columns found = fields::silos(tests);
  if (is_empty(found)) return {};
  const statistics::Column& pressure = *found.find("pressure");
  const Scale scale = scale_of(pressure.values, "Pa");
  const Values height = scaled(found["height"], 1e3);
  const auto in_unit_of_axis = [&](const Values& values) { return scaled(values, 1 / scale.factor); };
  Series points{.name = "measured",
                .x = height,
                .y = in_unit_of_axis(pressure.values),
                .error = in_unit_of_axis(pressure.error),
                .points = true};
  Panel panel{.x = {.label = "height of the filling", .unit = "mm", .brief = "height", .low = 0},
              .y = {.label = "pressure at the bottom", .unit = scale.unit, .brief = "pressure", .low = 0},
              .series = {points, law_of("as a liquid", {height, in_unit_of_axis(found["hydrostatic"])}, Line::dotted)}};
  Drawing drawing;
  if (height.size() >= fields::least_points_of_law) {
    const auto law = fields::fit_janssen(found["height"], pressure.values, pressure.error, found["hydrostatic"]);
    panel.y.high = 2 * law.saturation.value / scale.factor;
    panel.series.push_back(
        law_of("Janssen", sampled(
                              0, largest_in(height), [&](double h) { return law.at(1e-3 * h) / scale.factor; }, 120)));
    drawing.key = {{"Janssen",
                    "weak",
                    {in_unit("p_{s}/" + scale.unit, law.saturation, scale.factor), in_unit("l/mm", law.length, 1e-3)}},
                   {"as a liquid", "weak", {}, Line::dotted}};
  } else {
    drawing.note = too_few("Janssen\u2019s law", height.size());
  }
  drawing.panels = {panel};
  return {drawing};
}

}  // namespace

const std::vector<Row<Tests>>& figures_over_runs() {
  static const std::vector<Row<Tests>> list{
      {{"rheology", "rheology", "Rheology",
        "Ratio of shear and normal stress and solid fraction against the inertial number, a point a run: means over "
        "its "
        "steady part with standard errors.",
        true},
       rheology},
      {{"critical-state", "critical-state", "Critical state",
        "Friction and solid fraction of the plateau against the friction of the grains, a point a run, with standard "
        "errors.",
        true},
       critical_states},
      {{"beverloo", "beverloo", "Discharge against opening",
        "Rate of discharge W, a point a run with its standard error, and the law of Beverloo, with exponent 3/2 in the "
        "plane and 5/2 in space; w: width lost at the edges."},
       beverloo},
      {{"runout", "runout", "Run-out against aspect ratio",
        "Displacement of the front of a collapse over the width before, a point a run with its standard error, and "
        "power "
        "laws a^{n} of low and of high samples."},
       runout},
      {{"janssen", "janssen", "Pressure at the bottom of a silo",
        "Mean pressure on the floor, a point a run with its standard error; full line: Janssen\u2019s law, p = p_{s} "
        "(1 "
        "\u2212 exp(\u2212H/l)); dotted: pressure of a liquid of the same bulk density."},
       janssen}};
  return list;
}

const Row<Tests>& figure_over_runs(const std::string& id) {
  const auto& list = figures_over_runs();
  const auto at = std::ranges::find(list, id, [](const auto& row) { return row.head.id; });
  if (at == list.end()) throw refusal("there is no figure {} of several results", id);
  return *at;
}

}  // namespace arenite::report::figures
