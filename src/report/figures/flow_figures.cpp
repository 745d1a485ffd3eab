#include "report/figures/flow_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/vec.hpp"
#include "grains/fields/discharge.hpp"
#include "grains/fields/free_surface.hpp"
#include "grains/fields/laboratory/test_kind.hpp"

namespace arenite::report::figures {
namespace {

using Values = std::vector<double>;

constexpr std::size_t parts_of_way = 4;  // of a front, after each of which a profile is drawn

Axis time_axis(const StageData& data) {
  return {.label = "time in \u201c" + data.stage.name + "\u201d", .unit = "s", .brief = "time"};
}

double begin_of(const StageData& data) {
  const Values* time = data.stage.history.find("time");
  return time && !time->empty() ? time->front() : data.states.front()->time;
}

Values times_of(const StageData& data) {
  return mapped(data.states, [&](const Snapshot* state) { return std::max(0.0, state->time - begin_of(data)); });
}

bool is_of(const StageData& data, fields::TestKind kind) {
  return data.states.size() > 2 && norm(data.stage.asked.gravity) > 0 &&
         fields::kind_of(fields::Test{data.stage, data.before}) == kind;
}

std::vector<fields::FreeSurface> surfaces_of(const StageData& data) {
  return mapped(data.states, [&](const Snapshot* state) {
    return fields::find_free_surface(state->packing, data.stage.asked.gravity);
  });
}

/// The way of the front that has gone farther in the end, at every state.
Series front_of(const std::vector<fields::FreeSurface>& surfaces, const Values& time, const fields::FreeSurface& then) {
  const bool to_right = surfaces.back().right - then.right >= then.left - surfaces.back().left;
  return {.name = to_right ? "right front" : "left front",
          .x = time,
          .y = mapped(surfaces,
                      [&](const auto& s) { return 1e3 * (to_right ? s.right - then.right : then.left - s.left); }),
          .line = Line::solid,
          .points = true};
}

/// Profiles before, in the end, and each time when the front has gone another part of its way.
Panel profile_panel(const std::vector<fields::FreeSurface>& surfaces, const fields::FreeSurface& then,
                    const Values& front) {
  Panel panel{.x = {.label = "place along the ground", .unit = "mm", .brief = "place"},
              .y = {.label = "height of the surface", .unit = "mm", .brief = "height", .low = 0}};
  const auto add = [&](const fields::FreeSurface& s, const std::string& colour, const char* name) {
    panel.series.push_back({.name = name,
                            .colour = colour,
                            .x = scaled(s.place, 1e3),
                            .y = mapped(s.height, [&](double h) { return 1e3 * (h - then.bottom); }),
                            .line = Line::solid,
                            .is_read = *name != '\0'});
  };
  add(then, "weak", "before");
  for (std::size_t k = 1; k < parts_of_way; ++k) {
    const double share = static_cast<double>(k) / parts_of_way;
    const auto at = std::ranges::find_if(front, [&](double way) { return way >= share * front.back(); });
    add(surfaces[static_cast<std::size_t>(at - front.begin())], "scale " + rounded(share, 2), "");
  }
  add(surfaces.back(), "strong", "in the end");
  return panel;
}

}  // namespace

Drawings discharge(const StageData& data) {
  const Values *time = data.stage.history.find("time"), *mass = fields::passed_in(data.stage.history).mass;
  if (!time || !mass || time->size() < 2 || mass->size() < 2) return {};
  const double begin = time->front();
  const Scale scale = scale_of(1e3 * largest_of(*mass, 0), "g");
  const double factor = scale.factor / 1e3;
  Drawing drawing;
  Panel panel{.x = time_axis(data), .y = {.label = "mass passed", .unit = scale.unit, .low = 0}};
  panel.series.push_back(
      {.x = mapped(*time, [&](double t) { return t - begin; }), .y = scaled(*mass, 1 / factor), .line = Line::solid});
  panel.now.x = times_of(data);
  const auto number = [&](const char* name) {
    return estimate_at(data.stage.texture, std::string("/discharge/") + name);
  };
  if (const auto rate = number("rate_kg_s"); std::isfinite(rate.value)) {
    const double from = number("begin_s").value, to = number("end_s").value;
    const auto passed = [&](double t) { return fields::at_time(*time, *mass, t) / factor; };
    panel.series.push_back({.colour = "accent",
                            .x = {from - begin, to - begin},
                            .y = {passed(from), passed(from) + rate.value * (to - from) / factor},
                            .line = Line::dashed,
                            .weight = 1.6,
                            .is_read = false});
    drawing.key.push_back(
        {"rate", "accent", {said_in_unit("W", {1e3 * rate.value, 1e3 * rate.error}, "g/s")}, Line::dashed});
  }
  drawing.panels.push_back(std::move(panel));
  return {drawing};
}

Drawings collapse(const StageData& data) {
  if (!is_of(data, fields::TestKind::collapse)) return {};
  const auto surfaces = surfaces_of(data);
  const fields::FreeSurface then =
      data.before ? fields::find_free_surface(*data.before, data.stage.asked.gravity) : surfaces.front();
  Drawing drawing{.key = {{"before", "weak"}, {"in the end", "strong"}}};
  Panel front{.x = time_axis(data), .y = {.label = "way of the front", .unit = "mm", .brief = "way", .low = 0}};
  front.series.push_back(front_of(surfaces, times_of(data), then));
  front.now.x = times_of(data);
  if (const auto way = estimate_at(data.stage.texture, "/surface/runout_m"); std::isfinite(way.value)) {
    front.references.push_back({.y = 1e3 * way.value, .colour = "accent", .line = Line::dashed});
    drawing.key.push_back({"run-out", "accent", {said_in_unit("L", way, "m")}, Line::dashed});
  }
  const Values way = front.series.front().y;
  drawing.panels = {std::move(front), profile_panel(surfaces, then, way)};
  return {drawing};
}

Drawings surface_angle(const StageData& data) {
  if (!is_of(data, fields::TestKind::drum)) return {};
  constexpr double degrees = 180 / std::numbers::pi;
  Series angle{.name = "surface", .x = times_of(data), .line = Line::solid, .points = true};
  for (const auto& surface : surfaces_of(data)) {
    angle.y.push_back(degrees * surface.angle.value);
    angle.error.push_back(degrees * surface.angle.error);
  }
  Drawing drawing;
  Panel panel{.x = time_axis(data), .y = {.label = "angle of the surface", .unit = "\u00b0", .brief = "angle"}};
  panel.now.x = angle.x;
  if (const auto mean = estimate_at(data.stage.texture, "/surface/mean_angle_deg"); std::isfinite(mean.value)) {
    const double half = angle.x[angle.x.size() / 2];
    panel.series.push_back({.colour = "accent",
                            .x = {half, angle.x.back()},
                            .y = {mean.value, mean.value},
                            .low = {mean.value - mean.error, mean.value - mean.error},
                            .high = {mean.value + mean.error, mean.value + mean.error},
                            .line = Line::solid,
                            .is_read = false});
    drawing.key.push_back({"mean of the second half", "accent", {said_in_unit("\u03b8", mean, "\u00b0")}});
  }
  panel.series.push_back(std::move(angle));
  drawing.panels.push_back(std::move(panel));
  return {drawing};
}

}  // namespace arenite::report::figures
