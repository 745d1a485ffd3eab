#include "solid/elements/load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "support/cemented_sample.hpp"
#include "support/element_samples.hpp"

namespace arenite::elements::load_test {
namespace {

using test::alike;
using test::solid;

TEST(ElementLoad, LaminatesAreExact) {
  for (const bool along : {false, true}) {
    PhaseMap map = solid(24, 40, Phase::particle);
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
        if ((along ? x : y) % 8 < 3) map.phase[map.index(x, y)] = Phase::matrix, map.grain[map.index(x, y)] = -1;
    // Interfaces are made of what they lie in: of matrix.
    const LoadOptions options{{.tolerance = 1e-9, .material = {{1, 0}, {1, 0}, {5, 0}}}};
    const statics::LoadResult result = load(map, options);
    ASSERT_EQ(result.report.ending, statics::Ending::solved) << result.report.sentence;
    const double share = 3.0 / 8, expected = along ? share + 5 * (1 - share) : 1 / (share + (1 - share) / 5);
    EXPECT_NEAR(result.report.modulus / expected, 1, 1e-6);
    EXPECT_NEAR(result.report.identity_defect, 0, 1e-7);
  }
}

TEST(ElementLoad, ACementedSampleIsSolvedAndItsReactionsBalance) {
  const PhaseMap map = test::cemented_sample({.nodes = 160, .size_ratio = 2.5, .bridge = 0.3});
  for (const auto loading : {statics::Loading::tension, statics::Loading::shear})
    for (const double ratio : {4.0, 100.0}) {
      const statics::LoadResult result =
          load(map, LoadOptions{{.material = {{1, 0.3}, {1, 0.3}, {ratio, 0.2}}}, loading});
      const statics::LoadReport& r = result.report;
      ASSERT_EQ(r.ending, statics::Ending::solved) << r.sentence;
      EXPECT_LE(r.iterations, 35) << r.sentence;
      EXPECT_LT(std::abs(r.identity_defect), 1e-5);
      EXPECT_LT(norm(r.top_force + r.bottom_force), 1e-4 * norm(r.top_force));
      EXPECT_EQ(r.repairs, 0);
    }
}

TEST(ElementLoad, StressBesideAHoleFollowsKirsch) {
  constexpr int side = 321, middle = side / 2;
  PhaseMap map = solid(side, side);
  const LoadOptions options{{.tolerance = 1e-8, .material = alike({1, 0.3})}};
  const auto whole = load(map, options);
  double pixels = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (std::hypot(x - middle, y - middle) < side / 32.0) map.phase[map.index(x, y)] = Phase::empty, pixels += 1;
  const auto result = load(map, options);
  ASSERT_EQ(result.report.ending, statics::Ending::solved);
  const double radius = std::sqrt(pixels / std::numbers::pi);  // of the disk of equal area
  for (const double distance : {1.5, 2.0, 2.5}) {
    const int x = middle + static_cast<int>(std::lround(distance * radius));
    const double q = radius / (x - middle), kirsch = 1 + q * q / 2 + 1.5 * std::pow(q, 4);
    EXPECT_NEAR(result.field.yy[map.index(x, middle)] / whole.field.yy[map.index(x, middle)] / kirsch, 1, 0.015)
        << distance;
  }
}

TEST(ElementLoad, NonsenseIsRefused) {
  const PhaseMap map = solid(10, 10);
  EXPECT_THROW(load(solid(10, 1), LoadOptions{}), InputError);
  EXPECT_THROW(load(map, LoadOptions{{}, statics::Loading::tension, statics::LowerEdge::fixed, 0}), InputError);
  EXPECT_THROW(load(map, LoadOptions{{.material = alike({1, 0.5})}}), InputError);
  EXPECT_THROW(load(map, LoadOptions{{.material = alike({0, 0.3})}}), InputError);
  EXPECT_THROW(load(map, LoadOptions{{}, statics::Loading::shear, statics::LowerEdge::sliding}), InputError);
}

}  // namespace
}  // namespace arenite::elements::load_test
