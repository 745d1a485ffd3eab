#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "core/joined_sets.hpp"
#include "core/pages.hpp"
#include "model/phase_map.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::statics {

/// The sample cut by grain and by square cells. Matrix goes to the nearest grain; an aggregate is what hangs
/// together of one owner inside one cell. Soft necks and bridges then lie on cuts, and every rigid motion and uniform
/// strain of every grain is a bilinear function on its aggregates.
struct Aggregates {
  static constexpr int cell = 16;  ///< nodes a side
  static constexpr std::int32_t none = -1;

  struct Aggregate {
    std::int32_t owner, cell_x, cell_y;
    std::int32_t nodes = 0;  ///< how many it holds
  };
  Buffer<std::int32_t> of_node;  ///< padded; none for void and for rows with both components prescribed
  std::vector<Aggregate> list;
  std::int32_t count() const { return static_cast<std::int32_t>(list.size()); }
};

/// A cell of the sample: its first node and how many it has each way.
struct Cell {
  int x0, y0, wide, high;
};

/// Owner of every node or pixel of a map, in its order, -1 for void: its grain; for matrix the grain that a flood
/// through the matrix reaches it from first; for matrix that touches no grain, one number beyond the grains.
std::vector<std::int32_t> owners_in(const PhaseMap& map);

/// Cuts nodes by their owners (padded, -1: nobody's). `join(cell, sets)` joins the nodes of a cell (by their places in
/// it, y * Aggregates::cell + x) that hang together and have one owner.
Aggregates cut_by_owner(const Grid& grid, const Buffer<std::int32_t>& owner,
                        const std::function<void(const Cell&, JoinedSets&)>& join);

}  // namespace arenite::statics
