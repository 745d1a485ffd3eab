#include "grains/fields/regime/stage_steps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/problems.hpp"
#include "geometry/ball.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"

namespace arenite::fields {

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

double settling_of(const dem::Stage& stage, std::span<const dem::SideDrive> sides, double critical,
                   double steady_drag) {
  const double drag = steady_drag + stage.drag + stage.critical_drag * critical;
  return settling_time(4 * std::numbers::pi / critical, drag, stage.equilibrium.unbalanced,
                       std::ranges::all_of(sides, &dem::SideDrive::presses));
}

namespace {

constexpr double late = 4;  // slips and grains that come to bear late; measured on packings of 120 to 900 spheres

/// Time in which spheres get as dense as the drives of a stage make them, s.
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
  const double speed = 2 * stage.inertial_number * std::sqrt(pressure * volume / mass);
  double closing = speed > 0 ? way / speed : 0;
  if (stage.gravity) closing += std::sqrt(2 * larger * cell.extent(1) / stage.gravity_size);
  return closing;
}

double settling_time(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage, double larger) {
  return settling_of(stage, stage.side, dem::critical_drag(engine) / larger, steady_drag);
}

}  // namespace

std::int64_t steps_to_rest(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage) {
  return about_steps(late * (closing_time(engine, stage, 1) + settling_time(engine, steady_drag, stage, 1)), engine.dt);
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
  const double closing = at_rest ? 0 : closing_time(engine, stage, larger),
               settling = settling_time(engine, steady_drag, stage, larger);
  at_rest = true;
  p.states = dem::increment_count(stage);
  p.duration = late * (closing + static_cast<double>(p.states) * settling);
  p.steps = about_steps(p.duration, p.time_step);
  p.increment_steps = about_steps(late * (closing + settling), p.time_step);
  return p;
}

}  // namespace arenite::fields
