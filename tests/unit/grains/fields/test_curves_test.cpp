#include "grains/fields/test_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "grains/fields/driven.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite::fields {
namespace {

/// A box of 100 by 100 mm, 10 mm thick, with one grain, whose columns are to be filled.
struct Loading {
  StageResult stage;

  explicit Loading(std::size_t rows, bool sheared) {
    stage.name = "shear";
    Snapshot snapshot;
    snapshot.packing.grains.resize(1);
    snapshot.packing.grains.radius = {0.05};
    snapshot.packing.domain.thickness = 0.01;
    stage.snapshots.push_back(snapshot);
    for (const char* name : {"time", "left_position", "right_position", "bottom_position", "top_position", "left_force",
                             "right_force", "bottom_force", "top_force", "bottom_shear_force", "top_shear_force"})
      stage.history.columns.push_back({name, "", std::vector<double>(rows, 0.0)});
    if (sheared) stage.history.columns.push_back({"shear_strain", "", std::vector<double>(rows, 0.0)});
    for (std::size_t k = 0; k < rows; ++k) {
      of("time")[k] = static_cast<double>(k);
      of("right_position")[k] = of("top_position")[k] = 0.1;
    }
  }

  std::vector<double>& of(const std::string& name) {
    for (auto& c : stage.history.columns)
      if (c.name == name) return c.values;
    throw std::logic_error(name);
  }
};

/// Friction rises to `plateau` within a tenth of the test and fluctuates by 0.02 from sample to sample.
Loading steady_shear(double plateau, std::size_t rows = 2000) {
  Loading test(rows, true);
  RandomStream random(5, Purpose::order);
  for (std::size_t k = 0; k < rows; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(rows - 1);
    const double mu = plateau * (1 - std::exp(-50 * share)) + 0.02 * random.normal();
    test.of("shear_strain")[k] = 4 * share;
    test.of("bottom_force")[k] = test.of("top_force")[k] = 100;
    test.of("bottom_shear_force")[k] = 100 * mu;
    test.of("top_shear_force")[k] = -100 * mu;
    test.of("top_position")[k] = 0.1 * (1 + 1e-3 * random.normal());
  }
  return test;
}

TEST(TestCurves, OfABiaxialTestAreStrainRatioAndVolumeOfTheSides) {
  Loading test(5, false);
  test.of("top_position") = {0.1, 0.0975, 0.095, 0.0925, 0.09};
  test.of("right_position") = {0.1, 0.1, 0.101, 0.102, 0.103};
  for (std::size_t k = 0; k < 5; ++k) {
    test.of("bottom_force")[k] = test.of("top_force")[k] = 3e3 * 0.01 * test.of("right_position")[k];  // 3 kPa
    test.of("left_force")[k] = test.of("right_force")[k] = 1e3 * 0.01 * test.of("top_position")[k];    // 1 kPa
  }
  const auto curves = test_curves(fields::Test{test.stage});
  ASSERT_TRUE(curves);
  EXPECT_EQ(curves->strain_name, "strain of the height");
  EXPECT_EQ(curves->ratio_name(), "q_over_p");
  EXPECT_NEAR(curves->strain[4], 0.1, 1e-12);
  EXPECT_NEAR(curves->ratio[4], 0.5, 1e-12);  // (3 - 1)/(3 + 1)
  EXPECT_NEAR(curves->volume[4], 1 - 0.09 * 0.103 / 0.01, 1e-12);
  EXPECT_NEAR(curves->solid_fraction[0], std::numbers::pi * 0.05 * 0.05 / 0.01, 1e-12);
}

TEST(TestCurves, OfABiaxialTestAreAlongTheAxisOfCompressionThoughTheWidthGrowsByMore) {
  Loading test(100, false);
  for (std::size_t k = 0; k < 100; ++k) {
    const double share = static_cast<double>(k) / 99;
    test.of("top_position")[k] = 0.1 * (1 - 0.4 * share);
    test.of("right_position")[k] = 0.1 / (1 - 0.4 * share);
    test.of("bottom_force")[k] = test.of("top_force")[k] = 3e3 * 0.01 * test.of("right_position")[k];
    test.of("left_force")[k] = test.of("right_force")[k] = 1e3 * 0.01 * test.of("top_position")[k];
  }
  const auto curves = test_curves(fields::Test{test.stage});
  EXPECT_EQ(curves->strain_name, "strain of the height");
  EXPECT_NEAR(curves->strain.back(), 0.4, 1e-12);
  ASSERT_TRUE(critical_state(*curves));
  EXPECT_NEAR(critical_state(*curves)->ratio.value, 0.5, 1e-12);
}

TEST(TestCurves, UnderLoadsOnBothAxesHaveNoCriticalState) {
  Loading test(100, false);
  for (std::size_t k = 0; k < 100; ++k) {
    const double share = static_cast<double>(k) / 99;
    test.of("top_position")[k] = 0.1 * (1 - 0.4 * share);
    test.of("right_position")[k] = 0.1 / (1 - 0.4 * share);
    test.of("bottom_force")[k] = test.of("top_force")[k] = 3e3 * 0.01 * test.of("right_position")[k];
    test.of("left_force")[k] = test.of("right_force")[k] = 1e3 * 0.01 * test.of("top_position")[k];
  }
  test.stage.texture["loads"]["right"]["asked_Pa"] = 1e3;
  ASSERT_TRUE(critical_state(*test_curves(fields::Test{test.stage}))) << "the top moves at a given speed";
  test.stage.texture["loads"]["top"]["asked_Pa"] = 3e3;
  EXPECT_TRUE(test_curves(fields::Test{test.stage})->by_stress);
  EXPECT_FALSE(critical_state(*test_curves(fields::Test{test.stage}))) << "its ratio is what was asked for";
}

TEST(TestCurves, ACriticalStateTellsItsInertialNumber) {
  Loading test = steady_shear(0.3);
  Packing& packing = test.stage.snapshots.back().packing;
  packing.materials = {{"glass", 2500, 1e6, 0}};
  const auto curves = test_curves(fields::Test{test.stage});
  const auto state = critical_state(*curves);
  ASSERT_TRUE(state);
  const double pressure = 100 / (0.1 * 0.01), expected = 4.0 / 1999 * 0.1 * std::sqrt(2500 / pressure);
  EXPECT_NEAR(state->inertial_number, expected, 0.01 * expected);
  EXPECT_NEAR(numbers_of(*curves, *state)["inertial_number"].get<double>(), expected, 0.01 * expected);
}

TEST(TestCurves, OfASampleThatIsDrawnApartAreOfTheStressAlongTheAxis) {
  Loading test(5, false);
  test.of("top_position") = {0.1, 0.101, 0.102, 0.103, 0.104};
  test.of("bottom_force") = test.of("top_force") = {0.2, -0.1, -0.3, -0.2, -0.1};
  test.of("left_force") = test.of("right_force") = {0.2, 0.05, -0.1, -0.1, 0};
  const auto curves = test_curves(fields::Test{test.stage});
  ASSERT_TRUE(curves);
  EXPECT_EQ(curves->ratio_name(), "axial_stress");
  EXPECT_NEAR(curves->ratio[2], -0.3 / (0.1 * 0.01), 1e-9);
  test.of("top_position") = {0.1, 0.099, 0.098, 0.097, 0.096};
  EXPECT_EQ(test_curves(fields::Test{test.stage})->ratio_name(), "q_over_p");
}

TEST(TestCurves, WithoutConfinementAreOfTheStressAlongTheAxis) {
  Loading test(5, false);
  test.of("top_position") = {0.1, 0.0999, 0.0998, 0.0997, 0.0996};
  test.stage.snapshots.back().packing.domain.thickness = 0.06;
  for (std::size_t k = 0; k < 5; ++k)
    test.of("bottom_force")[k] = test.of("top_force")[k] = 600.0 * static_cast<double>(k);
  const auto curves = test_curves(fields::Test{test.stage});
  ASSERT_TRUE(curves);
  EXPECT_EQ(curves->ratio_name(), "axial_stress");
  EXPECT_NEAR(curves->ratio[4], 2400 / (0.1 * 0.06), 1e-6);
  EXPECT_FALSE(critical_state(*curves));
}

TEST(TestCurves, AreNotThoseOfAStageThatHardlyStrains) {
  Loading test(5, false);
  test.of("top_position") = {0.1, 0.09999, 0.09998, 0.09997, 0.09996};
  EXPECT_FALSE(test_curves(fields::Test{test.stage}));
  test.stage.history.columns.clear();
  EXPECT_FALSE(test_curves(fields::Test{test.stage}));
}

TEST(TestCurves, ACriticalStateCoversWhatMadeIt) {
  int covered = 0;
  for (const double plateau : {0.2, 0.25, 0.3, 0.35, 0.4}) {
    const auto curves = test_curves(fields::Test{steady_shear(plateau).stage});
    ASSERT_TRUE(curves);
    EXPECT_EQ(curves->ratio_name(), "mu");
    const auto state = critical_state(*curves);
    ASSERT_TRUE(state) << plateau;
    EXPECT_GT(state->from, 0.05) << "the rise is counted";
    EXPECT_LT(state->from, 2);
    EXPECT_DOUBLE_EQ(state->to, 4);
    EXPECT_LT(state->ratio.error, 2e-3);
    const auto [low, high] = statistics::confidence_95(state->ratio);
    covered += low <= plateau && plateau <= high ? 1 : 0;
    EXPECT_NEAR(state->solid_fraction.value, std::numbers::pi / 4, 2e-4);
    const Numbers j = numbers_of(*curves, *state);
    EXPECT_NEAR(j["mu"]["value"].get<double>(), plateau, 5e-3);
    EXPECT_LT(j["mu"]["low_95"].get<double>(), j["mu"]["high_95"].get<double>());
    EXPECT_NE(to_text(j).find("Mean shear over mean normal stress on the sides"), std::string::npos);
  }
  EXPECT_GE(covered, 4);
}

/// The same with a friction that forgets within 30 samples, so that of the plateau's some thirty are independent.
Loading slow_fluctuations(double plateau, std::uint64_t seed) {
  Loading test = steady_shear(plateau);
  RandomStream random(seed, Purpose::test);
  double deviation = 0;
  for (std::size_t k = 0; k < 2000; ++k) {
    deviation = std::exp(-1 / 30.0) * deviation + std::sqrt(1 - std::exp(-2 / 30.0)) * 0.03 * random.normal();
    test.of("bottom_shear_force")[k] = 100 * (plateau * (1 - std::exp(-0.025 * static_cast<double>(k))) + deviation);
    test.of("top_shear_force")[k] = -test.of("bottom_shear_force")[k];
  }
  return test;
}

TEST(TestCurves, ACriticalStateOfFewFluctuationsHasAWideIntervalAndSaysSo) {
  int found = 0, covered = 0, sure = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto curves = test_curves(fields::Test{slow_fluctuations(0.3, seed).stage});
    const auto state = critical_state(*curves);
    if (!state) continue;
    ++found;
    sure += state->sure ? 1 : 0;
    EXPECT_LT(state->ratio.error, 0.02);
    const auto [low, high] = statistics::confidence_95(state->ratio);
    covered += low <= 0.3 && 0.3 <= high ? 1 : 0;
  }
  EXPECT_GE(found, 45);
  EXPECT_LT(sure, found / 2);
  EXPECT_GE(covered, 92 * found / 100);  // 95 % within chance
}

