#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "solid/statics/aggregates.hpp"
#include "solid/statics/cholesky.hpp"
#include "solid/statics/couplings.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::statics {

/// The second level of the static solve: one coarse node at each cell corner for each set of aggregates of one owner
/// that hang together there, with a bilinear hat on those aggregates. `correct` projects a residual on this space,
/// solves there and adds the answer.
class CoarseSpace {
 public:
  CoarseSpace(const Grid& grid, Aggregates aggregates, const std::vector<Coupling>& couplings,
              const std::vector<std::uint8_t>& prescribed);

  /// z += P (P^T A P)^-1 P^T r.
  void correct(Plane<const float> r, Plane<float> z);

  /// How often the matrix had to be stiffened on its diagonal until all pivots were positive; 0 in a sound sample.
  int repairs() const { return repairs_; }

 private:
  /// Nodes of one aggregate that follow each other in a row.
  struct Run {
    std::ptrdiff_t begin;
    std::int32_t aggregate;
    std::int16_t x, y, length;  ///< of the first node, in its cell
    bool slides;                ///< moves along x only
  };
  void number_corners(const std::vector<Coupling>& couplings);
  BlockMatrix assemble(const std::vector<Coupling>& couplings) const;
  void list_runs(const std::vector<std::uint8_t>& prescribed);

  Grid grid_;
  Aggregates aggregates_;
  std::int32_t nodes_ = 0;
  std::vector<std::int32_t> corner_;  ///< coarse node of corner a of aggregate p at 4 p + a
  std::vector<Run> runs_;
  std::optional<Cholesky> factor_;
  std::vector<double> load_;    ///< right side and solution, 2 a coarse node
  std::vector<float> moments_;  ///< 8 an aggregate
  int repairs_ = 0;
};

}  // namespace arenite::statics
