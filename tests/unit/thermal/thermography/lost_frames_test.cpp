#include "thermal/thermography/lost_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/disturbed_film.hpp"
#include "support/sentences.hpp"
#include "thermal/thermography/lockin.hpp"

namespace {
using namespace arenite;
using namespace arenite::thermography;

LockinMaps locked(const test::DisturbedFilm& of) {
  Film film = of.draw();
  LockinOptions options;
  options.frequency = 3;
  options.reference_phase = of.phase;
  return lock_in(film, options);
}

/// Root mean square of the pixels' errors over those that are told.
double errors(const test::DisturbedFilm& of, const LockinMaps& maps) {
  double square = 0;
  for (std::size_t p = 0; p < maps.size(); ++p)
    square += std::pow(
        (static_cast<double>(maps.in_phase[p]) - of.amplitude(p)) / static_cast<double>(maps.standard_error[p]), 2);
  return std::sqrt(square / static_cast<double>(maps.size()));
}

TEST(LostFrames, AreFoundByThePhaseOfTheLoadAndTold) {
  for (const std::uint64_t seed : {1U, 2U}) {
    test::DisturbedFilm of;
    of.seed = seed;
    of.lost = test::DisturbedFilm::some_of(of.frames, 0.027, seed);
    const LockinMaps maps = locked(of);
    EXPECT_NEAR(static_cast<double>(maps.lost_frames), static_cast<double>(of.lost.size()), 2) << seed;
    EXPECT_NEAR(maps.frequency, of.frequency, 4 * maps.frequency_error) << seed;
    EXPECT_LT(maps.frequency_error, 0.0005);
    EXPECT_LT(errors(of, maps), 1.15) << seed;
    EXPECT_NE(test::all_of(maps.disturbances).find("frames are missing"), std::string::npos);
    EXPECT_EQ(maps.time.size(), maps.frames);
  }
}

TEST(LostFrames, OneLossOfSomeFramesIsFound) {
  for (const std::size_t count : {1U, 4U, 20U}) {
    test::DisturbedFilm of;
    for (std::size_t n = 0; n < count; ++n) of.lost.push_back(700 + n);
    const LockinMaps maps = locked(of);
    EXPECT_EQ(maps.lost_frames, count);
    EXPECT_NEAR(maps.frequency, of.frequency, 4 * maps.frequency_error) << count;
    EXPECT_LT(errors(of, maps), 1.15) << count;
  }
}

TEST(LostFrames, NoiseAndDriftLoseNone) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    test::DisturbedFilm of;
    of.seed = seed, of.common = 0.02, of.columns = seed == 3 ? 0.02 : 0;
    of.drift = [](double t) { return 0.3 * std::sin(0.7 * t); };
    const LockinMaps maps = locked(of);
    EXPECT_EQ(maps.lost_frames, 0U) << seed;
    EXPECT_EQ(test::all_of(maps.disturbances).find("phase of the load"), std::string::npos)
        << test::all_of(maps.disturbances);
  }
}

TEST(LostFrames, ALoadOfWanderingFrequencyHasNone) {
  test::DisturbedFilm of;
  of.late = [](double t) { return 0.5 * std::sin(1.3 * t); };
  const LockinMaps maps = locked(of);
  EXPECT_EQ(maps.lost_frames, 0U);
  EXPECT_NE(test::all_of(maps.disturbances).find("wanders by 18 deg"), std::string::npos)
      << test::all_of(maps.disturbances);
}

TEST(LostFrames, StampsAreBelieved) {
  test::DisturbedFilm of;
  for (std::size_t n = 0; n < 20; ++n) of.lost.push_back(700 + n);
  Film film = of.draw();
  for (std::size_t n = 0; n < of.frames; ++n)
    if (n < 700 || n >= 720) film.about.time.push_back(static_cast<double>(n) / of.rate);
  LockinOptions options;
  options.frequency = 3;
  const LockinMaps maps = lock_in(film, options);
  EXPECT_EQ(maps.lost_frames, 0U);
  EXPECT_TRUE(maps.disturbances.empty());
  EXPECT_NEAR(maps.frequency, of.frequency, 4 * maps.frequency_error);
}

}  // namespace
