#pragma once
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

/// Force of the grains on each boundary that is there, along each axis.
template <int D> Drawings boundary_forces(const StageData& data, const std::vector<BoundaryIn<D>>& boundaries);

/// Figures of the history of a stage, in their order on the page.
const std::vector<Row<StageData>>& stage_figures();

}  // namespace arenite::report::figures
