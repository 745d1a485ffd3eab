#include "thermal/camera/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "thermal/camera/expose.hpp"
#include "thermal/camera/scene.hpp"
#include "thermal/camera/virtual_film.hpp"
#include "unit/thermal/camera/pressed_disk.hpp"

namespace arenite::camera {
namespace {

std::vector<std::uint16_t> levels(FilmSource& film, std::int64_t first, std::size_t count) {
  FrameBlock block;
  film.read(first, count, block);
  return block.level;
}

double mean_of(const std::vector<std::uint16_t>& v) {
  double sum = 0;
  for (const auto x : v) sum += x;
  return sum / static_cast<double>(v.size());
}

double deviation_of(const std::vector<std::uint16_t>& v) {
  const double mean = mean_of(v);
  double sum = 0;
  for (const auto x : v) sum += (x - mean) * (x - mean);
  return std::sqrt(sum / static_cast<double>(v.size()));
}

constexpr double level_per_kelvin = 16383 * 6e6 / 1.2e7 * 10.6 / 296;

TEST(VirtualCamera, CentreOfAPressedDiskWarmsByTheClosedForm) {
  const double force = 2000;
  auto p = ideal();
  p.surroundings.radiometry = false;
  const Scene scene = scene_of_state(pressed_disk(force), p);
  const auto cold = expose(scene, p, 0), warm = expose(scene, p, 1);
  const std::size_t centre = 32 * 64 + 32;  // half a pixel off, where the field is flat
  const double slope = radiometry::photon_exitance_slope(p.band, 296) / radiometry::photon_exitance(p.band, 296);
  const double warming = (static_cast<double>(warm[centre]) - static_cast<double>(cold[centre])) / slope;
  const double expected = 0.0150e-6 * 2 * force / (std::numbers::pi * 0.0155 * 0.06);
  EXPECT_NEAR(warming / expected, 1, 0.01);
}

TEST(VirtualCamera, TheStressOfTheLowStateIsTakenOff) {
  auto p = ideal();
  const Scene both = scene_between(pressed_disk(500), pressed_disk(2000), p),
              difference = scene_of_state(pressed_disk(1500), p);
  for (std::size_t k = 0; k < both.stress[0].value.size(); ++k)
    EXPECT_NEAR(both.stress[0].value[k], difference.stress[0].value[k],
                1e-5 * std::abs(difference.stress[0].value[k]) + 1);
}

TEST(VirtualCamera, NoiseIsTheNetdAsked) {
  auto p = ideal();
  p.detector.netd = 0.020;
  const auto film = uniform_film(p, 296, 8, 3);
  EXPECT_NEAR(deviation_of(levels(*film, 0, 8)) / level_per_kelvin, 0.020, 0.0005);
}

TEST(VirtualCamera, ShotNoiseAloneIsElevenMillikelvin) {
  auto p = ideal();
  p.detector.netd = 0.0114;
  const auto film = uniform_film(p, 296, 8, 3);
  const double cold = deviation_of(levels(*film, 0, 8));
  const auto warm_film = uniform_film(p, 308, 8, 3);
  const double brighter = mean_of(levels(*warm_film, 0, 1)) / mean_of(levels(*film, 0, 1));
  EXPECT_NEAR(deviation_of(levels(*warm_film, 0, 8)) / cold, std::sqrt(brighter), 0.03);
}

TEST(VirtualCamera, PlateOfEvenTemperatureReadsAsPlanckSays) {
  const auto p = ideal();
  const auto at = [&](double t) { return mean_of(levels(*uniform_film(p, t, 1, 3), 0, 1)); };
  EXPECT_NEAR(at(296), 16383 * 0.5, 1);
  EXPECT_NEAR((at(297) - at(295)) / 2, level_per_kelvin, 1);
}

TEST(VirtualCamera, BadPixelsAreAsManyAsAsked) {
  auto p = ideal();
  p.optics.width = p.optics.height = 256;
  p.detector.bad_share = 0.01;
  const auto frame = levels(*uniform_film(p, 296, 1, 11), 0, 1);
  int dead = 0, hot = 0;
  for (const auto level : frame) {
    dead += level < 1000;
    hot += level == 16383;
  }
  const double expected = 65536 * 0.01 / 3;
  EXPECT_NEAR(dead, expected, 4 * std::sqrt(expected));
  EXPECT_NEAR(hot, expected, 4 * std::sqrt(expected));
}

TEST(VirtualCamera, PatternIsTheCamerasOwn) {
  auto p = ideal();
  p.detector.gain_spread = 0.02;
  p.detector.offset_spread = 0.03;
  const auto first = levels(*uniform_film(p, 296, 2, 5), 0, 2), other = levels(*uniform_film(p, 296, 1, 6), 0, 1);
  EXPECT_TRUE(std::equal(first.begin(), first.begin() + 64 * 64, first.begin() + 64 * 64));
  EXPECT_NE(std::vector(first.begin(), first.begin() + 64 * 64), other);
  EXPECT_NEAR(deviation_of(other), std::hypot(0.02 * 8192, 0.03 * 16383), 30);
}

TEST(VirtualCamera, SameSeedDrawsTheSameFilmInWhateverParts) {
  auto p = ideal();
  p.detector = {};
  p.timing = {40, 148, 1.5e-3, 3, 1e-3, 0.02, 0.1};
  p.motion = true;
  const Scene scene = scene_between(pressed_disk(500, -0.002), pressed_disk(2000, 0.002), p);
  const auto one = film(scene, p, 9), two = film(scene, p, 9);
  const auto frames = static_cast<std::size_t>(one->info().frames);
  const auto whole = levels(*one, 0, frames);
  auto parts = levels(*two, 0, 7);
  const auto rest = levels(*two, 7, frames - 7);
  parts.insert(parts.end(), rest.begin(), rest.end());
  EXPECT_EQ(whole, parts);
}

TEST(VirtualCamera, DroppedFramesShowInTheTimeStamps) {
  auto p = ideal();
  p.timing.dropped = 0.2;
  const auto f = film(scene_of_state(pressed_disk(1000), p), p, 4);
  const auto& info = f->info();
  EXPECT_NEAR(static_cast<double>(info.frames), 148 * 0.8, 20);
  ASSERT_EQ(info.time.size(), static_cast<std::size_t>(info.frames));
  EXPECT_DOUBLE_EQ(info.time.back(), 147.0 / 148);
  int gaps = 0;
  for (std::size_t k = 1; k < info.time.size(); ++k) gaps += info.time[k] - info.time[k - 1] > 1.5 / 148;
  EXPECT_GT(gaps, 5);
}

TEST(VirtualCamera, FramesLostWithoutStampsAreOnlyTooFew) {
  auto p = ideal();
  p.timing.frames = 3000, p.timing.dropped = 0.1, p.timing.dropped_together = 5;
  const Scene scene = scene_of_state(pressed_disk(1000), p);
  const FilmInfo stamped = film(scene, p, 4)->info();
  p.timing.time_stamps = false;
  const FilmInfo bare = film(scene, p, 4)->info();
  EXPECT_TRUE(bare.time.empty());
  EXPECT_EQ(bare.frames, stamped.frames);
  EXPECT_DOUBLE_EQ(bare.frame_rate, 148);
  EXPECT_NEAR(static_cast<double>(stamped.frames), 2700, 100);
  for (std::size_t k = 2; k + 1 < stamped.time.size(); ++k) {  // two losses may follow on each other
    const auto missing = std::lround(148 * (stamped.time[k] - stamped.time[k - 1])) - 1;
    EXPECT_EQ(missing % 5, 0) << k;
  }
}

TEST(VirtualCamera, LevelsJumpWhenTheShutterHasCorrectedThem) {
  auto p = ideal();
  p.timing.frames = 20, p.detector.jump = 0.1, p.detector.jump_time = 10.0 / 148;
  const Scene scene = scene_of_state(pressed_disk(0), p);
  const auto mean = [&](std::int64_t n) { return mean_of(levels(*film(scene, p, 4), n, 1)); };
  EXPECT_NEAR(mean(9) - mean(0), 0, 0.2);
  EXPECT_NEAR((mean(10) - mean(9)) / level_per_kelvin, 0.1, 0.003);  // a level is 3.4 mK
  EXPECT_NEAR(mean(19) - mean(10), 0, 0.2);
  p.detector.jump = 0, p.detector.jump_pattern = 0.05;
  const auto before = levels(*film(scene, p, 4), 9, 1), after = levels(*film(scene, p, 4), 10, 1);
  double square = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    square += std::pow(after[i] - before[i], 2) / static_cast<double>(before.size());
  EXPECT_NEAR(std::sqrt(square) / level_per_kelvin, 0.05, 0.003);
  const auto plate = uniform_film(p, 296, 20, 4);
  EXPECT_EQ(levels(*plate, 0, 1), levels(*plate, 19, 1)) << "black-body references are filmed at another time";
}

}  // namespace
}  // namespace arenite::camera
