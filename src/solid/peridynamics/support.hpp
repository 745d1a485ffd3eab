#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/load.hpp"

/// How a sample is held, and what of it hangs together.
namespace arenite::peridynamics {

/// Unit vector along which the top row moves.
Vec2 direction_of(Loading loading);

/// What is prescribed in each row of nodes (kernels.hpp). Throws InputError for shear above a sliding edge.
std::vector<std::uint8_t> prescribed_rows(int height, Loading loading, LowerEdge lower);

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

/// Which clamp a node moves with where it carries nothing.
enum class Tie : std::uint8_t { none = 0, below = 1, above = 2, both = 3 };

/// Cuts all bonds of what is not tied to both clamps out of `bonds`, and its nodes out of `aggregates`. `tie` says, a
/// node (padded), what it was tied to.
Support prune(Bonds& bonds, Aggregates& aggregates, const std::vector<std::uint8_t>& prescribed, Buffer<Tie>& tie);

/// All hinges of what is tied to the bottom row: cut nodes of the graph of bonds (R. Tarjan, 1972), sorted by row, then
/// column. Single nodes on two or more bonds that are not in line, and parts held by two nodes, are no hinges.
std::vector<Hinge> find_hinges(const Bonds& bonds);

}  // namespace arenite::peridynamics
