#include "grains/packing/bidisperse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "grains/packing/free_space.hpp"
#include "grains/packing/poisson_disk.hpp"
#include "grains/packing/two_classes.hpp"
#include "unit/grains/packing/classes.hpp"

namespace arenite::packing {
namespace {

using std::numbers::pi;

double cut_normal_share_below(double r, const CutNormal& law) {
  const auto normal = [&](double v) { return 0.5 * std::erfc(-(v - law.mean) / law.deviation / std::sqrt(2.0)); };
  return (normal(std::clamp(r, law.low, law.high)) - normal(law.low)) / (normal(law.high) - normal(law.low));
}

/// Kolmogorov-Smirnov statistic times sqrt(n): above 1.63 with probability 0.01 if the radii follow the law.
double kolmogorov(std::vector<double> radii, const CutNormal& law) {
  std::sort(radii.begin(), radii.end());
  const double n = static_cast<double>(radii.size());
  double worst = 0;
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const double share = cut_normal_share_below(radii[k], law);
    worst = std::max({worst, share - static_cast<double>(k) / n, static_cast<double>(k + 1) / n - share});
  }
  return worst * std::sqrt(n);
}

std::vector<double> radii_of(const Packing& p, std::size_t from, std::size_t to) {
  return {p.grains.radius.begin() + static_cast<std::ptrdiff_t>(from),
          p.grains.radius.begin() + static_cast<std::ptrdiff_t>(to)};
}

TEST(CutNormal, FollowsItsLawWholeAndBelowARadius) {
  const CutNormal law{1, 0.25, 0.625, 1.375};
  for (const double below : {1.375, 1.0, 0.7}) {
    RandomStream random(3, Purpose::test);
    std::vector<double> radii(20000);
    for (double& r : radii) r = law.draw(random, below);
    EXPECT_LT(kolmogorov(radii, {1, 0.25, 0.625, below}), 1.63) << below;
  }
  RandomStream random(3, Purpose::test);
  EXPECT_EQ(law.draw(random, 0.5), 0.625);
  EXPECT_EQ((CutNormal{1, 0, 0.5, 2}).draw(random), 1);
}

TEST(Bidisperse, HeldRadiiFollowTheirLawAndRedrawnOnesAreSmaller) {
  for (const bool each : {false, true}) {
    auto p = parameters(2.5, 2.2, 900);
    p.cut_each_class = each;
    const double small = p.large_radius / 2.5;
    const CutNormal law_large{p.large_radius, 0.25 * p.large_radius, 0.625 * (each ? p.large_radius : small),
                              1.375 * p.large_radius};
    const CutNormal law_small{small, 0.25 * small, 0.625 * small, 1.375 * (each ? small : p.large_radius)};
    for (const bool hold : {false, true}) {
      p.hold_radius = hold;
      Packing packing;
      const auto report = sample_bidisperse(packing, p, 11);
      const double large_distance = kolmogorov(radii_of(packing, 0, report.large), law_large);
      const double small_distance = kolmogorov(radii_of(packing, report.large, packing.grains.size()), law_small);
      if (hold) {
        EXPECT_LT(large_distance, 1.63);
        EXPECT_LT(small_distance, 1.63);
      } else {
        EXPECT_GT(large_distance, 3);
        EXPECT_GT(small_distance, 3);
        EXPECT_LT(report.mean_large, 0.96 * p.large_radius);  // P's samples: 0.75 to 0.96
        EXPECT_LT(report.mean_small, 0.96 * small);
      }
    }
  }
}

TEST(Bidisperse, ReachesTheVolumeRatioAskedForAndReportsWhatItIs) {
  const std::pair<double, double> pairs[] = {{5, 6}, {3.33, 2.7}, {2.5, 1.4}, {1.43, 1.6}, {1.11, 2.7}, {1, 6}};
  for (const auto& [gamma, theta] : pairs) {
    Packing packing;
    const auto report = sample_bidisperse(packing, parameters(gamma, theta, 900), 2);
    double area[2] = {0, 0};
    for (std::size_t i = 0; i < packing.grains.size(); ++i)
      area[packing.grains.material[i]] += pi * packing.grains.radius[i] * packing.grains.radius[i];
    EXPECT_NEAR(area[0] / area[1], theta, 0.0101 * theta) << gamma;
    EXPECT_NEAR(report.volume_ratio, area[0] / area[1], 1e-9) << gamma;
    EXPECT_NEAR(report.volume_ratio_error, area[0] / area[1] / theta - 1, 1e-9) << gamma;
    EXPECT_NEAR(report.solid_fraction, (area[0] + area[1]) / packing.domain.area(), 1e-12) << gamma;
    EXPECT_EQ(report.left_out > 0, gamma == 5) << gamma;  // only there no gap is narrow enough
    EXPECT_EQ(report.gap == 0, gamma == 5) << gamma;
  }
}

std::string refusal(const BidisperseParameters& p) {
  Packing packing;
  try {
    sample_bidisperse(packing, p, 1);
  } catch (const InputError& e) {
    EXPECT_EQ(packing.grains.size(), 0u);
    return e.what();
  }
  return "accepted";
}

TEST(Bidisperse, RatiosOutOfReachAreRefusedWithWhatCanBeReached) {
  EXPECT_NE(refusal(parameters(2.5, 0.001)).find("theta of 0.001 is out of reach"), std::string::npos);
  EXPECT_NE(refusal(parameters(2.5, 0.001)).find("gives 0.1"), std::string::npos);
  EXPECT_NE(refusal(parameters(2, 1e6)).find("theta of 1e+06 is out of reach"), std::string::npos);
  EXPECT_NE(refusal(parameters(0.8, 2)).find("gamma is 0.8; in this box it can be from 1 to 115"), std::string::npos);
  EXPECT_NE(refusal(parameters(1000, 2)).find("from 1 to 115"), std::string::npos);
}

TEST(Bidisperse, EveryBadParameterIsNamedAtOnce) {
  BidisperseParameters p;
  p.large_radius = NAN;
  p.deviation = 1;
  p.trials = 0;
  p.tolerance = 0;
  p.box_area = 3;
  p.volume_ratio = -1;
  p.size_ratio = 0;
  Packing packing;
  try {
    sample_bidisperse(packing, p, 1);
    FAIL() << "accepted";
  } catch (const InputError& e) { EXPECT_EQ(e.problems().size(), 7u); }
}

}  // namespace
}  // namespace arenite::packing
