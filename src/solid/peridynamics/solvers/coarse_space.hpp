#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "solid/peridynamics/solvers/block_diagonal.hpp"
#include "solid/peridynamics/support.hpp"

namespace arenite::peridynamics {

/// Symmetric sparse matrix of 2 x 2 blocks: the lower triangle by block columns, rows ascending, the diagonal block
/// first in each column.
struct BlockMatrix {
  std::vector<std::int32_t> column_begin, row;
  std::vector<double> value;  ///< 4 a block: (0,0), (1,0), (0,1), (1,1)
  std::int32_t columns() const { return static_cast<std::int32_t>(column_begin.size()) - 1; }
};

/// A direct solver of one matrix: CHOLMOD's supernodal factor, nodes ordered by AMD.
class Cholesky {
 public:
  explicit Cholesky(const BlockMatrix& matrix);
  ~Cholesky();

  /// False where a pivot was not positive; then solve() must not be called.
  bool positive() const;
  /// b becomes the solution.
  void solve(std::vector<double>& b);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The four bilinear hats of a cell at one of its nodes; corners in the order (0,0), (1,0), (0,1), (1,1).
using Hats = double __attribute__((vector_size(32)));

/// Stiffness between the corners of aggregate p and those of aggregate q: [component][corner of p](corner of q), Pa,
/// with the components xx, xy (x of p, y of q), yy, yx.
struct Coupling {
  std::int32_t p, q;
  std::array<std::array<Hats, 4>, 4> block;
};

/// Galerkin sums over all bonds, in double: couplings of every aggregate with itself (first, in order of aggregates)
/// and of pairs of aggregates that bonds join. In a bottom row that slides, hats move nodes along x only.
std::vector<Coupling> couplings(const Bonds& bonds, const Aggregates& aggregates, const BlockDiagonal<double>& diagonal,
                                const std::vector<std::uint8_t>& prescribed);

/// Hats at a node, whose place counts from the corner of any cell.
const Hats& hats_at(int x, int y);

/// The second level of the static solve: one coarse node at each cell corner for each set of aggregates of one owner
/// that hang together there, with a bilinear hat on those aggregates. `correct` projects a residual on this space,
/// solves there and adds the answer.
class CoarseSpace {
 public:
  CoarseSpace(const Bonds& bonds, Aggregates aggregates, const BlockDiagonal<double>& diagonal,
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

}  // namespace arenite::peridynamics
