#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"
#include "model/stress_field.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::stress {

/// The sets that do not overlap; unclassed are particles without class.
enum class NodeSet : std::uint8_t { left_out, matrix, small, large, unclassed };

/// Which nodes count, and in which block each lies.
struct Selection {
  std::vector<NodeSet> set;              ///< one a node
  std::vector<std::uint16_t> block;      ///< one a node
  int blocks = 1;                        ///< in all
  std::vector<double> block_area;        ///< nodes of a block beyond the clamp rows, void included
  std::size_t nodes = 0, clamp_nodes = 0, surface_nodes = 0, unloaded_nodes = 0;
};

/// Throws InputError where the options, the map and the field do not fit each other or leave nothing.
Selection select(const PhaseMap& map, const StressField& field, const StressOptions& options);

/// Whether one of a node's eight neighbours is of another phase or grain; beyond the map there is none.
bool on_surface(const PhaseMap& map, int x, int y);

}  // namespace arenite::stress