TEST(TestCurves, ARatioIsThatOfTheMeansAndNotTheMeanOfRatios) {
  // The pressure fluctuates by a fifth, the shear force against it: the mean of ratios is larger by the fifth's square
  // and by what goes together.
  Loading test = steady_shear(0.3);
  RandomStream random(6, Purpose::test);
  double shear = 0, normal = 0, ratios = 0;
  for (std::size_t k = 0; k < 2000; ++k) {
    const double off = 0.2 * random.normal(), force = 100 * (1 + off),
                 along = 100 * (0.3 * (1 - std::exp(-0.025 * static_cast<double>(k))) - 0.1 * off);
    test.of("bottom_force")[k] = test.of("top_force")[k] = force;
    test.of("bottom_shear_force")[k] = along;
    test.of("top_shear_force")[k] = -along;
    if (k >= 1000) shear += along, normal += force, ratios += along / force / 1000;
  }
  const auto state = critical_state(*test_curves(fields::Test{test.stage}));
  ASSERT_TRUE(state);
  EXPECT_GT(ratios - shear / normal, 0.01);
  EXPECT_NEAR(state->ratio.value, shear / normal, 3 * state->ratio.error);
  EXPECT_LT(state->ratio.error, 0.003);
}

/// A box between walls that slide along themselves, the top by a table over time.
StageResult slid_to_and_fro() {
  Loading test(400, false);
  for (std::size_t k = 0; k < 400; ++k) {
    test.of("time")[k] =
        5 + 0.01 * static_cast<double>(k + 1);  // the stage began at 5 s; its first row is a little later
    test.of("bottom_force")[k] = test.of("top_force")[k] = 100;
    test.of("bottom_shear_force")[k] = 30, test.of("top_shear_force")[k] = -30;
  }
  dem::Stage asked;
  asked.duration = 4;
  asked.slide[top] = 0.01;
  asked.programmes = {{{dem::Programme::What::slide, top}, {{0, 0.01}, {1, 0.02}, {2, -0.02}}, true}};
  add_driven(test.stage, asked);
  return test.stage;
}

