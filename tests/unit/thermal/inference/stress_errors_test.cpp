#include "thermal/inference/stress_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::inference {
namespace {

PeakToPeak stresses(std::vector<double> sigma, double error) {
  PeakToPeak change;
  change.temperature.assign(sigma.size(), 0);
  change.error.assign(sigma.size(), error);
  change.sigma_hyd = std::move(sigma);
  return change;
}

TEST(StressErrors, ABlurCountsBySlopeTimesItsError) {
  PeakToPeak change = stresses({-1e6, -2e6, NAN}, 3e4);
  add_blur_error(change, stresses({-1.08e6, -2e6, -1e6}, 0), 0.1, 0.05);
  EXPECT_NEAR(change.error[0], 5e4, 1e-6);  // 0.08e6/0.1 * 0.05 = 4e4 beside 3e4
  EXPECT_NEAR(change.error[1], 3e4, 1e-6);
  EXPECT_NEAR(change.error[2], 3e4, 1e-6);  // nothing is known of its slope
}

TEST(StressErrors, ABlurIsAsWellKnownAsRimsShowIt) {
  EXPECT_DOUBLE_EQ(blur_error(0.9, 0.5), 0.4);
  EXPECT_DOUBLE_EQ(blur_error(0.2, 0.5), 0.3);
  EXPECT_DOUBLE_EQ(blur_error(0.51, 0.5), 0.05);
  EXPECT_DOUBLE_EQ(blur_error(0, 0.5), 0.05);  // nothing was seen
}

TEST(StressErrors, AHaloCountsByWhatIsNotKnownOfIt) {
  FilmResult r;
  r.peak_to_peak = stresses({-1e6, -3e6}, 0);
  r.halo = {0.1, 0.02, 4, 0};  // a fifth of it unknown
  add_halo_error(r, stresses({-1.3e6, -2.6e6}, 0));
  EXPECT_NEAR(r.peak_to_peak.error[0], 0.2 * 0.3e6, 1e-6);
  EXPECT_NEAR(r.peak_to_peak.error[1], 0.2 * 0.4e6, 1e-6);
  EXPECT_NEAR(r.halo.cost, std::sqrt((0.09 + 0.16) / 2) / 2, 1e-12);  // r.m.s. change over the mean
  r.halo.error = 0.001;
  r.peak_to_peak.error = {0, 0};
  add_halo_error(r, stresses({-1.3e6, -2.6e6}, 0));
  EXPECT_NEAR(r.peak_to_peak.error[0], 0.05 * 0.3e6, 1e-6);  // its shape is never known better
}

FilmResult of_two_materials() {
  FilmResult r;
  r.packing.materials = {{"POM", 0, 0, 0.015e-6}, {"HDPE", 0, 0, 0.025e-6}};
  r.packing.grains.resize(2);
  r.packing.grains.material = {0, 1};
  r.peak_to_peak = stresses({-4e6, -1e6}, 0);
  r.fit.factor_scale = {1.25, 1};
  r.fit.factor_scale_error = {0.05, 0.01};
  return r;
}

TEST(StressErrors, GivenFactorsCountByTheirErrorUnlessTheLoadTellsThem) {
  FilmResult r = of_two_materials();
  add_factor_error({.error = 0.02}, r);
  EXPECT_NEAR(r.peak_to_peak.error[0], 0.02 * 4e6, 1e-6);
  r = of_two_materials();
  add_factor_error({.error = 0.02, .with_load = true}, r);
  EXPECT_EQ(r.peak_to_peak.sigma_hyd[0], -4e6);
  EXPECT_NEAR(r.peak_to_peak.error[0], std::hypot(0.04, std::log(1.25)) * 4e6, 1e-6);
}

/// A load of which next to nothing is known takes nothing from what the recipe knows of the factors.
TEST(StressErrors, FactorsThatTheLoadTellsWorseAreAsWellKnownAsGiven) {
  FilmResult r = of_two_materials();
  r.fit.factor_scale = {1.02, 1};
  r.fit.factor_scale_error = {0.4, 0.02};
  add_factor_error({.error = 0.02, .with_load = true}, r);
  EXPECT_NEAR(r.peak_to_peak.error[0], 0.02 * 4e6, 0.02 * 0.02 * 4e6);
  EXPECT_NEAR(r.peak_to_peak.error[1], 0.02 * 1e6, 1e-6);
}

TEST(StressErrors, FittedFactorsMakeTheStressesTheirs) {
  FilmResult r = of_two_materials();
  add_factor_error({.fitted = true, .with_load = true}, r);
  EXPECT_NEAR(r.peak_to_peak.sigma_hyd[0], -4e6 / 1.25, 1e-6);
  EXPECT_NEAR(r.peak_to_peak.error[0], 0.04 * 4e6 / 1.25, 1e-6);
}

TEST(StressErrors, WhatMapsAndForcesDifferByIsAnErrorOfAllGrainsAndOfEach) {
  FilmResult r = of_two_materials();
  r.maps.convention = AmplitudeConvention::peak_to_peak;
  r.maps.width = 40, r.maps.height = 20;
  const std::size_t pixels = 800;
  r.maps.mean.assign(pixels, 296), r.maps.standard_error.assign(pixels, 1e-4f);
  r.maps.in_phase.assign(pixels, 0.03f);
  r.fit.picture.assign(pixels, 0.024f);
  PictureGrains shown;
  shown.centre = {{9, 9}, {29, 9}};
  shown.radius = {6, 6};
  shown.material = {0, 1};
  add_fit_error(r, shown, 0.5);
  // Each material has one grain, whose difference is the median: |dT|/(2 A).
  const double off[] = {0.006 / (2 * 0.015e-6), 0.006 / (2 * 0.025e-6)};
  for (std::size_t g = 0; g < 2; ++g)
    EXPECT_NEAR(r.peak_to_peak.error[g], std::hypot(off[g] / 0.6744897501960817, 0.5 * off[g]), 1e-5 * off[g]);
}

}  // namespace
}  // namespace arenite::inference
