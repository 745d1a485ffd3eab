#include "report/figures/failure.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "model/kinds.hpp"
#include "solid/peridynamics/measures.hpp"

namespace arenite::report::figures {
namespace {

std::vector<double> steps_of(const FieldData& data) {
  std::vector<double> steps;
  if (const auto* strain = data.curve.find("strain"))
    for (std::size_t k = 0; k < strain->size(); ++k) steps.push_back(static_cast<double>(k + 1));
  return steps;
}

const std::vector<double>* column(const FieldData& data, const char* name) {
  const auto* values = data.curve.find(name);
  return steps_of(data).size() > 1 ? values : nullptr;
}

std::string unit_of(const FieldData& data, const char* name) {
  return std::ranges::find(data.curve.columns, name, &History::Column::name)->unit;
}

}  // namespace

Drawings stress_strain(const FieldData& data) {
  const auto *strain = column(data, "strain"), *stress = column(data, "stress");
  if (!strain || !stress) return {};
  const Scale scale = scale_of(*stress, unit_of(data, "stress"));
  Series steps{.x = scaled(*strain, 1e3), .y = scaled(*stress, 1 / scale.factor), .line = Line::solid, .each = "step"};
  Panel panel{{.label = "strain", .unit = "10\u207b\u00b3"}, {.label = "stress", .unit = scale.unit}};
  // Straight until the first bond breaks.
  panel.series = {{.x = {0, steps.x.front()}, .y = {0, steps.y.front()}, .line = Line::solid, .is_read = false}, steps};
  if (data.has_steps) panel.now = {steps.x, steps.y}, panel.click = "step", panel.near = true;
  return {{.panels = {panel}}};
}

Drawings broken_bonds(const FieldData& data) {
  const auto* broken = column(data, "broken");
  if (!broken || data.broken.empty()) return {};
  Drawing drawing;
  Panel panel{{.label = "step"}, {.label = "broken bonds", .low = 0}};
  if (data.has_steps) panel.now = {steps_of(data)};
  for (int type = 1; type <= 3; ++type) {
    const std::string colour = "crack " + std::to_string(type);
    Series series{.name = std::string(crack_types[type]),
                  .colour = colour,
                  .x = steps_of(data),
                  .y = peridynamics::broken_after_steps(data.broken, *broken, type),
                  .line = Line::solid,
                  .steps = true};
    if (data.has_steps) drawing.key.push_back({series.name, colour, {}, Line::solid, type - 1});
    else drawing.key.push_back({series.name + " " + counted(series.y.back()), colour, {}, Line::solid});
    panel.series.push_back(std::move(series));
  }
  drawing.panels = {panel};
  return {drawing};
}

Drawings energy_balance(const FieldData& data) {
  const auto *work = column(data, "work"), *elastic = column(data, "elastic"), *released = column(data, "released");
  if (!work || !elastic || !released) return {};
  const Scale scale = scale_of(*work, unit_of(data, "work"));
  const auto in_unit = [&](const std::vector<double>& values) { return scaled(values, 1 / scale.factor); };
  const std::vector<double> lost = in_unit(*released), stored = in_unit(*elastic), none(lost.size(), 0.0);
  std::vector<double> both;
  for (std::size_t k = 0; k < lost.size(); ++k) both.push_back(lost[k] + stored[k]);
  const auto x = steps_of(data);
  Panel panel{{.label = "step"}, {.label = "energy", .unit = scale.unit, .low = 0}};
  panel.series = {
      {.name = "released", .colour = "line 1", .x = x, .y = lost, .low = none, .high = lost, .opacity = 0.5},
      {.name = "elastic", .colour = "line 0", .x = x, .y = stored, .low = lost, .high = both, .opacity = 0.4},
      {.name = "work", .colour = "strong", .x = x, .y = in_unit(*work), .line = Line::solid}};
  if (data.has_steps) panel.now = {x};
  return {{.panels = {panel}, .key = {{"work", "strong"}, {"elastic", "line 0"}, {"released", "line 1"}}}};
}

}  // namespace arenite::report::figures
