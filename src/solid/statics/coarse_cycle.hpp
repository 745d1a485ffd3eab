#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solid/statics/chebyshev.hpp"
#include "solid/statics/cholesky.hpp"
#include "solid/statics/coarse_matrix.hpp"

namespace arenite::statics {

/// Where a coarse node is: its grain and the corner of cells, counted along each axis.
struct CoarsePlace {
  std::int32_t owner;
  std::array<std::int32_t, 3> at;
};

/// The third level, for coarse matrices whose factor would outgrow the sample: Chebyshev steps on the matrix, a
/// correction by a few functions of the place in every grain, and the same steps again. A grain moves and strains
/// uniformly; owners that reach far are cut into boxes with multilinear hats, and what does not hang together in a box
/// is told apart. Symmetric and positive.
template <int D> class CoarseCycle {
 public:
  CoarseCycle(BlockMatrix matrix, const std::vector<CoarsePlace>& places, const ThreadPool* pool = nullptr);

  /// False where a pivot of the last matrix was not positive.
  bool positive() const { return factor_->positive(); }
  /// b becomes the answer.
  void solve(std::vector<double>& b);

 private:
  using Field = std::vector<Four>;
  void set_steps();
  void cut(const BlockMatrix& matrix, const std::vector<CoarsePlace>& places);
  /// The product with the functions from both sides.
  BlockMatrix product(const BlockMatrix& matrix) const;
  void smooth(const Field& b, bool from_zero);
  void correct(const Field& b);

  std::size_t n_ = 0;
  CoarseMatrix<D> matrix_;
  std::vector<ChebyshevStep> steps_;
  std::vector<std::array<std::int32_t, 1 << D>> function_;  ///< of every coarse node: those of its box
  std::vector<std::array<float, 1 << D>> weight_;           ///< of each there
  std::int32_t functions_ = 0;
  std::optional<Cholesky> factor_;
  Field x_, older_, f_, right_;
  std::vector<double> load_;
};
extern template class CoarseCycle<2>;
extern template class CoarseCycle<3>;

}  // namespace arenite::statics
