#include <gtest/gtest.h>

#include <numbers>

#include "grains/texture/texture.hpp"
#include "model/shapes.hpp"
#include "support/numbers_of.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;

const Shape rod{{{-1, 0}, {1, 0}}, {0.5, 0.5}, false};
const Shape square{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, {0.1, 0.1, 0.1, 0.1}, true};

/// Grains of one shape side by side, turned by these angles.
Packing turned_by(const std::vector<double>& angles, const Shape& shape) {
  Packing p = test::empty_box(3 * static_cast<double>(angles.size()), 3);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    test::add_grain(p, {3 * static_cast<double>(k) + 1.5, 1.5}, 1);
    add_shape(p.grains.shapes, shape, 1);
    p.grains.angle.back() = angles[k];
  }
  return p;
}

using test::value_of;

Numbers axes_of(const std::vector<double>& angles, const Shape& shape = rod) {
  return measure(turned_by(angles, shape)).numbers.value("long_axes", Numbers());
}

TEST(LongAxes, OfGrainsThatLieAlikeAreFullyOrderedWhicheverEndIsAhead) {
  std::vector<double> angles(40, 150 * degree);
  for (std::size_t k = 0; k < angles.size(); k += 3) angles[k] -= pi;
  for (std::size_t k = 0; k < angles.size(); k += 7) angles[k] += 4 * pi;
  const Numbers axes = axes_of(angles);
  EXPECT_EQ(value_of(axes, "grains"), 40);
  EXPECT_NEAR(value_of(axes, "order"), 1, 1e-12);
  EXPECT_NEAR(value_of(axes, "direction_deg"), 150, 1e-9);
}

TEST(LongAxes, HaveTheModulusAndPhaseOfTheirMean) {
  std::vector<double> angles;
  for (int k = 0; k < 10; ++k) angles.insert(angles.end(), {20 * degree, 20 * degree, 20 * degree, 110 * degree});
  const Numbers three_to_one = axes_of(angles);
  EXPECT_NEAR(value_of(three_to_one, "order"), 0.5, 1e-12);  // (3 - 1)/4
  EXPECT_NEAR(value_of(three_to_one, "direction_deg"), 20, 1e-9);
  EXPECT_GT(test::error_of(three_to_one, "order"), 0);
  std::vector<double> fan;  // evenly over 60 degrees about 90: <cos 2x> from -30 to 30 degrees
  for (int k = 0; k < 400; ++k) fan.push_back((90 + 60 * ((k + 0.5) / 400 - 0.5)) * degree);
  EXPECT_NEAR(value_of(axes_of(fan), "order"), std::sin(pi / 3) / (pi / 3), 1e-5);
  EXPECT_NEAR(value_of(axes_of(fan), "direction_deg"), 90, 1e-9);
}

TEST(LongAxes, OfRandomGrainsAreOrderedByNoMoreThanTheNoiseSays) {
  const int trials = 200;
  double mean = 0;
  RandomStream random(3, Purpose::test);
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> angles(60);
    for (double& angle : angles) angle = random.uniform(0, pi);
    const Numbers axes = axes_of(angles);
    mean += value_of(axes, "order") / value_of(axes, "noise") / trials;
  }
  EXPECT_NEAR(mean, 1, 4 * 0.523 / std::sqrt(trials));  // Rayleigh's: deviation over mean sqrt(4/pi - 1)
}

TEST(LongAxes, AreOfGrainsThatHaveOne) {
  EXPECT_FALSE(axes_of({0, 1, 2}, square).is_known());
  Packing mixed = turned_by({0.5, 0.5}, rod);
  mixed.grains.shapes = {};
  add_shape(mixed.grains.shapes, rod, 1);
  add_shape(mixed.grains.shapes, {{{0, 0}}, {1}, false}, 1);
  EXPECT_EQ(value_of(measure(mixed).numbers, "long_axes/grains"), 1);
  mixed.grains.shapes = {};
  EXPECT_FALSE(measure(mixed).numbers.contains("long_axes"));
}

}  // namespace
}  // namespace arenite::texture
