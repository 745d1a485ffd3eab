#include "report/colour_ends.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <vector>

using namespace arenite;
using report::ends_of;

namespace {

/// From 0 to 1000, and what is not known.
std::vector<double> in_order() {
  std::vector<double> values(1001);
  std::iota(values.begin(), values.end(), 0.0);
  values.push_back(NAN);
  return values;
}

const fields::CoarseLayerIn<2>& layer(std::string_view name) {
  return *std::ranges::find(fields::coarse_layers<2>(), name, &fields::CoarseLayerIn<2>::name);
}

report::ColourEnds ends_of_layer(std::string_view name, const std::vector<double>& values, double solid = 0.8) {
  fields::CoarseFieldsIn<2> fields;
  fields.solid_fraction.assign(values.size(), solid);
  fields.solid_fraction.front() = 0;
  return ends_of(layer(name), fields, values);
}

}  // namespace

TEST(ColourEnds, LeaveOutThisShareOfWhatIsKnownAtEitherEnd) {
  EXPECT_EQ(ends_of(in_order(), 0), (report::ColourEnds{0, 1000}));
  const auto [low, high] = ends_of(in_order(), 0.01);
  EXPECT_NEAR(low, 10, 1);
  EXPECT_NEAR(high, 990, 1);
  EXPECT_EQ(ends_of({NAN}, 0.01), (report::ColourEnds{0, 0}));
}

TEST(ColourEnds, OfALayerBeginAtNothingOrAtItsLeastAndAreWideWhereItIsEven) {
  // The first cell, with no grain in reach, does not count.
  EXPECT_EQ(ends_of_layer("pressure", {-9, 2, 4, 3}), (report::ColourEnds{0, 4}));
  EXPECT_EQ(ends_of_layer("solid_fraction", {0, 0.7, 0.8, 0.9}), (report::ColourEnds{0.7, 0.9}));
  EXPECT_EQ(ends_of_layer("shear", {50, -5, 2, 3}), (report::ColourEnds{-5, 5}));
  EXPECT_EQ(ends_of_layer("density", {0, 2, 2, 2}), (report::ColourEnds{1, 3}));
  EXPECT_EQ(ends_of_layer("shear", {0, 0, 0}), (report::ColourEnds{-1, 1}));
}
