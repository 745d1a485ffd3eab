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

/// Largest distance between the volume that passes and F, 0.3 below the sieve of 2, of grains graded 1 to 4.
double distance_by_volume(std::vector<double> radius) {
  std::ranges::sort(radius);
  double all = 0, below = 0, distance = 0;
  for (const double r : radius) all += r * r * r;
  for (const double r : radius) {
    const double d = 2e3 * r;
    below += r * r * r;
    distance = std::max(distance, std::abs(below / all - (d < 2 ? 0.3 * (d - 1) : 0.3 + 0.35 * (d - 2))));
  }
  return distance;
}

/// With w = d^3 the volume of n independent grains strays from F by (1 - F) S(d) - F (S(all) - S(d)), S a Brownian
/// motion of variance E[w^2; below d]/(n E[w]^2) for many grains: beyond 5/sqrt(n E[w]^2/E[w^2]) in fewer than four
/// times 6e-7 of samples (reflection at both ends). Of n grains 1/E[w] is the sum of each class's volume times the mean
/// of 1/d^3, (a + b)/(2 a^2 b^2), and E[w^2]/E[w] that with the mean of d^3, (a + b)(a^2 + b^2)/4.
TEST(SizeCurve, OfSpheresBetweenSievesIsPassedByVolume) {
  SieveCurve sieves;
  sieves.sieves = {1e-3, 2e-3, 4e-3};
  sieves.passing = {0, 0.3, 1};
  const std::vector<Population> graded{{"glass", 100'000, {}, sieves, {}}};
  const auto spheres = draw_spheres(graded, glass, 0, 3);
  const double mean = 1 / (0.3 * 3 / 8 + 0.7 * 6 / 128), square = mean * (0.3 * 3 * 5 / 4 + 0.7 * 6 * 20 / 4);
  EXPECT_LT(distance_by_volume(spheres.radius), 5 / std::sqrt(1e5 * mean * mean / square));
  EXPECT_GT(distance_by_volume(draw_grains(graded, glass, 0, 3).radius), 0.1);  // the plane's: 0.45/2.55 at 2 mm
  EXPECT_EQ(spheres.radius, draw_spheres(graded, glass, 0, 3).radius);
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
