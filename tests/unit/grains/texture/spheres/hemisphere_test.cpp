#include "grains/texture/spheres/hemisphere.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"

namespace arenite::texture::spheres {
namespace {

Vec3 random_direction(RandomStream& random) {
  const Vec3 v{random.normal(), random.normal(), random.normal()};
  return (1 / norm(v)) * v;
}

/// Counts of 75 cells of a Poisson scatter about their mean: chi^2 has 74 degrees of freedom and a deviation of 12.
TEST(Hemisphere, CellsAreOfEqualArea) {
  RandomStream random(1, Purpose::test);
  constexpr int count = 75'000;
  std::vector<double> contacts(hemisphere::cells);
  for (int k = 0; k < count; ++k) contacts[hemisphere::cell_of(random_direction(random))] += 1;
  const double mean = static_cast<double>(count) / hemisphere::cells;
  double chi_squared = 0;
  for (const double n : contacts) chi_squared += (n - mean) * (n - mean) / mean;
  EXPECT_NEAR(chi_squared, hemisphere::cells - 1, 4 * std::sqrt(2.0 * (hemisphere::cells - 1)));
}

TEST(Hemisphere, DirectionsHaveNoSenseAndLieInTheirCell) {
  RandomStream random(2, Purpose::test);
  const auto cells = hemisphere::every_cell();
  ASSERT_EQ(cells.size(), static_cast<std::size_t>(hemisphere::cells));
  for (int k = 0; k < 1000; ++k) {
    const Vec3 n = random_direction(random);
    const std::size_t cell = hemisphere::cell_of(n);
    EXPECT_EQ(hemisphere::cell_of(-1 * n), cell);
    const auto [radius, angle] = hemisphere::projected(n);
    EXPECT_GE(radius, cells[cell].inner - 1e-12);
    EXPECT_LE(radius, cells[cell].outer + 1e-12);
    EXPECT_GE(angle, cells[cell].from - 1e-12);
    EXPECT_LE(angle, cells[cell].to + 1e-12);
  }
}

/// Seen from above, x lies to the right, z below, and half way down (60 degrees) is at 1/sqrt(2) of the rim.
TEST(Hemisphere, IsSeenFromAbove) {
  EXPECT_DOUBLE_EQ(hemisphere::projected({0, 1, 0}).radius, 0);
  EXPECT_DOUBLE_EQ(hemisphere::projected({1, 0, 0}).radius, 1);
  EXPECT_DOUBLE_EQ(hemisphere::projected({1, 0, 0}).angle, 0);
  EXPECT_DOUBLE_EQ(hemisphere::projected({0, 0, 1}).angle, 1.5 * std::numbers::pi);
  EXPECT_NEAR(hemisphere::projected({0, 0.5, std::sqrt(0.75)}).radius, std::sqrt(0.5), 1e-15);
}

}  // namespace
}  // namespace arenite::texture::spheres
