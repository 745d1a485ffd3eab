#include "solid/grid/rasterise_spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace arenite::grid {
namespace {

constexpr double pi = std::numbers::pi;

SpherePack two_spheres(double apart, double a, double b) {
  SpherePack pack;
  pack.centre = {{-apart / 2, 0, 0}, {apart / 2, 0, 0}};
  pack.radius = {a, b};
  pack.label = {0, 1};
  pack.low = {-2, -2, -2};
  pack.high = {2, 2, 2};
  return pack;
}

double volume_of(const VoxelMap& map, Phase phase) {
  return static_cast<double>(std::ranges::count(map.phase, phase)) * map.dx * map.dx * map.dx;
}

TEST(RasteriseSpheres, VolumesComeOutAndOverlapsAreParted) {
  const VoxelMap map = rasterise_spheres(two_spheres(1.2, 0.8, 0.8), {}, 200);
  // Two spheres of radius r less their lens: pi (2 r - d)^2 (d + 4 r)/12.
  const double r = 0.8, d = 1.2, lens = pi * (2 * r - d) * (2 * r - d) * (d + 4 * r) / 12;
  EXPECT_NEAR(volume_of(map, Phase::particle), 2 * 4 * pi / 3 * r * r * r - lens, 2e-3);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const auto k = map.index(x, y, 100);
      EXPECT_TRUE(map.grain[k] < 0 || map.grain[k] == (x < 100 ? 0 : 1)) << x << " " << y;
    }
}

TEST(RasteriseSpheres, ABridgeHasTheVolumeOfItsCylinder) {
  // Of equal spheres a bridge is a cylinder of radius a less what the spheres hold of it, each
  // 2 pi/3 (r^3 - (r^2 - a^2)^(3/2)).
  constexpr double r = 0.8, d = 1.65, width = 0.5, a = width * r;
  cement::CementParameters parameters;
  parameters.width = width;
  parameters.gap = 0.1;
  double used = 0;
  const VoxelMap map = cemented_voxels(two_spheres(d, r, r), parameters, 240, used);
  const double held = 2 * pi / 3 * (r * r * r - std::pow(r * r - a * a, 1.5));
  EXPECT_NEAR(volume_of(map, Phase::matrix) / (pi * a * a * d - 2 * held), 1, 0.01);
  EXPECT_EQ(used, width);
  parameters.gap = 0.04;  // the gap is 0.05
  EXPECT_EQ(volume_of(cemented_voxels(two_spheres(d, r, r), parameters, 60, used), Phase::matrix), 0);
}

TEST(RasteriseSpheres, CementBelowAVoxelIsDoubted) {
  double used = 0;
  cement::CementParameters thin;
  thin.width = 0.02, thin.gap = 0.1;
  const SpherePack pack = two_spheres(2, 1, 1);
  EXPECT_FALSE(doubt_about_cement(thin, cemented_voxels(pack, thin, 12, used)).empty());
  cement::CementParameters none = thin, wide = thin;
  none.kind = cement::CementParameters::Kind::none;
  wide.width = 0.8;
  EXPECT_TRUE(doubt_about_cement(none, cemented_voxels(pack, none, 12, used)).empty());
  EXPECT_TRUE(doubt_about_cement(wide, cemented_voxels(pack, wide, 40, used)).empty());
}

TEST(RasteriseSpheres, ACoatingIsAShell) {
  cement::CementParameters parameters;
  parameters.kind = cement::CementParameters::Kind::coating;
  parameters.thickness = 0.1;
  SpherePack one = two_spheres(0, 1, 1);
  one.centre.pop_back(), one.radius.pop_back(), one.label.pop_back();
  double used = 0;
  const VoxelMap map = cemented_voxels(one, parameters, 200, used);
  EXPECT_NEAR(volume_of(map, Phase::matrix), 4 * pi / 3 * (1.331 - 1), 5e-3);
}

TEST(RasteriseSpheres, ASaturationIsMet) {
  using Kind = cement::CementParameters::Kind;
  for (const auto kind : {Kind::bridges, Kind::coating, Kind::menisci}) {
    cement::CementParameters parameters;
    parameters.kind = kind;
    parameters.gap = 0.3;
    parameters.saturation = 0.005;
    double used = 0;
    const VoxelMap map = cemented_voxels(two_spheres(1.7, 0.8, 0.8), parameters, 120, used);
    EXPECT_NEAR(saturation_of(map), 0.005, 2e-4);
    EXPECT_GT(used, 0);
    parameters.saturation = 0.999;
    EXPECT_THROW(cemented_voxels(two_spheres(1.7, 0.8, 0.8), parameters, 40, used), InputError);
  }
}

