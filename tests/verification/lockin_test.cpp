#include "thermal/thermography/lockin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "../support/oscillating_film.hpp"

namespace arenite::thermography {
namespace {

using test::OscillatingFilm;

double rms(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum / static_cast<double>(v.size()));
}

LockinOptions at(double frequency, bool refine = true) {
  LockinOptions o;
  o.frequency = frequency;
  o.refine = refine;
  return o;
}

/// Largest errors of amplitude (relative) and phase over all pixels.
std::pair<double, double> worst(const LockinMaps& maps, const OscillatingFilm& truth, double factor = 1) {
  double amplitude = 0, phase = 0;
  for (std::size_t p = 0; p < maps.size(); ++p) {
    amplitude =
        std::max(amplitude, std::abs(static_cast<double>(maps.amplitude[p]) / (factor * truth.amplitude_of(p)) - 1));
    phase = std::max(
        phase, std::abs(std::remainder(static_cast<double>(maps.phase[p]) - truth.phase_of(p), 2 * std::numbers::pi)));
  }
  return {amplitude, phase};
}

OscillatingFilm drifting() {
  OscillatingFilm f;
  f.frames = 777;  // 15.75 cycles
  f.drift = 0.7;
  f.curve = -0.05;
  f.second = 0.3;
  return f;
}

TEST(LockIn, FindsAmplitudeAndPhaseOffTheBinWithDriftAndHarmonics) {
  const OscillatingFilm truth = drifting();
  Film film = truth.draw();
  const LockinMaps maps = lock_in(film, at(3, false));
  const auto [amplitude, phase] = worst(maps, truth);
  EXPECT_LT(amplitude, 2e-6);  // a film of single precision around 50
  EXPECT_LT(phase, 2e-6);
  EXPECT_NEAR(maps.second_harmonic[7], 0.3 * truth.amplitude_of(7), 2e-6);
  const double middle = 776 / 148.0 / 2;
  EXPECT_NEAR(maps.mean[7], 20 + 7 + 0.7 * middle - 0.05 * middle * middle, 1e-5);
  EXPECT_NEAR(maps.drift[7], 0.7 - 2 * 0.05 * middle, 1e-5);
  EXPECT_LT(*std::max_element(maps.residual.begin(), maps.residual.end()), 1e-3);  // root of a rounded sum of squares
}

TEST(LockIn, FindsTheFrequencyThatTheFilmHas) {
  for (const double given : {3.0, 3.003, 2.997, 3.02, 2.95}) {
    OscillatingFilm truth = drifting();
    truth.frames = 4001;
    truth.width = 4;
    truth.frequency = 3.000123;
    Film film = truth.draw();
    const LockinMaps maps = lock_in(film, at(given));
    EXPECT_NEAR(maps.frequency, truth.frequency, 1e-7) << given;
    const auto [amplitude, phase] = worst(maps, truth);
    EXPECT_LT(amplitude, 1e-5) << given;
    EXPECT_LT(phase, 2e-5) << given;
  }
}

/// Smallest standard error of a frequency from N frames in T seconds with white noise s and amplitudes a that is
/// possible: sqrt(24/(N sum a^2)) s/(2 pi T), Hz.
double cramer_rao(const OscillatingFilm& f) {
  double power = 0;
  for (std::size_t p = 0; p < static_cast<std::size_t>(f.width * f.height); ++p)
    power += f.amplitude_of(p) * f.amplitude_of(p);
  const auto frames = static_cast<double>(f.frames);
  return std::sqrt(24 / frames / power) * f.noise / (2 * std::numbers::pi * frames / f.rate);
}

TEST(LockIn, FindsTheFrequencyOfManyCyclesFarFromTheNominal) {
  OscillatingFilm truth;
  truth.width = 3, truth.height = 2;
  truth.frames = 40000;  // 1351 cycles: a nominal frequency that is 1e-3 off loses more than one of them
  truth.rate = 74, truth.frequency = 2.5 * (1 + 1e-3);
  truth.noise = 1;
  Film film = truth.draw();
  const LockinMaps maps = lock_in(film, at(2.5));
  EXPECT_NEAR(maps.frequency, truth.frequency, 5 * maps.frequency_error);
  EXPECT_NEAR(maps.frequency_error / cramer_rao(truth), 1, 0.05);
}

TEST(LockIn, ErrorIsTheNoiseTimesRootOfTwoOverFrames) {
  OscillatingFilm truth;
  truth.width = 32, truth.height = 32;
  truth.noise = 0.020, truth.amplitude = 0.030;
  truth.frames = 800;
  Film film = truth.draw();
  const LockinMaps maps = lock_in(film, at(3));
  std::vector<double> in_phase, reported;
  for (std::size_t p = 0; p < maps.size(); ++p) {
    in_phase.push_back(static_cast<double>(maps.in_phase[p]) -
                       truth.amplitude_of(p) * std::cos(truth.phase_of(p) - maps.reference_phase));
    reported.push_back(static_cast<double>(maps.standard_error[p]));
  }
  EXPECT_NEAR(rms(in_phase), 0.020 * std::sqrt(2.0 / 800), 0.06e-3);
  EXPECT_NEAR(rms(reported), 0.020 * std::sqrt(2.0 / 800), 0.02e-3);
  EXPECT_NEAR(rms(reported), 1e-3, 0.02e-3);
}

TEST(LockIn, NoiseFloorIsWhatPixelsWithoutLoadShow) {
  OscillatingFilm truth;
  truth.width = 40, truth.height = 30;
  truth.noise = 0.020, truth.amplitude = 0;
  Film film = truth.draw();
  const LockinMaps maps = lock_in(film, at(3, false));
  double shown = 0, reported = 0;
  for (std::size_t p = 0; p < maps.size(); ++p)
    shown += static_cast<double>(maps.amplitude[p]), reported += static_cast<double>(maps.noise_floor[p]);
  EXPECT_NEAR(shown / reported, 1, 0.05);
}

TEST(LockIn, FrequencyIsAsGoodAsTheCramerRaoBound) {
  std::vector<double> off;
  OscillatingFilm truth;
  truth.width = 8, truth.height = 4;
  truth.frames = 1000;
  truth.noise = 0.5;
  double reported = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    truth.seed = seed;
    Film film = truth.draw();
    const LockinMaps maps = lock_in(film, at(3.003));
    off.push_back(maps.frequency - truth.frequency);
    reported += maps.frequency_error / 60;  // each from its own film's noise, of 32 pixels
  }
  const double bound = cramer_rao(truth);
  EXPECT_NEAR(reported / bound, 1, 0.05);
  EXPECT_NEAR(rms(off) / bound, 1, 0.3);  // 60 draws: 9 % standard error
}

