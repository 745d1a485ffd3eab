#include "validation/family.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arenite::validation {
namespace {

Family alike(std::size_t count, double value, double error, double freedom = 4) {
  Family family;
  for (std::size_t k = 0; k < count; ++k) family.push_back({"pair " + std::to_string(k), {value, error, freedom}});
  return family;
}

TEST(Holm, StepsDown) {
  // 0.01 < 0.05/4, 0.013 < 0.05/3, 0.03 > 0.05/2: what comes after is not looked at.
  EXPECT_EQ(holm({0.03, 0.01, 0.04, 0.013}, 0.05), (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(holm({0.01, 0.02, 0.03}, 0.05), (std::vector<bool>{true, true, true}));
  EXPECT_EQ(holm({0.04}, 0.05), std::vector<bool>{true});
  EXPECT_EQ(holm({0.04, statistics::unknown}, 0.05), (std::vector<bool>{false, false}));
  EXPECT_TRUE(holm({}, 0.05).empty());
}

TEST(Holm, OfManyWithoutEffectRarelyFindsOne) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> even(0, 1);
  int found = 0;
  const int rounds = 2000;
  for (int k = 0; k < rounds; ++k) {
    std::vector<double> chances(45);
    for (double& chance : chances) chance = even(random);
    for (const bool one : holm(chances, 0.05))
      if (one) {
        ++found;
        break;
      }
  }
  EXPECT_NEAR(static_cast<double>(found) / rounds, 0.05, 0.015);
}

TEST(Every, HoldsIfEachShowsItAndTellsTheLeastSure) {
  Family family = alike(45, 1, 0.1);
  family[7].value = {1, 0.2, 4};
  const Check check = every("rises", "> 0", family, {.low = 0});
  EXPECT_EQ(check.outcome, Outcome::holds);
  EXPECT_EQ(check.what, "rises, in 45 of 45; worst case pair 7");
  EXPECT_EQ(check.ours.error, 0.2);
}

TEST(Every, OneThatStraysByChanceAmongManyFailsNothing) {
  Family family = alike(45, 1, 0.1);
  family[7].value = {-0.35, 0.1, 4};  // 3.5 errors: alone it fails
  EXPECT_EQ(every("", "", {family[7]}, {.low = 0}).outcome, Outcome::fails);
  EXPECT_EQ(every("", "", family, {.low = 0}).outcome, Outcome::undecided);
  family[7].value = {-2, 0.1, 4};
  const Check check = every("rises", "", family, {.low = 0});
  EXPECT_EQ(check.outcome, Outcome::fails);
  EXPECT_EQ(check.what, "rises, in 44 of 45, violated in 1; worst case pair 7");
}

TEST(Every, IsUndecidedWhereOneIsNotSureAndUnknownWhereOneIsMissing) {
  Family family = alike(3, 1, 0.1);
  family.push_back({"weak", {0.1, 0.1, 4}});
  EXPECT_EQ(every("", "", family, {.low = 0}).outcome, Outcome::undecided);
  family.push_back({"none", {}});
  EXPECT_EQ(every("", "", family, {.low = 0}).outcome, Outcome::unknown);
  EXPECT_EQ(every("", "", {}, {.low = 0}).outcome, Outcome::unknown);
}

TEST(Every, AsksForSeedsOfTheOneOutsideAloneAndOfAsManyAsFailItAmongAll) {
  Family family = alike(45, 1, 0.1, 40);
  for (std::size_t k = 0; k < 3; ++k) {
    family[k].value = {0.1, 0.1, 40};
    family[k].draws = {{"study", {{"k", std::to_string(k)}}}};
  }
  EXPECT_EQ(every("", "", family, {.low = 0}).draws.size(), 3u);
  family[1].value.value = -0.2;
  const Check check = every("", "", family, {.low = 0});
  ASSERT_EQ(check.outcome, Outcome::undecided);
  EXPECT_EQ(check.draws, family[1].draws);
  // 0.025/45 leaves 3.26 errors of a normal distribution.
  EXPECT_NEAR(seeds_factor(check), std::pow(3.26 / 2, 2), 0.15);
  const double times = 1.02 * seeds_factor(check);
  family[1].value = {-0.2, 0.1 / std::sqrt(times), 41 * times - 1};
  EXPECT_EQ(every("", "", family, {.low = 0}).outcome, Outcome::fails);
}

TEST(Every, OfARangeLooksAtBothEnds) {
  Family family = alike(5, 0.85, 0.001);
  EXPECT_EQ(every("", "", family, {0.82, 0.89}).outcome, Outcome::holds);
  family[2].value.value = 0.91;
  EXPECT_EQ(every("", "", family, {0.82, 0.89}).outcome, Outcome::fails);
  EXPECT_EQ(every("", "", family, {0.82, 0.89}).ours.value, 0.91);
}

TEST(OnTheWhole, NeedsTheMeanAndNoContradiction) {
  // None of 45 is sure by itself; together they are.
  Family family = alike(45, 0.15, 0.1);
  EXPECT_EQ(every("", "", family, {.low = 0}).outcome, Outcome::undecided);
  const Check check = on_the_whole("more", "", family, +1);
  EXPECT_EQ(check.outcome, Outcome::holds);
  EXPECT_NEAR(check.ours.error, 0.1 / std::sqrt(45.0), 1e-12);
  EXPECT_NEAR(check.ours.freedom, 45 * 4, 1e-9);
  EXPECT_EQ(on_the_whole("", "", family, -1).outcome, Outcome::fails);
  family[3].value = {-1, 0.1, 4};
  const Check against = on_the_whole("more", "", family, +1);
  EXPECT_EQ(against.outcome, Outcome::fails);
  EXPECT_NE(against.what.find("contradicting: pair 3 (-1.00 +- 0.10)"), std::string::npos) << against.what;
  family[3].value = {-0.3, 0.1, 4};
  EXPECT_EQ(on_the_whole("", "", family, +1).outcome, Outcome::holds)
      << "3 errors of 5 samples the other way are chance among 45";
}

TEST(OnTheWhole, IsUndecidedWithoutErrorsAndUnknownWithoutMembers) {
  EXPECT_EQ(on_the_whole("", "", alike(3, 1, statistics::unknown), +1).outcome, Outcome::undecided);
  EXPECT_EQ(on_the_whole("", "", {}, +1).outcome, Outcome::unknown);
}

}  // namespace
}  // namespace arenite::validation
