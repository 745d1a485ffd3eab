#include "statistics/jackknife.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace arenite::statistics;

TEST(Jackknife, AnErrorIsUnknownWhereABlockLeftOutLeavesNoValue) {
  const auto found = with_errors({1.0, 2.0}, {{1.1, unknown}, {0.9, 2.1}, {1.0, 1.9}});
  EXPECT_NEAR(found[0].error, std::sqrt(2.0 / 3 * 0.02), 1e-12);
  EXPECT_TRUE(std::isnan(found[1].error)) << found[1].error;
  EXPECT_TRUE(std::isnan(with_errors({1.0}, {{1.0}})[0].error));
}

}  // namespace