TEST(LockIn, AFilmOfNoiseKeepsTheNominalFrequencyOrSaysHowUnsureItIs) {
  OscillatingFilm truth;
  truth.amplitude = 0, truth.noise = 1;
  Film film = truth.draw();
  const LockinMaps maps = lock_in(film, at(3));
  EXPECT_TRUE(maps.frequency == 3 || maps.frequency_error > 1e-3) << maps.frequency << " " << maps.frequency_error;
}

TEST(LockIn, WildPixelsDoNotMoveTheFrequency) {
  OscillatingFilm truth;
  truth.noise = 0.02, truth.frames = 2000;
  Film film = truth.draw();
  RandomStream random(5, Purpose::test);
  for (std::size_t n = 0; n < truth.frames; ++n) {
    film.value[n * 45 + 3] = static_cast<float>(5000 * random.uniform());
    film.value[n * 45 + 4] = 17;
  }
  const LockinMaps maps = lock_in(film, at(3.002));
  EXPECT_NEAR(maps.frequency, 3, 5 * maps.frequency_error);
  EXPECT_LT(maps.frequency_error, 1.1 * cramer_rao(truth));
}

TEST(LockIn, DroppedFramesAreSeenFromTheTimes) {
  OscillatingFilm truth = drifting();
  for (std::size_t n = 0; n < 2500; ++n)
    if (n % 97 > 4 && (n < 900 || n > 1333)) truth.time.push_back(static_cast<double>(n) / truth.rate);
  Film film = truth.draw();
  const auto [amplitude, phase] = worst(lock_in(film, at(3.001)), truth);
  EXPECT_LT(amplitude, 1e-5);
  EXPECT_LT(phase, 1e-5);
  film.about.time.clear();  // as if no frame were missing
  EXPECT_GT(worst(lock_in(film, at(3, false)), truth).first, 0.05);
}

TEST(LockIn, DigitalLevelsGiveWhatFloatsGive) {
  OscillatingFilm truth = drifting();
  truth.mean = 8000, truth.amplitude = 12;
  truth.noise = 2;
  Film floats = truth.draw(), levels = truth.levels(1);
  for (std::size_t n = 0; n < floats.value.size(); ++n) floats.value[n] = static_cast<float>(levels.level[n]);
  const LockinMaps a = lock_in(floats, at(3)), b = lock_in(levels, at(3));
  EXPECT_EQ(a.in_phase, b.in_phase);
  EXPECT_EQ(a.residual, b.residual);
  EXPECT_EQ(a.frequency, b.frequency);
}

