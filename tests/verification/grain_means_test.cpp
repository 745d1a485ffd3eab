#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "model/elasticity/disk_field.hpp"
#include "thermal/thermography/grains/grain_means.hpp"

namespace arenite::thermography {
namespace {

PictureGrains one_grain(double x, double y, double radius) {
  PictureGrains g;
  g.centre = {{x, y}};
  g.radius = {radius};
  g.position_error = {0};
  g.material = {0};
  return g;
}

/// A map whose pixels are means of a harmonic field over their squares: value + a x + b y + c (x^2 - y^2) + d x y about
/// (x0, y0). Outside of radius 1.2 R there is something else.
LockinMaps harmonic(double value, double x0, double y0, double radius, double a = 3, double b = -2, double c = 0.4,
                    double d = 0.7) {
  LockinMaps maps;
  maps.width = 40;
  maps.height = 30;
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 40; ++column) {
      const double x = column - x0, y = row - y0;
      maps.in_phase.push_back(static_cast<float>(
          std::hypot(x, y) < 1.2 * radius ? value + a * x + b * y + c * (x * x - y * y) + d * x * y : 1e3));
    }
  maps.mean.resize(maps.in_phase.size());
  maps.standard_error.assign(maps.in_phase.size(), 0.01f);
  return maps;
}

GrainMeanOptions share(double s, double factor = 0.015e-6) {
  GrainMeanOptions o;
  o.share = s;
  o.factor = {factor};
  return o;
}

TEST(GrainMeans, AnyConcentricDiskHasTheGrainsMean) {
  for (const double s : {0.2, 0.5, 0.8})
    for (const double at : {0.0, 0.31, 0.5}) {
      const LockinMaps maps = harmonic(0.05, 18 + at, 14 - at / 3, 6.3);
      const PeakToPeak found = grain_means(maps, one_grain(18 + at, 14 - at / 3, 6.3), share(s));
      // pixels on the rim of the disk are taken as a whole, with the part of them that it covers
      EXPECT_NEAR(found.temperature[0] / 2, 0.05, 0.06) << s << " " << at;
      EXPECT_NEAR(found.pixels[0], s * 3.14159265 * 6.3 * 6.3, 1e-6);
    }
}

/// The disk of T under two opposite loads P over radius R and length L: mean sigma_kk = -2 P/(pi R L).
TEST(GrainMeans, DiskUnderContactForcesHasItsMeanStress) {
  const double radius = 5e-3, pixel = 1.0e-3, length = 0.06, factor = 0.015e-6;
  elasticity::Disk disk;
  disk.radius = radius;
  disk.length = length;
  disk.forces = {{{1, 0}, 900, 0, 0}, {{-1, 0}, 900, 0, 0}, {{0.6, 0.8}, 500, 100, 0}, {{-0.6, -0.8}, 500, 100, 0}};
  double worst = 0;
  for (int draw = 0; draw < 20; ++draw) {
    RandomStream random(static_cast<std::uint64_t>(draw), Purpose::test);
    const double x0 = 12 + random.uniform(), y0 = 11 + random.uniform();
    LockinMaps maps;
    maps.width = 25, maps.height = 24;
    for (int row = 0; row < 24; ++row)
      for (int column = 0; column < 25; ++column) {
        const Vec2 centre{(column - x0) * pixel, (row - y0) * pixel};
        const bool inside = std::hypot(centre.x, centre.y) < radius - 0.71 * pixel;
        maps.in_phase.push_back(inside ? static_cast<float>(-factor * elasticity::square_mean(disk, centre, pixel))
                                       : 7.f);
      }
    maps.convention = AmplitudeConvention::peak_to_peak;
    maps.standard_error.assign(maps.in_phase.size(), 0.f);
    const PeakToPeak found = grain_means(maps, one_grain(x0, y0, radius / pixel), share(0.5));
    worst = std::max(worst, std::abs(found.sigma_hyd[0] / (elasticity::sigma_kk(disk, {}) / 2) - 1));
  }
  EXPECT_LT(worst, 0.01);  // whole pixels would be off by 3 to 6 %
}

TEST(GrainMeans, AmplitudesAreDoubled) {
  LockinMaps maps = harmonic(0.05, 18, 14, 6, 0, 0, 0, 0);
  const PeakToPeak half = grain_means(maps, one_grain(18, 14, 6), share(0.5));
  maps.convention = AmplitudeConvention::peak_to_peak;
  const PeakToPeak full = grain_means(maps, one_grain(18, 14, 6), share(0.5));
  EXPECT_NEAR(half.temperature[0], 0.1, 1e-8);
  EXPECT_NEAR(half.sigma_hyd[0], -0.1 / (2 * 0.015e-6), 1);  // warmer: compressed
  EXPECT_NEAR(full.sigma_hyd[0], -0.05 / (2 * 0.015e-6), 1);
  EXPECT_NEAR(half.error[0], 2 * full.error[0], 1e-9 * half.error[0]);
}

TEST(GrainMeans, ErrorIsThatOfRepeatedDraws) {
  const double x0 = 18.3, y0 = 14.6, noise = 0.02, off = 0.1;
  PictureGrains grain = one_grain(x0, y0, 6);
  grain.position_error = {off};
  double sum = 0, reported = 0;
  const int draws = 400;
  for (int n = 0; n < draws; ++n) {
    RandomStream random(static_cast<std::uint64_t>(n), Purpose::test);
    LockinMaps maps = harmonic(0.05, x0, y0, 6, 0.03, -0.01, 0, 0);
    for (auto& v : maps.in_phase) v += static_cast<float>(noise * random.normal());
    maps.standard_error.assign(maps.in_phase.size(), static_cast<float>(noise));
    grain.centre = {{x0 + off * random.normal(), y0 + off * random.normal()}};
    const PeakToPeak found = grain_means(maps, grain, share(0.5));
    sum += std::pow(found.temperature[0] - 0.1, 2);
    reported += std::pow(found.error[0] * 2 * 0.015e-6, 2);
  }
  EXPECT_NEAR(std::sqrt(sum / reported), 1, 0.12);
}

TEST(GrainMeans, PixelsWithoutAValueAreLeftOut) {
  LockinMaps maps = harmonic(0.05, 18, 14, 6, 0, 0, 0, 0);
  maps.in_phase[14 * 40 + 18] = std::nanf("");
  const PeakToPeak found = grain_means(maps, one_grain(18, 14, 6), share(0.5));
  EXPECT_NEAR(found.temperature[0], 0.1, 1e-8);
  EXPECT_NEAR(found.pixels[0], 0.5 * 3.14159265 * 36 - 1, 1e-6);
  const PeakToPeak outside = grain_means(maps, one_grain(-50, 14, 6), share(0.5));
  EXPECT_EQ(outside.pixels[0], 0);
  EXPECT_TRUE(std::isinf(outside.error[0]));
}

TEST(GrainMeans, RefusesAMaterialWithoutFactorAndAShareOutOfRange) {
  const LockinMaps maps = harmonic(0.05, 18, 14, 6);
  PictureGrains grain = one_grain(18, 14, 6);
  EXPECT_THROW(grain_means(maps, grain, share(0)), InputError);
  EXPECT_THROW(grain_means(maps, grain, share(1.1)), InputError);
  EXPECT_THROW(grain_means(maps, grain, share(0.5, 0)), InputError);
  grain.material = {1};
  EXPECT_THROW(grain_means(maps, grain, share(0.5)), InputError);
  grain.material = {-1};
  EXPECT_THROW(grain_means(maps, grain, share(0.5)), InputError);
}

}  // namespace
}  // namespace arenite::thermography
