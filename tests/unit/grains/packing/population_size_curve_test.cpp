#include "grains/packing/population.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arenite::packing {
namespace {

const Materials glass{{"glass", 2500, 1e6, 0}};

/// The value that a curve has at a diameter: that of the last point before it.
double at(const SizeCurve& curve, double d) {
  const auto above = std::ranges::upper_bound(curve.diameter, d);
  return above == curve.diameter.begin() ? 0
                                         : curve.passing[static_cast<std::size_t>(above - curve.diameter.begin()) - 1];
}

TEST(SizeCurve, OfTwoSizesIsAStairOfTheirMasses) {
  Grains grains;
  grains.resize(5);
  grains.radius = {2, 1, 1, 1, 1};
  const auto curve = measured_size_curve(grains, glass);
  EXPECT_DOUBLE_EQ(at(curve, 1.99), 0);
  EXPECT_DOUBLE_EQ(at(curve, 3), 0.5);  // four of mass 1 and one of mass 4
  EXPECT_DOUBLE_EQ(at(curve, 4), 1);
  EXPECT_TRUE(std::ranges::is_sorted(curve.passing));
}

TEST(SizeCurve, WeighsMaterialsByTheirDensities) {
  Grains grains;
  grains.resize(2);
  grains.radius = {1, 2};
  grains.material = {1, 0};
  EXPECT_DOUBLE_EQ(at(measured_size_curve(grains, {{"light", 1000, 1, 0}, {"heavy", 4000, 1, 0}}), 2.5), 0.5);
}

TEST(SizeCurve, OfALawIsItsClosedForm) {
  Population uniform{"glass", 300, {}, UniformSizes{1e-3, 3e-3}, {}};
  const auto curve = asked_size_curve({uniform}, glass, 0);
  for (const double d : {1.4e-3, 2e-3, 2.6e-3})
    EXPECT_NEAR(at(curve, d), (std::pow(d, 3) - 1e-9) / (27e-9 - 1e-9), 0.008) << d;
}

TEST(SizeCurve, OfASieveCurveIsTheCurve) {
  SieveCurve sieves;
  sieves.sieves = {1e-3, 2e-3, 4e-3};
  sieves.passing = {0, 0.3, 1};
  const auto curve = asked_size_curve({{"glass", {}, 1.0, sieves, {}}}, glass, 500);
  EXPECT_NEAR(at(curve, 1.5e-3), 0.15, 0.01);
  EXPECT_NEAR(at(curve, 2e-3), 0.3, 0.01);
  EXPECT_NEAR(at(curve, 3e-3), 0.65, 0.01);
}

TEST(SizeCurve, KeepsTheSharesOfPopulations) {
  const std::vector<Population> two{{"glass", 4, {}, FixedSize{1e-3}, {}}, {"glass", 1, {}, FixedSize{2e-3}, {}}};
  EXPECT_NEAR(at(asked_size_curve(two, glass, 0), 1.5e-3), 0.5, 1e-12);
}

TEST(SizeCurve, OfManyGrainsHasFewPoints) {
  Population uniform{"glass", 5000, {}, UniformSizes{1e-3, 3e-3}, {}};
  EXPECT_LE(measured_size_curve(draw_grains({uniform}, glass, 0, 3), glass).diameter.size(), 210u);
  EXPECT_TRUE(measured_size_curve({}, glass).diameter.empty());
}

}  // namespace
}  // namespace arenite::packing
