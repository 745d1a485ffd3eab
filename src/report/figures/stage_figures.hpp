#pragma once
#include <string>
#include <vector>

#include "model/result.hpp"
#include "report/figures/drawing.hpp"

namespace arenite::report::figures {

/// A stage with the stored states of it that are shown, and the packing before it, to which its strains refer.
struct StageData {
  const StageResult& stage;
  std::vector<const Snapshot*> states;
  const Packing* before = nullptr;
};

/// Figures of the history of a stage, in their order on the page.
const std::vector<Row<StageData>>& stage_figures();

/// All states of a run: the texture of each, none where it is not known, the packing at the end and what was asked of
/// it.
struct RunData {
  std::vector<const Numbers*> textures;
  const Packing* last = nullptr;
  Asked asked = {};
};

/// Figures of a run as a whole.
const std::vector<Row<RunData>>& run_figures();

}  // namespace arenite::report::figures
