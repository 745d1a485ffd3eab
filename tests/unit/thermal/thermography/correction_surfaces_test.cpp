#include "thermal/thermography/correction.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::thermography {
namespace {

/// Planck's law in photons by Simpson's rule, apart from the program's sum.
double photons(const radiometry::Band& band, double t) {
  constexpr double c = 299792458.0, c2 = 6.62607015e-34 * c / 1.380649e-23;
  constexpr int steps = 2000;
  const auto rate = [&](double l) { return 2 * 3.14159265358979 * c / (l * l * l * l * std::expm1(c2 / (l * t))); };
  const double h = (band.high - band.low) / steps;
  double sum = rate(band.low) + rate(band.high);
  for (int k = 1; k < steps; ++k) sum += (k % 2 == 1 ? 4 : 2) * rate(band.low + k * h);
  return sum * h / 3;
}

/// The temperature of a surface that sends so many photons, by halving.
double temperature_of(const radiometry::Band& band, const radiometry::Surface& s, double seen) {
  double low = 200, high = 400;
  for (int k = 0; k < 60; ++k) {
    const double t = 0.5 * (low + high);
    (s.emissivity * photons(band, t) + (1 - s.emissivity) * photons(band, s.ambient) < seen ? low : high) = t;
  }
  return low;
}

/// Two grains side by side in a picture of 24 x 12 pixels, one a material.
PictureGrains two_grains() {
  PictureGrains g;
  g.centre = {{6, 6}, {18, 6}};
  g.radius = {4, 4};
  g.material = {0, 1};
  return g;
}

class Surfaces : public ::testing::TestWithParam<radiometry::Band> {};

TEST_P(Surfaces, GiveBackWhatSurfacesTakenForAnotherHide) {
  const radiometry::Band band = GetParam();
  for (const double assumed : {1.0, 0.9}) {
    const GrainSurfaces surfaces{band, {assumed, 288}, {0.80, 0.95}};
    LockinMaps maps;
    maps.width = 24;
    maps.height = 12;
    for (auto* map : {&maps.mean, &maps.amplitude, &maps.in_phase, &maps.standard_error}) map->assign(288, 0);
    const double middle = 301, warming = 0.2;
    for (const double e : {0.80, 0.95}) {
      const auto taken_for = [&](double t) {
        return temperature_of(band, surfaces.assumed, e * photons(band, t) + (1 - e) * photons(band, 288));
      };
      const auto mean = static_cast<float>(taken_for(middle)),
                 change = static_cast<float>(taken_for(middle + warming / 2) - taken_for(middle - warming / 2));
      for (std::size_t i = 0; i < 288; ++i) {
        if ((i % 24 < 12) != (e < 0.9)) continue;
        maps.mean[i] = mean;
        maps.in_phase[i] = maps.amplitude[i] = change;
        maps.standard_error[i] = 0.01f * change;
      }
    }
    const float corner = maps.in_phase[0];
    see_surfaces(maps, two_grains(), surfaces);
    for (const std::size_t at : {std::size_t{6 * 24 + 6}, std::size_t{6 * 24 + 18}}) {
      EXPECT_NEAR(static_cast<double>(maps.mean[at]), middle, 1e-3);
      EXPECT_NEAR(static_cast<double>(maps.in_phase[at]), warming, 2e-4 * warming + 1e-4);
      EXPECT_FLOAT_EQ(maps.standard_error[at], 0.01f * maps.amplitude[at]);
    }
    EXPECT_EQ(maps.in_phase[0], corner);  // of no grain
  }
}

INSTANTIATE_TEST_SUITE_P(Bands, Surfaces, ::testing::Values(radiometry::Band{}, radiometry::Band{7.7e-6, 9.3e-6}));

TEST(Surfaces, WhatIsAsAssumedKeepsItsBits) {
  LockinMaps maps;
  maps.width = 24;
  maps.height = 12;
  maps.mean.assign(288, 300.125f);
  maps.in_phase.assign(288, 0.1f);
  see_surfaces(maps, two_grains(), {{}, {0.9, 296}, {0.9, 0.9}});
  see_surfaces(maps, two_grains(), {});
  EXPECT_EQ(maps.mean, std::vector<float>(288, 300.125f));
  EXPECT_EQ(maps.in_phase, std::vector<float>(288, 0.1f));
}

}  // namespace
}  // namespace arenite::thermography
