#include "report/figures/flow_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/vec.hpp"
#include "grains/fields/discharge.hpp"
#include "grains/fields/free_surface.hpp"
#include "grains/fields/laboratory/test_kind.hpp"
#include "grains/fields/steady_state.hpp"

namespace arenite::report::figures {
namespace {

using Values = std::vector<double>;

constexpr std::size_t parts_of_way = 4;  // of a front, after each of which a profile is drawn

Axis time_axis(const std::string& stage) {
  return {.label = "time in \u201c" + stage + "\u201d", .unit = "s", .brief = "time"};
}

/// When a stage began, s.
double begin_of(const History& history, const auto& states) {
  const Values* time = history.find("time");
  return time && !time->empty() ? time->front() : states.front()->time;
}

/// Of states, s from the beginning of their stage.
Values times_of(const History& history, const auto& states) {
  const double begin = begin_of(history, states);
  return mapped(states, [&](const auto* state) { return std::max(0.0, state->time - begin); });
}

/// The free surface of a sample in the states of a stage, and before.
struct Surfaces {
  std::string stage;
  const Numbers& texture;
  Values times;  ///< s, from the beginning of the stage
  std::vector<fields::FreeSurface> at;
  fields::FreeSurface before;
};

/// Without a state before the first one stands for it.
template <int D>
Surfaces surfaces_of(const StageResultIn<D>& stage, const std::vector<const SnapshotIn<D>*>& states,
                     const PackingIn<D>* before) {
  Surfaces found{stage.name, stage.texture, times_of(stage.history, states), {}, {}};
  for (const SnapshotIn<D>* state : states)
    found.at.push_back(fields::find_free_surface(state->packing, stage.asked.gravity));
  found.before = before ? fields::find_free_surface(*before, stage.asked.gravity) : found.at.front();
  return found;
}

bool can_be(fields::TestKind kind, fields::TestKind found, std::size_t states, Vec2 gravity) {
  return states > 2 && norm(gravity) > 0 && found == kind;
}

std::optional<Surfaces> surfaces_of(const StageData& data, fields::TestKind kind) {
  const fields::TestKind found = fields::kind_of(fields::Test{data.stage, data.before});
  if (!can_be(kind, found, data.states.size(), data.stage.asked.gravity)) return std::nullopt;
  return surfaces_of<2>(data.stage, data.states, data.before);
}

std::optional<Surfaces> surfaces_of(const SphereResult& stage, fields::TestKind kind) {
  if (!can_be(kind, fields::kind_of(stage), stage.snapshots.size(), stage.asked.gravity)) return std::nullopt;
  const auto states = mapped(stage.snapshots, [](const SnapshotIn<3>& state) { return &state; });
  return surfaces_of<3>(stage, states, nullptr);
}

/// The way of the front that has gone farther in the end, at every state.
Series front_of(const std::vector<fields::FreeSurface>& surfaces, const Values& time, const fields::FreeSurface& then) {
  const bool to_right = fields::farther_front(then, surfaces.back()).to_right;
  return {.name = to_right ? "right front" : "left front",
          .x = time,
          .y = mapped(surfaces, [&](const auto& s) { return 1e3 * fields::way_of_front(to_right, then, s); }),
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
  Panel panel{.x = time_axis(data.stage.name), .y = {.label = "mass passed", .unit = scale.unit, .low = 0}};
  panel.series.push_back(
      {.x = mapped(*time, [&](double t) { return t - begin; }), .y = scaled(*mass, 1 / factor), .line = Line::solid});
  panel.now.x = times_of(data.stage.history, data.states);
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

namespace {

Drawings draw_collapse(const Surfaces& surfaces) {
  Drawing drawing{.key = {{"before", "weak"}, {"in the end", "strong"}}};
  Panel front{.x = time_axis(surfaces.stage),
              .y = {.label = "way of the front", .unit = "mm", .brief = "way", .low = 0}};
  front.series.push_back(front_of(surfaces.at, surfaces.times, surfaces.before));
  front.now.x = surfaces.times;
  if (const auto way = estimate_at(surfaces.texture, "/surface/runout_m"); std::isfinite(way.value)) {
    front.references.push_back({.y = 1e3 * way.value, .colour = "accent", .line = Line::dashed});
    drawing.key.push_back({"run-out", "accent", {said_in_unit("L", way, "m")}, Line::dashed});
  }
  const Values way = front.series.front().y;
  drawing.panels = {std::move(front), profile_panel(surfaces.at, surfaces.before, way)};
  return {drawing};
}

Drawings draw_surface_angle(const Surfaces& surfaces) {
  constexpr double degrees = 180 / std::numbers::pi;
  Series angle{.name = "surface", .x = surfaces.times, .line = Line::solid, .points = true};
  for (const auto& surface : surfaces.at) {
    angle.y.push_back(degrees * surface.angle.value);
    angle.error.push_back(degrees * surface.angle.error);
  }
  Drawing drawing;
  Panel panel{.x = time_axis(surfaces.stage),
              .y = {.label = "angle of the surface", .unit = "\u00b0", .brief = "angle"}};
  panel.now.x = angle.x;
  if (const auto mean = estimate_at(surfaces.texture, "/surface/mean_angle_deg"); std::isfinite(mean.value)) {
    const double half = fields::later_half(angle.x).front();
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

Drawings drawn(const std::optional<Surfaces>& surfaces, Drawings (*draw)(const Surfaces&)) {
  return surfaces ? draw(*surfaces) : Drawings{};
}

}  // namespace

Drawings collapse(const StageData& data) { return drawn(surfaces_of(data, fields::TestKind::collapse), draw_collapse); }
Drawings collapse(const SphereResult& stage) {
  return drawn(surfaces_of(stage, fields::TestKind::collapse), draw_collapse);
}

Drawings surface_angle(const StageData& data) {
  return drawn(surfaces_of(data, fields::TestKind::drum), draw_surface_angle);
}
Drawings surface_angle(const SphereResult& stage) {
  return drawn(surfaces_of(stage, fields::TestKind::drum), draw_surface_angle);
}

}  // namespace arenite::report::figures
