#include "statistics/sectors.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace arenite::statistics {
namespace {

TEST(Sectors, EvenCountsAreOneEverywhere) {
  EXPECT_EQ(over_isotropic({5, 5, 5, 5}, 20), (std::vector<double>{1, 1, 1, 1}));
  EXPECT_EQ(over_isotropic({8, 2}, 20), (std::vector<double>{0.8, 0.2}));  // half of the directions are elsewhere
}

TEST(Sectors, SecondOrderIsLargestAlongItsDirectionAndOneInTheMean) {
  const std::vector<double> values = second_order_distribution(0.3, 30, 18);  // every 10 degrees
  EXPECT_NEAR(values[3], 1.3, 1e-12);
  EXPECT_NEAR(values[12], 0.7, 1e-12);
  EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0) / 18, 1, 1e-12);
}

}  // namespace
}  // namespace arenite::statistics
