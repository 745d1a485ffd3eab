#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../support/correlated_noise.hpp"
#include "../support/films.hpp"
#include "../support/pictures.hpp"
#include "../support/swinging_film.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::thermography {
namespace {

using test::CorrelatedNoise;
using test::SwingingFilm;

/// 32 x 32 pixels, one phase.
SwingingFilm plain(double amplitude, std::size_t frames = 800) {
  SwingingFilm film;
  film.width = film.height = 32;
  film.amplitude = amplitude;
  film.frames = frames;
  film.phase = 0;
  return film;
}

LockinMaps locked(const SwingingFilm& swing, const CorrelatedNoise& noise, double told = 3) {
  Film film = swing.draw();
  noise.add_to(film);
  LockinOptions o;
  o.frequency = told;
  return lock_in(film, o);
}

/// Root mean square of the pixels' errors over that of their standard errors.
double actual_over_told(const SwingingFilm& swing, CorrelatedNoise noise) {
  double actual = 0, told = 0;
  for (noise.seed = 1; noise.seed <= 4; ++noise.seed) {
    const LockinMaps maps = locked(swing, noise);
    for (std::size_t p = 0; p < maps.size(); ++p) {
      actual += std::pow(static_cast<double>(maps.in_phase[p]) - swing.amplitude_of(p), 2);
      told += std::pow(static_cast<double>(maps.standard_error[p]), 2);
    }
  }
  return std::sqrt(actual / told);
}

TEST(LockInNoise, ErrorsHoldWhereFramesFollowOnEachOther) {
  for (const double correlation : {0.0, 0.5, 0.8, -0.4})
    for (const std::size_t frames : {300u, 1200u})
      EXPECT_NEAR(actual_over_told(plain(0.05, frames), {0.02, 0, correlation}), 1, 0.08) << correlation << " " << frames;
}

TEST(LockInNoise, ErrorsHoldBesideALineOfTheCamera) {
  SwingingFilm swing = plain(0.05);
  Film film = swing.draw();
  CorrelatedNoise{}.add_to(film);
  for (std::size_t i = 0; i < film.value.size(); ++i) {  // two cycles over the film away
    const double t = static_cast<double>(i / 1024) / swing.rate, row = static_cast<double>(i % 1024 / 32);
    film.value[i] += static_cast<float>(0.02 * std::cos(2 * std::numbers::pi * (3.37 * t + 0.13 * row)));
  }
  LockinOptions o;
  o.frequency = 3;
  const LockinMaps maps = lock_in(film, o);
  EXPECT_TRUE(shows_swing(maps));
  EXPECT_NEAR(maps.frequency, 3, 4e-3);
  EXPECT_NEAR(static_cast<double>(maps.standard_error[5]) / (static_cast<double>(maps.residual[5]) * std::sqrt(2.0 / 800)), 1, 0.5);
}

/// Films of 100 that show a load though there is none.
int called_loaded(CorrelatedNoise noise) {
  SwingingFilm swing = plain(0, 400);
  swing.width = swing.height = 16;
  int count = 0;
  for (noise.seed = 1; noise.seed <= 100; ++noise.seed) {
    const std::string said = test::complaint([&] { count += shows_swing(locked(swing, noise)) ? 1 : 0; });
    if (!said.empty()) ++count;  // a load at another frequency
  }
  return count;
}

TEST(LockInNoise, AFilmAtRestShowsALoadInOneOfAHundredFilmsAtMost) {
  EXPECT_LE(called_loaded({0.02, 0, 0}), 3);  // 1 is expected; more than 3 come once in fifty times
  EXPECT_LE(called_loaded({0.02, 0, 0.6}), 3);
  EXPECT_LE(called_loaded({0.02, 0.02, 0}), 3);
  EXPECT_LE(called_loaded({0.02, 0.05, 0.6}), 3);
  EXPECT_LE(called_loaded({0, 0.05, 0.3}), 3);
}

TEST(LockInNoise, ARealCameraAtRestShowsNoLoadAtAnyFrequency) {
  const auto film = io::open_film(test::infrared("PyradiSampleMWIR.ptw"));
  int loaded = 0;
  for (int k = 0; k < 124; ++k) {  // it has lines at 4.67, 6.8 and 16 Hz, whose phase goes on from row to row
    LockinOptions o;
    o.frequency = 1 + 15.0 * k / 123;
    try {
      loaded += shows_swing(lock_in(*film, o)) ? 1 : 0;
    } catch (const InputError& error) { EXPECT_TRUE(false) << o.frequency << " " << error.what(); }
  }
  EXPECT_LE(loaded, 1);
}

TEST(LockInNoise, ALineOverTheRowsIsNoLoad) {
  SwingingFilm swing = plain(0);
  Film film = swing.draw();
  CorrelatedNoise{}.add_to(film);
  for (std::size_t i = 0; i < film.value.size(); ++i)
    film.value[i] += static_cast<float>(
        0.03 * std::cos(2 * std::numbers::pi * (3 * static_cast<double>(i / 1024) / swing.rate + 0.19 * static_cast<double>(i % 1024 / 32))));
  LockinOptions o;
  o.frequency = 3;
  const LockinMaps maps = lock_in(film, o);
  EXPECT_LT(maps.chance, 0.01);
  EXPECT_LT(maps.one_phase, 0.2);
  EXPECT_FALSE(shows_swing(maps));
}

TEST(LockInNoise, ALoadIsSeenInTheNoiseThatItsCameraHas) {
  EXPECT_TRUE(shows_swing(locked(plain(0.002), {0.02, 0, 0})));  // a standard error is 1 mK
  EXPECT_TRUE(shows_swing(locked(plain(0.006), {0.02, 0, 0.6})));
  EXPECT_TRUE(shows_swing(locked(plain(0.03), {0.02, 0.02, 0.5})));
}

TEST(LockInNoise, FrequencyIsAsSureAsTheNoiseThatAllPixelsShareAllows) {
  double square = 0, told = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const LockinMaps maps = locked(plain(0.05), {0.02, 0.02, 0.3, seed}, 3.001);
    square += std::pow(maps.frequency - 3, 2);
    told += std::pow(maps.frequency_error, 2);
  }
  EXPECT_NEAR(std::sqrt(square / told), 1, 0.35);
}

