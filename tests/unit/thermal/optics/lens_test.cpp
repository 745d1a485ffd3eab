#include "thermal/optics/lens.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace arenite::optics {
namespace {

std::vector<float> scene_of(const Lens& lens, int width, int height, auto&& light) {
  const int across = width * lens.fine + 2 * lens.margin, down = height * lens.fine + 2 * lens.margin;
  std::vector<float> scene;
  for (int r = 0; r < down; ++r)
    for (int c = 0; c < across; ++c)
      scene.push_back(
          static_cast<float>(light((c - lens.margin + 0.5) / lens.fine, (r - lens.margin + 0.5) / lens.fine)));
  return scene;
}

TEST(Lens, SharesAddUpAndAreAlikeOnBothSides) {
  for (const double blur : {0.0, 0.3, 0.7, 1.5}) {
    const Lens lens = make_lens(blur, 4, 4);
    EXPECT_EQ(lens.taps.size(), static_cast<std::size_t>(4 + 2 * lens.margin));
    EXPECT_NEAR(std::accumulate(lens.taps.begin(), lens.taps.end(), 0.0), 1, 1e-6);
    for (std::size_t k = 0; k < lens.taps.size(); ++k)
      EXPECT_FLOAT_EQ(lens.taps[k], lens.taps[lens.taps.size() - 1 - k]);
  }
}

TEST(Lens, WithoutBlurAPixelIsTheMeanOfItsPoints) {
  const Lens lens = make_lens(0, 4, 5);
  const int width = 5, height = 3;
  const auto picture = through_lens(
      lens, scene_of(lens, width, height, [](double x, double y) { return 2 * x - 3 * y; }), width, height);
  for (int r = 0; r < height; ++r)
    for (int c = 0; c < width; ++c)
      EXPECT_NEAR(picture[static_cast<std::size_t>(r * width + c)], 2 * (c + 0.5) - 3 * (r + 0.5), 1e-5);
}

/// A Gaussian blur of an edge is an error function; a pixel has its mean from x to x + 1, in closed form by parts.
TEST(Lens, AnEdgeIsSeenAsTheMeanOfAnErrorFunction) {
  const double blur = 0.8, edge = 6;
  const Lens lens = make_lens(blur, 16, 5);
  const int width = 12, height = 2;
  const auto picture = through_lens(
      lens, scene_of(lens, width, height, [&](double x, double) { return x < edge ? 0.0 : 1.0; }), width, height);
  const auto integral = [&](double x) {
    const double u = (x - edge) / (blur * std::sqrt(2.0));
    return 0.5 * (x - edge) * (1 + std::erf(u)) + blur * std::exp(-u * u) / std::sqrt(2 * std::numbers::pi);
  };
  for (int r = 0; r < height; ++r)
    for (int c = 0; c < width; ++c)
      EXPECT_NEAR(picture[static_cast<std::size_t>(r * width + c)], integral(c + 1) - integral(c), 1e-3);
}

}  // namespace
}  // namespace arenite::optics
