#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/pages.hpp"
#include "solid/statics/aggregates.hpp"
#include "solid/statics/cholesky.hpp"
#include "solid/statics/coarse_cycle.hpp"
#include "solid/statics/couplings.hpp"
#include "solid/statics/grid.hpp"
#include "solid/statics/hats.hpp"
#include "solid/statics/pool.hpp"

namespace arenite::statics {

/// The second level of the static solve: one coarse node at each cell corner for each set of aggregates of one owner
/// that hang together there, with a multilinear hat on those aggregates. `correct` projects a residual on this space,
/// solves there, or takes the third level's answer (coarse_cycle.hpp), and adds it.
template <int D> class CoarseSpaceIn {
 public:
  CoarseSpaceIn(const Grid& grid, Aggregates aggregates, const GalerkinSums<D>& sums,
                const std::vector<std::uint8_t>& prescribed, const ThreadPool* pool = nullptr);

  /// z += P (P^T A P)^-1 P^T r.
  void correct(PointersIn<D, const float> r, PointersIn<D, float> z);

  /// How often the matrix had to be stiffened on its diagonal until all pivots were positive; 0 in a sound sample.
  int repairs() const { return repairs_; }
  std::int32_t nodes() const { return nodes_; }

 private:
  static constexpr int moments = 1 << D;  ///< of a component on an aggregate

  /// Nodes of one aggregate that follow each other in a row.
  struct Run {
    std::ptrdiff_t begin;
    std::int32_t aggregate;
    std::int16_t length, x, y, z;  ///< of the first node in its cell
    bool slides;                   ///< does not move across the clamps

    /// 1, y, (z, y z): of the row in its cell.
    std::array<float, moments / 2> monomials() const {
      std::array<float, moments / 2> of;
      set_monomials(y, z, of);
      return of;
    }
  };
  void number_corners(const GalerkinSums<D>& sums);
  BlockMatrix pattern(const GalerkinSums<D>& sums) const;
  /// Returns the stiffest entry of a coupling.
  double assemble(const GalerkinSums<D>& sums, BlockMatrix& matrix) const;
  /// The matrix with its diagonal stiffened once and for every repair once more.
  BlockMatrix stiffened(const GalerkinSums<D>& sums) const;
  void factorise(const GalerkinSums<D>& sums);
  std::vector<CoarsePlace> places() const;
  void solve();
  /// Adds the runs of a layer to the moments of its aggregates, and the answer of these to the runs.
  void take_moments(std::size_t layer, PointersIn<D, const float> r);
  void add_answer(std::size_t layer, PointersIn<D, float> z) const;
  void list_runs(const std::vector<std::uint8_t>& prescribed);
  std::int32_t corner(std::int32_t aggregate, int a) const {
    return corner_[static_cast<std::size_t>(corners<D> * aggregate + a)];
  }

  Grid grid_;
  Aggregates aggregates_;
  std::int32_t nodes_ = 0;
  std::vector<std::int32_t> corner_;  ///< coarse node of corner a of aggregate p at 2^D p + a
  Buffer<Run> runs_;
  std::vector<std::size_t> layer_begin_{0};  ///< the first run of every layer of cells, and the end
  const ThreadPool* pool_;
  std::optional<Cholesky> factor_;
  std::optional<CoarseCycle<D>> cycle_;  ///< instead, where the factor would be large
  std::vector<double> load_;             ///< right side and solution, D a coarse node
  std::vector<float> moments_;           ///< D 2^D an aggregate
  int repairs_ = 0;
};
using CoarseSpace = CoarseSpaceIn<2>;
extern template class CoarseSpaceIn<2>;
extern template class CoarseSpaceIn<3>;

}  // namespace arenite::statics
