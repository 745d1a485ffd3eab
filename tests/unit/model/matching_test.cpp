#include "model/matching.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace arenite {
namespace {

TEST(Matching, PlacesAreByIdAndNewcomersHaveNone) {
  Grains then, now;
  then.resize(3), now.resize(3);
  then.id = {7, 8, 9};
  now.id = {9, 7, 12};
  EXPECT_EQ(places_in(then, now), (std::vector<std::int32_t>{2, 0, -1}));
  EXPECT_EQ(places_in(then, then), (std::vector<std::int32_t>{0, 1, 2}));
}

TEST(Matching, TheNearestCentreIsTheGrain) {
  // On a line at 0, 1, .., 9 the nearest to x is x rounded.
  std::vector<Vec2> line, places;
  std::vector<std::size_t> rounded;
  for (int k = 0; k < 10; ++k) line.push_back({1.0 * k, 5});
  for (const double x : {0.2, 3.4, 3.6, 8.9, 20.0}) {
    places.push_back({x, 4});
    rounded.push_back(x > 9 ? 9 : static_cast<std::size_t>(x + 0.5));
  }
  EXPECT_EQ(nearest_grains(places, line), rounded);
}

}  // namespace
}  // namespace arenite
