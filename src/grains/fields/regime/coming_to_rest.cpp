#include "grains/fields/regime/coming_to_rest.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/problems.hpp"
#include "geometry/ball.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"

namespace arenite::fields {

double settling_time(double period, double drag, double unbalanced, bool pressed_all_round) {
  const double periods = pressed_all_round ? 1.0 : 4.5;
  return std::log(1 / unbalanced) / (1 / (periods * period) + 0.5 * drag);
}

double settling_time(const dem::Stage& stage, std::span<const dem::SideDrive> sides, double critical,
                     double steady_drag) {
  const double drag = steady_drag + stage.drag + stage.critical_drag * critical;
  return settling_time(4 * std::numbers::pi / critical, drag, stage.equilibrium.unbalanced,
                       std::ranges::all_of(sides, &dem::SideDrive::presses));
}

double closing_speed(double inertial_number, double pressure, double bulk_density) {
  return 2 * inertial_number * std::sqrt(pressure / bulk_density);
}

double closing_time(const dem::Stage& stage, const Closing& closing, Bulk& bulk) {
  const double dense = closing.without_friction ? 0.84 : 0.81;  // random packings of disks: little and some friction
  const bool x = closing.along_x, y = closing.along_y;
  if ((!x && !y && !stage.gravity) || bulk.solid_fraction >= dense) return 0;
  const double closer = x && y ? std::sqrt(bulk.solid_fraction / dense) : bulk.solid_fraction / dense;
  const double speed = closing_speed(stage.inertial_number, closing.pressure, bulk.solid_fraction * bulk.density);
  const double way = (1 - closer) * std::max(x ? bulk.width : 0.0, y || !x ? bulk.height : 0.0);
  if (x) bulk.width *= closer;
  if (y || !x) bulk.height *= closer;
  bulk.solid_fraction = dense;
  return way / (x || y ? speed : std::sqrt(stage.gravity_size * way));
}

namespace {

double closing_time(const dem::EngineIn<3>& engine, const dem::Stage& stage, double larger) {
  using Kind = dem::SideDrive::Kind;
  constexpr double dense = 0.6;  // random packings of spheres, with little and with some friction
  const DomainIn<3>& cell = engine.domain;
  const double volume = volume_of(cell), mass = engine.wall[left].sample_mass;
  double solid = 0, pressure = 0, way = 0;
  for (std::size_t k = 0; k < engine.count; ++k) solid += geometry::volume_of_ball<3>(engine.record[k].radius) / volume;
  for (int side = 0; side < sides_in<3>; ++side) {
    const dem::SideDrive& drive = stage.side[side];
    const double length = cell.extent(side / 2);
    if (!drive.presses()) continue;
    pressure = std::max(pressure, drive.value * (drive.kind == Kind::force ? length / (larger * larger * volume) : 1));
    way = std::max(way, (1 - std::min(1.0, solid / dense)) * larger * length);
  }
  const double speed = closing_speed(stage.inertial_number, pressure, mass / volume);
  double time = speed > 0 ? way / speed : 0;
  if (stage.gravity) time += std::sqrt(2 * larger * cell.extent(1) / stage.gravity_size);
  return time;
}

}  // namespace

TimeToRest time_to_rest(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage, double larger) {
  constexpr double late = 4;  // slips and grains that come to bear late; measured on packings of 120 to 900 spheres
  const double settling = settling_time(stage, stage.side, dem::critical_drag(engine) / larger, steady_drag);
  return {late * closing_time(engine, stage, larger), late * settling};
}

std::int64_t about_steps(double time, double time_step) {
  return dem::steps_of(std::min(time, most_steps * time_step), time_step);
}

void count_steps(StagePrediction& p, const dem::Stage& stage) {
  if (const std::string wrong = too_many_steps(stage, p.time_step); !wrong.empty())
    throw refusal("stage \"{}\": {}", stage.name, wrong);
  p.duration = stage.duration.value_or(0);
  for (std::int64_t half = 0; half < dem::increment_count(stage) && stage.strain_cycles; ++half)
    p.duration += static_cast<double>(dem::strain_half(*stage.strain_cycles, half, p.time_step).steps) * p.time_step;
  p.steps = dem::steps_of(p.duration, p.time_step);
  p.states = stage.strain_cycles ? dem::increment_count(stage) : std::max<std::int64_t>(1, stage.snapshots);
}

void count_steps(StagePrediction& p, const dem::Stage& stage, double closing, double settling) {
  p.states = dem::increment_count(stage);
  p.duration = closing + static_cast<double>(p.states) * settling;
  p.steps = about_steps(p.duration, p.time_step);
  p.increment_steps = about_steps(closing + settling, p.time_step);
}

std::int64_t steps_to_rest(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage) {
  const TimeToRest time = time_to_rest(engine, steady_drag, stage, 1);
  return about_steps(time.closing + time.settling, engine.dt);
}

StagePrediction predict_stage(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage,
                              double larger, bool& at_rest) {
  StagePrediction p;
  p.name = stage.name;
  p.time_step = engine.dt;
  p.exact = stage.duration || stage.strain_cycles;
  if (p.exact) {
    count_steps(p, stage);
    return p;
  }
  const TimeToRest time = time_to_rest(engine, steady_drag, stage, larger);
  count_steps(p, stage, at_rest ? 0 : time.closing, time.settling);
  at_rest = true;
  return p;
}

}  // namespace arenite::fields