TEST(LockIn, LevelsFarFromZeroLoseNothingToRounding) {
  OscillatingFilm truth = drifting();
  truth.frames = 6000;
  truth.mean = 60000, truth.amplitude = 8, truth.drift = 2, truth.curve = 0;
  truth.noise = 3;
  Film film = truth.levels(1);
  const LockinMaps maps = lock_in(film, at(3, false));
  for (const std::size_t p : {0u, 13u, 44u}) {  // beside plain sums in double precision, less the drift that was drawn
    std::complex<double> sum = 0;
    for (std::size_t n = 0; n < truth.frames; ++n) {
      const double t = truth.when(n), rest = static_cast<double>(film.level[n * 45 + p]) - truth.mean -
                                             static_cast<double>(p) - truth.drift * t;
      sum += rest * std::polar(1.0, 2 * std::numbers::pi * 3 * t);
    }
    EXPECT_NEAR(maps.amplitude[p], std::abs(sum) / 3000, 0.1 * static_cast<double>(maps.standard_error[p])) << p;
    EXPECT_NEAR(maps.residual[p], std::sqrt(9 + 1.0 / 12), 0.1) << p;
  }
}

TEST(LockIn, PeakToPeakIsTwiceTheAmplitude) {
  const OscillatingFilm truth = drifting();
  Film film = truth.draw();
  LockinOptions o = at(3, false);
  o.convention = AmplitudeConvention::peak_to_peak;
  const LockinMaps full = lock_in(film, o), half = lock_in(film, at(3, false));
  EXPECT_LT(worst(full, truth, 2).first, 2e-6);
  EXPECT_EQ(full.convention, AmplitudeConvention::peak_to_peak);
  EXPECT_FLOAT_EQ(full.in_phase[3], 2 * half.in_phase[3]);
  EXPECT_FLOAT_EQ(full.second_harmonic[3], 2 * half.second_harmonic[3]);
  EXPECT_FLOAT_EQ(full.standard_error[3], 2 * half.standard_error[3]);
  EXPECT_EQ(full.residual[3], half.residual[3]);
}

TEST(LockIn, SignsFollowTheReference) {
  OscillatingFilm truth;
  truth.phase = 0.5;  // even pixels +0.5 rad, odd ones -0.5 rad
  Film film = truth.draw();
  LockinOptions o = at(3, false);
  o.reference_phase = 0.5;
  const LockinMaps reported = lock_in(film, o);
  EXPECT_NEAR(reported.in_phase[2], truth.amplitude_of(2), 1e-5);
  EXPECT_NEAR(reported.quadrature[2], 0, 1e-5);
  EXPECT_NEAR(reported.in_phase[3], truth.amplitude_of(3) * std::cos(1.0), 1e-5);
  EXPECT_NEAR(reported.quadrature[3], -truth.amplitude_of(3) * std::sin(1.0), 1e-5);
  for (const double c : {1.0, 0.3, -2.0}) {  // most pixels follow the load, some the other way
    EXPECT_NEAR(std::remainder(reference_phase({3 * std::cos(c), -std::cos(c), 2 * std::cos(c)},
                                               {3 * std::sin(c), -std::sin(c), 2 * std::sin(c)}) -
                                   c,
                               2 * std::numbers::pi),
                0, 1e-12);
  }
}

TEST(LockIn, NearestBinIsOffByUpToOneLessTwoOverPi) {
  OscillatingFilm truth;
  truth.width = 2, truth.height = 1;
  truth.frames = 148 * 40;
  for (const double off : {0.0, 0.25, 0.5}) {
    truth.frequency = 3 + off / 40;
    Film film = truth.draw();
    const LockinMaps plain = nearest_bin_transform(film, at(3.0));
    const double loss = off == 0 ? 1 : std::sin(std::numbers::pi * off) / (std::numbers::pi * off);
    EXPECT_NEAR(static_cast<double>(plain.amplitude[0]) / truth.amplitude_of(0), loss, 0.01) << off;
    EXPECT_NEAR(plain.frequency, 3, 1e-12);
    EXPECT_LT(worst(lock_in(film, at(3.0)), truth).first, 1e-5) << off;
  }
}

TEST(LockIn, NearestBinIsTheTransformOfTheFilmLessItsMeanImage) {
  OscillatingFilm truth = drifting();
  truth.noise = 0.1;
  Film film = truth.draw();
  const LockinMaps plain = nearest_bin_transform(film, at(3));
  const std::size_t p = 17, bin = 16;  // of 777 frames at 148 Hz, 3 Hz is 15.75
  double mean = 0;
  for (std::size_t n = 0; n < 777; ++n) mean += static_cast<double>(film.value[n * 45 + p]) / 777;
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < 777; ++n)
    sum += (static_cast<double>(film.value[n * 45 + p]) - mean) *
           std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(bin * n) / 777);
  EXPECT_NEAR(plain.amplitude[p], 2 * std::abs(sum) / 777, 1e-5);
  EXPECT_NEAR(plain.phase[p], std::arg(sum), 1e-5);
}

TEST(LockIn, DiffusionLengthOfPlasticAtThreeHertz) { EXPECT_NEAR(diffusion_length(1.0e-7, 3), 0.103e-3, 1e-6); }

}  // namespace
}  // namespace arenite::thermography
