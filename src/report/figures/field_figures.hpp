#pragma once
#include <vector>

#include "model/result.hpp"
#include "report/figures/drawing.hpp"

namespace arenite::report::figures {

/// A cemented sample or its stresses, with the densities of these by component and set (stress::numbers); a tree
/// without any where they are not known.
struct FieldData {
  const FieldResult& result;
  const Numbers& densities;
};

/// Figures of a sample on a grid, in their order on the page.
const std::vector<Row<FieldData>>& field_figures();
/// Of a sample in space, by its numbers and its solver.
const std::vector<Row<FieldData>>& voxel_figures();

}  // namespace arenite::report::figures
