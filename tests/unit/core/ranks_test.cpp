#include "core/ranks.hpp"

#include <gtest/gtest.h>

namespace arenite {
namespace {

TEST(Ranks, AreThoseOfTheSortedValues) {
  const std::vector<double> values{5, -1, 3, 3, 8, 0, 3};  // -1 0 3 3 3 5 8
  const double sorted[] = {-1, 0, 3, 3, 3, 5, 8};
  for (std::size_t rank = 0; rank < values.size(); ++rank) EXPECT_EQ(of_rank(values, rank), sorted[rank]);
  EXPECT_EQ(at_share(values, 0), -1);
  EXPECT_EQ(at_share(values, 0.3), 0);  // rank 1.8
  EXPECT_EQ(at_share(values, 0.9), 5);  // rank 5.4
  EXPECT_EQ(at_share(values, 1), 8);
}

}  // namespace
}  // namespace arenite
