#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "core/error.hpp"
#include "grains/packing/bidisperse.hpp"
#include "grains/packing/free_space.hpp"
#include "grains/packing/poisson_disk.hpp"
#include "unit/grains/packing/classes.hpp"

namespace arenite::packing {
namespace {

constexpr double ball_volume = 4 * std::numbers::pi / 3;

PackingIn<3> sides_in_space(bool periodic_x, bool periodic_y, bool periodic_z) {
  PackingIn<3> packing;
  packing.domain.periodic = {periodic_x, periodic_y, periodic_z};
  return packing;
}

/// The smallest gap between the surfaces of the first spheres, so many, by comparing all with all.
double smallest_gap(const PackingIn<3>& p, std::size_t count) {
  double least = INFINITY;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, norm(p.domain.nearest_image(p.grains.position[i] - p.grains.position[j])) -
                                  p.grains.radius[i] - p.grains.radius[j]);
  return least;
}

double smallest_gap_to_a_wall(const PackingIn<3>& p) {
  double least = INFINITY;
  for (std::size_t i = 0; i < p.grains.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const double r = p.grains.radius[i], at = p.grains.position[i][axis];
      if (p.domain.wall[2 * axis].present) least = std::min({least, at - r, p.domain.extent(axis) - at - r});
    }
  return least;
}

class SidesInSpace : public testing::TestWithParam<std::tuple<bool, bool, bool>> {};

TEST_P(SidesInSpace, NoSpheresOverlapAndLargeOnesKeepTheGap) {
  const auto [periodic_x, periodic_y, periodic_z] = GetParam();
  PackingIn<3> packing = sides_in_space(periodic_x, periodic_y, periodic_z);
  const auto p = parameters(2, 1.4, 100);
  const auto report = sample_bidisperse(packing, p, 7);
  ASSERT_EQ(report.large + report.small, packing.grains.size());
  EXPECT_GT(report.gap, 0.1 * p.large_radius);
  EXPECT_GE(smallest_gap(packing, packing.grains.size()), -1e-12 * p.large_radius);
  EXPECT_GE(smallest_gap_to_a_wall(packing), 0);
  // Each stands beside another, no farther off than the gap asks.
  EXPECT_NEAR(smallest_gap(packing, report.large), report.gap, 1e-9 * p.large_radius);
  for (std::size_t i = 0; i < packing.grains.size(); ++i)
    EXPECT_EQ(packing.grains.material[i], i < report.large ? 0 : 1);
  EXPECT_NEAR(volume_of(packing.domain), 100 * ball_volume * 1e-9, 1e-18);
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(packing.domain.wall[2 * axis].present, !packing.domain.periodic[axis]);
}

INSTANTIATE_TEST_SUITE_P(Bidisperse, SidesInSpace,
                         testing::Values(std::tuple{false, false, false}, std::tuple{true, false, true},
                                         std::tuple{false, true, false}, std::tuple{true, true, true}));

TEST(BidisperseSpheres, TheVolumeRatioAskedForIsReachedAndTold) {
  const std::pair<double, double> pairs[] = {{3, 4}, {2, 1.4}, {1, 1.4}, {1, 4}};
  for (const auto& [gamma, theta] : pairs) {
    PackingIn<3> packing = sides_in_space(true, true, true);
    const auto report = sample_bidisperse(packing, parameters(gamma, theta, 400), 2);
    std::array<double, 2> volume{};
    for (std::size_t i = 0; i < packing.grains.size(); ++i)
      volume[packing.grains.material[i] == 0 ? 0 : 1] += ball_volume * std::pow(packing.grains.radius[i], 3);
    const double reached = volume[0] / volume[1];
    EXPECT_NEAR(reached, theta, 0.0101 * theta) << gamma;
    EXPECT_NEAR(report.volume_ratio, reached, 1e-9) << gamma;
    EXPECT_NEAR(report.volume_ratio_error, reached / theta - 1, 1e-9) << gamma;
    EXPECT_NEAR(report.solid_fraction, (volume[0] + volume[1]) / volume_of(packing.domain), 1e-12) << gamma;
  }
}

// Equal spheres thrown blindly, each kept where it fits, come to rest at a solid fraction of 0.3841 (M. Ciesla and P.
// Kubala, J. Chem. Phys. 148, 024501, 2018), from which they are off by c t^(-1/3) after t throws a sphere's volume:
// with eight times as many by half of that.
TEST(FreeSpaceOfSpheres, SpheresThrownBlindlySaturateWhereRandomSequentialAdditionDoes) {
  constexpr double side = 30, volume = side * side * side;
  FreeSpace<3> space({{}, {side, side, side}, {true, true, true}}, 0);
  space.open_store(2);
  RandomStream random(3, Purpose::test);
  const auto throw_until = [&](double& thrown, double most) {
    for (; thrown * ball_volume / volume < most; ++thrown) {
      const double x = random.uniform(0, side), y = random.uniform(0, side), z = random.uniform(0, side);
      if (const Ball<3> one{{x, y, z}, 1}; space.fits(one)) space.add(one);
    }
    return static_cast<double>(space.balls().size()) * ball_volume / volume;
  };
  double thrown = 0;
  const double early = throw_until(thrown, 80), late = throw_until(thrown, 640);
  // Of some 2300 spheres that scatters by 0.004 between samplings (six of them), and is 0.004 short at these times:
  // this and two and a half scatters.
  EXPECT_NEAR(2 * late - early, 0.3841, 0.014);

  // Beside one another they lie closer, and no place in which one fits is left to a blind throw in a thousand.
  FreeSpace<3> beside({{}, {side, side, side}, {true, true, true}}, 0);
  beside.open_store(2);
  fill_redrawing(beside, CutNormal{1, 0, 1, 1}, 300, random);
  EXPECT_GT(static_cast<double>(beside.balls().size()) * ball_volume / volume, 0.40);
  int room = 0;
  for (int k = 0; k < 20000; ++k) {
    const double x = random.uniform(0, side), y = random.uniform(0, side), z = random.uniform(0, side);
    room += beside.fits({{x, y, z}, 1});
  }
  EXPECT_LT(room, 20);
}

TEST(FreeSpaceOfSpheres, NeighboursStandInEveryDirectionAlike) {
  constexpr double side = 30;
  FreeSpace<3> space({{}, {side, side, side}, {true, true, true}}, 0);
  space.open_store(2);
  RandomStream random(5, Purpose::test);
  fill_redrawing(space, CutNormal{1, 0, 1, 1}, 30, random);
  Vec3 squares{};
  double touching = 0;
  const auto& balls = space.balls();
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 d = space.box().nearest_image(balls[i].centre - balls[j].centre);
      if (norm(d) > 2 * (1 + 1e-9)) continue;
      squares += (1 / dot(d, d)) * Vec3{d.x * d.x, d.y * d.y, d.z * d.z};
      ++touching;
    }
  EXPECT_EQ(touching, static_cast<double>(balls.size()) - 1) << "each but the first touches the one it was put beside";
  // Squares of the cosines of random directions have the mean 1/3 and the variance 4/45.
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(squares[axis] / touching, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / touching)) << axis;
}

