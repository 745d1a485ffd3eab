#include "statistics/histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "draws.hpp"

namespace arenite::statistics {
namespace {

TEST(BlockedSample, CountsAreThoseOfASearchInEveryBlock) {
  const BlockedSample sample = drawn(
      5000, 1, [](RandomStream& r) { return r.normal(); }, 7);
  const Bins bins{-1.5, 0.25, 10};
  const BlockCounts counts = count(sample, bins);
  for (std::size_t b = 0; b < 7; ++b) {
    Counts expected(bins.count + 2, 0);
    for (std::size_t i = 0; i < sample.x.size(); ++i) {
      if (sample.block[i] != b) continue;
      expected.front() += sample.x[i] < bins.edge(0);
      expected.back() += sample.x[i] >= bins.edge(10);
      for (std::size_t k = 0; k < bins.count; ++k)
        expected[k + 1] += sample.x[i] >= bins.edge(k) && sample.x[i] < bins.edge(k + 1);
    }
    EXPECT_EQ(counts.block[b], expected);
  }
  EXPECT_EQ(total(counts.all), 5000);
  EXPECT_EQ(total(counts.without(3)), 5000 - total(counts.block[3]));
}

TEST(BlockedSample, BinsReachTheExtremesUnlessTheseLieFarOut) {
  const Bins near = pdf_bins(1000000, {-1, 0, 0.5, 1.5, 2, 3});
  EXPECT_DOUBLE_EQ(near.width, 0.01);
  EXPECT_LE(near.edge(0), -1 + 1e-9);
  EXPECT_GE(near.edge(near.count), 3 - 1e-9);
  const Bins far = pdf_bins(1000000, {-1e6, 0, 0.5, 1.5, 2, 1e6});
  EXPECT_NEAR(far.edge(0), -4, 0.011);
  EXPECT_NEAR(far.edge(far.count), 6, 0.011);
  EXPECT_DOUBLE_EQ(pdf_bins(1000000, {-100, -50, -0.5, 0.5, 50, 100}).width, 0.1);  // a thousandth of low to high
  EXPECT_DOUBLE_EQ(pdf_bins(1000000, {-4, -3, -0.1, 0.1, 3, 4}).width, 0.006);
  EXPECT_DOUBLE_EQ(pdf_bins(1000000, {-4, -3, 0, 0, 3, 4}).width, 0.03);
  EXPECT_EQ(pdf_bins(1000, {2, 2, 2, 2, 2, 2}).count, 0u);
}

TEST(BlockedSample, PdfHoldsAllValuesAndItsErrorIsThatOfCounting) {
  const BlockedSample sample = drawn(200000, 2, [](RandomStream& r) { return r.uniform(); });
  const BlockCounts counts = counted(sample);
  const Curve curve = pdf(counts);
  const double sum = std::accumulate(curve.y.begin(), curve.y.end(), 0.0) * counts.bins.width;
  EXPECT_NEAR(sum, 1, 1e-12);
  double error = 0;
  const double inner = static_cast<double>(curve.x.size() - 4);
  for (std::size_t k = 2; k + 2 < curve.x.size(); ++k) {
    EXPECT_NEAR(curve.y[k], 1, 6 * curve.error[k]);
    error += curve.error[k] / inner;
  }
  EXPECT_NEAR(error, 1 / std::sqrt(200000 * counts.bins.width), 0.1 * error);
}

TEST(BlockedSample, QuantilesByRankAreThoseOfTheSortedValues) {
  const BlockedSample sample = drawn(3001, 3, [](RandomStream& r) { return r.normal(); });
  std::vector<double> sorted = sample.x;
  std::sort(sorted.begin(), sorted.end());
  const auto q = exact_quantiles(sample.x, {0, 0.1, 0.1, 0.5, 0.999, 1});
  EXPECT_EQ(q, (std::vector<double>{sorted[0], sorted[300], sorted[300], sorted[1500], sorted[2997], sorted[3000]}));
}

TEST(BlockedSample, QuantileAndShareInBinsAreEachOthersInverse) {
  const BlockCounts counts = counted(drawn(20000, 4, [](RandomStream& r) { return r.normal(); }));
  for (const double p : {0.01, 0.3, 0.5, 0.9, 0.995})
    EXPECT_NEAR(survival(counts.bins, counts.all, quantile(counts.bins, counts.all, p)), 1 - p, 1e-9);
}

}  // namespace
}  // namespace arenite::statistics
