#pragma once
#include <vector>

#include "model/result.hpp"
#include "report/figures/drawing.hpp"
#include "report/figures/grains/grain_scatter.hpp"

namespace arenite::report::figures {

/// All states of a run: the texture of each, none where it is not known, the packing at the end with the numbers of its
/// grains, and what was asked of it.
struct RunData {
  std::vector<const Numbers*> textures;
  const Packing* last = nullptr;
  Asked asked = {};
  GrainNumbers grains = {};
};

/// Figures of a run as a whole.
const std::vector<Row<RunData>>& run_figures();

/// Figures of a stage of spheres: those of disks that say the same of them, by its numbers and its history.
const std::vector<Row<SphereResult>>& sphere_figures();

}  // namespace arenite::report::figures
