#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "support/correlated_noise.hpp"
#include "support/oscillating_film.hpp"
#include "support/sentences.hpp"
#include "thermal/thermography/step/step_load.hpp"

namespace {
using namespace arenite;
using namespace arenite::thermography;

/// 24 x 20 pixels, 148 frames a second for 6 s. Pixels jump by 45 to 85 mK, 65 on the mean, as the load goes from 0 to
/// 1 by `done` (of the time since the step, s), seen by frames that integrate over their time; then heat flows.
struct RisingFilm {
  int width = 24, height = 20;
  std::size_t frames = 888;
  double rate = 148, noise = 0, heat = 0, drift = 0.02;
  std::function<double(double)> done = [](double since) { return since < 0 ? 0.0 : 1.0; };
  double step = 3 + 0.5 / 148;  // in the middle of a frame
  std::uint64_t seed = 1;
  std::vector<double> time = {};

  static double jump(std::size_t p) { return 0.045 + 0.005 * static_cast<double>(p % 9); }
  double at(std::size_t p, double t) const {
    constexpr int parts = 16;  // of a frame's time
    double sum = 0;
    for (int k = 0; k < parts; ++k) {
      const double since = t + ((k + 0.5) / parts - 0.5) / rate - step;
      sum += done(since) * (heat > 0 && since > 0 ? std::exp(-since / heat) : 1) / parts;
    }
    return 300 + static_cast<double>(p % 13) + drift * t + jump(p) * sum;
  }
};

struct Found {
  double jump = 0;    ///< mean of all pixels
  double errors = 0;  ///< root mean square of the pixels' errors over those that are told
  StepMaps maps = {};
};

Found found(const RisingFilm& of, const test::CorrelatedNoise& noise, const StepOptions& options = {}) {
  Film film = test::draw_film(of);
  noise.add_to(film);
  Found f;
  f.maps = step_load(film, options);
  const double pixels = static_cast<double>(f.maps.size());
  for (std::size_t p = 0; p < f.maps.size(); ++p) {
    f.jump += static_cast<double>(f.maps.jump[p]) / pixels;
    f.errors +=
        std::pow((static_cast<double>(f.maps.jump[p]) - of.jump(p)) / static_cast<double>(f.maps.standard_error[p]),
                 2) /
        pixels;
  }
  f.errors = std::sqrt(f.errors);
  return f;
}

TEST(StepRise, AFrameHalfWayIsNoHeatThatFlows) {
  for (const double noise : {0.001, 0.02, 0.05})
    for (const double part : {0.1, 0.5, 0.9}) {
      RisingFilm of;
      of.step = 3 + (part - 0.5) / 148;  // within the frame at 3 s
      const Found f = found(of, {noise, 0, 0.0, 7});
      EXPECT_NEAR(f.jump, 0.065, 0.003) << noise << " " << part;
      EXPECT_LT(f.errors, 1.2) << noise << " " << part;
      EXPECT_NEAR(f.maps.time, of.step, 0.6 / 148) << noise << " " << part;
      EXPECT_LT(f.maps.rise, 2.5 / 148);
    }
}

TEST(StepRise, TheTimeThatALoadTakesIsFoundAndLeftOut) {
  const auto ramp = [](double since) { return std::clamp(since / 0.1 + 0.5, 0.0, 1.0); };
  const auto smooth = [&](double since) { return 0.5 - 0.5 * std::cos(3.14159265 * ramp(since)); };
  const auto slow = [](double since) { return since < 0 ? 0 : 1 - std::exp(-since / 0.03); };
  for (const double heat : {0.0, 2.0})
    for (const auto& done : {std::function<double(double)>(ramp), std::function<double(double)>(smooth),
                             std::function<double(double)>(slow)}) {
      RisingFilm of;
      of.done = done, of.heat = heat;
      const Found f = found(of, {0.02, 0, 0.0, 5});
      EXPECT_NEAR(f.jump, 0.065, 0.003) << heat;
      EXPECT_GT(f.maps.rise, 0.05) << heat;
      EXPECT_LT(f.maps.rise, 0.25) << heat;
      EXPECT_NE(test::all_of(f.maps.doubts).find("on its way"), std::string::npos) << heat;
    }
}

TEST(StepRise, NoiseThatPixelsShareIsNoRise) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RisingFilm of;
    of.step = 3 - 0.5 / 148;  // between two frames
    const Found f = found(of, {0.02, 0.01, 0.6, seed + 5});
    EXPECT_EQ(f.maps.rise, 0) << seed;
    EXPECT_NEAR(f.jump, 0.065, 0.02) << seed;
    EXPECT_TRUE(f.maps.doubts.empty()) << seed << test::all_of(f.maps.doubts);
  }
}

