#pragma once
#include <cstdint>
#include <string>

#include "grains/dem/engine.hpp"
#include "grains/dem/stage.hpp"
#include "model/result.hpp"

namespace arenite::dem {

/// A stage under way: everything besides the engine's own state that decides how it goes on, so that a checkpoint of
/// both resumes with the same bits.
template <int D> struct StageRunIn {
  StageStart start;
  std::int64_t increment = 0;  ///< the one under way
  std::int64_t steps_in_increment = 0;
  std::int64_t sample_every = 1;  ///< checks between two rows of the history
  std::int64_t checks = 0;
  std::int64_t extra_states = 0;  ///< stored beside those that the stage asks for
  bool finished = false;
  Equilibrium latest;       ///< what the last look at the sample found
  StageResultIn<D> result;  ///< snapshots and history so far
};
using StageRun = StageRunIn<2>;

/// Whether grains rest by a stage's criterion; what the forces on the sides must reach besides is the stage's to judge.
bool is_at_rest(const Equilibrium& now, const EquilibriumCriterion& rest);

/// The numbers that this is judged by, in words.
std::string describe(const Equilibrium& now);

/// Sets gravity, friction, drag and glue of the stage and notes the walls' forces.
template <int D> StageRunIn<D> begin_stage(EngineIn<D>& engine, const Stage& stage);

/// Goes on for one check interval: moves the sample, looks whether the increment is at rest (or its time is over),
/// stores a snapshot at its end and takes up the next. Sets `run.finished` after the last, or when an increment cannot
/// come to rest within `equilibrium.max_steps` (result.converged is then false and result.outcome says what was
/// reached).
template <int D> void continue_stage(EngineIn<D>& engine, const Stage& stage, StageRunIn<D>& run);

/// Keeps the state of the last look beside those that the stage asks for.
template <int D> void store_state(const EngineIn<D>& engine, std::string label, StageRunIn<D>& run);

/// Ends a stage at the last look, before it came to its own end: its state is the last one, and `why` begins the
/// sentence of its outcome.
template <int D>
void end_early(const EngineIn<D>& engine, const Stage& stage, const std::string& why, StageRunIn<D>& run);

/// What keeps the increment under way from rest, with the bounds asked for and the keys that mend it, in words.
template <int D> std::string unrest(const EngineIn<D>& engine, const Stage& stage, const StageRunIn<D>& run);

/// Share of the stage that is done, 0 to 1, for a progress bar: increments, and within one how far its unbalanced ratio
/// has come down on a logarithmic scale.
template <int D> double share_done(const Stage& stage, const StageRunIn<D>& run);

}  // namespace arenite::dem
