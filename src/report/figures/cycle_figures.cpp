#include "report/figures/cycle_figures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "grains/fields/laboratory/tested_stage.hpp"
#include "grains/fields/state_curves.hpp"
#include "report/figures/test_figures.hpp"

namespace arenite::report::figures {
namespace {

using statistics::Columns;
using Values = std::vector<double>;

constexpr std::size_t few_cycles = 50;  // whose points are marked

/// Every cycle where the stage noted each, otherwise those whose states are stored.
std::optional<Columns> cycles_of(const fields::Test& test) {
  const auto* numbers = fields::loading_of(test) ? test.stage.cycles.find("cycle") : nullptr;
  if (numbers && numbers->size() > 3) return fields::every_cycle(test);
  if (fields::has_history(test.stage) && fields::whole_cycles(test.stage).size() > 1)
    return fields::curves_of_cycles(test);
  return {};
}

/// Each state at the cycle during which it was, where the times of all are known.
Chosen states_among(const StageData& data) {
  const Values *time = data.stage.cycles.find("time"), *cycle = data.stage.cycles.find("cycle");
  Chosen now;
  if (!time || !cycle || time->size() < 2) return now;
  for (const Snapshot* state : data.states) now.x.push_back(fields::at_time(*time, *cycle, state->time));
  return now;
}

Panel strain_panel(const StageData& data, const Columns& found, const std::string& strain, Drawing& drawing) {
  Panel panel{.x = {.label = "cycle in \u201c" + data.stage.name + "\u201d", .brief = "cycle"},
              .y = {.label = words_of(strain), .unit = "%"},
              .now = states_among(data)};
  const Values& cycle = found["cycle"];
  for (const auto& [end, name, colour] :
       {std::tuple{"_maximum", "maximum of the load", "line 1"}, {"_minimum", "minimum of the load", "line 0"}}) {
    panel.series.push_back({.name = name,
                            .colour = colour,
                            .x = cycle,
                            .y = scaled(found[strain + end], 100),
                            .line = Line::solid,
                            .points = cycle.size() <= few_cycles});
    drawing.key.push_back({name, colour});
  }
  return panel;
}

/// The names of strain and stress that a loop is of.
std::pair<std::string, std::string> names_of_loop(const fields::Loading& of, int side) {
  if (of.sheared) return {"shear_strain", "tau"};
  const bool upright = side < 0 ? of.upright : side >= bottom;
  return {upright ? "strain_y" : "strain_x", upright ? "sigma_yy" : "sigma_xx"};
}

/// First row of the last cycle.
std::size_t begin_of_last(const StageData& data, const Values& time) {
  const Values* ends = data.stage.cycles.find("time");
  if (!ends || ends->size() < 4) return time.size();
  const std::size_t last = ends->size() - ends->size() % 2;
  return static_cast<std::size_t>(std::ranges::lower_bound(time, (*ends)[last - 3]) - time.begin());
}

/// Stress against strain over the whole stage, pale, and in its last cycle.
std::optional<Panel> loop_panel(const StageData& data, const fields::Loading& of, Drawing& drawing) {
  const auto [strain, stress] = names_of_loop(of, data.stage.asked.cycled);
  const Values* time = data.stage.history.find("time");
  if (!of.curves.has(stress) || !time) return {};
  const CurveAxis across = axis_of(*of.curves.find(strain)), up = axis_of(*of.curves.find(stress));
  const Values x = scaled(of.curves[strain], 1 / across.factor), y = scaled(of.curves[stress], 1 / up.factor);
  Panel panel{.x = across.axis, .y = up.axis};
  panel.series.push_back(
      {.colour = "weak", .x = x, .y = y, .line = Line::solid, .weight = 0.5, .opacity = 0.5, .is_read = false});
  if (const std::size_t first = begin_of_last(data, *time); first + 2 < x.size()) {
    const auto from = static_cast<std::ptrdiff_t>(first);
    panel.series.push_back({.name = "last cycle",
                            .colour = "strong",
                            .x = {x.begin() + from, x.end()},
                            .y = {y.begin() + from, y.end()},
                            .line = Line::solid});
    drawing.key.push_back({"last cycle", "strong"});
  }
  for (const Snapshot* state : data.states) {
    panel.now.x.push_back(fields::at_time(*time, x, state->time));
    panel.now.y.push_back(fields::at_time(*time, y, state->time));
  }
  panel.near = true;
  return panel;
}

}  // namespace

Drawings cycles(const StageData& data) {
  const fields::Test test{data.stage, data.before};
  const auto found = cycles_of(test);
  if (!found) return {};
  const auto loading = fields::loading_of(test);
  const std::string strain = loading && loading->sheared ? "shear_strain" : "axial_strain";
  if (!found->has(strain + "_maximum")) return {};
  Drawing drawing;
  drawing.panels.push_back(strain_panel(data, *found, strain, drawing));
  if (loading)
    if (auto loop = loop_panel(data, *loading, drawing)) drawing.panels.push_back(std::move(*loop));
  return {drawing};
}

}  // namespace arenite::report::figures
