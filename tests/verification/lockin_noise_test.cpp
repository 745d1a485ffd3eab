#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../support/correlated_noise.hpp"
#include "../support/films.hpp"
#include "../support/oscillating_film.hpp"
#include "../support/pictures.hpp"
#include "thermal/thermography/judge_amplitude.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::thermography {
namespace {

using test::CorrelatedNoise;
using test::OscillatingFilm;

/// 32 x 32 pixels, one phase.
OscillatingFilm plain(double amplitude, std::size_t frames = 800) {
  OscillatingFilm film;
  film.width = film.height = 32;
  film.amplitude = amplitude;
  film.frames = frames;
  film.phase = 0;
  return film;
}

LockinMaps locked(const OscillatingFilm& oscillating, const CorrelatedNoise& noise, double given = 3) {
  Film film = oscillating.draw();
  noise.add_to(film);
  LockinOptions o;
  o.frequency = given;
  return lock_in(film, o);
}

/// Root mean square of the pixels' errors over that of their standard errors.
double actual_over_reported(const OscillatingFilm& oscillating, CorrelatedNoise noise) {
  double actual = 0, reported = 0;
  for (noise.seed = 1; noise.seed <= 4; ++noise.seed) {
    const LockinMaps maps = locked(oscillating, noise);
    for (std::size_t p = 0; p < maps.size(); ++p) {
      actual += std::pow(static_cast<double>(maps.in_phase[p]) - oscillating.amplitude_of(p), 2);
      reported += std::pow(static_cast<double>(maps.standard_error[p]), 2);
    }
  }
  return std::sqrt(actual / reported);
}

TEST(LockInNoise, ErrorsHoldWhereFramesFollowOnEachOther) {
  for (const double correlation : {0.0, 0.5, 0.8, -0.4})
    for (const std::size_t frames : {300u, 1200u})
      EXPECT_NEAR(actual_over_reported(plain(0.05, frames), {0.02, 0, correlation}), 1, 0.08)
          << correlation << " " << frames;
}

TEST(LockInNoise, ErrorsHoldBesideALineOfTheCamera) {
  OscillatingFilm oscillating = plain(0.05);
  Film film = oscillating.draw();
  CorrelatedNoise{}.add_to(film);
  for (std::size_t i = 0; i < film.value.size(); ++i) {  // two cycles over the film away
    const double t = static_cast<double>(i / 1024) / oscillating.rate, row = static_cast<double>(i % 1024 / 32);
    film.value[i] += static_cast<float>(0.02 * std::cos(2 * std::numbers::pi * (3.37 * t + 0.13 * row)));
  }
  LockinOptions o;
  o.frequency = 3;
  const LockinMaps maps = lock_in(film, o);
  EXPECT_TRUE(shows_load(maps));
  EXPECT_NEAR(maps.frequency, 3, 4e-3);
  EXPECT_NEAR(
      static_cast<double>(maps.standard_error[5]) / (static_cast<double>(maps.residual[5]) * std::sqrt(2.0 / 800)), 1,
      0.5);
}

/// Films of 100 that show a load though there is none.
int called_loaded(CorrelatedNoise noise) {
  OscillatingFilm oscillating = plain(0, 400);
  oscillating.width = oscillating.height = 16;
  int count = 0;
  for (noise.seed = 1; noise.seed <= 100; ++noise.seed) {
    const std::string said = test::complaint([&] { count += shows_load(locked(oscillating, noise)) ? 1 : 0; });
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
      loaded += shows_load(lock_in(*film, o)) ? 1 : 0;
    } catch (const InputError& error) { EXPECT_TRUE(false) << o.frequency << " " << error.what(); }
  }
  EXPECT_LE(loaded, 1);
}

TEST(LockInNoise, ALineOverTheRowsIsNoLoad) {
  OscillatingFilm oscillating = plain(0);
  Film film = oscillating.draw();
  CorrelatedNoise{}.add_to(film);
  for (std::size_t i = 0; i < film.value.size(); ++i)
    film.value[i] += static_cast<float>(0.03 * std::cos(2 * std::numbers::pi *
                                                        (3 * static_cast<double>(i / 1024) / oscillating.rate +
                                                         0.19 * static_cast<double>(i % 1024 / 32))));
  LockinOptions o;
  o.frequency = 3;
  const LockinMaps maps = lock_in(film, o);
  EXPECT_LT(maps.chance, 0.01);
  EXPECT_LT(maps.one_phase, 0.2);
  EXPECT_FALSE(shows_load(maps));
}

