#include "statistics/least_squares.hpp"

#include <gtest/gtest.h>

namespace arenite::statistics {
namespace {

/// Columns 1, x and x^2 at x = 0 .. 5.
Matrix parabola_columns() {
  Matrix a(6, 3);
  for (std::size_t n = 0; n < 6; ++n) {
    const auto x = static_cast<double>(n);
    a(n, 0) = 1, a(n, 1) = x, a(n, 2) = x * x;
  }
  return a;
}

void expect_near(const Matrix& a, const Matrix& b, double within) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.columns(), b.columns());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a.column(0)[k], b.column(0)[k], within);
}

TEST(LeastSquares, AllSolversFindWhatTheRightSideWasMadeFrom) {
  const Matrix a = parabola_columns(), normal = transposed_times(a, a);
  Matrix x(3, 2);
  for (std::size_t k = 0; k < x.size(); ++k) x.column(0)[k] = 1.5 - static_cast<double>(k);
  const Matrix right = normal * x;
  expect_near(solve(normal, right), x, 1e-10);
  expect_near(solve_symmetric(normal, right), x, 1e-10);
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (int half = 0; half < 2; ++half) entries.push_back({i, j, normal(i, j) / 2});
  expect_near(solve_sparse(entries, right), x, 1e-10);
}

TEST(LeastSquares, OrthonormalColumnsSpanThoseGiven) {
  const Matrix a = parabola_columns();
  const auto [q, r] = orthonormal(a);
  expect_near(transposed_times(q, q), identity(3, 3), 1e-14);
  expect_near(q * r, a, 1e-13);
  EXPECT_EQ(r(2, 0), 0);
}

TEST(LeastSquares, ProductsWithTransposedAreThoseOfTheTransposed) {
  const Matrix a = parabola_columns();
  expect_near(times_transposed(a, a), a * transposed(a), 1e-12);
  expect_near(transposed_times(a, a), transposed(a) * a, 1e-12);
  EXPECT_EQ(squares(a), dot(a.column(0), a.column(0), a.size()));
}

TEST(LeastSquares, SmallNormalEquationsFitWeighedRows) {
  const Matrix a = parabola_columns();
  SmallNormal<3> normal;
  for (std::size_t n = 0; n < 6; ++n)
    normal.add({a(n, 0), a(n, 1), a(n, 2)}, 2 - 3 * a(n, 1) + 0.5 * a(n, 2), 1 + static_cast<double>(n));
  const auto x = normal.solution();
  EXPECT_NEAR(x[0], 2, 1e-11);
  EXPECT_NEAR(x[1], -3, 1e-11);
  EXPECT_NEAR(x[2], 0.5, 1e-11);
}

}  // namespace
}  // namespace arenite::statistics
