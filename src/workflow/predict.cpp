#include "workflow/predict.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"
#include "grains/fields/regime/coming_to_rest.hpp"
#include "grains/fields/regime/prediction.hpp"
#include "recipe/smaller_sample.hpp"
#include "workflow/make_packing.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

namespace {

using statistics::described;

/// So much longer takes a step of a sample under load, which has more contacts than the one in hand: measured on
/// examples/01 and 05, of spheres on validation/benchmarks/penetration.toml.
double dense(const dem::Engine& /*engine*/) { return 1.25; }
double dense(const dem::EngineIn<3>& /*engine*/) { return 1.45; }

/// Processor's seconds that a step will take, from some hundred at the begin of the first stage.
template <int D> double measured_step(dem::EngineIn<D>& engine, const dem::Stage& stage) {
  dem::StageRunIn<D> run = dem::begin_stage(engine, stage);
  dem::continue_stage(engine, stage, run);  // warms up
  const std::int64_t first = engine.step;
  const std::clock_t began = std::clock();
  const auto seconds = [&] { return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC; };
  for (int round = 0; round < 20 && !run.finished && seconds() < 0.2; ++round) dem::continue_stage(engine, stage, run);
  const std::int64_t steps = engine.step - first;
  return steps > 0 ? dense(engine) * seconds() / static_cast<double>(steps) : 0;
}

constexpr std::size_t most_grains = 20'000, few_grains = 4'000;

void warn(Prediction& p, const recipe::Recipe& recipe) {
  const auto add = [&](std::vector<std::string> doubts) { std::ranges::move(doubts, std::back_inserter(p.warnings)); };
  add(fields::doubts_about_step(p.time_step, p.limit, p.collision, recipe.contact));
  for (std::size_t s = 0; s < p.stages.size(); ++s) add(fields::doubts_about(p.stages[s], recipe.stages[s]));
}

/// In the order of fields::StepLimit.
constexpr const char* limit_words[] = {"collision", "stiffness", "damping", "given"};

Numbers numbers_of(const fields::StagePrediction& s) {
  Numbers j{{"name", s.name},
            {"steps", described(s.steps, "", "Steps of the stage")},
            {"exact", described(s.exact, "", "Whether their number follows from a duration; else it is an estimate")},
            {"duration_s", described(s.duration, "s", "Simulated time")},
            {"time_step_s", described(s.time_step, "s", "Time step of the stage")},
            {"computing_s", described(s.seconds, "s", "CPU time on one free core")}};
  j["states"] = described(s.states, "", "States that are stored");
  if (s.height) j["height_m"] = described(*s.height, "m", "Height of the sample in the end, an estimate");
  if (s.strain)
    j["strain"] = described(*s.strain, "", "Strain reached: of shear, or of the axis along which sides move");
  if (s.inserted > 0)
    j["grains_inserted"] = described(std::round(s.inserted), "", "Grains that its inflows bring, if all find room");
  if (s.pressure > 0) j["pressure_Pa"] = described(s.pressure, "Pa", "Largest pressure of sides or weight");
  if (s.inertial_number) {
    j["inertial_number"] = described(*s.inertial_number, "", "Inertial number rate d sqrt(rho/P)");
    j["flow"] = fields::flow_regime(*s.inertial_number);
  }
  if (s.stiffness_number) {
    j["stiffness_number"] =
        described(*s.stiffness_number, "", "Diameter over overlap under the pressure, k/(P L) of a linear law");
    j["overlap_over_diameter"] = described(*s.overlap, "", "Overlap under the pressure over the diameter");
  }
  return j;
}

}  // namespace

double Prediction::seconds() const {
  double sum = 0;
  for (const fields::StagePrediction& stage : stages) sum += stage.seconds;
  return sum;
}

double Prediction::bytes() const {
  constexpr double of_stage = 4e5;  // rows of a history, measured on three recipes of init
  double sum = bytes_of_state * static_cast<double>(grains);
  for (const fields::StagePrediction& stage : stages)
    sum += of_stage + bytes_of_state * static_cast<double>(grains) * static_cast<double>(stage.states);
  return sum;
}