TEST(LockInNoise, ALoadIsSeenInTheNoiseThatItsCameraHas) {
  EXPECT_TRUE(shows_load(locked(plain(0.002), {0.02, 0, 0})));  // a standard error is 1 mK
  EXPECT_TRUE(shows_load(locked(plain(0.006), {0.02, 0, 0.6})));
  EXPECT_TRUE(shows_load(locked(plain(0.03), {0.02, 0.02, 0.5})));
}

TEST(LockInNoise, FrequencyIsAsSureAsTheNoiseThatAllPixelsShareAllows) {
  double square = 0, reported = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const LockinMaps maps = locked(plain(0.05), {0.02, 0.02, 0.3, seed}, 3.001);
    square += std::pow(maps.frequency - 3, 2);
    reported += std::pow(maps.frequency_error, 2);
  }
  EXPECT_NEAR(std::sqrt(square / reported), 1, 0.35);
}

TEST(LockInFrequency, AWrongOneIsRefusedWithTheRightOne) {
  for (const double given : {3.5, 2.4, 4.1, 9.0, 30.0})
    for (const std::size_t frames : {1184u, 3000u, 8880u}) {
      OscillatingFilm oscillating = plain(0.05, frames);
      oscillating.width = oscillating.height = 8, oscillating.frequency = 3.003, oscillating.second = 0.1;
      const std::string said = test::complaint([&] { locked(oscillating, {}, given); });
      EXPECT_NE(said.find("but an oscillation at 3.00"), std::string::npos) << given << " " << frames << " " << said;
    }
}

TEST(LockInFrequency, AMultipleOfTheLoadsIsRefused) {
  OscillatingFilm oscillating = plain(0.05, 1184);
  oscillating.second = 0.2;
  EXPECT_NE(test::complaint([&] { locked(oscillating, {}, 6); }).find("larger at 3.00"), std::string::npos);
  EXPECT_EQ(test::complaint([&] { locked(oscillating, {}, 3); }), "");
}

TEST(LockInFrequency, IsFoundWithinTwoCyclesOverTheFilm) {
  for (const double given : {2.6, 2.8, 3.3, 3.7}) {
    OscillatingFilm oscillating = plain(0.05, 300);
    EXPECT_NEAR(locked(oscillating, {}, given).frequency, 3, 2e-3) << given;
  }
}

TEST(LockInFrequency, OfFewCyclesIsKeptAndNoAmplitudeRunsAway) {
  for (const double cycles : {1.0, 1.05, 1.2, 1.5, 1.9, 2.1, 2.6})
    for (const int drift : {0, 1, 2, 4})
      for (const double noise : {0.0, 0.02}) {
        OscillatingFilm oscillating = plain(0.05, static_cast<std::size_t>(std::ceil(cycles * 148 / 3)));
        Film film = oscillating.draw();
        CorrelatedNoise{noise}.add_to(film);
        LockinOptions o;
        o.frequency = 3;
        o.drift_order = drift;
        try {
          const LockinMaps maps = lock_in(film, o);
          if (cycles < 2) { EXPECT_EQ(maps.frequency, 3); }
          EXPECT_NEAR(maps.frequency, 3, 0.1);
          for (std::size_t p = 0; p < maps.size(); ++p)
            EXPECT_NEAR(maps.amplitude[p], oscillating.amplitude_of(p),
                        6 * static_cast<double>(maps.standard_error[p]) + 2e-3)
                << cycles << " " << drift;
        } catch (const InputError& error) {
          EXPECT_TRUE(std::string(error.what()).find("too few to separate the load from a drift") !=
                          std::string::npos &&
                      drift > 1)
              << error.what();
        }
      }
}

}  // namespace
}  // namespace arenite::thermography
