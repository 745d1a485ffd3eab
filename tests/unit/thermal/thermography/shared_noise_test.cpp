#include "thermal/thermography/shared_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/disturbed_film.hpp"
#include "thermal/thermography/lockin.hpp"

namespace {
using namespace arenite;
using namespace arenite::thermography;

/// Errors of the pixels of some films against those that are told.
struct Coverage {
  double mean = 0, common = 0;  ///< root mean square of the error of the whole sample's mean, and what is told of it, K
  double within_one = 0, two = 0;  ///< shares of pixels
  int told = 0;                    ///< films of which a sentence says that pixels share noise
  double before = 0;
};

Coverage coverage(test::DisturbedFilm of, int films) {
  Coverage c;
  for (int k = 1; k <= films; ++k) {
    of.seed = static_cast<std::uint64_t>(k);
    Film film = of.draw();
    LockinOptions options;
    options.frequency = 3;
    options.reference_phase = of.phase;
    const LockinMaps maps = lock_in(film, options);
    double mean = 0, pixels = 0;
    for (std::size_t p = 0; p < maps.size(); ++p) {
      const double off = static_cast<double>(maps.in_phase[p]) - of.amplitude(p),
                   over = std::abs(off) / static_cast<double>(maps.standard_error[p]);
      if (of.sample(p)) mean += off, ++pixels;
      c.within_one += (over < 1) / static_cast<double>(films) / static_cast<double>(maps.size());
      c.two += (over < 2) / static_cast<double>(films) / static_cast<double>(maps.size());
    }
    c.mean += mean * mean / (pixels * pixels) / films;
    c.common += maps.common_error * maps.common_error / films;
    for (const auto& sentence : maps.disturbances) c.told += sentence.find("pixels share noise") != std::string::npos;
  }
  c.mean = std::sqrt(c.mean), c.common = std::sqrt(c.common);
  return c;
}

TEST(SharedNoise, OfAllPixelsIsTakenOffWherePixelsOffTheSampleShowIt) {
  test::DisturbedFilm of;
  of.common = 0.02;
  const Coverage c = coverage(of, 6);
  EXPECT_EQ(c.told, 6);
  EXPECT_LT(c.mean, 0.00015) << "1.4 mK as it is";
  EXPECT_LT(c.common, 0.0001);
  EXPECT_NEAR(c.within_one, 0.68, 0.08);
  EXPECT_NEAR(c.two, 0.94, 0.04);
}

TEST(SharedNoise, OfColumnsIsTakenOff) {
  test::DisturbedFilm of;
  of.columns = 0.02;
  const Coverage c = coverage(of, 6);
  EXPECT_EQ(c.told, 6);
  EXPECT_NEAR(c.within_one, 0.68, 0.08);
  EXPECT_NEAR(c.two, 0.94, 0.04);
}

TEST(SharedNoise, StaysInTheErrorsOfASampleThatFillsThePicture) {
  test::DisturbedFilm of;
  of.common = 0.02, of.border = 0;
  const Coverage c = coverage(of, 6);
  EXPECT_EQ(c.told, 6);
  EXPECT_NEAR(c.mean / c.common, 1, 0.6);
  EXPECT_GT(c.common, 0.0007);
}

TEST(SharedNoise, IndependentPixelsShareNone) {
  const Coverage c = coverage({}, 6);
  EXPECT_EQ(c.told, 0);
  EXPECT_EQ(c.common, 0);
  EXPECT_NEAR(c.within_one, 0.68, 0.04);
}

}  // namespace
