#include "thermal/camera/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "thermal/camera/expose.hpp"
#include "thermal/camera/scene.hpp"
#include "thermal/camera/virtual_film.hpp"

namespace arenite::camera {
namespace {

/// One disk between two references, pressed by P, its centre at (x, 0); the frame is far away.
Packing pressed_disk(double force, double x = 0) {
  Packing packing;
  packing.materials = {{"POM", 1410, 27.35e6, 0.0150e-6}};
  packing.domain.thickness = 0.06;
  const double far[4] = {-0.2, 0.2, -0.2, 0.2};
  for (int side = 0; side < 4; ++side) packing.domain.wall[side].position = far[side];
  packing.grains.resize(1);
  packing.grains.position[0].x = x;
  packing.grains.radius[0] = 0.0155;
  packing.contacts.add(0, wall_partner(bottom), {0, 1}, force, 0, 0.0155, 0);
  packing.contacts.add(0, wall_partner(top), {0, -1}, force, 0, 0.0155, 0);
  return packing;
}

/// A camera without any fault, 64 x 64 pixels of 1.6 mm.
Parameters ideal() {
  Parameters p;
  p.optics.width = p.optics.height = 64;
  p.optics.blur = 0;
  p.detector.netd = p.detector.gain_spread = p.detector.offset_spread = p.detector.bad_share = 0;
  p.surroundings.drift = 0;
  p.surroundings.emissivity = {1};
  p.timing = {148, 148, 0, 1, 0, 0, 0};
  p.motion = false;
  return p;
}

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

/// Of the light at the centre of a grain, over many grains that differ by their seeds.
TEST(VirtualCamera, EmissivitiesOfGrainsScatter) {
  auto p = ideal();
  p.surroundings.ambient = 30;  // which sends no light into the band
  p.surroundings.emissivity = {0.8};
  const Scene scene = scene_of_state(pressed_disk(0), p);
  const auto centre = [&](std::uint64_t seed) { return static_cast<double>(expose(scene, p, 0, seed)[32 * 64 + 32]); };
  EXPECT_EQ(centre(1), centre(2));
  p.surroundings.emissivity_scatter = 0.05;
  double sum = 0, square = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    sum += centre(seed) / 200, square += centre(seed) * centre(seed) / 200;
  EXPECT_NEAR(sum, 0.8, 0.01);
  EXPECT_NEAR(std::sqrt(square - sum * sum) / sum, 0.05, 0.01);
}

/// Centroid of what is brighter than the background, pixels.
double centroid_x(const std::vector<float>& picture, float background) {
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const double v = static_cast<double>(picture[i] - background);
    sum += v;
    moment += v * static_cast<double>(i % 64);
  }
  return moment / sum;
}

TEST(VirtualCamera, GrainsTravelBetweenTheStates) {
  auto p = ideal();
  p.motion = true;
  p.surroundings.background_emissivity = p.surroundings.container_emissivity = 0.5;
  const Scene scene = scene_between(pressed_disk(0, -0.004), pressed_disk(0, 0.004), p);
  const auto at = [&](double s) {
    const auto picture = expose(scene, p, s);
    return centroid_x(picture, picture.front());
  };
  EXPECT_NEAR(at(0), 31.5 - 2.5, 0.02);
  EXPECT_NEAR(at(0.5), 31.5, 0.02);
  EXPECT_NEAR(at(1), 31.5 + 2.5, 0.02);
}

TEST(VirtualCamera, BlurKeepsTheLightAndSpreadsIt) {
  auto sharp = ideal(), soft = ideal();
  soft.optics.blur = 0.7;
  const Scene scene = scene_of_state(pressed_disk(0), sharp);
  const auto a = expose(scene, sharp, 0), b = expose(scene, soft, 0);
  double sum_a = 0, sum_b = 0, steepest_a = 0, steepest_b = 0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    sum_a += static_cast<double>(a[i]);
    sum_b += static_cast<double>(b[i]);
    steepest_a = std::max(steepest_a, static_cast<double>(std::abs(a[i] - a[i - 1])));
    steepest_b = std::max(steepest_b, static_cast<double>(std::abs(b[i] - b[i - 1])));
  }
  EXPECT_NEAR(sum_b / sum_a, 1, 1e-5);
  EXPECT_LT(steepest_b, 0.75 * steepest_a);
}

/// Each pixel keeps its share of the light, and the rest goes round it as a Gaussian does, summed here pixel by pixel.
TEST(VirtualCamera, ALensScattersLightIntoAHalo) {
  auto sharp = ideal();
  const Scene scene = scene_of_state(pressed_disk(0, 0.03), sharp);  // near the edge of the picture
  auto lens = sharp;
  lens.optics.halo = 0.2, lens.optics.halo_width = 3;
  sharp.optics.width = sharp.optics.height = 64 + 2 * 15;
  const auto wide = expose(scene, sharp, 0), seen = expose(scene, lens, 0);
  for (const int row : {5, 31, 40})
    for (int column = 0; column < 64; column += 3) {
      double light = 0, all = 0;
      for (int dy = -15; dy <= 15; ++dy)
        for (int dx = -15; dx <= 15; ++dx) {
          const double weight = std::exp(-(dx * dx + dy * dy) / 18.0);
          light +=
              weight * static_cast<double>(wide[static_cast<std::size_t>((row + 15 + dy) * 94 + column + 15 + dx)]);
          all += weight;
        }
      const auto own = static_cast<double>(wide[static_cast<std::size_t>((row + 15) * 94 + column + 15)]);
      EXPECT_NEAR(seen[static_cast<std::size_t>(row * 64 + column)], 0.8 * own + 0.2 * light / all, 1e-4)
          << row << " " << column;
    }
}

TEST(VirtualCamera, StatesOfDifferentGrainsAreRefused) {
  auto other = pressed_disk(1000);
  other.grains.radius[0] *= 1.01;
  EXPECT_THROW(scene_between(pressed_disk(1000), other, ideal()), InputError);
}

TEST(VirtualCamera, WhatWouldTakeHoursIsRefusedAtOnce) {
  const auto refusal = [](const auto& change) -> std::string {
    Parameters p = ideal();
    change(p);
    try {
      const Scene scene = scene_of_state(pressed_disk(1e4), p);
      optical_picture(scene, p, {0.5}, 1);
      film(scene, p, 1);
    } catch (const InputError& error) { return error.what(); }
    return "";
  };
  EXPECT_EQ(refusal([](Parameters&) {}), "");
  EXPECT_NE(refusal([](Parameters& p) { p.optics.pixel = 1e-9; }).find("raise camera.pixel"), std::string::npos);
  EXPECT_NE(refusal([](Parameters& p) { p.photograph.pixel = 1e-12; }).find("optical_pixel"), std::string::npos);
  EXPECT_NE(refusal([](Parameters& p) { p.photograph.pixel = 1e50; }).find("optical_pixel"), std::string::npos);
  EXPECT_NE(refusal([](Parameters& p) {
              p.optics.width = p.optics.height = 8192, p.optics.pixel = p.photograph.pixel = 1e-2;
            }).find("too large"),
            std::string::npos);
  EXPECT_NE(refusal([](Parameters& p) {
              p.optics.width = p.optics.height = 7000, p.optics.supersampling = 1, p.photograph.pixel = 0.5;
            }).find("GB"),
            std::string::npos);
}

TEST(VirtualCamera, MaterialWithoutFactorIsRefused) {
  auto packing = pressed_disk(1000);
  packing.materials[0].thermoelastic_factor = 0;
  EXPECT_THROW(scene_of_state(packing, ideal()), InputError);
}

}  // namespace
}  // namespace arenite::camera
