#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// The sample cut by grain and by square cells. Matrix goes to the nearest grain; an aggregate is what bonds hold
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

/// `prescribed` has one entry a row (kernels.hpp).
Aggregates cut_into_aggregates(const PhaseMap& map, const Bonds& bonds, const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::peridynamics
