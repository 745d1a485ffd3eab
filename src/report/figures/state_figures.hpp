#pragma once
#include <string>
#include <vector>

#include "model/packing.hpp"
#include "report/figures/drawing.hpp"

namespace arenite::report::figures {

/// A state of a packing: its texture with curves (texture::numbers), and its materials' names.
struct StateData {
  const Numbers& texture;
  std::vector<std::string> materials;
};

/// Figures of one state, in their order on the page.
const std::vector<Row<StateData>>& state_figures();

}  // namespace arenite::report::figures
