#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"
#include "solid/stress/options.hpp"

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
  int blocks = 1;                                  ///< in all, one layer of them between the clamps after the other
  int columns = 1;                                 ///< blocks of a layer: so many columns from clamp to clamp
  std::vector<double> block_area;                  ///< nodes of a block beyond the clamp rows, void included
};

/// Throws InputError where so many rows at each clamp leave no row of the map.
void check_clamp_rows(const PhaseMap& map, int rows);

/// Throws InputError where the options, the map and the field do not fit each other or leave nothing.
Selection select(const PhaseMap& map, const StressField& field, const StressOptions& options);

}  // namespace arenite::stress
