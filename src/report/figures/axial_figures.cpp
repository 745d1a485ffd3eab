#include "report/figures/axial_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "grains/fields/laboratory/axial_tests.hpp"
#include "grains/fields/loading.hpp"
#include "model/kinds.hpp"
#include "report/figures/test_figures.hpp"

namespace arenite::report::figures {
namespace {

using Values = std::vector<double>;

/// The straight line whose slope is the modulus, through the curve where it has half of the strength.
Series modulus_line(const fields::UniaxialTest& test, const Panel& panel, double factor) {
  const Series& curve = panel.series.back();
  const double sign = test.in_tension ? -1 : 1, most = test.strength / factor, half = 0.5 * most;
  const auto at = std::ranges::find_if(curve.y, [&](double v) { return sign * v >= half; });
  const double strain = curve.x[static_cast<std::size_t>(at - curve.y.begin())];
  const double slope = test.modulus / factor / 100;  // strains are in per cent
  const auto where = [&](double stress) { return strain + sign * (stress - half) / slope; };
  return {
      .colour = "accent", .x = {where(0), where(most)}, .y = {0, sign * most}, .line = Line::dashed, .is_read = false};
}

void add_modulus(Drawing& drawing, double modulus) {
  if (std::isfinite(modulus))
    drawing.key.push_back({"modulus", "accent", {said_in_unit("E", {modulus}, "Pa")}, Line::dashed});
}

/// Nothing where grains have no bonds.
std::optional<Panel> broken_panel(const Panel& plain, const History& history, const Values& strain, Drawing& drawing) {
  Panel panel = plain;
  panel.y = {.label = "broken bonds", .low = 0};
  for (std::size_t way = 1; way < bond_breaks.size(); ++way) {
    const std::string name(bond_breaks[way]), colour = "broken " + std::to_string(way - 1);
    if (const Values* count = history.find("broken_in_" + name)) {
      panel.series.push_back({.name = name, .colour = colour, .x = strain, .y = *count, .line = Line::solid});
      drawing.key.push_back({"broken in " + name, colour});
    }
  }
  if (panel.series.empty()) return {};
  return panel;
}

}  // namespace

Drawing uniaxial_drawing(const fields::TestCurves& curves, const Panel& plain, const History& history) {
  const Values strain = scaled(curves.strain, 100);
  const Scale scale = scale_of(curves.ratio, "Pa");
  Drawing drawing;
  Panel panel = plain;
  panel.y = {.label = "stress along the axis", .unit = scale.unit, .brief = "stress"};
  add_curve(panel, strain, scaled(curves.ratio, 1 / scale.factor), "strong");
  if (const auto test = fields::uniaxial_test(curves)) {
    const double sign = test->in_tension ? -1 : 1;
    if (std::isfinite(test->modulus)) panel.series.push_back(modulus_line(*test, panel, scale.factor));
    panel.references.push_back({.x = sign * 100 * test->strain,
                                .y = sign * test->strength / scale.factor,
                                .label = test->failed ? "strength" : "largest stress",
                                .colour = "accent"});
    drawing.key.push_back(
        {test->failed ? "strength" : "largest stress", "strong", {said_in_unit("\u03c3", {test->strength}, "Pa")}});
    add_modulus(drawing, test->modulus);
  }
  drawing.panels.push_back(std::move(panel));
  if (auto broken = broken_panel(plain, history, strain, drawing)) drawing.panels.push_back(std::move(*broken));
  return drawing;
}

Drawing oedometer_drawing(const fields::TestCurves& curves, const StageData& data) {
  const fields::Test test{data.stage, data.before};
  const auto loading = fields::loading_of(test);
  const Values strain = scaled(curves.strain, 100);
  const std::string along = loading->upright ? "sigma_yy" : "sigma_xx",
                    across = loading->upright ? "sigma_xx" : "sigma_yy";
  const auto stress = [&](const std::string& name) {
    return loading->curves.has(name) ? loading->curves[name] : Values(strain.size(), statistics::unknown);
  };
  const Scale scale = scale_of(stress(along), "Pa");
  Drawing drawing{.key = {{"along the axis", "strong"}, {"across it", "weak"}}};
  Panel stresses =
      against_strain(curves, data, {.label = "stress on the sides", .unit = scale.unit, .brief = "stress"});
  for (const auto& [name, colour, words] :
       {std::tuple{along, "strong", "along the axis"}, {across, "weak", "across it"}}) {
    add_curve(stresses, strain, scaled(stress(name), 1 / scale.factor), colour);
    stresses.series.back().name = words;
  }
  Panel ratio = against_strain(curves, data, {.label = "q/p from the forces on the sides", .brief = "q/p"});
  add_curve(ratio, strain, known_up_to(curves.ratio, largest_ratio),
            known_up_to(fields::running_ratio(curves), largest_ratio), "strong");
  if (const auto found = fields::oedometer_test(test, curves)) add_modulus(drawing, found->modulus);
  drawing.panels = {std::move(stresses), std::move(ratio)};
  return drawing;
}

}  // namespace arenite::report::figures