Numbers numbers(const Prediction& p) {
  Numbers stages = Numbers::list();
  for (const fields::StagePrediction& stage : p.stages) stages.push_back(numbers_of(stage));
  return {{"time_step_s", described(p.time_step, "s", "Time step")},
          {"time_step_limited_by", limit_words[static_cast<std::size_t>(p.limit)]},
          {"largest_stable_step_s", described(p.largest_step, "s", "Largest stable time step")},
          {"shortest_collision",
           {{"time_s", described(p.collision.time, "s", "Duration of the collision without damping")},
            {"material", p.material},
            {"radius_m", described(p.collision.radius, "m", "Radius of its grain")},
            {"with_wall",
             described(p.collision.with_wall, "", "Whether it is with a wall; otherwise with an equal grain")}}},
          {"grains", described(p.grains, "", "Grains of the recipe")},
          {"grains_timed", described(p.sample, "", "Grains of the sample that was timed")},
          {"seconds_per_step", described(p.seconds_per_step, "s", "CPU time of one step on one free core")},
          {"computing_s", described(p.seconds(), "s", "CPU time of all stages on one free core")},
          {"files_bytes", described(p.bytes(), "", "Bytes of the files of all stages, to a factor of two or so")},
          {"memory_bytes", described(p.memory, "", "Bytes of memory that a run of spheres takes; 0 of disks")},
          {"stages", std::move(stages)},
          {"warnings", p.warnings}};
}

namespace {

/// What the engine of the recipe's sample, or of the small one, says of its steps.
template <int D>
void look_at(Prediction& p, const dem::EngineIn<D>& engine, const PackingIn<D>& start, const recipe::Recipe& recipe) {
  p.time_step = engine.dt;
  p.largest_step = step_bounds(engine).largest();
  p.collision = fields::shortest_collision(start, recipe.contact);
  p.material = start.materials[static_cast<std::size_t>(p.collision.material)].name;
  p.limit = fields::step_limit(engine, recipe.integration, p.collision.time);
}

/// Times the first stage, and so knows what all of them take.
template <int D>
void time_stages(Prediction& p, const PackingIn<D>& start, const recipe::Recipe& recipe, double share) {
  try {
    dem::EngineIn<D> timed(start, recipe.contact, recipe.integration);
    p.seconds_per_step = measured_step(timed, recipe.stages.front()) / share;
  } catch (const CannotGoOn& error) {
    p.warnings.push_back(fmt::format("stage {}: {}", recipe.stages.front().name, error.what()));
  }
  const auto first = static_cast<double>(p.grains);
  double grains = first;
  for (fields::StagePrediction& stage : p.stages) {
    const double in_mean = (grains + 0.5 * stage.inserted) / first;
    stage.seconds = p.seconds_per_step * static_cast<double>(stage.steps) * in_mean;
    grains += stage.inserted;
  }
}

Prediction predict_spheres(const recipe::Recipe& recipe, std::size_t expected, double share) {
  Prediction p;
  const recipe::SmallerSample smaller = recipe::smaller_sample(recipe, share);
  const recipe::Recipe& made = smaller.recipe;
  const PackingIn<3> start = make_sphere_packing(made).snapshots.back().packing;
  p.sample = start.grains.size();
  p.grains = share < 1 ? expected : p.sample;
  p.bytes_of_state = 500;                                 // dense, with their contacts: measured on docs/benchmarks.md
  p.memory = 3e7 + 2500 * static_cast<double>(p.grains);  // measured on 25 000 and a million
  dem::EngineIn<3> engine(start, made.contact, made.integration);
  look_at(p, engine, start, made);
  bool at_rest = false;
  for (const dem::Stage& stage : made.stages) {
    dem::begin_stage(engine, stage);
    p.stages.push_back(fields::predict_stage(engine, made.integration.drag, stage, 1 / smaller.across, at_rest));
  }
  if (made.stages.empty()) return p;
  time_stages(p, start, made, share);
  warn(p, made);
  return p;
}

Prediction predict_disks(const recipe::Recipe& recipe, std::size_t expected, double share) {
  Prediction p;
  const recipe::SmallerSample by = recipe::smaller_sample(recipe, share);
  const Packing start = make_packing(by.recipe).snapshots.back().packing;
  p.sample = start.grains.size();
  p.grains = share < 1 ? expected : p.sample;
  p.bytes_of_state = 170;  // measured on three recipes of init
  dem::Engine engine(start, recipe.contact, recipe.integration);
  look_at(p, engine, start, recipe);
  fields::Bulk bulk = fields::bulk_of(start, recipe.contact);
  bulk.larger = 1 / std::min(by.across, by.along);
  bulk.width /= by.across;
  bulk.height /= by.along;
  fields::Pressures pressures;
  for (const dem::Stage& stage : recipe.stages) {
    dem::begin_stage(engine, stage);
    p.stages.push_back(fields::predict_stage(engine, recipe.contact, recipe.integration.drag, stage, bulk, pressures));
  }
  if (recipe.stages.empty()) return p;
  time_stages(p, start, recipe, share);
  warn(p, recipe);
  return p;
}

}  // namespace

Prediction predict(const recipe::Recipe& recipe) {
  const std::size_t expected = recipe::grains_asked(recipe);
  const double share = expected > most_grains ? static_cast<double>(few_grains) / static_cast<double>(expected) : 1.0;
  return recipe.dimension == 3 ? predict_spheres(recipe, expected, share) : predict_disks(recipe, expected, share);
}

}  // namespace arenite::workflow
