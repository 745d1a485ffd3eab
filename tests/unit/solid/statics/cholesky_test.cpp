#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <initializer_list>

#include "solid/statics/cholesky.hpp"

namespace arenite::statics {
namespace {

/// A chain of plane springs with a little ground stiffness, 2 x 2 blocks.
BlockMatrix chain(int n, double ground) {
  BlockMatrix m;
  m.column_begin = {0};
  for (int c = 0; c < n; ++c) {
    m.row.push_back(c);
    m.value.insert(m.value.end(), {4 + ground, 1, 1, 3 + ground});
    if (c + 1 < n) {
      m.row.push_back(c + 1);
      m.value.insert(m.value.end(), {-1, 0.5, -0.25, -1});
    }
    m.column_begin.push_back(static_cast<std::int32_t>(m.row.size()));
  }
  return m;
}

TEST(Cholesky, SolutionTimesTheMatrixIsTheRightSide) {
  const int n = 50;
  const BlockMatrix m = chain(n, 0.5);
  Cholesky factor(m);
  ASSERT_TRUE(factor.positive());
  std::vector<double> b(2 * n), product(2 * n, 0.0);
  for (std::size_t k = 0; k < b.size(); ++k) b[k] = static_cast<double>(k % 7) - 3;
  auto x = b;
  factor.solve(x);
  for (int c = 0; c < n; ++c)
    for (int j = m.column_begin[static_cast<std::size_t>(c)]; j < m.column_begin[static_cast<std::size_t>(c) + 1]; ++j)
      for (int s = 0; s < 2; ++s)
        for (int r = 0; r < 2; ++r) {
          const int row = 2 * m.row[static_cast<std::size_t>(j)] + r, column = 2 * c + s;
          const double v =
              m.value[4 * static_cast<std::size_t>(j) + 2 * static_cast<std::size_t>(s) + static_cast<std::size_t>(r)];
          product[static_cast<std::size_t>(row)] += v * x[static_cast<std::size_t>(column)];
          if (m.row[static_cast<std::size_t>(j)] != c)
            product[static_cast<std::size_t>(column)] += v * x[static_cast<std::size_t>(row)];
        }
  for (std::size_t k = 0; k < b.size(); ++k) EXPECT_NEAR(product[k], b[k], 1e-12);
}

TEST(Cholesky, IndefiniteMatrixIsToldNotSolved) { EXPECT_FALSE(Cholesky(chain(20, -5)).positive()); }

/// Nodes of a square lattice, each coupled with the next in its row and in its column: the factor has large dense
/// blocks.
BlockMatrix lattice(int side) {
  BlockMatrix m;
  m.column_begin = {0};
  const auto couple = [&](int row, std::initializer_list<double> block) {
    m.row.push_back(row);
    m.value.insert(m.value.end(), block);
  };
  for (int c = 0; c < side * side; ++c) {
    couple(c, {5, 0.1, 0.1, 5});
    if ((c + 1) % side != 0) couple(c + 1, {-1, 0, 0, -1});
    if (c + side < side * side) couple(c + side, {-1, 0, 0, -1});
    m.column_begin.push_back(static_cast<std::int32_t>(m.row.size()));
  }
  return m;
}

double first_of_solution() {
  constexpr int side = 80;
  Cholesky factor(lattice(side));
  std::vector<double> b(2 * side * side, 1.0);
  factor.solve(b);
  return b[0];
}

TEST(Cholesky, AProcessForkedFromOneThatHasSolvedSolves) {
  const double here = first_of_solution();
  const pid_t process = fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    alarm(60);  // for one that waits for threads that it does not have
    _exit(first_of_solution() == here ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  EXPECT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace arenite::statics
