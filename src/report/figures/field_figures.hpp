#pragma once
#include <vector>

#include "model/result.hpp"
#include "report/figures/drawing.hpp"

namespace arenite::report::figures {

/// What figures show of a sample on a grid: how it was solved, how it failed (a sample in space never does), its
/// numbers, and the densities of its stresses by component and set; a tree without any where they are not known.
struct FieldData {
  const History& convergence;
  const History& curve;
  const std::vector<Crack>& cracks;
  const Numbers& numbers;
  const Numbers& densities;

  FieldData(const FieldResult& result, const Numbers& of_stresses)
      : convergence(result.convergence),
        curve(result.curve),
        cracks(result.cracks),
        numbers(result.numbers),
        densities(of_stresses) {}
  FieldData(const VoxelResult& result, const Numbers& of_stresses);
};

/// Figures of a sample on a grid, in their order on the page.
const std::vector<Row<FieldData>>& field_figures();
/// Of a sample in space, by its numbers and its solver.
const std::vector<Row<FieldData>>& voxel_figures();

}  // namespace arenite::report::figures
