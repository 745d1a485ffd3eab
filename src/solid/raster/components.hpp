#pragma once
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"

namespace arenite::raster {

/// Which phases are flooded.
enum class Flooded { voids, pores, solid };  // empty; not particle; not empty

/// Connected sets of nodes, in the order of their first node.
struct Components {
  std::vector<std::int32_t> label;    ///< one a node; -1: another phase
  std::vector<std::int64_t> nodes;    ///< one a component
  std::vector<std::uint8_t> sides;    ///< bit Side (model/domain.hpp) of the edges of the map that it touches
};

/// Labels by runs along rows and their union; neighbours are the four nearest nodes, or all eight.
Components find_components(const PhaseMap& map, Flooded phases, bool eight_connected);

}  // namespace arenite::raster
