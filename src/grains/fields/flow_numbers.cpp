#include "grains/fields/stage_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/ball_window.hpp"
#include "geometry/union_area.hpp"
#include "grains/fields/discharge.hpp"
#include "grains/fields/free_surface.hpp"
#include "grains/fields/silo.hpp"
#include "grains/fields/steady_state.hpp"

namespace arenite::fields {
namespace {

using statistics::described;

constexpr double degrees = 180 / std::numbers::pi;

Numbers estimate(double value, double error, const char* unit, const char* sentence, double scale = 1) {
  return described({{"value", scale * value}, {"error", scale * error}}, unit, sentence);
}

/// The part of a series over which a flow is averaged: the steady part of a discharge, else that in which the series
/// only fluctuates; empty where it does not settle.
struct Steady {
  std::size_t first = 0, count = 0;
};

std::optional<Steady> steady_rows(const std::vector<double>& time, const Numbers& flow, const std::vector<double>& of) {
  if (const Numbers* steady = flow.at_path("/discharge/steady")) {
    if (!steady->get<bool>()) return {};
    const auto row_at = [&](const char* name) {
      return static_cast<std::size_t>(std::ranges::lower_bound(time, flow.at_path(name)->get<double>() - 1e-12) -
                                      time.begin());
    };
    const std::size_t first = row_at("/discharge/begin_s"), end = std::min(row_at("/discharge/end_s") + 1, of.size());
    return Steady{first, end - first};
  }
  const SteadyState state = find_steady_state(of);
  if (!state.settled) return {};
  return Steady{state.first, state.count};
}

/// A column of what grains do to a boundary, and the number that is its mean.
struct BoundaryColumn {
  const char *column, *name, *unit, *what;
  bool of_turning = false;
};
constexpr BoundaryColumn columns_in_plane[] = {{"_force_x", "force_x_N", "N", "Force along x"},
                                               {"_force_y", "force_y_N", "N", "Force along y"},
                                               {"_torque", "torque_N_m", "N m", "Torque", true}};
constexpr BoundaryColumn columns_in_space[] = {{"_force_x", "force_x_N", "N", "Force along x"},
                                               {"_force_y", "force_y_N", "N", "Force along y"},
                                               {"_force_z", "force_z_N", "N", "Force along z"},
                                               {"_torque_x", "torque_x_N_m", "N m", "Torque about x", true},
                                               {"_torque_y", "torque_y_N_m", "N m", "Torque about y", true},
                                               {"_torque_z", "torque_z_N_m", "N m", "Torque about z", true}};
std::span<const BoundaryColumn> columns_of(const Boundary& /*boundary*/) { return columns_in_plane; }
std::span<const BoundaryColumn> columns_of(const BoundaryIn<3>& /*boundary*/) { return columns_in_space; }

/// What the grains do to the boundaries of a stage that lasts a time: an obstacle in a flow, a blade, a drum.
template <int D> Numbers boundary_numbers(const StageResultIn<D>& result, const Numbers& flow) {
  constexpr std::size_t fewest_rows = 12;
  Numbers all = Numbers::tree();
  const auto* time = result.history.find("time");
  if (!time || time->size() < fewest_rows) return all;
  const bool discharges = flow.contains("discharge");
  for (const BoundaryIn<D>& boundary : result.snapshots.back().packing.domain.boundaries) {
    const auto put = [&](const BoundaryColumn& of) {
      const auto* values = result.history.find(boundary.name + of.column);
      if (!values || !boundary.present || (of.of_turning && boundary.spin == Turning<D>{})) return;
      const auto steady = steady_rows(*time, flow, *values);
      if (!steady || steady->count < fewest_rows) return;
      const auto rows = std::span(*values).subspan(steady->first, steady->count);
      statistics::Measured mean = block_average(rows).mean;
      if (!std::isfinite(mean.error)) mean = mean_of_blocks(rows, 6);
      const std::string sentence =
          fmt::format("{} of the grains on the boundary, mean over {}", of.what,
                      discharges ? "the steady part of the discharge" : "the part in which it only fluctuates");
      all[boundary.name][of.name] = estimate(mean.value, mean.error, of.unit, sentence.c_str());
    };
    for (const BoundaryColumn& of : columns_of(boundary)) put(of);
  }
  return all;
}

/// Counts at the end of a stage in which grains come in or leave.
Numbers exchange_numbers(const StageResult& result) {
  const auto last = [&](const char* name) {
    const auto* values = result.history.find(name);
    return values && !values->empty() ? values->back() : 0.0;
  };
  if (!result.history.find("inserted")) return Numbers::tree();
  return {
      {"inserted", described(std::llround(last("inserted")), "", "Grains that came in during the stage")},
      {"inserted_kg", described(last("inserted_mass"), "kg", "Their mass")},
      {"removed",
       described(std::llround(last("removed")), "", "Grains that left during the stage; those put back count as both")},
      {"removed_kg", described(last("removed_mass"), "kg", "Their mass")},
      {"grains", described(std::llround(last("grains")), "", "Grains at the end of the stage")},
      {"waiting", described(std::llround(last("waiting")), "", "Grains that are due at the end and found no room")}};
}

bool has_free_surface(const Asked& asked, const dem::Stage& stage) {
  return norm(asked.gravity) > 0 && std::ranges::none_of(stage.side, &dem::SideDrive::presses);
}

/// Mean angle over the second half of the states, of a drum that turns, say; nothing where it still changes, or stands
/// still. Errors by the scatter of states, which lie far apart in time.
template <int D> void put_mean_angle(Numbers& j, const StageResultIn<D>& result, Vec2 gravity) {
  std::vector<double> angles;
  for (std::size_t k = result.snapshots.size() / 2; k < result.snapshots.size(); ++k)
    if (const double angle = find_free_surface(result.snapshots[k].packing, gravity).angle.value; std::isfinite(angle))
      angles.push_back(angle);
  if (angles.size() < 6) return;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  const statistics::Measured all = statistics::mean_of(angles), one = statistics::mean_of({angles.begin(), middle}),
                             two = statistics::mean_of({middle, angles.end()});
  if (!(all.error > 0) || !(std::abs(one.value - two.value) < 3 * std::hypot(one.error, two.error))) return;
  j["mean_angle_deg"] =
      estimate(all.value, all.error, "deg", "Mean angle of the surface over the second half of the states", degrees);
  j["states_in_mean"] = described(angles.size(), "", "Number of states averaged");
}

/// What a grain covers of a part of the container from one height to another, over its whole depth.
double covered(Vec2 place, double radius, const geometry::Rectangle& window) {
  return geometry::disk_window_area(place, radius, window);
}
double covered(Vec3 place, double radius, const geometry::Rectangle& window) {
  return geometry::ball_window_volume(
      place, radius,
      {{window.x_min, window.y_min, place.z - 2 * radius}, {window.width(), window.height(), 4 * radius}, {}});
}
double depth_of(const Domain& /*domain*/) { return 1; }
double depth_of(const DomainIn<3>& domain) { return domain.wall[front].position - domain.wall[back].position; }

/// Solid fraction of a layer between the walls, two mean diameters off its floor and its surface, with its error by
/// strips; nothing where so much is not there, or boundaries stand in it.
template <int D> void put_filling(Numbers& j, const PackingIn<D>& packing, Vec2 gravity, const FreeSurface& surface) {
  constexpr std::size_t strips = 8;
  const double away = 2 * surface.diameter;
  if (!packing.domain.boundaries.empty() || gravity.x != 0 || gravity.y > 0 || surface.height.size() < strips ||
      !surface.fills_depth)
    return;
  const double low = surface.bottom + away, high = std::ranges::min(surface.height) - away,
               width = (surface.right - surface.left) / strips;
  if (!(high - low >= 5 * surface.diameter)) return;
  std::vector<double> fraction;
  for (std::size_t k = 0; k < strips; ++k) {
    const double left = surface.left + static_cast<double>(k) * width;
    const geometry::Rectangle window{left, left + width, low, high};
    double sum = 0;
    for (std::size_t g = 0; g < packing.grains.size(); ++g)
      sum += covered(packing.grains.position[g], packing.grains.radius[g], window);
    fraction.push_back(sum / (window.area() * depth_of(packing.domain)));
  }
  const statistics::Measured mean = statistics::mean_of(fraction);
  j["solid_fraction"] = estimate(mean.value, mean.error, "",
                                 "Solid fraction between the walls, two mean diameters off floor and surface");
}

/// Whether a front stands at a wall.
template <int D> bool is_stopped(double front, const WallIn<D>& wall, double diameter) {
  return wall.present && std::abs(wall.position - front) < 0.5 * diameter;
}

/// Way of the farther front, and beside the column that was there before. A front of grains is known to half a grain;
/// what one that a wall stopped would have gone is not known.
template <int D>
void put_runout(Numbers& j, const FreeSurface& now, const FreeSurface& then, const PackingIn<D>& packing) {
  const auto [to_right, way] = farther_front(then, now);
  const double width = then.right - then.left, height = statistics::mean_of(then.height).value - then.bottom;
  const bool stopped = to_right ? is_stopped(now.right, packing.domain.wall[right], now.diameter)
                                : is_stopped(now.left, packing.domain.wall[left], now.diameter);
  const double error = stopped ? statistics::unknown : 0.5 * now.diameter;
  if (way > 0.5 * now.diameter) {
    j["runout_m"] = estimate(way, error, "m", "Displacement of the front that has moved farther");
    j["runout_over_width"] = estimate(way / width, error / width, "", "Run-out over the width before");
    if (stopped)
      j["notes"].push_back(
          "A side of the container stopped the front, which would have gone farther; make the container wider.");
  }
  j["width_before_m"] = described(width, "m", "Width before the stage");
  j["height_before_m"] = described(height, "m", "Mean height before the stage");
  j["aspect_ratio_before"] = described(height / width, "", "Height over width before the stage");
  j["height_over_width"] = described((now.top - now.bottom) / width, "", "Height now over the width before the stage");
}

/// What presses on the floor of a silo, and which share of their normal force its walls hold the filling back with.
void put_floor(Numbers& j, const StageResult& result) {
  const auto silo = silo_state(result);
  if (!silo) return;
  j["height_m"] = described(silo->height, "m", "Mean height of the filling");
  j["pressure_Pa"] = estimate(silo->force.value, silo->force.error, "Pa",
                              "Pressure on the floor, mean of the second half of the stage", 1 / silo->area());
  j["hydrostatic_Pa"] = described(silo->weight / silo->area(), "Pa", "Weight of the filling over the floor's area");
  j["wall_friction"] = described(silo->wall_friction, "", "Weight carried by the walls over their normal force");
  if (std::isfinite(silo->stress_ratio))
    j["stress_ratio"] = described(silo->stress_ratio, "",
                                  "Horizontal over vertical normal stress of the contacts, over the states of the "
                                  "second half");
}

template <int D>
Numbers surface_numbers(const StageResultIn<D>& result, const dem::Stage& stage, const PackingIn<D>* before) {
  const Vec2 gravity = result.asked.gravity;
  const PackingIn<D>& packing = result.snapshots.back().packing;
  const FreeSurface now = find_free_surface(packing, gravity);
  if (constexpr std::size_t fewest = 10; now.grains < fewest && now.grains < packing.grains.size()) {
    Numbers none = Numbers::tree();
    none["notes"].push_back(fmt::format("At most {} of {} grains lie together at the end, which are no heap.",
                                        now.grains, packing.grains.size()));
    return none;
  }
  Numbers j{{"grains", described(now.grains, "", "Grains of the heap")},
            {"left_m", described(now.left, "m", "Its left front")},
            {"right_m", described(now.right, "m", "Its right front")},
            {"bottom_m", described(now.bottom, "m", "Lower edge of its lowest grain")},
            {"top_m", described(now.top, "m", "Upper edge of its highest grain")}};
  const auto put_angle = [&j](const char* name, const statistics::Estimate& angle, const char* sentence) {
    if (std::isfinite(angle.value)) j[name] = estimate(angle.value, angle.error, "deg", sentence, degrees);
  };
  put_angle("angle_deg", now.angle, "Angle of the whole free surface, counter-clockwise");
  put_angle("left_angle_deg", now.left_flank.angle, "Angle of the left flank");
  put_angle("right_angle_deg", now.right_flank.angle, "Angle of the right flank");
  if (!now.fills_depth)
    j["notes"].push_back(
        "The heap does not reach from the back to the front, so that its profile over the depth has no angle.");
  put_filling(j, packing, gravity, now);
  if (stage.duration && result.snapshots.size() >= 12) put_mean_angle(j, result, gravity);
  if (before && !in_drum(packing.domain)) {
    const FreeSurface then = find_free_surface(*before, gravity);
    if (!then.height.empty()) put_runout(j, now, then, packing);
  }
  return j;
}

}  // namespace

template <int D> Numbers flows_of(const StageResultIn<D>& result, const dem::Stage& stage, const PackingIn<D>* before) {
  Numbers j = Numbers::tree();
  if (result.snapshots.back().packing.grains.size() == 0) return j;
  if (Numbers discharge = discharge_of(result); !discharge.empty()) j["discharge"] = std::move(discharge);
  if (stage.duration)
    if (Numbers boundaries = boundary_numbers(result, j); !boundaries.empty())
      j["boundary_loads"] = std::move(boundaries);
  if (has_free_surface(result.asked, stage)) j["surface"] = surface_numbers(result, stage, before);
  return j;
}
template Numbers flows_of(const StageResult&, const dem::Stage&, const Packing*);
template Numbers flows_of(const SphereResult&, const dem::Stage&, const PackingIn<3>*);

Numbers flow_numbers(const StageEnd& end) {
  const auto& [result, stage, before, texture, options] = end;
  Numbers j = flows_of(result, stage, before);
  if (result.snapshots.back().packing.grains.size() == 0) return j;
  if (Numbers exchange = exchange_numbers(result); !exchange.empty()) j["exchange"] = std::move(exchange);
  if (!stage.duration || !j.contains("surface")) return j;
  Numbers floor = Numbers::tree();
  put_floor(floor, result);
  if (!floor.empty()) j["floor"] = std::move(floor);
  return j;
}

}  // namespace arenite::fields
