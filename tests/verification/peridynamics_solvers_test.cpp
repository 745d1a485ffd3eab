// The ways to the field against each other, and properties that any right field has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solid/peridynamics/load.hpp"
#include "support/cemented_sample.hpp"
#include "support/homogeneous_sample.hpp"
#include "verification/loaded.hpp"

namespace arenite::peridynamics {
namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(ThreeWays, AgreeOnEveryNodesStress) {
  const PhaseMap map = cemented();
  const auto direct = loaded(map, {});
  ASSERT_EQ(direct.report.ending, Ending::solved) << direct.report.sentence;
  for (const Method method : {Method::relaxation, Method::damped}) {
    LoadOptions options;
    options.method = method;
    const auto other = loaded(map, options);
    ASSERT_EQ(other.report.ending, Ending::solved) << other.report.sentence;
    EXPECT_LT(largest_difference(direct.field.yy, other.field.yy), 1e-5 * mean(direct.field.yy));
    EXPECT_LT(largest_difference(direct.field.xy, other.field.xy), 1e-5 * mean(direct.field.yy));
  }
}

TEST(ThreeWays, AgreeUnderThePapersStretchAtSmallStrain) {
  const PhaseMap map = cemented(64);
  LoadOptions options;
  options.strain = 1e-6;
  const auto linear = loaded(map, options);
  options.exact_stretch = true;
  for (const Method method : {Method::static_solve, Method::relaxation, Method::damped}) {
    options.method = method;
    const auto other = loaded(map, options, 1e-9);
    ASSERT_EQ(other.report.ending, Ending::solved) << other.report.sentence;
    EXPECT_LT(largest_difference(linear.field.yy, other.field.yy), 2e-5 * mean(linear.field.yy));
  }
}

TEST(ReactionIdentity, HoldsUnderEveryLoading) {
  const PhaseMap map = cemented();
  for (const Loading loading : {Loading::tension, Loading::compression, Loading::shear}) {
    LoadOptions options;
    options.loading = loading;
    const auto result = loaded(map, options);
    EXPECT_LT(std::abs(result.report.identity_defect), 1e-8);
    EXPECT_LT(std::abs(result.report.top_force.x + result.report.bottom_force.x), 1e-8 * norm(result.report.top_force));
    EXPECT_LT(std::abs(result.report.top_force.y + result.report.bottom_force.y), 1e-8 * norm(result.report.top_force));
  }
}

TEST(Linearity, DoubledStrainDoublesEveryStress) {
  const PhaseMap map = cemented();
  LoadOptions options;
  const auto once = loaded(map, options);
  options.strain *= 2;
  auto twice = loaded(map, options);
  for (double& s : twice.field.yy) s /= 2;
  EXPECT_LT(largest_difference(once.field.yy, twice.field.yy), 1e-6 * mean(once.field.yy));
}

TEST(Linearity, ThePapersStretchDepartsInProportionToTheStrain) {
  const PhaseMap map = cemented(64, 1000);
  const auto departure = [&](double strain) {
    LoadOptions options;
    options.strain = strain;
    const double linear = loaded(map, options).report.modulus;
    options.exact_stretch = true;
    return loaded(map, options, 1e-9).report.modulus / linear - 1;
  };
  const double small = departure(1e-3), large = departure(2e-3);
  EXPECT_GT(std::abs(small), 1e-5);
  EXPECT_NEAR(large / small, 2, 0.05);
}

TEST(FieldSymmetry, CompressionIsTensionReversed) {
  const PhaseMap map = cemented();
  LoadOptions options;
  const auto pulled = loaded(map, options);
  options.loading = Loading::compression;
  auto pushed = loaded(map, options);
  for (double& s : pushed.field.yy) s = -s;
  EXPECT_LT(largest_difference(pulled.field.yy, pushed.field.yy), 1e-7 * mean(pulled.field.yy));
}

TEST(FieldSymmetry, MirroredAndTurnedSamplesHaveMirroredAndTurnedFields) {
  const PhaseMap map = cemented();
  PhaseMap mirrored = map, turned = map;
  const int n = map.width;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const auto i = map.index(x, y), m = map.index(n - 1 - x, y), t = map.index(n - 1 - x, n - 1 - y);
      mirrored.phase[m] = turned.phase[t] = map.phase[i];
      mirrored.grain[m] = turned.grain[t] = map.grain[i];
    }
  const auto plain = loaded(map, {}), left = loaded(mirrored, {}), around = loaded(turned, {});
  const double scale = mean(plain.field.yy);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const auto i = map.index(x, y), m = map.index(n - 1 - x, y), t = map.index(n - 1 - x, n - 1 - y);
      ASSERT_NEAR(left.field.yy[m], plain.field.yy[i], 1e-6 * scale);
      ASSERT_NEAR(left.field.xy[m], -plain.field.xy[i], 1e-6 * scale);
      ASSERT_NEAR(around.field.yy[t], plain.field.yy[i], 1e-6 * scale);
    }
}

TEST(LowerEdge, SlidingEdgeCarriesNoShearAndIsSofter) {
  const PhaseMap map = cemented();
  LoadOptions options;
  const double fixed = loaded(map, options).report.modulus;
  options.lower = LowerEdge::sliding;
  const auto slid = loaded(map, options);
  ASSERT_EQ(slid.report.ending, Ending::solved) << slid.report.sentence;
  EXPECT_NEAR(slid.report.bottom_force.x, 0, 1e-8 * slid.report.top_force.y);
  EXPECT_LT(slid.report.modulus, fixed);
  EXPECT_LE(loaded(map, options, 1e-6).report.iterations, 20);
}

TEST(Tolerance, OfAMillionthLeavesAMillionthInTheStresses) {
  const PhaseMap map = cemented(256, 0.4, 2.5);
  const auto exact = loaded(map, {}), solved = loaded(map, {}, 1e-6);
  double square = 0;
  for (std::size_t i = 0; i < map.size(); ++i) square += std::pow(exact.field.yy[i] - solved.field.yy[i], 2);
  EXPECT_LT(std::sqrt(square / static_cast<double>(map.size())), 1e-6 * mean(exact.field.yy));
}

TEST(Robustness, StiffGrainsAsManyIterations) {
  LoadOptions options;
  options.stiffness.particle = 100;
  const auto result = loaded(cemented(256, 0.2, 2.5), options, 1e-6);
  EXPECT_EQ(result.report.ending, Ending::solved) << result.report.sentence;
  EXPECT_LE(result.report.iterations, 20);
}

TEST(Robustness, LittleCementFewIterations) {
  for (const double gamma : {1.0, 2.5})
    for (const double bridge : {0.2, 0.6, 1000.0}) {
      const auto result = loaded(cemented(256, bridge, gamma), {}, 1e-6);
      EXPECT_EQ(result.report.ending, Ending::solved) << result.report.sentence;
      EXPECT_LE(result.report.iterations, 20) << gamma << " " << bridge;
      EXPECT_EQ(result.report.repairs, 0);
    }
}

}  // namespace
}  // namespace arenite::peridynamics
