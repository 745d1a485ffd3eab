#include "validation/wall_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace arenite::validation {
namespace {

/// By the mean over places, step by step.
double by_places(double window, double strip) {
  constexpr int places = 20000;
  double sum = 0;
  for (int k = 0; k < places; ++k) {
    const double x = (k + 0.5) / places * (1 - window);
    sum += (std::min(x + window, 1 - strip) - std::max(x, strip)) / window;
  }
  return sum / places;
}

TEST(WallLayers, TheShareOfTheInteriorIsTheMeanOverPlaces) {
  for (const double window : {0.45, 0.6, 0.8, 0.95})
    for (const double strip : {0.02, 0.1, 0.3})
      EXPECT_NEAR(share_of_interior(window, strip), by_places(window, strip), 1e-6) << window << " " << strip;
}

/// Squares of disks: one in every cell of 1 mm, none in the outermost cells of 10 x 10 mm.
workflow::FinalState with_bare_walls() {
  workflow::FinalState state;
  auto& domain = state.packing.domain;
  domain.wall[right].position = domain.wall[top].position = 0.01;
  auto& grains = state.packing.grains;
  for (int r = 1; r < 9; ++r)
    for (int c = 1; c < 9; ++c) {
      grains.position.push_back({1e-3 * (c + 0.5), 1e-3 * (r + 0.5)});
      grains.radius.push_back(0.5e-3);
    }
  state.texture.mean_diameter = 1e-3;
  state.texture.solid_fraction.value = 0.7853981634;
  return state;
}

TEST(WallLayers, EmptyStripsLowerTheFractionOfLargeWindows) {
  const WallLayers layers = wall_layers(with_bare_walls(), 1);
  EXPECT_NEAR(layers.at_walls, 0, 1e-9);
  EXPECT_DOUBLE_EQ(layers.strip_x, 0.1);
  EXPECT_NEAR(layers.of_windows(1), 0.7853981634 * 0.64, 1e-9);
  EXPECT_GT(layers.of_windows(0.2), layers.of_windows(0.9));
}

}  // namespace
}  // namespace arenite::validation