TEST(BidisperseSpheres, SameSeedSameBytesAndAnotherSeedAnotherSample) {
  PackingIn<3> a, b, c;
  const auto p = parameters(2, 2.2, 100);
  sample_bidisperse(a, p, 4);
  sample_bidisperse(b, p, 4);
  sample_bidisperse(c, p, 5);
  EXPECT_EQ(a.grains.position, b.grains.position);
  EXPECT_EQ(a.grains.radius, b.grains.radius);
  EXPECT_NE(a.grains.position, c.grains.position);
}

std::string refusal_in_space(const BidisperseParameters& p) {
  PackingIn<3> packing;
  try {
    sample_bidisperse(packing, p, 1);
  } catch (const InputError& e) {
    EXPECT_EQ(packing.grains.size(), 0u);
    return e.what();
  }
  return "accepted";
}

TEST(BidisperseSpheres, WhatSpaceDoesNotHaveAndRatiosOutOfReachAreRefused) {
  auto p = parameters(2, 1.4);
  p.maximal = true;
  EXPECT_NE(refusal_in_space(p).find("hold_radius and maximal find places on the arcs of circles"), std::string::npos);
  EXPECT_NE(refusal_in_space(parameters(2, 0.001)).find("theta of 0.001 is out of reach"), std::string::npos);
  // 2e6 small spheres at most: (2e6/150)^(1/3).
  EXPECT_NE(refusal_in_space(parameters(30, 2)).find("gamma is 30; in this box it can be from 1 to 23"),
            std::string::npos);
}

}  // namespace
}  // namespace arenite::packing
