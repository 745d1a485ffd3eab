#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/random.hpp"
#include "thermal/inference/normal_equations.hpp"

namespace arenite::inference {
namespace {

/// Random equations in overlapping groups of unknowns, the same as a dense matrix.
struct Both {
  NormalEquations sparse;
  Eigen::MatrixXd dense;
  Eigen::VectorXd right;
};

Both random_equations(int unknowns, std::uint64_t seed) {
  Both both{NormalEquations(unknowns), Eigen::MatrixXd::Zero(unknowns, unknowns), Eigen::VectorXd::Zero(unknowns)};
  RandomStream random(seed, Purpose::test);
  for (int first = 0; first + 4 <= unknowns; first += 2) {
    const std::vector<int> columns{first + 3, first, first + 2, (first + 11) % unknowns};
    if (columns[3] >= first && columns[3] < first + 4) continue;
    std::vector<double> rows, values, weights;
    for (int r = 0; r < 6; ++r) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(unknowns);
      for (const int c : columns) row[c] = rows.emplace_back(random.normal());
      values.push_back(random.normal()), weights.push_back(0.5 + random.uniform());
      both.dense += weights.back() * row * row.transpose();
      both.right += weights.back() * values.back() * row;
    }
    both.sparse.add(columns, rows, values, weights);
  }
  for (int u = 0; u < unknowns; ++u) {
    both.sparse.add_diagonal(u, 0.1, 1);
    both.dense(u, u) += 0.1, both.right[u] += 0.1;
  }
  return both;
}

TEST(NormalEquations, SolutionErrorsAndInertiaAreThoseOfTheDenseMatrix) {
  const Both both = random_equations(60, 1);
  const Eigen::VectorXd x = both.dense.ldlt().solve(both.right);
  const Eigen::VectorXd variance = both.dense.inverse().diagonal();
  const std::vector<double> found = both.sparse.solve(), diagonal = both.sparse.inverse_diagonal();
  for (int u = 0; u < 60; ++u) {
    EXPECT_NEAR(found[static_cast<std::size_t>(u)], x[u], 1e-9);
    EXPECT_NEAR(diagonal[static_cast<std::size_t>(u)] / variance[u], 1, 1e-9);
  }
  const Eigen::VectorXd values = both.dense.selfadjointView<Eigen::Lower>().eigenvalues();
  for (const double share : {1e-3, 1e-2, 0.1, 0.3})
    EXPECT_EQ(both.sparse.small_eigenvalues(share),
              (values.array() < share * both.dense.diagonal().maxCoeff()).count());
}

/// At the minimum in the cone the slope is orthogonal to the solution along each edge, or points outwards.
RC_GTEST_PROP(NormalEquations, ConeSolutionObeysKarushKuhnTucker, ()) {
  const int contacts = 12;
  const double mu = 0.3;
  const Both both = random_equations(2 * contacts + 8, *rc::gen::inRange<std::uint64_t>(1, 1000));
  const std::vector<double> x = both.sparse.solve_in_cone(contacts, mu);
  const Eigen::Map<const Eigen::VectorXd> v(x.data(), static_cast<Eigen::Index>(x.size()));
  const Eigen::VectorXd slope = both.dense * v - both.right;
  for (int c = 0; c < contacts; ++c)
    for (const double sign : {1.0, -1.0}) {
      const double part = 0.5 * (v[2 * c] + sign * v[2 * c + 1] / mu),
                   rise = slope[2 * c] + sign * mu * slope[2 * c + 1];
      RC_ASSERT(part > -1e-8);
      RC_ASSERT(rise > -1e-7);
      RC_ASSERT(std::abs(part * rise) < 1e-7);
    }
  for (int u = 2 * contacts; u < both.sparse.unknowns(); ++u) RC_ASSERT(std::abs(slope[u]) < 1e-7);
}

TEST(NormalEquations, NumbersBeyondTheRangeAreBadInput) {
  for (const double weight :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e308}) {
    Both both = random_equations(20, 3);
    both.sparse.add_diagonal(4, weight, 1e30);
    EXPECT_THROW(both.sparse.solve(), InputError) << weight;
  }
  EXPECT_THROW(NormalEquations(3).solve(), InputError) << "nothing holds any unknown";
}

}  // namespace
}  // namespace arenite::inference
