#include <gtest/gtest.h>

#include <numbers>

#include "draws.hpp"
#include "statistics/q_gaussian.hpp"

namespace arenite::statistics {
namespace {

const std::vector<double> unchanged(36, 1.0);

TEST(QGaussian, DensityIsNormalisedForEveryQ) {
  for (const double q : {-1.0, 0.3, 0.9, 1 - 1e-7, 1.0, 1 + 1e-7, 1.3, 1.6}) {
    double sum = 0;
    const int n = 400000;
    for (int k = 0; k < n; ++k) sum += q_gaussian_density(-200 + 400 * (k + 0.5) / n, 0.7, 2.0, q) * 400 / n;
    EXPECT_NEAR(sum, 1, 2e-4) << q;
  }
}

TEST(QGaussian, HasItsClosedForms) {
  const double x = 0.8;
  EXPECT_NEAR(q_gaussian_density(x, 0, 0.5, 1), std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(q_gaussian_density(x, 0, 1, 2), 1 / (std::numbers::pi * (1 + x * x)), 1e-12);  // Cauchy
  EXPECT_NEAR(q_gaussian_density(x, 0, 1, 0), 0.75 * (1 - x * x), 1e-12);                    // parabola
  EXPECT_EQ(q_gaussian_density(1.1, 0, 1, 0), 0);
  EXPECT_NEAR(q_gaussian_density(x, 0, 0.5, 1 + 2e-6), q_gaussian_density(x, 0, 0.5, 1), 1e-6);
  EXPECT_NEAR(q_gaussian_density(x, 0, 0.5, 1 - 2e-6), q_gaussian_density(x, 0, 0.5, 1), 1e-6);
}

TEST(QGaussian, GivesBackItsParametersWithinTheirErrors) {
  for (const double q : {0.3, 0.8, 1.0, 1.3, 1.7}) {
    const double scale = 0.3, beta = 1 / (3 - q) / (scale * scale);
    int within = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const BlockedSample sample =
          drawn(40000, seed, [&](RandomStream& r) { return 1 + scale * draw_q_gaussian(r, q); });
      const QGaussian fit = fit_q_gaussian(counted(sample), unchanged);
      EXPECT_NEAR(fit.q.value, q, 5 * fit.q.error) << q;
      EXPECT_NEAR(fit.beta.value, beta, 5 * fit.beta.error) << q;
      EXPECT_NEAR(fit.centre.value, 1, 5 * fit.centre.error) << q;
      EXPECT_LT(fit.q.error, 0.15) << q;
      EXPECT_GT(fit.r2, 0.97);
      within += std::abs(fit.q.value - q) < fit.q.error;
    }
    EXPECT_GE(within, 4) << q;  // two thirds of twelve are expected
  }
}

TEST(QGaussian, IsUnknownWhereNothingLikeItIsThere) {
  const BlockedSample same = drawn(1000, 9, [](RandomStream&) { return 1.0; });
  EXPECT_FALSE(std::isfinite(fit_q_gaussian(counted(same), unchanged).q.value));
}

TEST(QGaussian, SameCountsGiveTheSameBits) {
  const BlockCounts counts = counted(drawn(5000, 3, [](RandomStream& r) { return r.normal(); }));
  const QGaussian a = fit_q_gaussian(counts, unchanged), b = fit_q_gaussian(counts, unchanged);
  EXPECT_EQ(a.q.value, b.q.value);
  EXPECT_EQ(a.beta.error, b.beta.error);
}

}  // namespace
}  // namespace arenite::statistics
