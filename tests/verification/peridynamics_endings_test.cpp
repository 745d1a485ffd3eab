// The ways to the field against each other, and properties that any right field has.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "geometry/label_cells.hpp"
#include "solid/peridynamics/load.hpp"
#include "support/cemented_sample.hpp"
#include "support/homogeneous_sample.hpp"
#include "verification/loaded.hpp"

namespace arenite::peridynamics {
namespace {

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

TEST(Ending, FlapOnBondsInLineTurnsUnderThePapersStretchWithoutStress) {
  // Nodes (0, 36) to (0, 38) hang above one another from (0, 39), which no single node's removal parts from the block:
  // no hinge, and yet the flap below them may turn.
  PhaseMap map = test::homogeneous_sample(60, 60);
  put(map, 0, 20, 20, 39, Phase::empty);
  put(map, 0, 1, 36, 39, Phase::matrix);
  put(map, 0, 3, 30, 36, Phase::matrix);
  for (const double strain : {1e-4, 3e-4}) {
    LoadOptions options;
    options.exact_stretch = true;
    options.strain = strain;
    options.tolerance = 1e-9;
    const auto result = load(map, options);
    EXPECT_EQ(result.report.ending, Ending::solved) << result.report.sentence;
    const double largest = *std::max_element(result.field.yy.begin(), result.field.yy.end());
    for (int y = 30; y < 36; ++y) EXPECT_LT(std::abs(result.field.yy[map.index(1, y)]), 1e-6 * largest);
    expect_finite(result);
  }
}

/// A corner of a sample cemented by narrow bridges, bottom row first: matrix (o) and particles (x). The sliver of a
/// grain on the left stands on one bond and hangs on two of one node, in line: a pull does not keep it from turning at
/// first.
constexpr std::array<std::string_view, 25> sliver{
    "xxxxxxxxxxxxxxxx............xxxxxxxxxxxx", "xxxxxxxxxxxxxxx............xxxxxxxxxxxxx",
    "xxxxxxxxxxxxx..............xxxxxxxxxxxxx", "xxxxxxxxxxx...............xxxxxxxxxxxxxx",
    "..........................xxxxxxxxxxxxxx", ".........................xxxxxxxxxxxxxxx",
    "x........................xxxxxxxxxxxxxxx", "x........................xxxxxxxxxxxxxxx",
    "xx.......................xxxxxxxxxxxxxxx", "xx.......................xxxxxxxxxxxxxxx",
    "xx........................xxxxxxxxxxxxxx", "xxx.......................xxxxxxxxxxxxxx",
    "xxx........................xxxxxxxxxxxxx", "xxx........................xxxxxxxxxxxxx",
    "xxx.........................xxxxxxxxxxxx", "xxx..........................xxxxxxxxxxx",
    "xxx...........................oxxxxxxxxx", "xx....................xxxxx...ooooxxx...",
    "xx............xxxxxxxxxxxxxxxxxxxxxoo...", "xx........xxxxxxxxxxxxxxxxxxxxxxxxxxxxx.",
    "x......xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx", ".....xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx",
    "..xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx", "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx",
    "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx",
};

TEST(Ending, SliverThatNothingKeepsFromTurningAtFirstIsSolvedUnderThePapersStretch) {
  // Once it is left free to turn, rounding must not carry it away.
  PhaseMap map = test::homogeneous_sample(static_cast<int>(sliver[0].size()), static_cast<int>(sliver.size()));
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const char node = sliver[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      put(map, x, x + 1, y, y + 1, node == '.' ? Phase::empty : node == 'x' ? Phase::particle : Phase::matrix);
    }
  std::vector<std::uint8_t> inside(map.size());
  std::transform(map.phase.begin(), map.phase.end(), inside.begin(), [](Phase p) { return p == Phase::particle; });
  const auto grains = geometry::label_cells({map.width, map.height}, inside, {});
  map.grain = grains.label;
  map.grain_class.assign(static_cast<std::size_t>(grains.count), GrainClass::none);
  LoadOptions options;
  options.exact_stretch = true;
  options.strain = 3e-4;
  options.tolerance = 1e-9;
  const auto result = load(map, options);
  EXPECT_EQ(result.report.ending, Ending::solved) << result.report.sentence;
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
