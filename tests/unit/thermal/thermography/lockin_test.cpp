#include "thermal/thermography/lockin.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/oscillating_film.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {
namespace {

using test::OscillatingFilm;

LockinOptions at(double frequency) {
  LockinOptions o;
  o.frequency = frequency;
  return o;
}

TEST(LockIn, SameBitsWhateverTheThreadsAndBlocks) {
  OscillatingFilm film;
  film.width = 67, film.height = 41;  // no multiple of what the machine takes at once
  film.noise = 0.3;
  Film memory = film.draw();
  const LockinMaps one = lock_in(memory, at(3.001));
  for (const int threads : {2, 3}) {
    LockinOptions o = at(3.001);
    o.threads = threads;
    const LockinMaps more = lock_in(memory, o);
    EXPECT_EQ(one.frequency, more.frequency);
    EXPECT_EQ(one.in_phase, more.in_phase);
    EXPECT_EQ(one.residual, more.residual);
  }
  test::ReadFilm read(memory);
  EXPECT_EQ(lock_in(read, at(3.001)).in_phase, one.in_phase);
  EXPECT_EQ(read.frames_read, film.frames);  // one pass, though the frequency is refined
}

TEST(LockIn, KernelsAgree) {
  const std::size_t pixels = 101, frames = 37;
  std::vector<std::uint16_t> level(pixels * frames);
  std::vector<float> value(level.size()), reference(pixels, 7000), weights(frames * 6);
  RandomStream random(3, Purpose::test);
  for (std::size_t i = 0; i < level.size(); ++i)
    level[i] = static_cast<std::uint16_t>(7000 + random.below(900)), value[i] = level[i];
  for (auto& w : weights) w = static_cast<float>(random.uniform(-1, 1));
  const std::size_t size = 4 * chunk * 9;
  std::vector<float> expected(size);
  kernels("portable")
      ->add_levels({level.data(), pixels, frames, weights.data(), 6, reference.data()}, expected.data(), 9 * chunk, 0,
                   pixels);
  double exact = 0;
  for (std::size_t n = 0; n < frames; ++n)
    exact += static_cast<double>(weights[n * 6 + 2]) * (static_cast<double>(level[n * pixels + 70]) - 7000);
  EXPECT_NEAR(expected[2 * chunk * 9 + 3 * chunk + 6], exact, 1e-2);
  for (const char* name : {"avx2", "avx512"})
    if (const Kernels* k = kernels(name)) {
      std::vector<float> levels(size), values(size);
      k->add_levels({level.data(), pixels, frames, weights.data(), 6, reference.data()}, levels.data(), 9 * chunk, 0,
                    pixels);
      k->add_values({value.data(), pixels, frames, weights.data(), 6, reference.data()}, values.data(), 9 * chunk, 0,
                    pixels);
      EXPECT_EQ(levels, values) << name;
      for (std::size_t i = 0; i < size; ++i) EXPECT_NEAR(levels[i], expected[i], 1e-6f * 4e6f) << name << " " << i;
    }
}

TEST(LockIn, KernelsFitAsOneWouldByHand) {
  const std::size_t pixels = 101, segments = 3, planes = 9, rows = 15, apart = 128, count = segments * planes;
  RandomStream random(5, Purpose::test);
  std::vector<float> sums(4 * chunk * count);
  for (float& v : sums) v = static_cast<float>(random.uniform(-1, 1));
  std::vector<double> coefficient(rows * count), normal(rows * rows);
  for (double& v : coefficient) v = random.uniform(-1, 1);
  for (std::size_t m = 0; m < rows; ++m)
    for (std::size_t n = 0; n <= m; ++n) normal[m * rows + n] = normal[n * rows + m] = random.uniform(-1, 1);
  const double frames[] = {7, 9, 8};
  const SegmentView view{sums.data(), segments, planes};
  const auto plane = [&](std::size_t p, std::size_t s, std::size_t k) {
    return static_cast<double>(sums[view.at(p, s, k)]);
  };
  for (const char* name : {"portable", "avx2", "avx512"})
    if (const Kernels* k = kernels(name)) {
      std::vector<double> fitted(rows * apart), left(apart);
      k->combine(view, coefficient.data(), rows, fitted.data(), apart, 0, pixels);
      k->residual(view, frames, normal.data(), rows, fitted.data(), apart, left.data(), 0, pixels);
      for (const std::size_t p : {0, 70, 100}) {
        double rest = 0;
        for (std::size_t m = 0; m < rows; ++m) {
          double sum = 0;
          for (std::size_t q = 0; q < count; ++q) sum += coefficient[m * count + q] * plane(p, q / planes, q % planes);
          EXPECT_NEAR(fitted[m * apart + p], sum, 1e-12) << name << " " << m;
          for (std::size_t n = 0; n < rows; ++n)
            rest -= normal[m * rows + n] * fitted[m * apart + p] * fitted[n * apart + p];
        }
        for (std::size_t s = 0; s < segments; ++s) {
          const double step = plane(p, s, planes - 1);
          rest += plane(p, s, planes - 2) + 2 * step * plane(p, s, 0) + frames[s] * step * step;
        }
        EXPECT_NEAR(left[p], rest, 1e-10) << name << " " << p;
      }
    }
}

TEST(LockIn, KernelsStepAsOneWouldByHand) {
  const std::size_t pixels = 37, frames = 25, reach = 11, at = 13;
  RandomStream random(7, Purpose::test);
  std::vector<double> value(pixels * frames), weight(reach);
  for (double& v : value) v = random.uniform(-1, 1);
  for (double& v : weight) v = random.uniform(-1, 1);
  for (const char* name : {"portable", "avx2", "avx512"})
    if (const Kernels* k = kernels(name)) {
      std::vector<double> step(pixels);
      k->steps(value.data() + at * pixels, pixels, weight.data(), reach, step.data());
      for (std::size_t p = 0; p < pixels; ++p) {
        double sum = 0;
        for (std::size_t n = 0; n < reach; ++n)
          sum += weight[n] * (value[(at + n) * pixels + p] - value[(at - 1 - n) * pixels + p]);
        EXPECT_NEAR(step[p], sum, 1e-14) << name << " " << p;
      }
    }
}

void expect_refused(Film film, const LockinOptions& o, const char* word) {
  try {
    lock_in(film, o);
    ADD_FAILURE() << "not refused: " << word;
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 1u);
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(LockIn, RefusesFilmsThatShowNoCycle) {
  const OscillatingFilm film;
  expect_refused(film.draw(), at(30), "but an oscillation at 3");
  expect_refused(film.draw(), at(74), "Nyquist");
  expect_refused(film.draw(), at(90), "Nyquist");
  expect_refused(film.draw(), at(0.1), "cycles");
  expect_refused(film.draw(), at(0), "above 0 Hz");
  expect_refused(film.draw(), at(-3), "above 0 Hz");
  Film constant = film.draw();
  std::fill(constant.value.begin(), constant.value.end(), 3.f);
  expect_refused(constant, at(3), "constant");
  Film unknown = film.draw();
  unknown.about.frame_rate = 0;
  expect_refused(unknown, at(3), "frame rate");
  LockinOptions o = at(3);
  o.harmonics = 9;
  expect_refused(film.draw(), o, "harmonics");
  Film falling = film.draw();
  falling.about.time = frame_times(falling.about);
  falling.about.time[5] = falling.about.time[4];
  expect_refused(falling, at(3), "time stamp");
}

TEST(LockIn, HarmonicsAboveTheNyquistFrequencyAreLeftOut) {
  OscillatingFilm film;
  film.frequency = 40;
  Film memory = film.draw();
  const LockinMaps maps = lock_in(memory, at(40));
  EXPECT_EQ(maps.harmonics, 1);
  EXPECT_TRUE(maps.second_harmonic.empty());
  EXPECT_NEAR(maps.amplitude[3], film.amplitude_of(3), 1e-5);
}

TEST(LockIn, PhaseAfterTheLoadIsWithinHalfATurn) {
  constexpr double pi = std::numbers::pi;
  LockinMaps maps;
  maps.reference_phase = 0.5;
  maps.phase = {1.0F, 0.5F, static_cast<float>(0.5 - 0.99 * pi), static_cast<float>(3.0 * pi), -3.0F};
  const double wanted[] = {0.5, 0, -0.99 * pi, pi - 0.5, 2 * pi - 3.5};
  const std::vector<float> found = phase_after_load(maps);
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(static_cast<double>(found[k]), wanted[k], 1e-6);
}

TEST(LockIn, OneCycleIsEnough) {
  OscillatingFilm film;
  film.frames = 50;  // 1.01 cycles
  Film memory = film.draw();
  LockinOptions o = at(3);
  o.refine = false;
  o.drift_order = 1;
  EXPECT_NEAR(lock_in(memory, o).amplitude[3], film.amplitude_of(3), 1e-4);
}

TEST(LockIn, StopsWhenAskedTo) {
  OscillatingFilm film;
  Film memory = film.draw();
  LockinOptions o = at(3);
  o.progress = [](double) { return false; };
  EXPECT_EQ(lock_in(memory, o).size(), 0u);
}

TEST(LockIn, PixelsWithoutNumbersSpoilNoOthers) {
  OscillatingFilm film;
  Film memory = film.draw();
  for (std::size_t n = 0; n < film.frames; ++n) memory.value[n * 45 + 7] = std::nanf("");
  const LockinMaps maps = lock_in(memory, at(3.001));
  EXPECT_TRUE(std::isnan(maps.in_phase[7]));
  EXPECT_NEAR(maps.frequency, 3, 1e-6);
  EXPECT_NEAR(maps.amplitude[8], film.amplitude_of(8), 1e-5);
}

}  // namespace
}  // namespace arenite::thermography
