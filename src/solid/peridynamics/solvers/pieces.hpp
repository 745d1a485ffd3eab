#pragma once
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"
#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// The sample cut by grain and by square cells. Matrix goes to the nearest grain; a piece is what bonds hold together
/// of one owner inside one cell. Soft necks and bridges then lie on cuts, and every rigid motion and uniform strain of
/// every grain is a bilinear function on its pieces.
struct Pieces {
  static constexpr int cell = 16;  ///< nodes a side
  static constexpr std::int32_t none = -1;

  Buffer<std::int32_t> of_node;     ///< padded; none for void and for rows with both components prescribed
  std::vector<std::int32_t> owner;  ///< of each piece
  std::vector<std::int32_t> cell_x, cell_y;
  std::vector<std::int32_t> nodes;  ///< how many each holds
  std::int32_t count() const { return static_cast<std::int32_t>(owner.size()); }
};

/// `prescribed` has one entry a row (kernels.hpp).
Pieces cut_into_pieces(const PhaseMap& map, const Bonds& bonds, const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::peridynamics
