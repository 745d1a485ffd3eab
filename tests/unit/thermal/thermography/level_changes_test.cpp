#include "thermal/thermography/level_changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "support/disturbed_film.hpp"
#include "support/sentences.hpp"
#include "thermal/thermography/lockin.hpp"

namespace {
using namespace arenite;
using namespace arenite::thermography;

LockinMaps lock_in_of(const test::DisturbedFilm& of, Film film) {
  LockinOptions options;
  options.frequency = 3;
  options.reference_phase = of.phase;
  return lock_in(film, options);
}

/// Errors against those that are told: a sample that fills the picture, so that no pixel beside it shows what all
/// share.
struct PixelErrors {
  double mean = 0;                        ///< error of the mean of all pixels, K
  double within_one = 0, within_two = 0;  ///< shares of pixels
};

PixelErrors pixel_errors(const test::DisturbedFilm& of, const LockinMaps& maps) {
  PixelErrors c;
  const auto pixels = static_cast<double>(maps.size());
  for (std::size_t p = 0; p < maps.size(); ++p) {
    const double off = static_cast<double>(maps.in_phase[p]) - of.amplitude(p),
                 over = std::abs(off) / static_cast<double>(maps.standard_error[p]);
    c.mean += off / pixels, c.within_one += (over < 1) / pixels, c.within_two += (over < 2) / pixels;
  }
  return c;
}

void expect_told(const PixelErrors& c, std::uint64_t seed) {
  EXPECT_LT(std::abs(c.mean), 0.0002) << seed;
  EXPECT_NEAR(c.within_one, 0.68, 0.08) << seed;
  EXPECT_NEAR(c.within_two, 0.94, 0.04) << seed;
}

test::DisturbedFilm filled(std::uint64_t seed) {
  test::DisturbedFilm of;
  of.border = 0, of.seed = seed;
  return of;
}

TEST(LevelChanges, AJumpOfAllPixelsIsFoundAndFitted) {
  for (const std::uint64_t seed : {1U, 2U, 3U})
    for (const double size : {0.03, 0.1, -2.0}) {
      test::DisturbedFilm of = filled(seed);
      of.jump = size;
      const LockinMaps maps = lock_in_of(of, of.draw());
      ASSERT_EQ(maps.levels.jumps.size(), 1U) << seed;
      EXPECT_NEAR(static_cast<double>(maps.levels.jumps[0].frame), 800, std::abs(size) < 0.1 ? 4 : 0) << seed;
      EXPECT_NEAR(maps.levels.jumps[0].common, size, 0.01) << seed;
      EXPECT_NE(test::all_of(maps.disturbances).find("jumps at 5.4"), std::string::npos)
          << test::all_of(maps.disturbances);
      EXPECT_EQ(test::all_of(maps.disturbances).find("share noise"), std::string::npos)
          << test::all_of(maps.disturbances);
      expect_told(pixel_errors(of, maps), seed);
    }
}

TEST(LevelChanges, JumpsOfEachPixelAreFoundAndFitted) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    test::DisturbedFilm of = filled(seed);
    of.jump_pattern = 0.03;
    const LockinMaps maps = lock_in_of(of, of.draw());
    ASSERT_EQ(maps.levels.jumps.size(), 1U) << seed;
    EXPECT_EQ(maps.levels.jumps[0].frame, 800U) << seed;
    EXPECT_NEAR(maps.levels.jumps[0].own, 0.03, 0.015) << seed;
    expect_told(pixel_errors(of, maps), seed);
  }
}

TEST(LevelChanges, DriftThatNoPolynomialFollowsIsFoundAndFitted) {
  const std::vector<std::function<double(double)>> drifts{
      [](double t) { return -0.3 * std::exp(-2 * t); }, [](double t) { return -0.3 * std::exp(-t); },
      [](double t) { return 0.3 * std::sin(1.6 * t); }, [](double t) { return 0.3 * std::sin(2.5 * t); }};
  for (std::size_t k = 0; k < drifts.size(); ++k) {
    test::DisturbedFilm of = filled(k + 1);
    of.drift = drifts[k];
    const LockinMaps maps = lock_in_of(of, of.draw());
    EXPECT_FALSE(maps.levels.course.empty()) << k;
    EXPECT_NE(test::all_of(maps.disturbances).find("drift along a curve"), std::string::npos)
        << test::all_of(maps.disturbances);
    expect_told(pixel_errors(of, maps), k);
  }
}

TEST(LevelChanges, AreFoundWhereStampsHaveGaps) {
  test::DisturbedFilm of = filled(4);
  of.lost = test::DisturbedFilm::some_of(of.frames, 0.02, 4);
  of.jump_pattern = 0.03, of.jump = 0.1;
  of.drift = [](double t) { return -0.3 * std::exp(-2 * t); };
  Film film = of.draw();
  for (std::size_t n = 0; n < of.frames; ++n)
    if (!std::ranges::binary_search(of.lost, n)) film.about.time.push_back(static_cast<double>(n) / of.rate);
  const LockinMaps maps = lock_in_of(of, std::move(film));
  ASSERT_EQ(maps.levels.jumps.size(), 1U);
  const auto before = std::ranges::count_if(of.lost, [&](std::size_t n) { return n < of.jump_frame; });
  EXPECT_EQ(maps.levels.jumps[0].frame, of.jump_frame - static_cast<std::size_t>(before));
  EXPECT_FALSE(maps.levels.course.empty());
  expect_told(pixel_errors(of, maps), 4);
}

TEST(LevelChanges, OtherDisturbancesAreNone) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    test::DisturbedFilm of = filled(seed);
    of.common = seed % 2 == 0 ? 0.02 : 0;
    of.columns = seed % 3 == 0 ? 0.02 : 0;
    if (seed > 4) of.lost = test::DisturbedFilm::some_of(of.frames, 0.02, seed);
    if (seed == 7) of.late = [](double t) { return 0.5 * std::sin(t); };
    const LockinMaps maps = lock_in_of(of, of.draw());
    EXPECT_TRUE(maps.levels.empty()) << seed << " " << test::all_of(maps.disturbances);
  }
}

}  // namespace
