// The ways to the field against each other, and properties that any right field has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "solid/peridynamics/load.hpp"
#include "support/cemented_sample.hpp"
#include "support/homogeneous_sample.hpp"

namespace arenite::peridynamics {
namespace {

PhaseMap cemented(int nodes = 96, double bridge = 0.4, double gamma = 2) {
  return test::cemented_sample({.nodes = nodes, .size_ratio = gamma, .bridge = bridge});
}

LoadResult loaded(const PhaseMap& map, LoadOptions options, double tolerance = 1e-10) {
  options.tolerance = tolerance;
  return load(map, options);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

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

void expect_finite(const LoadResult& result) {
  for (const auto* values : {&result.field.ux, &result.field.uy, &result.field.xx, &result.field.yy, &result.field.xy})
    EXPECT_TRUE(std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); }));
  EXPECT_TRUE(std::isfinite(result.report.modulus) && std::isfinite(result.report.residual) &&
              std::isfinite(result.report.identity_defect));
}

void put(PhaseMap& map, int x0, int x1, int y0, int y1, Phase phase) {
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) map.phase[map.index(x, y)] = phase;
}

TEST(Ending, AllVoidIsEmpty) {
  const auto result = load(make_phase_map(40, 40, 1), {});
  EXPECT_EQ(result.report.ending, Ending::empty);
  expect_finite(result);
}

TEST(Ending, SampleInTwoHalvesIsSeveredAndFollowsItsClamps) {
  PhaseMap map = test::homogeneous_sample(40, 60);
  put(map, 0, 40, 28, 33, Phase::empty);
  const auto result = load(map, {});
  EXPECT_EQ(result.report.ending, Ending::severed);
  EXPECT_EQ(result.report.support.held_below, 40u * 27);
  EXPECT_EQ(result.report.support.held_above, 40u * 26);
  EXPECT_EQ(result.report.modulus, 0);
  EXPECT_EQ(result.field.uy[map.index(20, 40)], result.field.uy[map.index(20, 59)]);
  EXPECT_EQ(mean(result.field.yy), 0);
  expect_finite(result);
}

TEST(Ending, FloatingIslandIsCountedAndLeftWithoutStress) {
  PhaseMap map = test::homogeneous_sample(60, 60);
  put(map, 20, 40, 20, 40, Phase::empty);
  put(map, 26, 34, 26, 34, Phase::matrix);
  const auto result = load(map, {});
  EXPECT_EQ(result.report.ending, Ending::solved);
  EXPECT_EQ(result.report.support.floating, 64u);
  EXPECT_EQ(result.report.support.islands, 1);
  EXPECT_EQ(result.field.yy[map.index(30, 30)], 0);
  EXPECT_NE(result.report.sentence.find("64 floating nodes in 1 islands"), std::string::npos) << result.report.sentence;
  expect_finite(result);
}

TEST(Ending, NodeOnASingleBondIsAHingeAndTheRestIsSolved) {
  PhaseMap map = test::homogeneous_sample(60, 60);
  put(map, 40, 60, 20, 40, Phase::empty);
  map.phase[map.index(42, 30)] = Phase::matrix;  // held by the bond of length 3 alone
  const auto result = load(map, {});
  EXPECT_EQ(result.report.ending, Ending::solved) << result.report.sentence;
  EXPECT_EQ(result.report.loose_nodes, 1u);
  ASSERT_EQ(result.report.hinges.size(), 1u);
  EXPECT_EQ(result.report.hinges[0].x, 39);
  EXPECT_EQ(result.report.hinges[0].nodes, 1u);
  EXPECT_LT(std::abs(result.report.identity_defect), 1e-5);
  expect_finite(result);
}

TEST(Ending, HingeUnderThePapersStretchStaysWhereItIs) {
  PhaseMap map = test::homogeneous_sample(60, 60);
  put(map, 40, 60, 20, 40, Phase::empty);
  map.phase[map.index(41, 31)] = Phase::matrix;
  map.phase[map.index(44, 31)] = Phase::matrix;  // on one bond, which the pull turns
  LoadOptions options;
  options.exact_stretch = true;
  const auto result = load(map, options);
  EXPECT_EQ(result.report.ending, Ending::solved) << result.report.sentence;
  EXPECT_LT(std::abs(result.field.uy[map.index(44, 31)]), 60 * map.dx * options.strain * 10);
  expect_finite(result);
}

TEST(Ending, HalvesJoinedByAHingeStillCarryAPull) {
  // Two blocks that meet in a single node: free to turn, yet in line with the pull.
  PhaseMap map = test::homogeneous_sample(41, 61);
  put(map, 0, 41, 29, 34, Phase::empty);
  map.phase[map.index(20, 31)] = Phase::matrix;
  LoadOptions options;
  options.look_for_hinges = true;
  const auto result = load(map, options);
  EXPECT_EQ(result.report.ending, Ending::solved) << result.report.sentence;
  EXPECT_GT(result.report.modulus, 0);
  EXPECT_NE(result.report.sentence.find("it transmits the load"), std::string::npos) << result.report.sentence;
  expect_finite(result);
}

TEST(Ending, TooFewStepsIsToldWithWhatWasReached) {
  LoadOptions options;
  options.method = Method::damped;
  options.max_iterations = 20;
  const auto result = load(cemented(64), options);
  EXPECT_EQ(result.report.ending, Ending::not_converged);
  EXPECT_NE(result.report.sentence.find("after 20 iterations"), std::string::npos) << result.report.sentence;
  expect_finite(result);
}

TEST(SolveWatch, SeesEveryWayGoOnAndMayStopIt) {
  const PhaseMap map = cemented(64);
  for (const Method method : {Method::static_solve, Method::relaxation, Method::damped})
    for (const bool exact : {false, true}) {
      LoadOptions options;
      options.method = method;
      options.exact_stretch = exact;
      double share = 0;
      int calls = 0;
      options.watch = [&](const Progress& p) {
        EXPECT_GE(p.share, share);
        EXPECT_LE(p.share, 1);
        share = p.share;
        return ++calls < 4;
      };
      const auto result = loaded(map, options);
      EXPECT_EQ(result.report.ending, Ending::stopped) << result.report.sentence;
      EXPECT_EQ(calls, 4);
      EXPECT_GT(share, 0);
      expect_finite(result);
    }
}

TEST(LoadOptions, NonsenseIsRefused) {
  const PhaseMap map = test::homogeneous_sample(20, 20);
  LoadOptions options;
  options.strain = -1;
  EXPECT_THROW(load(map, options), InputError);
  options = {};
  options.loading = Loading::shear;
  options.lower = LowerEdge::sliding;
  EXPECT_THROW(load(map, options), InputError);
  options = {};
  options.tolerance = 0;
  EXPECT_THROW(load(map, options), InputError);
}

}  // namespace
}  // namespace arenite::peridynamics
