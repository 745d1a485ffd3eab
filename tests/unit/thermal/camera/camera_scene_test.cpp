#include "thermal/camera/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "thermal/camera/expose.hpp"
#include "thermal/camera/scene.hpp"
#include "thermal/camera/virtual_film.hpp"
#include "unit/thermal/camera/pressed_disk.hpp"

namespace arenite::camera {
namespace {

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
