#include "grains/texture/force_level.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

/// A lattice of contacts whose forces are exponential with mean 1: exp(-1) of them are above it.
Packing lattice(std::uint64_t seed) {
  Packing p = test::empty_box(41, 41);
  RandomStream random(seed, Purpose::test);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) test::add_grain(p, {x + 1.0, y + 1.0}, 0.501);
  for (std::size_t g = 0; g < 1600; ++g)
    if (g % 40 != 39) test::add_contact(p, g, g + 1, -std::log(1 - random.uniform()));
  test::add_wall_contact(p, 0, left, 1e6);
  return p;
}

TEST(ForceLevel, OfExponentialForcesTheErrorsCoverTheScatterOverSeeds) {
  constexpr int seeds = 40;
  double mean = 0, above = 0, chi2 = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const ForceLevel level = force_level(lattice(static_cast<std::uint64_t>(seed)));
    EXPECT_EQ(level.contacts, 1560u);  // walls are no grains
    mean += level.mean.value / seeds, above += level.above_mean.value / seeds;
    chi2 += std::pow((level.mean.value - 1) / level.mean.error, 2) / seeds;
  }
  EXPECT_NEAR(mean, 1, 4 / std::sqrt(1560.0 * seeds));
  EXPECT_NEAR(above, std::exp(-1.0), 4 * 0.5 / std::sqrt(1560.0 * seeds));
  // Student's t^2 with 35 blocks' freedom has mean 35/33 and, over 40 seeds, a standard error of about 0.24
  EXPECT_NEAR(chi2, 35.0 / 33, 4 * 0.24);
}

TEST(ForceLevel, WhatIsNotKnownOfTheNumberOfContactsCountsAsOnesThatCarryNothing) {
  const Packing p = lattice(3);
  const ForceLevel sure = force_level(p), unsure = force_level(p, 78);  // a twentieth of the contacts
  EXPECT_EQ(unsure.mean.value, sure.mean.value);
  EXPECT_NEAR(unsure.mean.error, std::hypot(sure.mean.error, 0.05 * sure.mean.value), 1e-12);
  Packing single = test::empty_box(4, 4);
  test::add_grain(single, {1, 2}, 0.5), test::add_grain(single, {2, 2}, 0.5);
  test::add_contact(single, 0, 1, 5);
  EXPECT_EQ(force_level(single).contacts, 1u);
  EXPECT_TRUE(std::isnan(force_level(single).mean.value));
}

}  // namespace
}  // namespace arenite::texture
