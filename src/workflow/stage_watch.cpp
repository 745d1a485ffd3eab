#include "workflow/stage_watch.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/hash.hpp"
#include "core/problems.hpp"
#include "grains/fields/regime/coming_to_rest.hpp"
#include "grains/fields/regime/prediction.hpp"
#include "workflow/runner.hpp"

namespace arenite::workflow {
namespace {

/// What may change while a stage is under way.
void take_drives(dem::Stage& to, const dem::Stage& from) {
  to.side = from.side, to.slide = from.slide, to.shear_rate = from.shear_rate;
  to.gravity = from.gravity, to.gravity_size = from.gravity_size, to.gravity_angle = from.gravity_angle;
  to.boundaries = from.boundaries;
  to.boundaries_in_space = from.boundaries_in_space;
  to.friction = from.friction, to.drag = from.drag, to.critical_drag = from.critical_drag;
}

/// Steps after which an increment takes too long: ten times what was predicted; none of a stage that lasts a time.
std::optional<std::int64_t> patience_of(const GrainStage& stage, const dem::Engine& engine, const dem::Stage& asked) {
  if (!stage.before || stage.before->grains.size() == 0) return std::nullopt;
  fields::Bulk bulk = fields::bulk_of(*stage.before, stage.recipe.contact);
  fields::Pressures pressures;
  const auto predicted =
      fields::predict_stage(engine, stage.recipe.contact, stage.recipe.integration.drag, asked, bulk, pressures);
  return predicted.exact ? std::nullopt : std::optional(10 * predicted.increment_steps);
}
std::optional<std::int64_t> patience_of(const GrainStageIn<3>& stage, const dem::EngineIn<3>& engine,
                                        const dem::Stage& asked) {
  if (!stage.before || stage.before->grains.size() == 0 || asked.duration) return std::nullopt;
  return 10 * fields::steps_to_rest(engine, stage.recipe.integration.drag, asked);
}

}  // namespace

template <int D> void StageUnderWayIn<D>::store(std::string label) {
  changes_.emplace_back(fmt::format("stored at {:.9g} s", dem::time_of<D>(engine_)), label);
  dem::store_state(engine_, std::move(label), run_);
}

template <int D> void StageUnderWayIn<D>::stop(const std::string& why) {
  changes_.emplace_back(fmt::format("stopped at {:.9g} s", dem::time_of<D>(engine_)), why);
  dem::end_early(engine_, stage(), why, run_);
}

template <int D> void StageUnderWayIn<D>::change(const std::vector<std::string>& assignments) {
  std::vector<std::string> overrides;
  for (const std::string& each : assignments) overrides.push_back(fmt::format("stages.{}.{}", place_ - 1, each));
  const dem::Stage before = stage();
  const dem::Stage after =
      recipe::parse_recipe(recipe::to_toml(recipe_), recipe_.source_file, overrides).stages[place_ - 1];
  dem::Stage same = after;
  take_drives(same, before);
  if (!(same == before))
    throw InputError(
        "a stage under way can change its sides, slide, gravity, shear_rate, boundaries, friction, drag and "
        "critical_drag, and no other key");
  recipe_.stages[place_ - 1] = after;
  engine_.change(before, after);
  for (const std::string& each : assignments)
    changes_.emplace_back(fmt::format("changed at {:.9g} s", dem::time_of<D>(engine_)), each);
}

template <int D>
StageWatch<D>::StageWatch(const GrainStageIn<D>& stage, dem::EngineIn<D>& engine, dem::StageRunIn<D>& run,
                          const RunOptions& options, const Progress& progress, const StepFunction* on_step)
    : given_(stage),
      engine_(engine),
      run_(run),
      options_(options),
      progress_(progress),
      on_step_(on_step),
      now_(stage.recipe, stage.place, engine, run),
      called_(engine.step),
      patience_(patience_of(stage, engine, now_.stage())) {
  if (!now_.stage().until.empty()) until_.emplace(now_.stage().until);
  progress_.increments = now_.stage().duration ? 0 : dem::increment_count(now_.stage());
}

template <int D> void StageWatch<D>::look() {
  if (!run_.finished) end_where_met();
  if (!run_.finished) tell_of_unrest();
  if (!run_.finished) call();
  show();
}

template <int D> typename StageWatch<D>::MadeBy StageWatch<D>::made_by() const {
  if (now_.changes().empty()) return {given_.recipe, given_.hash, {}};
  HashBuilder hash;
  hash.add("stage", given_.hash);
  for (const auto& [when, what] : now_.changes()) hash.add(when, what);
  return {now_.recipe(), hash.hex(), now_.changes()};
}

/// Looked at with each row, so that neither threads nor checkpoints decide.
template <int D> void StageWatch<D>::end_where_met() {
  const std::vector<double>* time = run_.result.history.find("time");
  if (!until_ || !time || time->back() != dem::time_of<D>(engine_)) return;
  if (const auto met =
          until_->met(run_.result.history, run_.start.time, now_.stage(), given_.loaded_before(), *given_.before))
    dem::end_early(engine_, now_.stage(), *met, run_);
}

template <int D> void StageWatch<D>::tell_of_unrest() {
  progress_.settles = !patience_ || run_.steps_in_increment < *patience_;
  if (progress_.settles || told_) return;
  told_ = true;
  options_.notice(
      fmt::format("stage {}: increment {} of {} has taken {} steps, ten times as many as predicted, without coming "
                  "to rest: {}; it goes on until equilibrium.max_steps = {}",
                  now_.stage().name, run_.increment + 1, progress_.increments, run_.steps_in_increment,
                  dem::unrest(engine_, now_.stage(), run_), now_.stage().equilibrium.max_steps));
}

template <int D> void StageWatch<D>::call() {
  if (!on_step_ || engine_.step - called_ < on_step_->every) return;
  called_ += (engine_.step - called_) / on_step_->every * on_step_->every;
  (*on_step_)(now_);
}

template <int D> void StageWatch<D>::show() {
  note_progress(engine_, now_.stage(), run_, progress_);
  if (!progress_.settles && !run_.finished)
    progress_.share = static_cast<double>(run_.increment) / static_cast<double>(progress_.increments);
  for (std::size_t side = 0; side < sides_in<D>; ++side) {
    const WallIn<D>& wall = engine_.domain.wall[side];
    progress_.side[side] = {wall.present, wall.position, wall.force};
  }
  options_.progress(progress_);
}

template class StageUnderWayIn<2>;
template class StageUnderWayIn<3>;
template class StageWatch<2>;
template class StageWatch<3>;

}  // namespace arenite::workflow
