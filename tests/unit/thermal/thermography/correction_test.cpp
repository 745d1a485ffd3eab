#include "thermal/thermography/correction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::thermography {
namespace {

/// A bell curve's worth of scatter that is the same in every run.
double scatter(std::uint32_t n) {
  std::uint64_t h = (n + 1) * 0x9e3779b97f4a7c15ULL;
  double sum = 0;
  for (int k = 0; k < 12; ++k) {
    h ^= h >> 31;
    h *= 0xbf58476d1ce4e5b9ULL;
    sum += static_cast<double>(h >> 11) * 0x1p-53;
  }
  return sum - 6;
}

/// A camera with gains and offsets of its own in every pixel, looking at a scene.
struct Camera {
  int width = 24, height = 16;
  double gain(std::size_t p) const { return 1 + 0.02 * scatter(static_cast<std::uint32_t>(p)); }
  double offset(std::size_t p) const { return 200 * scatter(static_cast<std::uint32_t>(p) + 50000); }
  template <class Scene> Film look(int frames, double noise, Scene&& scene) const {
    Film film = test::counted(width, height, frames, true);
    for (std::size_t i = 0; i < film.value.size(); ++i) {
      const std::size_t p = i % film.about.pixels();
      film.value[i] =
          static_cast<float>(gain(p) * scene(p) + offset(p) + noise * scatter(static_cast<std::uint32_t>(i) + 777777));
    }
    return film;
  }
};

double spread(const std::vector<float>& x) {
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  double sum = 0;
  for (const float v : x) sum += (static_cast<double>(v) - mean) * (static_cast<double>(v) - mean);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

std::vector<float> corrected(Film& film, const Correction& correction) {
  std::vector<float> out;
  apply(correction, test::all_of(film), out);
  return out;
}

TEST(Correction, OnePointTakesOffsetsAndTwoPointsTakeGainsToo) {
  const Camera camera;
  Film cold = camera.look(1, 0, [](std::size_t) { return 5000; }),
       warm = camera.look(1, 0, [](std::size_t) { return 9000; });
  Film between = camera.look(1, 0, [](std::size_t) { return 6500; });
  const auto c = frame_statistics(cold), w = frame_statistics(warm);
  Correction one, two;
  correct_offsets(c, one);
  correct_gains(c, w, two);
  EXPECT_GT(spread(corrected(between, {camera.width, camera.height, {}, {}, {}, {}, {}, {}})), 180);
  EXPECT_LT(spread(corrected(cold, one)), 1e-3);
  EXPECT_NEAR(spread(corrected(between, one)), 0.02 * 1500, 4);  // the gains' share stays
  EXPECT_LT(spread(corrected(between, two)), 2e-3);              // single precision
  EXPECT_LT(spread(corrected(warm, two)), 2e-3);
  EXPECT_NEAR(static_cast<double>(corrected(between, two)[7]),
              reference_level(c) + 1500.0 / 4000 * (reference_level(w) - reference_level(c)), 2e-3);
}

TEST(Correction, PlatesThatMakeNoCorrectionAreRefused) {
  const Camera camera;
  Film cold = camera.look(1, 0, [](std::size_t) { return 5000; });
  const auto c = frame_statistics(cold);
  Correction correction;
  EXPECT_NE(test::complaint([&] { correct_gains(c, c, correction); }).find("different temperatures"),
            std::string::npos);
  Camera other;
  other.width = 23;
  Film small = other.look(1, 0, [](std::size_t) { return 9000; });
  EXPECT_NE(test::complaint([&] { correct_gains(c, frame_statistics(small), correction); }).find("same window"),
            std::string::npos);
  correct_offsets(c, correction);
  EXPECT_NE(test::complaint([&] { corrected(small, correction); }).find("24 x 16"), std::string::npos);
}

TEST(Correction, BadPixelsAreFoundByLevelGainAndNoise) {
  const Camera camera;
  const std::size_t dead = 30, hot = 111, weak = 200, blinking = 300, frozen = 340;
  const auto spoil = [&](Film film) {
    const std::size_t n = film.about.pixels();
    for (std::size_t i = 0; i < film.value.size(); ++i) {
      if (i % n == dead) film.value[i] = 0;
      if (i % n == hot) film.value[i] = 16383;
      if (i % n == weak) film.value[i] = 5500 + 0.2F * (film.value[i] - 5500);
      if (i % n == blinking && i / n % 3 == 0) film.value[i] += 400;
      if (i % n == frozen) film.value[i] = film.value[frozen];
    }
    return film;
  };
  Film cold = spoil(camera.look(40, 4, [](std::size_t) { return 5000; })),
       warm = spoil(camera.look(40, 4, [](std::size_t) { return 6500; }));
  const auto c = frame_statistics(cold), w = frame_statistics(warm);
  const auto bad = find_bad_pixels(c, w);
  EXPECT_TRUE(bad[dead] & bad_level);
  EXPECT_TRUE(bad[hot] & bad_level);
  EXPECT_TRUE(bad[weak] & bad_gain);
  EXPECT_TRUE(bad[blinking] & bad_noise);
  EXPECT_TRUE(bad[frozen] & bad_noise);
  EXPECT_EQ(std::count_if(bad.begin(), bad.end(), [](std::uint8_t b) { return b != 0; }), 5);
  EXPECT_EQ(doubtful(c, 14).saturated, 1U);
  EXPECT_EQ(doubtful(c, 14).constant, 3U);
}

TEST(Correction, EdgesOfDisksAreNoBadPixels) {
  const Camera camera;
  Film film = camera.look(1, 0, [&](std::size_t p) {
    const double x = static_cast<double>(p % 24) - 11.3, y = static_cast<double>(p / 24) - 7.8;
    return x * x + y * y < 36 ? 9000 : 5000;
  });
  Correction one;
  Film even = camera.look(1, 0, [](std::size_t) { return 5000; });
  correct_offsets(frame_statistics(even), one);
  film.value = corrected(film, one);
  for (const std::uint8_t b : find_bad_pixels(frame_statistics(film))) EXPECT_EQ(b, 0);
}

TEST(Correction, BadPixelsAreReplacedByTheMeanOfGoodNeighbours) {
  std::vector<std::uint8_t> bad(25, 0);
  bad[12] = bad[13] = bad[0] = 1;  // two in the middle, one in the corner
  Correction correction{5, 5, {}, {}, {}, replacements(bad, 5, 5), {}, {}};
  ASSERT_EQ(correction.bad.size(), 3U);
  Film film = test::counted(5, 5, 2);
  const auto out = corrected(film, correction);
  EXPECT_FLOAT_EQ(out[12], (11 + 12 + 13 + 21 + 31 + 32 + 33) / 7.0F);
  EXPECT_FLOAT_EQ(out[0], (1 + 10 + 11) / 3.0F);
  EXPECT_FLOAT_EQ(out[25 + 0], 1000 + (1 + 10 + 11) / 3.0F);
  EXPECT_EQ(out[7], 12);
  EXPECT_TRUE(replacements({1}, 1, 1)[0].from.empty());  // no good one anywhere
  std::vector<std::uint8_t> cluster(49, 0);
  for (int r = 2; r <= 4; ++r)
    for (int c = 2; c <= 4; ++c) cluster[static_cast<std::size_t>(7 * r + c)] = 1;
  const auto wide = replacements(cluster, 7, 7);
  EXPECT_EQ(std::find_if(wide.begin(), wide.end(), [](const Replacement& r) { return r.pixel == 24; })->from.size(),
            16U);
}

TEST(Correction, ReferenceIsSubtractedAndMaskBlanks) {
  Film film = test::counted(5, 4, 3);
  Correction correction{5, 4, {}, {}, {}, {}, corrected(film, {5, 4, {}, {}, {}, {}, {}, {}}), {}};
  correction.reference.resize(20);
  correction.mask.assign(20, 1);
  correction.mask[3] = 0;
  const auto out = corrected(film, correction);
  for (std::size_t i = 0; i < 60; ++i) EXPECT_EQ(out[i], i % 20 == 3 ? 0 : 1000.0F * static_cast<float>(i / 20));
}

TEST(Correction, AFilmSeenThroughACorrectionIsReadInAnyBlocks) {
  Film film = test::counted(5, 4, 6);
  const Correction correction{5, 4, std::vector<float>(20, 2), std::vector<float>(20, -3), {}, {}, {}, {}};
  CorrectedFilm seen(film, correction);
  EXPECT_TRUE(seen.info().floating);
  const FrameBlock all = test::all_of(seen);
  FrameBlock part;
  seen.read(2, 3, part);
  EXPECT_TRUE(std::equal(part.value.begin(), part.value.end(), all.value.begin() + 40));
  EXPECT_EQ(all.value[21], 2 * 1001 - 3);
}

/// The mean of the neighbours is a plausible value: dead and hot pixels of a real camera stand out no more afterwards.
TEST(Correction, DeadAndHotPixelsOfARealCamera) {
  const auto film = io::open_film(test::infrared("LWIR-BBref-150C-150us.ptw"));
  const FrameStatistics before = frame_statistics(*film);
  const auto bad = find_bad_pixels(before);
  const auto count = std::count_if(bad.begin(), bad.end(), [](std::uint8_t b) { return b != 0; });
  EXPECT_GT(count, 50);
  EXPECT_LT(count, 768);  // one in a hundred
  // Its most striking ones: 10803 among 5288, 5171 among 5290, 5073 among 5319.
  for (const auto& [column, row] : {std::pair{54, 26}, std::pair{56, 10}, std::pair{260, 52}})
    EXPECT_TRUE(bad[static_cast<std::size_t>(320 * row + column)] & bad_level);
  Correction correction{320, 240, {}, {}, {}, replacements(bad, 320, 240), {}, {}};
  CorrectedFilm seen(*film, correction);
  const FrameStatistics after = frame_statistics(seen);
  EXPECT_NEAR(static_cast<double>(after.mean[320 * 26 + 54]), 5288, 15);
  EXPECT_GT(*std::max_element(before.mean.begin(), before.mean.end()), 10000);
  EXPECT_LT(*std::max_element(after.mean.begin(), after.mean.end()), 6900);
  std::size_t still = 0;
  const auto again = find_bad_pixels(after);
  for (std::size_t i = 0; i < bad.size(); ++i) still += bad[i] != 0 && again[i] != 0 ? 1 : 0;
  EXPECT_EQ(still, 0U);
}

TEST(Correction, TheOwnMeanOfARealFilmTakesItsPatternOut) {
  const auto film = io::open_film(test::infrared("PyradiSampleMWIR.ptw"));
  const FrameStatistics s = frame_statistics(*film);
  EXPECT_NEAR(spread(s.mean), 48.84, 0.01);
  Correction correction;
  correct_offsets(s, correction);
  CorrectedFilm seen(*film, correction);
  const FrameStatistics after = frame_statistics(seen);
  EXPECT_LT(spread(after.mean), 0.01);
  for (std::size_t i = 0; i < s.noise.size(); ++i) EXPECT_NEAR(after.noise[i], s.noise[i], 1e-3);
}

}  // namespace
}  // namespace arenite::thermography