TEST(StepRise, AWrongTimeIsTold) {
  RisingFilm of;
  of.step = 3 - 0.5 / 148;
  StepOptions options;
  options.time = 3.08;
  const Found f = found(of, {0.02, 0, 0.0, 5}, options);
  EXPECT_NE(test::all_of(f.maps.doubts).find("not at the given"), std::string::npos) << test::all_of(f.maps.doubts);
  EXPECT_NEAR(f.jump, 0.065, 0.004);
  options.time = of.step;
  EXPECT_TRUE(found(of, {0.02, 0, 0.0, 5}, options).maps.doubts.empty());
}

TEST(StepRise, ASecondStepIsTold) {
  RisingFilm of;
  of.done = [](double since) { return since < 0 ? 0.0 : since < 1.7 ? 1.0 : 0.4; };
  StepOptions options;
  options.time = of.step;
  const Found f = found(of, {0.02, 0, 0.0, 5}, options);
  EXPECT_NE(test::all_of(f.maps.doubts).find("jump again at 4.7"), std::string::npos) << test::all_of(f.maps.doubts);
  options.window = 1.5;
  const Found one = found(of, {0.02, 0, 0.0, 5}, options);
  EXPECT_EQ(test::all_of(one.maps.doubts).find("again"), std::string::npos) << test::all_of(one.maps.doubts);
  EXPECT_NEAR(one.jump, 0.065, 0.003);
}

/// A camera's shutter closes during the film: pixels get new offsets, before or after the step, larger or smaller than
/// it.
TEST(StepRise, LevelsThatJumpAreFittedAndTold) {
  for (const double at : {1.3, 4.6})
    for (const double size : {0.02, 0.1, -0.5}) {
      RisingFilm of;
      of.step = 3 - 0.5 / 148;
      Film film = test::draw_film(of);
      test::CorrelatedNoise{0.02, 0, 0.0, 5}.add_to(film);
      const std::size_t pixels = film.about.pixels(), from = static_cast<std::size_t>(at * of.rate);
      for (std::size_t k = from * pixels; k < film.value.size(); ++k) film.value[k] += static_cast<float>(size);
      const StepMaps maps = step_load(film, {});
      double jump = 0, square = 0;
      for (std::size_t p = 0; p < pixels; ++p) {
        const double off = static_cast<double>(maps.jump[p]) - of.jump(p);
        jump += static_cast<double>(maps.jump[p]) / static_cast<double>(pixels);
        square += std::pow(off / static_cast<double>(maps.standard_error[p]), 2) / static_cast<double>(pixels);
      }
      EXPECT_NEAR(maps.time, of.step, 1 / of.rate) << size;
      EXPECT_NEAR(jump, 0.065, 0.002) << size;
      EXPECT_LT(std::sqrt(square), 1.2) << size;
      ASSERT_EQ(maps.level_jumps.size(), 1U) << size;
      EXPECT_NEAR(maps.level_jumps[0], static_cast<double>(from) / of.rate, 1 / of.rate) << size;
      EXPECT_NE(test::all_of(maps.doubts).find("jump again at"), std::string::npos) << test::all_of(maps.doubts);
    }
}

TEST(StepRise, ALoadThatCreepsIsTold) {
  RisingFilm of;
  of.done = [](double since) { return since < 0 ? 0 : 1 - 0.3 * std::exp(-since / 0.5); };
  const Found f = found(of, {0.01, 0, 0.0, 5});
  EXPECT_NE(test::all_of(f.maps.doubts).find("creeps"), std::string::npos) << test::all_of(f.maps.doubts);
}

}  // namespace