TEST(RasteriseSpheres, APeriodMayBeginAnywhere) {
  // A sphere that reaches over an edge of the box, with a neighbour beyond a face: the same voxels, moved on.
  const auto pack = [](double shift) {
    SpherePack p;
    p.low = {0, 0, 0};
    p.high = {1, 1, 1};
    p.periodic = true;
    p.label = {0, 1};
    p.radius = {0.3, 0.2};
    for (const Vec3 centre : {Vec3{0.1, 0.05, 0.5}, Vec3{0.6, 0.05, 0.5}}) {
      Vec3 moved = centre + Vec3{shift, shift, shift};
      for (int axis = 0; axis < 3; ++axis) moved[axis] -= std::floor(moved[axis]);
      p.centre.push_back(moved);
    }
    return p;
  };
  cement::CementParameters parameters;
  parameters.gap = 0.05;
  double used = 0;
  constexpr int n = 40, moved = 13;
  const VoxelMap here = cemented_voxels(pack(0), parameters, n, used),
                 there = cemented_voxels(pack(moved / double{n}), parameters, n, used);
  EXPECT_GT(volume_of(here, Phase::matrix), 0);
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const auto a = here.index(x, y, z), b = there.index((x + moved) % n, (y + moved) % n, (z + moved) % n);
        ASSERT_EQ(here.phase[a], there.phase[b]) << x << " " << y << " " << z;
        ASSERT_EQ(here.grain[a], there.grain[b]);
      }
}

TEST(RasteriseSpheres, WhatFitsNoVoxelsIsRefused) {
  SpherePack pack = two_spheres(1, 0.4, 0.4);
  pack.periodic = true;
  pack.high.x = 2.03;
  EXPECT_THROW(rasterise_spheres(pack, {}, 50), InputError);
  EXPECT_THROW(rasterise_spheres({}, {}, 50), InputError);
}

TEST(RasteriseSpheres, AMeniscusHasTheVolumeOfItsTurnedSection) {
  // Of equal spheres with filling angle b, contact angle t and half gap s: an arc of radius R = (s + r (1 - cos b)) /
  // cos(b + t) about a point r sin b + R sin(b + t) above the middle. Volumes by slices across the line of centres.
  constexpr double r = 0.8, gap = 0.04, t = 0.35, width = 0.55;
  const double b = std::asin(width), arc = (gap / 2 + r * (1 - std::cos(b))) / std::cos(b + t);
  const double centre = r * width + arc * std::sin(b + t), end = r + gap / 2 - r * std::cos(b);
  double volume = 0;
  constexpr int slices = 4000;
  for (int k = 0; k < slices; ++k) {
    const double x = end * (k + 0.5) / slices, from_centre = r + gap / 2 - x;
    const double rim = centre - std::sqrt(arc * arc - x * x);
    volume += 2 * pi * end / slices * (rim * rim - std::max(0.0, r * r - from_centre * from_centre));
  }
  cement::CementParameters parameters;
  parameters.kind = cement::CementParameters::Kind::menisci;
  parameters.width = width;
  parameters.contact_angle = t;
  double used = 0;
  const VoxelMap map = cemented_voxels(two_spheres(2 * r + gap, r, r), parameters, 240, used);
  EXPECT_NEAR(volume_of(map, Phase::matrix) / volume, 1, 0.01);
  parameters.contact_angle = 0;  // a wetting liquid is drawn in more deeply
  EXPECT_LT(volume_of(cemented_voxels(two_spheres(2 * r + gap, r, r), parameters, 240, used), Phase::matrix),
            0.95 * volume);
}

TEST(RasteriseSpheres, ABoxIsCutOut) {
  SpherePack pack = two_spheres(1.2, 0.8, 0.8);
  const VoxelMap all = rasterise_spheres(pack, {}, 80);  // of 0.05
  cut_out(pack, {-1.5, -0.5, -0.5, 0.5, 0.5, 1});
  const VoxelMap part = rasterise_spheres(pack, {}, 40);
  ASSERT_EQ((std::array{part.width, part.height, part.depth}), (std::array{40, 20, 30}));
  for (int z = 0; z < 30; ++z)
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 40; ++x)
        ASSERT_EQ(part.grain[part.index(x, y, z)], all.grain[all.index(x + 10, y + 30, z + 30)]);
  EXPECT_THROW(cut_out(pack, {1.9, 1.9, 1.9, 2, 2, 2}), InputError);
  pack.periodic = true;
  EXPECT_THROW(cut_out(pack, {-1, -1, -1, 1, 1, 1}), InputError);
}

}  // namespace
}  // namespace arenite::grid
