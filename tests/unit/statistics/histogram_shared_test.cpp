#include "statistics/histogram.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace arenite::statistics {
namespace {

TEST(Histogram, CountsEachValueInItsBinAndOthersInTheTotal) {
  const auto pdf = histogram({0.26, 0.26, 1.01, 50}, 2);  // 0.52, 0.52, 2.02 and one beyond
  ASSERT_EQ(pdf.density.size(), 140u);
  EXPECT_NEAR(pdf.density[30], 2 / (4 * 0.05), 1e-12);
  EXPECT_NEAR(pdf.density[60], 1 / (4 * 0.05), 1e-12);
  EXPECT_NEAR(std::accumulate(pdf.density.begin(), pdf.density.end(), 0.0) * 0.05, 0.75, 1e-12);
}

TEST(PeakOf, IsTheHighestMeanOfThreeBins) {
  const Bins bins{0, 1, 7};
  // One high bin alone is less than three fairly high ones.
  const Peak peak = peak_of(bins, {0, 0, 8, 0, 5, 6, 5, 0, 0});
  EXPECT_DOUBLE_EQ(peak.at, 4.5);
  EXPECT_DOUBLE_EQ(peak.height, 16.0 / 3 / 24);
}

TEST(PeakOf, NoBinsIsUnknown) { EXPECT_FALSE(peak_of({}, {}).at == peak_of({}, {}).at); }

}  // namespace
}  // namespace arenite::statistics
