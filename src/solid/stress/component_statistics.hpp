#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/phase_map.hpp"
#include "statistics/numbers.hpp"

namespace arenite::stress {

/// The sets of nodes or voxels that do not overlap; unclassed are particles without class.
enum class NodeSet : std::uint8_t { left_out, matrix, small, large, unclassed };

/// Of a phase, and for a particle the class of its grain.
NodeSet set_of(Phase phase, GrainClass of_grain);

/// Which nodes count, and in which block each lies.
struct Selection {
  std::size_t nodes = 0;                           ///< considered: particle or matrix
  std::size_t clamp_nodes = 0, surface_nodes = 0;  ///< left out as clamp rows, as outermost ones
  std::size_t unloaded_nodes = 0;                  ///< particle or matrix without any stress beyond the clamp rows
  std::vector<NodeSet> set;                        ///< one a node
  std::vector<std::uint16_t> block;                ///< one a node
  int blocks = 1;                                  ///< in all
  std::vector<double> block_area;                  ///< nodes of a block beyond the clamp rows, void included
};

/// A stress at a node, Pa.
using StressAt = std::function<double(std::size_t node)>;

/// Statistics of one component of stress by set: "all", "particle", "large", "small", "matrix". Not known where it is
/// zero in every node. Stresses are divided by the mean over the nodes, or over the whole area.
Numbers component_statistics(const Selection& selection, const std::string& name, const StressAt& stress,
                             bool mean_over_area, std::vector<std::string>& notes);

}  // namespace arenite::stress
