#include "grains/fields/regime/stage_steps.hpp"

#include <algorithm>
#include <string>

#include "core/problems.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"
#include "grains/fields/regime/coming_to_rest.hpp"

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
