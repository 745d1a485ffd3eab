#include "thermal/radiometry/band.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace arenite::radiometry {
namespace {

/// Planck's law by wavelength, summed by Simpson's rule: nothing in common with the series.
double quadrature(const Band& band, double temperature) {
  const auto at = [&](double lambda) {
    const double c2 = 6.62607015e-34 * 299792458.0 / 1.380649e-23;
    return 2 * std::numbers::pi * 299792458.0 / std::pow(lambda, 4) / std::expm1(c2 / (lambda * temperature));
  };
  constexpr int parts = 2000;
  const double step = (band.high - band.low) / parts;
  double sum = at(band.low) + at(band.high);
  for (int i = 1; i < parts; ++i) sum += at(band.low + i * step) * (i % 2 == 1 ? 4 : 2);
  return sum * step / 3;
}

TEST(Band, PhotonsOfARoomInTheBandOfAnIndiumAntimonideCamera) {
  const Band band;
  EXPECT_NEAR(photon_exitance(band, 296) / 1.285e20, 1, 5e-4);
  EXPECT_NEAR(exitance_exponent(band, 296), 10.6, 0.05);
}

TEST(Band, AllWavelengthsGiveTheCubeOfTheTemperature) {
  const Band all{1e-9, 1e-1};
  const double c = 299792458.0, u = 300 * 1.380649e-23 / (6.62607015e-34 * c), zeta3 = 1.2020569031595943;
  // Beyond 0.1 m lie x^2/2/(2 zeta(3)) = 4.8e-8 of them, x = C2/(lambda T).
  EXPECT_NEAR(photon_exitance(all, 300) / (2 * std::numbers::pi * c * u * u * u * 2 * zeta3), 1 - 4.8e-8, 1e-9);
  EXPECT_NEAR(exitance_exponent(all, 300), 3, 1e-6);
}

RC_GTEST_PROP(BandProperty, ExitanceIsTheIntegralOfPlancksLaw, ()) {
  const double low = *rc::gen::inRange(500, 12000) * 1e-9;
  const Band band{low, low * (1 + *rc::gen::inRange(1, 200) * 0.01)};
  const double temperature = *rc::gen::inRange(150, 4000);
  const double n = photon_exitance(band, temperature);
  RC_ASSERT(std::abs(n / quadrature(band, temperature) - 1) < 1e-8);
  const double h = 1e-4 * temperature;
  const double slope = (photon_exitance(band, temperature + h) - photon_exitance(band, temperature - h)) / (2 * h);
  RC_ASSERT(std::abs(photon_exitance_slope(band, temperature) / slope - 1) < 1e-4);
}

RC_GTEST_PROP(BandProperty, TemperatureIsFoundFromWhatIsSeen, ()) {
  const Band band;
  const Surface surface{*rc::gen::inRange(1, 101) * 0.01, *rc::gen::inRange(200, 400) * 1.0};
  const double temperature = *rc::gen::inRange(2500, 9000) * 0.1;
  RC_ASSERT(std::abs(temperature_of_exitance(band, photon_exitance(band, temperature)) - temperature) < 1e-9);
  const double seen = seen_exitance(band, surface, temperature);
  const double mirrored = seen_exitance(band, surface, 1e-3);
  const double digits_lost = mirrored / (seen - mirrored);
  RC_ASSERT(std::abs(temperature_of_seen(band, surface, seen) - temperature) < 1e-9 * (1 + digits_lost));
}

TEST(Band, NothingSeenBeyondTheSurroundingsIsNoTemperature) {
  const Band band;
  EXPECT_EQ(temperature_of_exitance(band, 0), 0);
  EXPECT_EQ(temperature_of_seen(band, {0.5, 300}, 0.4 * photon_exitance(band, 300)), 0);
  EXPECT_EQ(photon_exitance(band, 0), 0);
}

TEST(Band, WithinARoomAMirrorAsWarmAsTheObjectChangesNothing) {
  const Band band;
  EXPECT_NEAR(seen_exitance(band, {0.3, 296}, 296) / photon_exitance(band, 296), 1, 1e-14);
}

}  // namespace
}  // namespace arenite::radiometry