TEST(TestCurves, OfAProgrammedSlideAreOfTheWayThatItWent) {
  const auto curves = test_curves(fields::Test{slid_to_and_fro()});
  ASSERT_TRUE(curves);
  EXPECT_EQ(curves->strain_name, "shear strain");
  // 15 mm in the first second, then 5 mm forth and 5 mm back in half a second each; over 100 mm of height, since the
  // first row at 0.01 s.
  EXPECT_NEAR(curves->strain[99], 0.15, 2e-3);
  EXPECT_NEAR(curves->strain[149], 0.20, 2e-3);
  EXPECT_NEAR(curves->strain[199], 0.15, 2e-3);
  EXPECT_NEAR(curves->strain[399], 0.30, 2e-3);
}

TEST(TestCurves, NoCriticalStateWhileTheVolumeChanges) {
  Loading test = steady_shear(0.3);
  for (std::size_t k = 0; k < 2000; ++k) test.of("top_position")[k] = 0.1 - 1e-6 * static_cast<double>(k);
  EXPECT_FALSE(critical_state(*test_curves(fields::Test{test.stage})));
}

TEST(TestCurves, NoCriticalStateWhereTheRatioDriftsOrTheStrainTurns) {
  Loading rising = steady_shear(0.3);
  for (std::size_t k = 0; k < 2000; ++k)
    rising.of("bottom_shear_force")[k] = 0.02 * static_cast<double>(k),
    rising.of("top_shear_force")[k] = -rising.of("bottom_shear_force")[k];
  EXPECT_FALSE(critical_state(*test_curves(fields::Test{rising.stage})));
  Loading back = steady_shear(0.3);
  for (std::size_t k = 0; k < 2000; ++k) back.of("shear_strain")[k] = std::sin(static_cast<double>(k) * 0.01);
  EXPECT_FALSE(critical_state(*test_curves(fields::Test{back.stage})));
}

TEST(TestCurves, RunningRatioIsThatOfTheMeans) {
  TestCurves curves;
  for (std::size_t k = 0; k < 1000; ++k) {
    curves.shear.push_back(-1);
    curves.normal.push_back(k % 2 == 0 ? 1 : 3);
    curves.ratio.push_back(k < 5 ? std::nan("") : 1 / curves.normal.back());
  }
  const std::vector<double> found = running_ratio(curves);
  EXPECT_TRUE(std::isnan(found[4]));
  EXPECT_NEAR(found[500], 11.0 / 23, 1e-12);  // of eleven rows, of which five have 1: not the mean ratio, 7/11
  curves.normal.clear();
  EXPECT_NEAR(running_ratio(curves)[500], 7.0 / 11, 1e-12);
}

}  // namespace
}  // namespace arenite::fields
