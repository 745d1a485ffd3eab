// Films of real cameras (tests/data/infrared), against numbers from a program that shares nothing with the reader.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "io/film/film.hpp"
#include "support/films.hpp"

namespace arenite::io {
namespace {

struct Sums {
  std::uint64_t total = 0, weighted = 0;
};

Sums sums_of(const std::vector<std::uint16_t>& level) {
  Sums sums;
  for (std::size_t i = 0; i < level.size(); ++i) {
    sums.total += level[i];
    sums.weighted += std::uint64_t{level[i]} * (i % 65521);
  }
  return sums;
}

double deviation(const std::vector<double>& x, double degrees) {
  double mean = 0, sum = 0;
  for (const double v : x) mean += v / static_cast<double>(x.size());
  for (const double v : x) sum += (v - mean) * (v - mean);
  return std::sqrt(sum / degrees);
}

TEST(RealFilm, JadeFilmIsReadToTheByte) {
  const auto film = open_film(test::infrared("PyradiSampleMWIR.ptw"));
  const FilmInfo& info = film->info();
  EXPECT_EQ(info.format, "ptw");
  EXPECT_EQ(info.width, 69);
  EXPECT_EQ(info.height, 64);
  EXPECT_EQ(info.frames, 100);
  EXPECT_EQ(info.bits, 14);
  EXPECT_DOUBLE_EQ(info.frame_rate, 100);
  EXPECT_DOUBLE_EQ(info.integration, 0.0005);
  EXPECT_EQ(info.camera, "Jade");
  EXPECT_EQ(info.lens, "50 mm");
  EXPECT_EQ(info.filter, "NE_010%");
  EXPECT_EQ(info.emissivity, 1);
  EXPECT_NEAR(info.ambient, 293.15, 1e-4);
  EXPECT_NEAR(info.band_low, 1.5e-6, 1e-12);
  EXPECT_NEAR(info.band_high, 2.5e-6, 1e-12);
  ASSERT_EQ(info.remarks.size(), 1U);
  EXPECT_EQ(info.remarks[0],
            "Frames are stamped 0.03 s apart, while the film states a frame rate of 100 Hz; the stamps are used.");
  const Sums sums = sums_of(test::all_of(*film).level);
  EXPECT_EQ(sums.total, 2768458392U);
  EXPECT_EQ(sums.weighted, 88106186730267U);
}

TEST(RealFilm, JadeFilmOfABlackbodyIsReadToTheByte) {
  const auto film = open_film(test::infrared("LWIR-BBref-150C-150us.ptw"));
  EXPECT_EQ(film->info().width, 320);
  EXPECT_EQ(film->info().height, 240);
  EXPECT_DOUBLE_EQ(film->info().frame_rate, 50);
  EXPECT_DOUBLE_EQ(film->info().integration, 0.00015);
  const Sums sums = sums_of(test::all_of(*film).level);
  EXPECT_EQ(sums.total, 857518240U);
  EXPECT_EQ(sums.weighted, 25745999738158U);
}

TEST(RealFilm, NoiseInTimeAndPatternInSpace) {
  const auto film = open_film(test::infrared("PyradiSampleMWIR.ptw"));
  const FrameBlock block = test::all_of(*film);
  const std::size_t pixels = film->info().pixels();
  std::vector<double> noise, mean;
  for (std::size_t p = 0; p < pixels; ++p) {
    std::vector<double> course;
    double sum = 0;
    for (std::size_t f = 0; f < 100; ++f) course.push_back(block.level[f * pixels + p]), sum += course.back();
    noise.push_back(deviation(course, 99));
    mean.push_back(sum / 100);
  }
  std::nth_element(noise.begin(), noise.begin() + static_cast<std::ptrdiff_t>(pixels / 2), noise.end());
  EXPECT_NEAR(noise[pixels / 2], 3.94, 0.01);
  EXPECT_NEAR(deviation(mean, static_cast<double>(pixels)), 48.84, 0.005);
}

/// The header's period is 10 ms, and the stamps are three of them apart: two frames of three were not stored, but none
/// is missing among those that were. The same header counts microseconds since midnight elsewhere.
TEST(RealFilm, StampsAgreeWithTheCountOfMicroseconds) {
  const auto path = test::infrared("PyradiSampleMWIR.ptw");
  const auto film = open_film(path);
  const auto bytes = open_bytes(path);
  ASSERT_EQ(film->info().time.size(), 100U);
  std::uint64_t first = 0;
  for (std::uint64_t f = 0; f < 100; ++f) {
    std::uint64_t us = 0;
    bytes->read(3476 + f * (1016 + 2 * 69 * 64) + 301, 8, &us);
    if (f == 0) first = us;
    EXPECT_NEAR(film->info().time[f], static_cast<double>(us - first) * 1e-6, 1.5e-6);
  }
  const FrameIntervals times = frame_intervals(film->info());
  EXPECT_NEAR(times.interval, 0.03, 1e-5);
  EXPECT_NEAR(times.duration, 99 * 0.029998, 1e-4);
  EXPECT_EQ(times.dropped, 0);
  EXPECT_TRUE(times.gap.empty());
}

TEST(RealFilm, TiffOfAMicrobolometer) {
  const auto film = open_film(test::infrared("example_radiometric.tiff"));
  EXPECT_EQ(film->info().format, "tiff");
  EXPECT_EQ(film->info().width, 640);
  EXPECT_EQ(film->info().height, 512);
  EXPECT_EQ(film->info().frames, 1);
  const FrameBlock block = test::all_of(*film);
  const auto [least, most] = std::minmax_element(block.level.begin(), block.level.end());
  EXPECT_EQ(*least, 6743);
  EXPECT_EQ(*most, 7077);
}

}  // namespace
}  // namespace arenite::io
