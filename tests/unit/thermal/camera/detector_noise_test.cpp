#include "thermal/camera/detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "thermal/camera/camera.hpp"
#include "thermal/camera/virtual_film.hpp"

namespace arenite::camera {
namespace {

TEST(FrameNoise, IsCorrelatedAsTold) {
  for (const double correlation : {0.0, 0.5, 0.9}) {
    FrameNoise noise(20000, correlation);
    const std::vector<float> first = noise.of(3, 7), next = noise.of(3, 8), third = noise.of(3, 9);
    double square = 0, once = 0, twice = 0;
    for (std::size_t i = 0; i < 20000; ++i) {
      square += static_cast<double>(first[i]) * static_cast<double>(first[i]) / 20000;
      once += static_cast<double>(first[i]) * static_cast<double>(next[i]) / 20000;
      twice += static_cast<double>(first[i]) * static_cast<double>(third[i]) / 20000;
    }
    EXPECT_NEAR(square, 1, 0.03);
    EXPECT_NEAR(once, correlation, 0.03);
    EXPECT_NEAR(twice, correlation * correlation, 0.03);
  }
}

TEST(FrameNoise, IsTheSameInWhateverOrderFramesAreRead) {
  FrameNoise there(100, 0.7), back(100, 0.7);
  std::vector<std::vector<float>> frames;
  for (std::uint64_t n = 0; n < 6; ++n) frames.push_back(there.of(1, n));
  for (std::uint64_t n = 6; n-- > 0;) EXPECT_EQ(back.of(1, n), frames[n]) << n;
}

TEST(FlickerNoise, HasAsMuchPowerInEveryOctave) {
  constexpr std::size_t frames = 1024, places = 200;
  FlickerNoise noise(places, frames);
  std::vector<std::vector<float>> frame;
  for (std::uint64_t n = 0; n < frames; ++n) frame.push_back(noise.of(4, n));
  double square = 0;
  std::vector<double> octave(9, 0);  // of frequencies from 2^k cycles a film to twice that, by a plain Fourier sum
  for (std::size_t i = 0; i < places; ++i) {
    for (const auto& each : frame)
      square += static_cast<double>(each[i]) * static_cast<double>(each[i]) / (places * frames);
    if (i >= 40) continue;
    for (std::size_t k = 1; k < 512; ++k) {
      double c = 0, s = 0;
      for (std::size_t n = 0; n < frames; ++n) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k * n % frames) / frames;
        c += static_cast<double>(frame[n][i]) * std::cos(angle),
            s += static_cast<double>(frame[n][i]) * std::sin(angle);
      }
      octave[static_cast<std::size_t>(std::log2(static_cast<double>(k)))] +=
          2 * (c * c + s * s) / (40.0 * frames * frames);
    }
  }
  EXPECT_NEAR(square, 1, 0.1);
  double mean = 0, slope = 0;  // of the logarithm over the octaves from the second to the ninth
  for (std::size_t k = 1; k < octave.size(); ++k) {
    mean += std::log2(octave[k]) / 8;
    slope += std::log2(octave[k]) * (static_cast<double>(k) - 4.5) / 42;
  }
  EXPECT_NEAR(slope, 0, 0.1) << "the spectrum is f to the power of -1 + this";
  EXPECT_NEAR(std::exp2(mean), 1.0 / 12, 0.02);
}

TEST(FlickerNoise, IsTheSameInWhateverOrderFramesAreRead) {
  FlickerNoise there(20, 300), back(20, 300);
  std::vector<std::vector<float>> frames;
  for (std::uint64_t n = 0; n < 300; ++n) frames.push_back(there.of(1, n));
  for (std::uint64_t n = 300; n-- > 0;) EXPECT_EQ(back.of(1, n), frames[n]) << n;
}

Parameters camera_before_a_plate() {
  Parameters p;
  p.optics.width = 40, p.optics.height = 30;
  p.detector.gain_spread = p.detector.offset_spread = p.detector.bad_share = 0;
  return p;
}

