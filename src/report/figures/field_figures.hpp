#pragma once
#include <cstdint>
#include <vector>

#include "core/mapped.hpp"
#include "model/result.hpp"
#include "report/figures/drawing.hpp"

namespace arenite::report::figures {

/// What figures show of a sample on a grid: how it was solved, how it failed, its
/// numbers, and the densities of its stresses by component and set; a tree without any where they are not known.
struct FieldData {
  const History& convergence;
  const History& curve;
  std::vector<std::uint8_t> broken;  ///< types of the bonds that broke, in their order
  const Numbers& numbers;
  const Numbers& densities;
  bool has_steps = true;  ///< the picture beside the figures shows one step of the test

  FieldData(const FieldResult& result, const Numbers& of_stresses)
      : convergence(result.convergence),
        curve(result.curve),
        broken(mapped(result.cracks, &Crack::type)),
        numbers(result.numbers),
        densities(of_stresses) {}
  FieldData(const VoxelResult& result, const Numbers& of_stresses)
      : convergence(result.convergence),
        curve(result.curve),
        broken(mapped(result.cracks, &Crack::type)),
        numbers(result.numbers),
        densities(of_stresses),
        has_steps(false) {}
};

/// Figures of a sample on a grid, in their order on the page.
const std::vector<Row<FieldData>>& field_figures();
/// Of a sample in space, by its numbers and its solver.
const std::vector<Row<FieldData>>& voxel_figures();

}  // namespace arenite::report::figures
