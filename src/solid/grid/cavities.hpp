#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"

namespace arenite::grid {

/// Pores are connected sets of nodes that are not grain, voids of nodes that are neither grain nor matrix (P III).
enum class Cavity { pore, void_ };

/// Rules of the flood fill; results are reported with them.
struct CavityRules {
  bool eight_connected = false;  ///< otherwise the four nearest nodes are neighbours
  int fewest_nodes = 5;          ///< smaller ones are specks of the grid and left out
  bool leave_out_border = true;  ///< those that touch the edge of the map are cut
  bool operator==(const CavityRules&) const = default;
};

struct Cavities {
  CavityRules rules;
  std::vector<std::int32_t> label;  ///< one a node: index of its cavity, -1 outside or left out
  std::vector<std::int64_t> nodes;  ///< one a cavity that counts, in order of their first node
  std::size_t specks = 0, cut = 0;  ///< left out as too small, as touching the border (whatever their size)
};

/// Throws InputError for a negative least size.
Cavities find_cavities(const PhaseMap& map, Cavity kind, const CavityRules& rules = {});

/// What runs through a map from side to side. Solid is grain and matrix together. Where voids are 4-connected solid is
/// 8-connected and the other way round, so that just one of a void from left to right and a solid from bottom to top
/// is there. Bonds of the solver reach further than neighbours: a solid that does not connect may still carry a little.
struct Percolation {
  bool solid_bottom_top = false, solid_left_right = false;
  bool void_bottom_top = false, void_left_right = false;
};

Percolation find_percolation(const PhaseMap& map, bool eight_connected_voids = false);

}  // namespace arenite::grid
