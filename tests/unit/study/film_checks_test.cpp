#include "study/film_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::study {
namespace {

/// Maps whose pixels swing by noise, and by `load` standard errors.
LockinMaps swinging(double load) {
  RandomStream random(5, Purpose::test, 9);
  LockinMaps maps;
  maps.mean.assign(9216, 296.f);
  for (std::size_t i = 0; i < maps.mean.size(); ++i) {
    maps.amplitude.push_back(static_cast<float>(0.002 * std::hypot(load + random.normal(), random.normal())));
    maps.standard_error.push_back(0.002f);
  }
  return maps;
}

TEST(FilmChecks, NoiseAloneSwingsByTwoVariances) {
  EXPECT_NEAR(swing_over_noise(swinging(0)), 2, 0.1);
  EXPECT_NEAR(swing_over_noise(swinging(3)), 11, 0.3);
}

TEST(FilmChecks, PixelsWithoutNoiseOrNumberAreLeftOut) {
  LockinMaps maps = swinging(3);
  for (std::size_t i = 0; i < 4000; ++i) i % 2 ? maps.amplitude[i] = NAN : maps.standard_error[i] = 0;
  EXPECT_NEAR(swing_over_noise(maps), 11, 0.4);
  maps.amplitude.assign(9216, NAN);
  EXPECT_EQ(swing_over_noise(maps), 0);
}

TEST(FilmChecks, RefusesAFilmWithoutALoad) {
  EXPECT_THROW(refuse_without_load(swinging(0), 3), InputError);
  EXPECT_NO_THROW(refuse_without_load(swinging(1), 3));
}

}  // namespace
}  // namespace arenite::study
