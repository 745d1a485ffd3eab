#include "validation/checks.hpp"

#include <gtest/gtest.h>

namespace arenite::validation {
namespace {

TEST(Checks, HoldFailOrAreUndecidedByTheInterval) {
  const auto above_1 = [](double value, double error, double freedom) {
    return above("", "", {value, error, freedom}, 1).outcome;
  };
  EXPECT_EQ(above_1(1.3, 0.1, 4), Outcome::holds);
  EXPECT_EQ(above_1(0.7, 0.1, 4), Outcome::fails);
  EXPECT_EQ(above_1(1.2, 0.1, 4), Outcome::undecided);
  EXPECT_EQ(above_1(0.8, 0.1, 4), Outcome::undecided) << "50.65 +- 0.75 against 50 is no failure";
}

TEST(Checks, ThreeErrorsAreEnoughForFiveSamplesAndNotForThreeOrTwo) {
  EXPECT_EQ(positive("", "", {3, 1, 4}).outcome, Outcome::holds);
  EXPECT_EQ(positive("", "", {3, 1, 2}).outcome, Outcome::undecided);
  EXPECT_EQ(positive("", "", {5, 1, 2}).outcome, Outcome::holds);
  EXPECT_EQ(positive("", "", {12, 1, 1}).outcome, Outcome::undecided);
  EXPECT_EQ(positive("", "", {13, 1, 1}).outcome, Outcome::holds);
  EXPECT_EQ(negative("", "", {13, 1, 1}).outcome, Outcome::fails);
}

TEST(Checks, OneSampleDecidesNothingAndNoneIsUnknown) {
  EXPECT_EQ(positive("", "", {7}).outcome, Outcome::undecided);
  EXPECT_EQ(positive("", "", {7, 0.1, 0}).outcome, Outcome::undecided);
  EXPECT_EQ(positive("", "", {}).outcome, Outcome::unknown);
}

TEST(Checks, WithoutErrorTheValueDecides) {
  EXPECT_EQ(within("", {1.05, 0}, 1, 0.1).outcome, Outcome::holds);
  EXPECT_EQ(within("", {1.15, 0}, 1, 0.1).outcome, Outcome::fails);
  EXPECT_EQ(above("", "", {2, 0}, 2).outcome, Outcome::fails);
}

TEST(Checks, ARangeMustHoldTheWholeInterval) {
  const auto in = [](double value, double error) { return between("", "", {value, error, 4}, 1.04, 1.10).outcome; };
  EXPECT_EQ(in(1.07, 0.008), Outcome::holds);
  EXPECT_EQ(in(1.07, 0.02), Outcome::undecided);
  EXPECT_EQ(in(1.09, 0.008), Outcome::undecided);
  EXPECT_EQ(in(1.13, 0.008), Outcome::fails);
}

TEST(Checks, EqualityIsShownAndNotMerelyNotDisproved) {
  // A slope that is surely not zero but small is none; one that is not significant for want of samples is not shown to
  // be none.
  EXPECT_EQ(equivalent("", "", {0.021, 0.002, 9}, 0.05).outcome, Outcome::holds);
  EXPECT_EQ(equivalent("", "", {0.01, 0.05, 9}, 0.05).outcome, Outcome::undecided);
  EXPECT_EQ(equivalent("", "", {0.09, 0.01, 9}, 0.05).outcome, Outcome::fails);
  // More samples make an equality surer.
  EXPECT_EQ(equivalent("", "", {0.021, 0.02, 4}, 0.05).outcome, Outcome::undecided);
  EXPECT_EQ(equivalent("", "", {0.021, 0.01, 19}, 0.05).outcome, Outcome::holds);
}

TEST(Checks, ADifferenceIsShownRefutedOrOpen) {
  EXPECT_EQ(differs("", "", {0.3, 0.05, 4}, 0.02).outcome, Outcome::holds);
  EXPECT_EQ(differs("", "", {0.001, 0.002, 4}, 0.02).outcome, Outcome::fails);
  EXPECT_EQ(differs("", "", {0.03, 0.05, 4}, 0.02).outcome, Outcome::undecided);
  EXPECT_EQ(differs("", "", {}, 0.02).outcome, Outcome::unknown);
}

TEST(Checks, ADifferenceIsNeverBothShownAndRefuted) {
  const auto is_other = [](double value, double error) { return differs("", "", {value, error, 9}, 0.02).outcome; };
  EXPECT_EQ(is_other(-0.048, 0.011), Outcome::holds);
  EXPECT_EQ(is_other(-0.026, 0.013), Outcome::undecided) << "beyond the margin, and not yet beyond its error";
  EXPECT_EQ(is_other(0.01, 0.001), Outcome::fails) << "surely not zero, and surely within the margin";
  EXPECT_EQ(is_other(0.019, 0.003), Outcome::holds) << "surely not zero, and perhaps beyond the margin";
  EXPECT_EQ(is_other(0, 0), Outcome::fails);
}

TEST(Checks, ToldBesideCountAndNameWhatFails) {
  Judgement judgement;
  add_beside(judgement, "under law R",
             {above("z", "", {4.2, 0.01, 4}, 4), above("rise", "", {}, 0), above("share", "", {0.1, 0.01, 4}, 0.5)});
  ASSERT_EQ(judgement.findings.size(), 1u);
  EXPECT_EQ(judgement.findings[0], "Under law R, 1 of 2 corresponding checks hold; failing: share (0.100 +- 0.010).");
  ASSERT_EQ(judgement.checks.size(), 2u);
  EXPECT_EQ(judgement.checks[0].what, "z, under law R");
  EXPECT_EQ(judgement.checks[0].kind, Kind::beside);
  add_beside(judgement, "in shear", {above("z", "", {}, 4)});
  EXPECT_EQ(judgement.findings.size(), 1u);
}

}  // namespace
}  // namespace arenite::validation
