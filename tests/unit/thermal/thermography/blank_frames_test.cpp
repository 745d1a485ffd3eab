#include "thermal/thermography/blank_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "support/oscillating_film.hpp"
#include "support/pictures.hpp"
#include "thermal/thermography/film_checks.hpp"
#include "thermal/thermography/frame_statistics.hpp"
#include "thermal/thermography/judge_amplitude.hpp"
#include "thermal/thermography/lockin.hpp"
#include "thermal/thermography/phase_pictures.hpp"
#include "thermal/thermography/step/step_load.hpp"

namespace arenite::thermography {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

LockinOptions at_3_hz() {
  LockinOptions o;
  o.frequency = 3;
  return o;
}

Film noisy_film() {
  test::OscillatingFilm film;
  film.noise = 0.05;
  return film.draw();
}

float* frame_of(Film& film, std::size_t n) { return film.value.data() + n * film.about.pixels(); }

/// The film as if these frames had never been taken, with the times of the others as stamps.
Film without(const Film& film, const std::vector<std::int64_t>& lost) {
  Film left = film;
  left.value.clear();
  left.level.clear();
  for (std::int64_t n = 0; n < film.about.frames; ++n) {
    if (std::ranges::count(lost, n) > 0) continue;
    const auto first = n * static_cast<std::ptrdiff_t>(film.about.pixels()),
               end = first + static_cast<std::ptrdiff_t>(film.about.pixels());
    if (film.about.floating) left.value.insert(left.value.end(), film.value.begin() + first, film.value.begin() + end);
    else left.level.insert(left.level.end(), film.level.begin() + first, film.level.begin() + end);
    left.about.time.push_back(static_cast<double>(n) / film.about.frame_rate);
  }
  left.about.frames = static_cast<std::int64_t>(left.about.time.size());
  return left;
}

void expect_same(const LockinMaps& maps, const LockinMaps& right) {
  EXPECT_EQ(maps.frequency, right.frequency);
  EXPECT_EQ(maps.frames, right.frames);
  EXPECT_EQ(maps.in_phase, right.in_phase);
  EXPECT_EQ(maps.residual, right.residual);
  EXPECT_EQ(maps.chance, right.chance);
}

TEST(BlankFrames, AmplitudesAreThoseOfTheOtherFrames) {
  const Film whole = noisy_film();
  const std::vector<std::vector<std::int64_t>> cases = {{0}, {40}, {0, 1, 400, 799}};
  for (const auto& lost : cases) {
    Film holed = whole, left = without(whole, lost);
    for (const auto n : lost) std::fill_n(frame_of(holed, static_cast<std::size_t>(n)), holed.about.pixels(), nothing);
    const LockinMaps maps = lock_in(holed, at_3_hz());
    expect_same(maps, lock_in(left, at_3_hz()));
    EXPECT_EQ(maps.blank, lost);
    EXPECT_TRUE(shows_load(maps));
    const auto pictures = phase_pictures(holed, maps, at_3_hz()),
               right = phase_pictures(left, lock_in(left, at_3_hz()), at_3_hz());
    EXPECT_EQ(pictures.spline, right.spline);
    LockinOptions plain = at_3_hz();
    EXPECT_NEAR(nearest_bin_transform(holed, plain).amplitude[7], maps.amplitude[7], 0.1);
  }
}

TEST(BlankFrames, OfLevelsAreZeros) {
  test::OscillatingFilm film;
  film.noise = 0.05;
  Film holed = film.levels(100);
  Film left = without(holed, {5, 6});
  std::fill_n(holed.level.begin() + static_cast<std::ptrdiff_t>(5 * holed.about.pixels()), 2 * holed.about.pixels(),
              std::uint16_t{0});
  const LockinMaps maps = lock_in(holed, at_3_hz());
  expect_same(maps, lock_in(left, at_3_hz()));
  EXPECT_EQ(maps.blank, (std::vector<std::int64_t>{5, 6}));
}

TEST(BlankFrames, AFrameThatCameInPartIsLostAndADeadPixelIsNot) {
  Film film = noisy_film();
  const std::size_t pixels = film.about.pixels();
  for (std::size_t n = 0; n < 800; ++n) frame_of(film, n)[3] = nothing;  // dead
  std::fill_n(frame_of(film, 70) + 2 * pixels / 3, pixels / 3, nothing);
  EXPECT_EQ(blank_frames(film), std::vector<std::int64_t>{70});
  const LockinMaps maps = lock_in(film, at_3_hz());
  EXPECT_EQ(maps.blank, std::vector<std::int64_t>{70});
  for (std::size_t p = 0; p < pixels; ++p) EXPECT_EQ(std::isfinite(maps.amplitude[p]), p != 3) << p;
  EXPECT_TRUE(shows_load(maps));
}

TEST(BlankFrames, AFilmWithoutAnyNumberShowsNothing) {
  Film film = noisy_film();
  std::ranges::fill(film.value, nothing);
  EXPECT_TRUE(blank_frames(film).empty());
  EXPECT_NE(test::complaint([&] { lock_in(film, at_3_hz()); }).find("not a number"), std::string::npos);
  EXPECT_NE(test::complaint([&] { nearest_bin_transform(film, at_3_hz()); }).find("not a number"), std::string::npos);
  EXPECT_NE(test::complaint([&] { step_load(film, {}); }).find("not a number"), std::string::npos);
  EXPECT_FALSE(shows_load(LockinMaps{}));
}

TEST(BlankFrames, PixelsThatFailInTurnGiveNoCertainty) {
  test::OscillatingFilm wide;
  wide.width = 40, wide.height = 30, wide.noise = 0.05;
  Film film = wide.draw();
  const std::size_t pixels = film.about.pixels();
  for (std::size_t n = 0; n < 800; ++n)
    for (std::size_t k = 0; k < 2; ++k) frame_of(film, n)[(2 * n + k) % pixels] = nothing;  // every pixel fails once
  EXPECT_TRUE(blank_frames(film).empty());
  const LockinMaps maps = lock_in(film, at_3_hz());
  EXPECT_TRUE(std::isnan(maps.amplitude[0]));
  EXPECT_TRUE(std::isnan(maps.chance));
  EXPECT_FALSE(shows_load(maps));
}

TEST(BlankFrames, OnePixelThatFailsInAFrameLeavesTheFrame) {
  Film film = noisy_film();
  const std::size_t pixels = film.about.pixels();
  ASSERT_GT(100U, pixels);  // of which one is more than a hundredth
  frame_of(film, 40)[3] = nothing;
  EXPECT_TRUE(blank_frames(film).empty());
  const LockinMaps maps = lock_in(film, at_3_hz());
  EXPECT_EQ(maps.frames, 800U);
  for (std::size_t p = 0; p < pixels; ++p) EXPECT_EQ(std::isfinite(maps.amplitude[p]), p != 3) << p;
  EXPECT_EQ(
      maps.disturbances.back(),
      "1 of " + std::to_string(pixels) + " pixels are no numbers in some of the frames and are left out, as dead ones");
  const FrameStatistics seen = frame_statistics(film);
  EXPECT_EQ(seen.without[3], 1U);
  EXPECT_NE(find_bad_pixels(seen)[3], 0);  // so that its neighbours stand in for it
}

TEST(BlankFrames, WherePixelsFailInManyFramesThatIsTheCause) {
  test::OscillatingFilm wide;
  wide.width = 20, wide.height = 10, wide.noise = 0.05;
  Film film = wide.draw();
  for (std::size_t n = 1; n < 800; ++n)
    for (std::size_t p = (7 * n) % 5; p < 200; p += 5) frame_of(film, n)[p] = nothing;  // a fifth, scattered
  EXPECT_TRUE(blank_frames(film).empty());
  const LockinMaps maps = lock_in(film, at_3_hz());
  EXPECT_TRUE(std::isnan(maps.chance));
  EXPECT_NE(no_load_sentence(maps, 3, "--frequency").find("no pixel of the film has numbers in all frames"),
            std::string::npos);
}

TEST(BlankFrames, ARefusalNamesTheFramesThatAreLeftOut) {
  Film film = noisy_film();
  for (std::size_t n = 0; n < 800; ++n)
    if (n % 40 != 0) std::fill_n(frame_of(film, n), film.about.pixels(), nothing);
  const std::string said = test::complaint([&] { lock_in(film, at_3_hz()); });
  EXPECT_EQ(said.find("780 frames (1, 2, 3, 4, 5 and 775 more) hold no whole picture"), 0U) << said;
  EXPECT_NE(said.find("are left out; of the others: the load frequency of 3 Hz is at or above"), std::string::npos);
}

TEST(BlankFrames, AStepIsThatOfTheOtherFrames) {
  test::OscillatingFilm still;
  still.amplitude = 0, still.noise = 0.05, still.frames = 300, still.rate = 100;
  Film whole = still.draw();
  for (std::size_t n = 150; n < 300; ++n)
    for (std::size_t p = 0; p < whole.about.pixels(); ++p) frame_of(whole, n)[p] += 2;
  Film holed = whole, left = without(whole, {10, 200});
  for (const std::size_t n : {10, 200}) std::fill_n(frame_of(holed, n), holed.about.pixels(), nothing);
  const StepMaps maps = step_load(holed, {}), right = step_load(left, {});
  EXPECT_EQ(maps.blank, (std::vector<std::int64_t>{10, 200}));
  EXPECT_EQ(maps.jump, right.jump);
  EXPECT_EQ(maps.standard_error, right.standard_error);
  EXPECT_NEAR(maps.jump[4], 2, 0.05);
}

TEST(BlankFrames, StatisticsAreOfTheNumbersThatAreThere) {
  Film film = noisy_film();
  Film left = without(film, {3});
  std::fill_n(frame_of(film, 3), film.about.pixels(), nothing);
  for (std::size_t n = 0; n < 800; ++n) frame_of(film, n)[5] = nothing;
  const FrameStatistics seen = frame_statistics(film), right = frame_statistics(left);
  EXPECT_EQ(seen.blank, std::vector<std::int64_t>{3});
  for (std::size_t p = 0; p < film.about.pixels(); ++p) {
    if (p == 5) {
      EXPECT_TRUE(std::isnan(seen.mean[p]) && std::isnan(seen.least[p]) && std::isnan(seen.noise[p]));
      continue;
    }
    EXPECT_EQ(seen.mean[p], right.mean[p]);
    EXPECT_EQ(seen.most[p], right.most[p]);
    EXPECT_NEAR(seen.noise[p], right.noise[p], 0.01 * static_cast<double>(right.noise[p]));
  }
  const auto bad = find_bad_pixels(seen);
  EXPECT_NE(bad[5] & bad_level, 0);
  EXPECT_EQ(std::ranges::count(bad, 0), static_cast<std::ptrdiff_t>(bad.size()) - 1);
}

TEST(BlankFrames, OneNumberEverywhereThatNoOtherFrameReachesIsNoPicture) {
  for (const float filled : {-1e30F, 65535.0F, 0.0F}) {
    Film holed = noisy_film(), left = without(holed, {40});
    std::fill_n(frame_of(holed, 40), holed.about.pixels(), filled);
    const LockinMaps maps = lock_in(holed, at_3_hz());
    EXPECT_EQ(maps.blank, std::vector<std::int64_t>{40});
    expect_same(maps, lock_in(left, at_3_hz()));
    const FrameStatistics seen = frame_statistics(holed), right = frame_statistics(left);
    EXPECT_EQ(seen.blank, std::vector<std::int64_t>{40});
    EXPECT_EQ(seen.mean, right.mean);
    EXPECT_EQ(seen.noise, right.noise);
  }
}

TEST(BlankFrames, AFrameOnceMoreIsNoPicture) {
  Film holed = noisy_film(), left = without(holed, {40, 41, 70});
  const std::size_t pixels = holed.about.pixels();
  for (const std::size_t n : {40, 41, 70}) std::copy_n(frame_of(holed, n - 1), pixels, frame_of(holed, n));
  const LockinMaps maps = lock_in(holed, at_3_hz());
  EXPECT_EQ(maps.blank, (std::vector<std::int64_t>{40, 41, 70}));
  EXPECT_TRUE(maps.levels.empty());
  expect_same(maps, lock_in(left, at_3_hz()));
}

TEST(BlankFrames, PicturesWithoutNoiseThatTurnRoundOrAreEvenAreKept) {
  test::OscillatingFilm clean;
  clean.rate = 150, clean.phase = 0;  // 50 frames a cycle; its largest values lie half way between two frames
  Film film;
  film.about = clean.draw().about;
  for (std::size_t n = 0; n < clean.frames; ++n)
    for (std::size_t p = 0; p < film.about.pixels(); ++p)
      film.value.push_back(std::round(100 * static_cast<float>(clean.at(p, (static_cast<double>(n) - 0.5) / 150))));
  ASSERT_TRUE(std::equal(frame_of(film, 0), frame_of(film, 1), frame_of(film, 1)));
  ASSERT_TRUE(std::equal(frame_of(film, 25), frame_of(film, 26), frame_of(film, 26)));
  EXPECT_TRUE(blank_frames(film).empty());
  std::fill_n(frame_of(film, 40), film.about.pixels(), film.value[0]);
  EXPECT_TRUE(blank_frames(film).empty());
}

TEST(BlankFrames, AreNamedInASentence) {
  EXPECT_EQ(blank_frames_sentence({}), "");
  EXPECT_EQ(
      blank_frames_sentence({40}),
      "frame 40 holds no whole picture (no numbers in more than a tenth of its pixels, one number everywhere, or the "
      "frame before once more) and is left out");
  EXPECT_EQ(
      blank_frames_sentence({1, 2, 3, 4, 5, 6, 7}),
      "7 frames (1, 2, 3, 4, 5 and 2 more) hold no whole picture (no numbers in more than a tenth of their pixels, "
      "one number everywhere, or the frame before once more) and are left out");
}

TEST(BlankFrames, FramesAroundThemAreReadInRuns) {
  Film film = noisy_film();
  std::vector<double> time(800);
  for (std::size_t n = 0; n < 800; ++n) time[n] = 0.5 * static_cast<double>(n);
  FilmWithout kept(film, {0, 2, 3}, time);
  EXPECT_EQ(kept.info().frames, 797);
  EXPECT_EQ(kept.info().time[0], 0.5);
  FrameBlock block, alone;
  kept.read(0, 4, block);
  std::size_t at = 0;
  for (const std::int64_t n : {1, 4, 5, 6}) {
    film.read(n, 1, alone);
    EXPECT_TRUE(std::ranges::equal(alone.value, std::span(block.value).subspan(at, film.about.pixels())));
    at += film.about.pixels();
  }
}

}  // namespace
}  // namespace arenite::thermography
