#include "report/figures/stage_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "grains/fields/laboratory/test_kind.hpp"
#include "model/kinds.hpp"
#include "report/figures/cycle_figures.hpp"
#include "report/figures/flow_figures.hpp"
#include "report/figures/test_figures.hpp"

namespace arenite::report::figures {
namespace {

using Column = History::Column;

const Column* column_of(const History& history, std::string_view name) {
  const auto at = std::ranges::find(history.columns, name, &Column::name);
  return at == history.columns.end() || at->values.size() < 2 ? nullptr : &*at;
}

/// Time since the stage began, with the states on it; empty without a history.
struct Clock {
  Axis axis;
  std::vector<double> time;
  Chosen states;
};
Clock clock_of(const StageData& data) {
  const Column* time = column_of(data.stage.history, "time");
  if (!time) return {};
  Clock clock{{.label = "time in \u201c" + data.stage.name + "\u201d", .unit = time->unit, .brief = "time"},
              mapped(time->values, [time](double t) { return t - time->values.front(); }),
              {}};
  for (const Snapshot* state : data.states) clock.states.x.push_back(std::max(0.0, state->time - time->values.front()));
  return clock;
}

struct Named {
  std::string column, name;
};

/// One line for each of the columns that the history has; what `is_shown` refuses is left out of it.
template <class Shown> Drawing lines_over_time(const StageData& data, const std::vector<Named>& names, Shown is_shown) {
  const Clock clock = clock_of(data);
  Drawing drawing;
  Panel panel{.x = clock.axis, .now = clock.states};
  for (std::size_t k = 0; k < names.size() && !clock.time.empty(); ++k) {
    const Column* column = column_of(data.stage.history, names[k].column);
    if (!column) continue;
    auto y = column->values;
    for (double& value : y)
      if (!is_shown(value)) value = statistics::unknown;
    if (std::ranges::count_if(y, [](double v) { return std::isfinite(v); }) < 2) continue;
    const std::string colour = "line " + std::to_string(k);
    drawing.key.push_back({names[k].name, colour});
    panel.series.push_back(
        {.name = names[k].name, .colour = colour, .x = clock.time, .y = std::move(y), .line = Line::solid});
  }
  if (!panel.series.empty()) drawing.panels.push_back(std::move(panel));
  return drawing;
}

double largest_in(const Panel& panel) {
  double most = 0;
  for (const Series& one : panel.series)
    for (const double y : one.y) most = std::fmax(most, std::abs(y));
  return most;
}

double least_in(const Panel& panel) {
  double least = largest_in(panel);
  for (const Series& one : panel.series) least = least_above_zero(one.y, least);
  return least;
}

Drawings wall_forces(const StageData& data) {
  Drawing drawing = lines_over_time(data,
                                    {{"bottom_force", "bottom wall"},
                                     {"top_force", "top wall"},
                                     {"left_force", "left wall"},
                                     {"right_force", "right wall"},
                                     {"back_force", "back wall"},
                                     {"front_force", "front wall"}},
                                    [](double) { return true; });
  if (drawing.panels.empty()) return {};
  Panel& panel = drawing.panels.front();
  const Scale scale = scale_of(largest_in(panel), "N");
  panel.y = {.label = "force", .unit = scale.unit};
  for (std::size_t k = 0; k < panel.series.size(); ++k) {  // equal forces of opposite walls remain visible
    panel.series[k].y = scaled(std::move(panel.series[k].y), 1 / scale.factor);
    if ((panel.series[k].colour.back() - '0') % 2 == 1) panel.series[k].line = drawing.key[k].line = Line::dashed;
  }
  return {drawing};
}

/// All terms of the account that are above 0 at some time.
Drawings energies(const StageData& data) {
  auto names = mapped(energy_terms, [](const EnergyTerm& term) { return Named{term.name, term.phrase}; });
  names.push_back({exchange_term.name, exchange_term.phrase});
  Drawing drawing = lines_over_time(data, names, [](double v) { return v > 0; });
  if (drawing.panels.empty()) return {};
  Panel& panel = drawing.panels.front();
  const double most = largest_in(panel);
  panel.y = decades_about("energy", std::max(least_in(panel), 1e-7 * most), most);
  panel.y.unit = "J";
  return {drawing};
}

Drawings equilibrium(const StageData& data) {
  if (!column_of(data.stage.history, "unbalanced_ratio")) return {};
  Drawing drawing = lines_over_time(data,
                                    {{"unbalanced_ratio", "unbalanced force ratio"},
                                     {"kinetic_ratio", "kinetic/elastic energy"},
                                     {"loose_kinetic_ratio", "kinetic/elastic energy of rattlers"},
                                     {"falling", "fraction of falling grains"},
                                     {"mobilisation", "mean |F_{t}|/F_{n}"}},
                                    [](double v) { return v > 0 && v < 1e3; });
  if (drawing.panels.empty()) return {};
  Panel& panel = drawing.panels.front();
  panel.y = decades_about("ratio", std::max(1e-10, least_in(panel)), largest_in(panel));
  return {drawing};
}

/// A side of the container, and the direction from it into the sample.
struct Side {
  const char* name;
  double inward;
  std::size_t place;  // in Domain::wall
};
constexpr std::array<Side, 4> sides{{{"left", 1, 0}, {"right", -1, 1}, {"bottom", 1, 2}, {"top", -1, 3}}};

std::string position(const char* side) { return std::string(side) + "_position"; }
std::string force(const char* side) { return std::string(side) + "_force"; }

/// The side whose wall moves farthest; none where none moves.
const Side* moving_side(const History& history) {
  const Side* best = nullptr;
  double farthest = 1e-9;  // m
  for (const Side& side : sides) {
    const Column* at = column_of(history, position(side.name));
    if (!at || !column_of(history, force(side.name))) continue;
    if (const double way = std::abs(at->values.back() - at->values.front()); way > farthest)
      best = &side, farthest = way;
  }
  return best;
}

Drawings travel(const StageData& data) {
  const Side* side = moving_side(data.stage.history);
  if (!side) return {};
  const Column &at = *column_of(data.stage.history, position(side->name)),
               &of = *column_of(data.stage.history, force(side->name));
  const Scale scale = scale_of(of.values, of.unit);
  const auto way = [&](double x) { return 1e3 * side->inward * (x - at.values.front()); };
  Panel panel{
      {.label = std::string("displacement of the ") + side->name + " wall", .unit = "mm", .brief = "displacement"},
      {.label = "force", .unit = scale.unit}};
  panel.series.push_back({.name = "curve",
                          .colour = "weak",
                          .x = mapped(at.values, way),
                          .y = scaled(of.values, 1 / scale.factor),
                          .line = Line::solid,
                          .weight = 0.8});
  Series states{.name = "stored states", .colour = "strong", .points = true, .weight = 1.3, .is_read = false};
  for (const Snapshot* state : data.states) {
    const Wall& wall = state->packing.domain.wall[side->place];
    states.x.push_back(way(wall.position));
    states.y.push_back(wall.force / scale.factor);
  }
  panel.now = {states.x, states.y};
  panel.series.push_back(states);
  panel.near = true;
  return {{.panels = {panel}}};
}

/// Bonds between grains that broke, by failure mode; those of a test along one axis stand beside its stress.
Drawings grain_bonds(const StageData& data) {
  if (fields::kind_of(fields::Test{data.stage, data.before}) == fields::TestKind::uniaxial) return {};
  std::vector<Named> ways;
  for (const std::string_view way : std::span(bond_breaks).subspan(1))
    ways.push_back({"broken_in_" + std::string(way), std::string(way)});
  Drawing drawing = lines_over_time(data, ways, [](double) { return true; });
  if (drawing.panels.empty() || !(largest_in(drawing.panels.front()) > 0)) return {};
  Panel& panel = drawing.panels.front();
  panel.y = {.label = "broken bonds", .low = 0};
  for (std::size_t k = 0; k < panel.series.size(); ++k)
    panel.series[k].colour = drawing.key[k].colour = "broken " + std::to_string(k);
  return {drawing};
}

}  // namespace

template <int D> Drawings boundary_forces(const StageData& data, const std::vector<BoundaryIn<D>>& boundaries) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::vector<std::string> words;
  for (const BoundaryIn<D>& boundary : boundaries)
    for (const char* axis : std::span(axes).first(D))
      if (boundary.present) words.insert(words.end(), {boundary.name + "_force_" + axis, boundary.name + ", " + axis});
  std::vector<Named> names;
  for (std::size_t k = 0; k < words.size(); k += 2) names.push_back({words[k].c_str(), words[k + 1].c_str()});
  if (names.empty() || names.size() > 8) return {};  // more lines are not told apart
  Drawing drawing = lines_over_time(data, names, [](double) { return true; });
  if (drawing.panels.empty()) return {};
  Panel& panel = drawing.panels.front();
  const Scale scale = scale_of(largest_in(panel), "N");
  panel.y = {.label = "force", .unit = scale.unit};
  for (Series& series : panel.series) series.y = scaled(std::move(series.y), 1 / scale.factor);
  return {drawing};
}
template Drawings boundary_forces(const StageData&, const std::vector<BoundaryIn<2>>&);
template Drawings boundary_forces(const StageData&, const std::vector<BoundaryIn<3>>&);

