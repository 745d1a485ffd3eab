#include "workflow/state_of_now.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "io/results/results.hpp"
#include "workflow/asked.hpp"

namespace arenite::workflow {
namespace {

template <int D>
StageResultIn<D> as_it_is(const GrainStageIn<D>& stage, const dem::EngineIn<D>& engine, const dem::StageRunIn<D>& run) {
  dem::StageRunIn<D> now;
  now.latest = run.latest;
  dem::store_state(engine, "now", now);
  now.result.name = run.result.name;
  now.result.outcome = "under way";
  now.result.history = run.result.history;
  note_asked(now.result, stage.recipe, stage.place, stage.loaded_before());
  return std::move(now.result);
}

}  // namespace

template <int D>
StateOfNow<D>::StateOfNow(const GrainStageIn<D>& stage, std::filesystem::path folder)
    : stage_(stage),
      file_(folder.empty() ? std::filesystem::path() : std::move(folder) / state_of_now) {}

template <int D> StateOfNow<D>::~StateOfNow() {
  std::error_code ignored;
  if (!file_.empty()) std::filesystem::remove(file_, ignored);
}

template <int D> void StateOfNow<D>::show(const dem::EngineIn<D>& engine, const dem::StageRunIn<D>& run) {
  const auto began = Clock::now();
  if (file_.empty() || began < next_) return;
  try {
    io::write_stage(file_, as_it_is(stage_, engine, run));
  } catch (const InputError&) {}  // the next one may have room
  const auto took = Clock::now() - began;
  next_ = Clock::now() + std::max<Clock::duration>(std::chrono::seconds(2), 100 * took);
}

template class StateOfNow<2>;
template class StateOfNow<3>;

}  // namespace arenite::workflow
