#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/lanes.hpp"
#include "core/pages.hpp"
#include "solid/statics/cholesky.hpp"
#include "solid/statics/pool.hpp"

namespace arenite::statics {

/// The components at a coarse node, and zeros.
using Four = Vector<float, 4>;

/// A matrix of D x D blocks in single precision and the inverse of its diagonal, for the smoother of the third level.
template <int D> class CoarseMatrix {
 public:
  explicit CoarseMatrix(const BlockMatrix& matrix, const ThreadPool* pool = nullptr);

  std::size_t size() const { return n_; }
  /// y := A x; what is added up to a row does not depend on the number of threads.
  void apply(const std::vector<Four>& x, std::vector<Four>& y);
  /// The inverse of a node's own block times r.
  Four preconditioned(std::size_t node, Four r) const;

 private:
  /// Columns whose product is formed in one piece, and the rows that it reaches.
  struct Stretch {
    std::size_t first, end, reach;
    std::vector<Four> sum;  ///< of rows from the first up to the reach
  };
  void invert_diagonal(const BlockMatrix& matrix);
  void cut_into_stretches();
  void add_product(const std::vector<Four>& x, Stretch& stretch) const;

  std::size_t n_;
  std::vector<std::int32_t> column_begin_;
  Buffer<std::int32_t> row_;
  Buffer<float> value_, inverse_;  ///< D^2 a block
  std::vector<Stretch> stretches_;
  const ThreadPool* pool_;
};
extern template class CoarseMatrix<2>;
extern template class CoarseMatrix<3>;

}  // namespace arenite::statics
