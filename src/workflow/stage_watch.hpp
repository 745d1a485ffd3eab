#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grains/dem/run_stage.hpp"
#include "grains/fields/regime/until.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

/// A stage on its way, for a function that is called every so many steps: it reads what it likes, and may keep the
/// state of now, end the stage, or change what drives it from the next step on.
template <int D> class StageUnderWayIn {
 public:
  StageUnderWayIn(const recipe::Recipe& recipe, std::size_t place, dem::EngineIn<D>& engine, dem::StageRunIn<D>& run)
      : recipe_(recipe),
        place_(place),
        engine_(engine),
        run_(run) {}

  const dem::EngineIn<D>& engine() const { return engine_; }
  const dem::StageRunIn<D>& run() const { return run_; }
  const dem::Stage& stage() const { return recipe_.stages[place_ - 1]; }

  void store(std::string label);
  void stop(const std::string& why);
  /// Keys of the stage and their values ("top.pressure=20 kPa"): sides, slides, gravity, shear, the motion of
  /// boundaries, friction and drag. Throws InputError for others, and for what a recipe may not say.
  void change(const std::vector<std::string>& assignments);

  /// The recipe as it is now, and what was changed when.
  const recipe::Recipe& recipe() const { return recipe_; }
  const std::vector<std::pair<std::string, std::string>>& changes() const { return changes_; }

 private:
  recipe::Recipe recipe_;
  std::size_t place_;
  dem::EngineIn<D>& engine_;
  dem::StageRunIn<D>& run_;
  std::vector<std::pair<std::string, std::string>> changes_;
};
using StageUnderWay = StageUnderWayIn<2>;

/// A function that is called after every so many steps, counted up to the next look at the sample.
struct StepFunction {
  std::function<void(StageUnderWayIn<2>&)> of_disks;
  std::int64_t every = 1000;
  std::function<void(StageUnderWayIn<3>&)> of_spheres = {};

  void operator()(StageUnderWayIn<2>& now) const { of_disks(now); }
  void operator()(StageUnderWayIn<3>& now) const { of_spheres(now); }
};

/// Looks at a stage each time that it has gone on for a while: ends it where its condition holds, says once that it
/// does not settle, calls the function, and shows how far it is.
template <int D> class StageWatch {
 public:
  /// As the stage has begun, or was kept on its way.
  StageWatch(const GrainStageIn<D>& stage, dem::EngineIn<D>& engine, dem::StageRunIn<D>& run, const RunOptions& options,
             const Progress& progress, const StepFunction* on_step);

  const dem::Stage& stage() const { return now_.stage(); }
  void look();

  /// What the result depends on: the recipe as it became, its hash, and what was changed when.
  struct MadeBy {
    const recipe::Recipe& recipe;
    std::string hash;
    std::vector<std::pair<std::string, std::string>> changes;
  };
  MadeBy made_by() const;

 private:
  void end_where_met();
  void tell_of_unrest();
  void call();
  void show();

  const GrainStageIn<D>& given_;
  dem::EngineIn<D>& engine_;
  dem::StageRunIn<D>& run_;
  const RunOptions& options_;
  Progress progress_;
  const StepFunction* on_step_;
  StageUnderWayIn<D> now_;
  std::int64_t called_;                   ///< step of the last call, or of the multiple before it
  std::optional<std::int64_t> patience_;  ///< steps after which an increment takes too long
  bool told_ = false;
  std::optional<fields::Until> until_;
};

}  // namespace arenite::workflow