std::vector<double> reference(const Parameters& p, std::int64_t frames) {
  const auto film = uniform_film(p, 296, frames, 5);
  FrameBlock block;
  film->read(0, static_cast<std::size_t>(frames), block);
  return {block.level.begin(), block.level.end()};
}

constexpr double levels_per_kelvin = 16383 * 6e6 / 1.2e7 * 10.6 / 296;

TEST(VirtualCamera, AllPixelsShareTheCommonNoise) {
  Parameters p = camera_before_a_plate();
  p.detector.netd = 0.001, p.detector.common_noise = 0.05;
  const std::vector<double> level = reference(p, 400);
  double mean = 0, square = 0;
  for (std::size_t n = 0; n < 400; ++n) mean += level[n * 1200 + 7] / 400;
  for (std::size_t n = 0; n < 400; ++n) square += std::pow(level[n * 1200 + 7] - mean, 2) / 400;
  EXPECT_NEAR(std::sqrt(square) / levels_per_kelvin, 0.05, 0.01);
  for (std::size_t n = 0; n < 5; ++n) EXPECT_NEAR(level[n * 1200 + 7], level[n * 1200 + 900], 5);
}

TEST(VirtualCamera, FlickerIsSharedByAllPixelsOrByColumns) {
  Parameters p = camera_before_a_plate();
  p.detector.netd = 0.001;
  p.timing.frames = 256;
  const auto change = [&](const std::vector<double>& level, std::size_t pixel) {
    return level[200 * 1200 + pixel] - level[3 * 1200 + pixel];
  };
  p.detector.common_flicker = 0.1;
  const std::vector<double> all = reference(p, 256);
  for (const std::size_t pixel : {8U, 47U, 900U}) EXPECT_NEAR(change(all, pixel), change(all, 7), 6) << pixel;
  p.detector.common_flicker = 0, p.detector.column_flicker = 0.1;
  const std::vector<double> columns = reference(p, 256);
  double square = 0, same = 0, other = 0;
  for (std::size_t c = 0; c < 39; ++c) {
    square += std::pow(change(columns, c), 2);
    same += change(columns, c) * change(columns, 25 * 40 + c);
    other += change(columns, c) * change(columns, c + 1);
  }
  EXPECT_NEAR(same / square, 1, 0.02);
  EXPECT_LT(std::abs(other / square), 0.5);
  EXPECT_NEAR(std::sqrt(square / 39) / levels_per_kelvin, 0.1 * std::sqrt(2.0), 0.05);
}

TEST(VirtualCamera, ALineGoesOverTheRows) {
  Parameters p = camera_before_a_plate();
  p.detector.netd = 0.001;
  p.interference = {37, 0.05, 0.25};
  p.timing.frame_rate = 148;  // four frames a cycle
  const std::vector<double> level = reference(p, 8);
  const double amplitude = 0.05 * levels_per_kelvin,
               rest = level[1200];  // a quarter of a cycle later, in the first row
  for (std::size_t row = 0; row < 8; ++row) {
    EXPECT_NEAR(level[row * 40] - rest, amplitude * std::cos(1.5707963 * static_cast<double>(row)), 4) << row;
    EXPECT_NEAR(level[row * 1200] - rest, amplitude * std::cos(1.5707963 * static_cast<double>(row)), 4) << row;
  }
}

TEST(VirtualCamera, TheSceneDriftsAsTold) {
  Surroundings around;
  around.drift = 0.01;
  EXPECT_DOUBLE_EQ(around.warmer(20), 0.2);
  around.drift_growth = 0.002;
  EXPECT_DOUBLE_EQ(around.warmer(20), 0.6);
  around.warm_up = 0.5, around.warm_up_time = 10;
  EXPECT_DOUBLE_EQ(around.warmer(10), 0.2 + 0.5 * (1 - std::exp(-1.0)));
  EXPECT_DOUBLE_EQ(around.warmer(0), 0);
  around = {};
  around.drift = 0, around.drift_wave = 0.3, around.drift_period = 20;
  EXPECT_DOUBLE_EQ(around.warmer(5), 0.3);
  EXPECT_NEAR(around.warmer(10), 0, 1e-12);
}

}  // namespace
}  // namespace arenite::camera
