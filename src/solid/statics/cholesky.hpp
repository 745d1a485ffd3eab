#pragma once
#include <cstdint>
#include <memory>
#include <vector>

namespace arenite::statics {

/// Symmetric sparse matrix of square blocks: the lower triangle by block columns, rows ascending, the diagonal block
/// first in each column.
struct BlockMatrix {
  int side = 2;  ///< of a block
  std::vector<std::int32_t> column_begin, row;
  std::vector<double> value;  ///< side^2 a block, column by column: (0,0), (1,0), ..
  std::int32_t columns() const { return static_cast<std::int32_t>(column_begin.size()) - 1; }
};

/// A direct solver of one matrix: CHOLMOD's supernodal factor, nodes ordered by AMD.
class Cholesky {
 public:
  /// The matrix is gone before the factor, which is many times as large, is there.
  explicit Cholesky(BlockMatrix matrix);
  ~Cholesky();

  /// False where a pivot was not positive; then solve() must not be called.
  bool positive() const;
  /// b becomes the solution.
  void solve(std::vector<double>& b);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace arenite::statics
