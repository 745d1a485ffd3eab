#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/joined_sets.hpp"
#include "core/pages.hpp"
#include "model/phase_map.hpp"
#include "model/voxel_map.hpp"
#include "solid/statics/grid.hpp"
#include "solid/statics/pool.hpp"

namespace arenite::statics {

/// The sample cut by grain and by square or cubic cells. Matrix goes to the nearest grain; an aggregate is what hangs
/// together of one owner inside one cell. Soft necks and bridges then lie on cuts, and every rigid motion and uniform
/// strain of every grain is a multilinear function on its aggregates.
struct Aggregates {
  static constexpr int cell = 16;  ///< nodes a side of a cell in the plane
  static constexpr std::int32_t none = -1;

  struct Aggregate {
    std::int32_t owner;
    std::array<std::int32_t, 3> cell;  ///< which, along each axis
    std::int32_t nodes = 0;            ///< how many it holds
  };
  int side = cell;               ///< nodes a side of a cell
  Buffer<std::int32_t> of_node;  ///< padded; none for void and for levels with all components prescribed
  std::vector<Aggregate> list;
  std::int32_t count() const { return static_cast<std::int32_t>(list.size()); }
};

/// A cell of the sample: its first node and how many it has each way.
struct Cell {
  int x0, y0, wide, high;
  int z0 = 0, deep = 1;
};

/// Owner of every node or pixel of a map, in its order, -1 for void: its grain; for matrix the grain that a flood
/// through the matrix reaches it from first; for matrix that touches no grain, one number beyond the grains. In space
/// pieces of grains and of such matrix stand for them (pieces.hpp).
std::vector<std::int32_t> owners_in(const PhaseMap& map);
std::vector<std::int32_t> owners_in(const VoxelMap& map);

/// Cuts nodes by their owners (padded, -1: nobody's) and by cells of `side` nodes. `join(cell, sets)` joins the nodes
/// of a cell (by their places in it, (z * side + y) * side + x) that hang together and have one owner.
Aggregates cut_by_owner(const Grid& grid, const Buffer<std::int32_t>& owner,
                        const std::function<void(const Cell&, JoinedSets&)>& join, int side = Aggregates::cell,
                        const ThreadPool* pool = nullptr);

}  // namespace arenite::statics
