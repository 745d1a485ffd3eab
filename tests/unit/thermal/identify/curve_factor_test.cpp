#include "thermal/identify/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace {
using namespace arenite;
using namespace arenite::identify;

TEST(Factor, SlopeOfTemperatureOverStressOfEitherSign) {
  const std::vector<double> stress{1.2e6, 2.4e6, 3.6e6, 4.8e6};
  std::vector<double> warm, cold;
  for (const double s : stress) warm.push_back(0.0150e-6 * s + 1e-3), cold.push_back(-0.0150e-6 * s);
  EXPECT_NEAR(factor_from_stress(stress, warm).factor.value, 0.0150e-6, 1e-20);
  EXPECT_NEAR(factor_from_stress(stress, warm).line.intercept.value, 1e-3, 1e-15);
  EXPECT_NEAR(factor_from_stress(stress, cold).factor.value, 0.0150e-6, 1e-20);
}

TEST(Factor, FourLoadsGiveIntervalsThatCoverTheTruth) {
  int covered = 0, seeds = 3000;
  for (int seed = 0; seed < seeds;
       ++seed) {  // thesis's loads of POM, force ratio 0.1, 1 mK of noise after the transform
    RandomStream random(static_cast<std::uint64_t>(seed), Purpose::test);
    std::vector<double> stress, temperature;
    for (const double force : {200.0, 400.0, 600.0, 800.0}) {
      stress.push_back(0.9 * force / (30.9e-3 * 4.9e-3));
      temperature.push_back(0.0150e-6 * stress.back() + 1e-3 * random.normal());
    }
    const auto range = statistics::confidence_95(factor_from_stress(stress, temperature).factor);
    covered += range.low <= 0.0150e-6 && 0.0150e-6 <= range.high;
  }
  EXPECT_NEAR(covered / double(seeds), 0.95, 0.015);
}

TEST(Factor, StrainGivesWhatStressGives) {
  const Elastic elastic{{2.8e9, 0.1e9}, {0.35, 0.02}};
  const double modulus = 2.8e9 / 0.65;
  EXPECT_NEAR(stress_over_strain(elastic).value, modulus, 1e-6);
  EXPECT_NEAR(stress_over_strain(elastic).error / modulus, std::hypot(0.1 / 2.8, 0.02 / 0.65), 1e-12);
  std::vector<double> strain{1e-4, 2e-4, 3e-4, 5e-4}, temperature;
  for (const double e : strain) temperature.push_back(0.0258e-6 * modulus * e);
  const auto f = factor_from_strain(strain, temperature, elastic);
  EXPECT_NEAR(f.factor.value, 0.0258e-6, 1e-18);
  EXPECT_NEAR(f.factor.error / f.factor.value, std::hypot(0.1 / 2.8, 0.02 / 0.65), 1e-9);
}

TEST(Factor, PropertiesWithTheirErrors) {
  const auto f = factor_from_properties({{110e-6, 5.5e-6}, {296, 1}, {1410}, {1470, 29.4}});
  EXPECT_NEAR(f.value, 110e-6 * 296 / (1410.0 * 1470), 1e-20);
  EXPECT_NEAR(f.error / f.value, std::sqrt(0.05 * 0.05 + 1 / 296.0 / 296 + 0.02 * 0.02), 1e-12);
}

/// A detector made from Planck's law: what it shows of a change of stress gives the constant back.
TEST(Factor, RawSignalRoutesAgree) {
  Detector d;
  d.emissivity = {0.9, 0.01};
  d.reference = 296, d.surface = 310;
  const double levels_per_photon = 3e-18, factor = 0.0150e-6, stress = 2e6;  // Z; K/Pa; Pa
  d.responsivity = {1 / (levels_per_photon * radiometry::photon_exitance_slope(d.band, d.reference))};
  const double warming = factor * stress;
  const double signal =
      levels_per_photon * 0.9 *
      (radiometry::photon_exitance(d.band, 310 + warming / 2) - radiometry::photon_exitance(d.band, 310 - warming / 2));
  const auto direct = direct_constant(d, band_correction(d), {factor});
  EXPECT_NEAR(direct.value, stress / signal, 1e-6 * stress / signal);
  EXPECT_NEAR(direct.error / direct.value, 0.01 / 0.9, 1e-12);
  const auto measured = signal_constant({0.5 * stress, stress, 2 * stress}, {0.5 * signal, signal, 2 * signal});
  EXPECT_NEAR(measured.factor.value, direct.value, 1e-6 * direct.value);
}

TEST(Factor, TheBandsCorrectionIsThePowerOfItsSlope) {
  Detector d;
  d.reference = 296, d.surface = 297;
  EXPECT_NEAR(printed_correction(d), 296.0 * 296 / (297.0 * 297), 1e-15);
  const double n = radiometry::exitance_exponent(d.band, 296.5);
  const double bend =
      std::log(radiometry::exitance_exponent(d.band, 297) / radiometry::exitance_exponent(d.band, 296)) /
      std::log(297.0 / 296);
  EXPECT_NEAR(std::log(band_correction(d)) / std::log(296.0 / 297), n - 1 + bend,
              1e-4);  // n falls with T: N' ~ T^(n-1) alone says 9.6
  EXPECT_NEAR(n - 1 + bend, 8.7, 0.1);
  d.band = {1e-7, 1e-2};  // all wavelengths: N ~ T^3, and the printed square is right
  EXPECT_NEAR(band_correction(d), printed_correction(d), 1e-3 * (1 - printed_correction(d)));
}

}  // namespace
