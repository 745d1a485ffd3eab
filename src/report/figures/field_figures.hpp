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

/// Those of tests to failure.
Drawings stress_strain(const FieldData& data);
Drawings broken_bonds(const FieldData& data);
Drawings energy_balance(const FieldData& data);

}  // namespace arenite::report::figures
