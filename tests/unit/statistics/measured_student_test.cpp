#include "statistics/measured.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {
using namespace arenite::statistics;

TEST(Student, SharesHaveTheirClosedForms) {
  for (const double t : {-3.0, -0.4, 0.0, 0.7, 2.5, 40.0}) {
    EXPECT_NEAR(student_share(t, 1), 0.5 + std::atan(t) / std::numbers::pi, 1e-14);
    EXPECT_NEAR(student_share(t, 2), 0.5 + t / (2 * std::sqrt(2 + t * t)), 1e-14);
    const double angle = std::atan(t / std::numbers::sqrt3);
    EXPECT_NEAR(student_share(t, 3), 0.5 + (angle + std::sin(angle) * std::cos(angle)) / std::numbers::pi, 1e-14);
  }
}

TEST(Student, QuantilesTurnSharesRound) {
  EXPECT_NEAR(student_quantile(0.975, 1), std::tan(0.475 * std::numbers::pi), 1e-11);
  EXPECT_NEAR(student_quantile(0.975, 2), 0.95 * std::sqrt(2 / (1 - 0.95 * 0.95)), 1e-12);
  EXPECT_NEAR(student_quantile(0.975, std::numeric_limits<double>::infinity()), 1.959963984540054, 1e-12);
  for (const double freedom : {0.5, 1.7, 4.0, 17.0, 333.3, 1e6})
    for (const double p : {0.001, 0.3, 0.5, 0.9, 0.9995})
      EXPECT_NEAR(student_share(student_quantile(p, freedom), freedom), p, 1e-10) << freedom << " " << p;
}

TEST(Student, ManyDegreesOfFreedomAreNormal) { EXPECT_NEAR(student_share(1.3, 1e6), student_share(1.3, 1e8), 1e-6); }

TEST(Student, FishersShareHasItsClosedForm) {
  for (const double f : {0.0, 0.3, 2.4, 17.0})
    for (const double d : {3.0, 15.0}) EXPECT_NEAR(fisher_survival(f, 2, d), std::pow(1 + 2 * f / d, -d / 2), 1e-13);
  EXPECT_NEAR(fisher_survival(6.25, 1, 7), 2 * (1 - student_share(2.5, 7)), 1e-13);  // F with 1 degree is t squared
}

}  // namespace
