#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "thermal/thermography/load_signal.hpp"

namespace arenite::thermography {
namespace {

struct Recorded {
  std::vector<double> time, signal;
};

/// Ten seconds at 148 Hz with a gap, a slow drift and noise; `square`: the sign of the cosine.
Recorded record(double frequency, double phase, bool square = false, double noise = 5) {
  Recorded r;
  RandomStream random(3, Purpose::camera_noise);
  for (int k = 0; k < 1480; ++k) {
    if (k > 700 && k < 720) continue;
    const double t = k / 148.0, c = std::cos(2 * std::numbers::pi * frequency * t - phase);
    r.time.push_back(t);
    r.signal.push_back(8000 + 20 * t + 1000 * (square ? std::copysign(1.0, c) : c) + noise * random.normal());
  }
  return r;
}

TEST(LoadSignal, TellsFrequencyAndPhaseWithTheirErrors) {
  for (const double given : {3.0, 3.5, 2.1}) {
    const auto r = record(3.003, 2.5);
    const auto found = fit_load_signal(r.time, r.signal, given);
    ASSERT_TRUE(found) << given;
    EXPECT_NEAR(found->frequency, 3.003, 4 * found->frequency_error);
    EXPECT_LT(found->frequency_error, 1e-4);
    EXPECT_NEAR(found->phase, 2.5, 0.002);
  }
}

TEST(LoadSignal, ASquareWaveDoesAsWell) {
  const auto r = record(3.003, -1, true);
  const auto found = fit_load_signal(r.time, r.signal, 3);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->frequency, 3.003, 0.003);
  EXPECT_NEAR(found->phase, -1, 0.05);
}

TEST(LoadSignal, WhatDoesNotCycleTellsNothing) {
  const auto r = record(0, 0, false, 500);
  EXPECT_FALSE(fit_load_signal(r.time, r.signal, 3));
  EXPECT_FALSE(fit_load_signal({0, 1, 2}, {1, 2, 1}, 3));
  const auto slow = record(0.1, 0);  // less than two cycles
  EXPECT_FALSE(fit_load_signal(slow.time, slow.signal, 0.1));
}

}  // namespace
}  // namespace arenite::thermography