const std::vector<Row<StageData>>& stage_figures() {
  static const std::vector<Row<StageData>> list{
      {{"cycles",
        "cycles",
        "Cycles",
        {"Left: strain at the largest and at the smallest load, or strain, of every whole cycle of the stage.",
         "Right: stress along the axis that cycles against its strain, thin over the whole stage. A click on a curve "
         "shows the state next to it."},
        true,
        {},
        true},
       cycles},
      {{"test-curves",
        "stress-strain",
        "Curves of the test",
        {"From the forces on the sides of the sample and their positions, against strain: stress ratio and volumetric "
         "strain, compaction positive; between sides that stand still, the stresses along the axis and across it; "
         "without confinement or in tension, the stress, with the slope from a tenth to half of the largest, and "
         "broken bonds.",
         "Thin: all sampled values; thick: running mean. Coloured: the critical state with its 95 % band, over the "
         "strains at which the ratio only fluctuates. A click on a curve shows the state next to it."},
        true,
        {},
        true},
       test_curves},
      {{"discharge",
        "discharge",
        "Discharge",
        {"Mass of the grains below the height count_below of the recipe, or that left.",
         "Dashed: the discharge rate, over the part in which it is steady."},
        true,
        {},
        true},
       discharge},
      {{"collapse",
        "collapse",
        "Collapse",
        {"Left: way of the front since the stage began.",
         "Right: surface of the grains that hang together, before, after each quarter of that way, and in the end."},
        true,
        {},
        true},
       collapse},
      {{"surface-angle",
        "surface-angle",
        "Angle of the surface",
        "Slope of the free surface at the stored states, with standard errors; band: their mean over the second half.",
        true,
        {},
        true},
       surface_angle},
      {{"grain-bonds",
        "broken-bonds",
        "Broken bonds",
        {"Broken bonds between grains, by failure mode.",
         "In the picture each is drawn as a crack between its grains."}},
       grain_bonds},
      {{"wall-forces", "wall-forces", "Forces on the walls",
        "Normal force of the grains on each wall over the loading; vertical line: the state shown."},
       wall_forces},
      {{"boundary-forces", "boundary-forces", "Forces on the boundaries",
        "Force of the grains on each boundary along the axes; vertical line: the state shown."},
       [](const StageData& data) {
         return data.stage.snapshots.empty()
                    ? Drawings{}
                    : boundary_forces(data, data.stage.snapshots.back().packing.domain.boundaries);
       }},
      {{"travel", "travel", "Force-displacement curve",
        "Force on the wall that moves farthest in this stage against its displacement into the sample; dots: stored "
        "states."},
       travel},
      {{"energies", "energies", "Energies",
        "Stored and dissipated energy and work, on a logarithmic scale, which shows positive values only."},
       energies},
      {{"equilibrium", "equilibrium", "Approach to equilibrium",
        "Distance of the sample from equilibrium during loading; every increment ends in equilibrium."},
       equilibrium}};
  return list;
}

}  // namespace arenite::report::figures