TEST(LockInFrequency, AWrongOneIsRefusedWithTheRightOne) {
  for (const double told : {3.5, 2.4, 4.1, 9.0, 30.0})
    for (const std::size_t frames : {1184u, 3000u, 8880u}) {
      SwingingFilm swing = plain(0.05, frames);
      swing.width = swing.height = 8, swing.frequency = 3.003, swing.second = 0.1;
      const std::string said = test::complaint([&] { locked(swing, {}, told); });
      EXPECT_NE(said.find("but the film swings at 3.00"), std::string::npos) << told << " " << frames << " " << said;
    }
}

TEST(LockInFrequency, AMultipleOfTheLoadsIsRefused) {
  SwingingFilm swing = plain(0.05, 1184);
  swing.second = 0.2;
  EXPECT_NE(test::complaint([&] { locked(swing, {}, 6); }).find("more at 3.00"), std::string::npos);
  EXPECT_EQ(test::complaint([&] { locked(swing, {}, 3); }), "");
}

TEST(LockInFrequency, IsFoundWithinTwoCyclesOverTheFilm) {
  for (const double told : {2.6, 2.8, 3.3, 3.7}) {
    SwingingFilm swing = plain(0.05, 300);
    EXPECT_NEAR(locked(swing, {}, told).frequency, 3, 2e-3) << told;
  }
}

TEST(LockInFrequency, OfFewCyclesIsKeptAndNoAmplitudeRunsAway) {
  for (const double cycles : {1.0, 1.05, 1.2, 1.5, 1.9, 2.1, 2.6})
    for (const int drift : {0, 1, 2, 4})
      for (const double noise : {0.0, 0.02}) {
        SwingingFilm swing = plain(0.05, static_cast<std::size_t>(std::ceil(cycles * 148 / 3)));
        Film film = swing.draw();
        CorrelatedNoise{noise}.add_to(film);
        LockinOptions o;
        o.frequency = 3;
        o.drift_order = drift;
        try {
          const LockinMaps maps = lock_in(film, o);
          if (cycles < 2) { EXPECT_EQ(maps.frequency, 3); }
          EXPECT_NEAR(maps.frequency, 3, 0.1);
          for (std::size_t p = 0; p < maps.size(); ++p)
            EXPECT_NEAR(maps.amplitude[p], swing.amplitude_of(p), 6 * static_cast<double>(maps.standard_error[p]) + 2e-3) << cycles << " " << drift;
        } catch (const InputError& error) {
          EXPECT_TRUE(std::string(error.what()).find("too few to tell the swing from a drift") != std::string::npos && drift > 1) << error.what();
        }
      }
}

}  // namespace
}  // namespace arenite::thermography
