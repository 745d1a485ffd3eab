#include "validation/claim.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "report/figure_list.hpp"
#include "validation/checks.hpp"
#include "validation/results.hpp"
#include "validation/studies.hpp"

namespace arenite::validation {
namespace claim_test {

struct Question {
  Kind kind;
  Outcome outcome;
};

Judgement of(std::initializer_list<Question> all) {
  Judgement judgement;
  for (const auto& [kind, outcome] : all)
    judgement.checks.push_back({"a number", "1", "", "0.9 to 1.1", {1, 0.01, 4}, {0.9, 1.1}, outcome, kind});
  return judgement;
}

constexpr auto trend = Kind::trend, number = Kind::number, source = Kind::source, beside = Kind::beside;
constexpr auto holds = Outcome::holds, fails = Outcome::fails, undecided = Outcome::undecided,
               unknown = Outcome::unknown;

TEST(Verdict, IsReproducedWhereTrendsAndNumbersHold) {
  EXPECT_EQ(of({{trend, holds}, {number, holds}, {source, holds}}).verdict(), Verdict::reproduced);
  EXPECT_EQ(of({{number, holds}}).verdict(), Verdict::reproduced);
}

TEST(Verdict, KeepsTrendsApartFromNumbers) {
  EXPECT_EQ(of({{trend, holds}, {number, fails}, {number, holds}}).verdict(), Verdict::trend_reproduced);
  EXPECT_EQ(of({{trend, fails}, {number, holds}}).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(of({{number, fails}, {number, holds}}).verdict(), Verdict::not_reproduced)
      << "a claim of numbers alone stands and falls with them";
}

TEST(Verdict, IsUndecidedWhereNothingFailsThatDecides) {
  EXPECT_EQ(of({{trend, undecided}, {number, holds}}).verdict(), Verdict::undecided);
  EXPECT_EQ(of({{trend, undecided}, {number, fails}}).verdict(), Verdict::undecided)
      << "whether the trend is there is open";
  EXPECT_EQ(of({{trend, holds}, {number, undecided}}).verdict(), Verdict::undecided);
  EXPECT_EQ(of({{trend, undecided}, {trend, fails}}).verdict(), Verdict::not_reproduced);
}

TEST(Verdict, IsUnknownWhileRunsAreMissingUnlessATrendFails) {
  EXPECT_EQ(of({}).verdict(), Verdict::unknown);
  EXPECT_EQ(of({{trend, holds}, {number, unknown}}).verdict(), Verdict::unknown);
  EXPECT_EQ(of({{trend, holds}, {number, unknown}, {number, fails}}).verdict(), Verdict::unknown);
  EXPECT_EQ(of({{trend, unknown}, {trend, fails}}).verdict(), Verdict::not_reproduced);
}

TEST(Verdict, OfASourceThatContradictsItselfIsNeither) {
  EXPECT_EQ(of({{trend, fails}, {source, fails}}).verdict(), Verdict::source_inconsistent);
}

TEST(Verdict, OfWhatNoRunCanTestIsNeither) {
  Judgement judgement = of({{beside, fails}});
  judgement.untestable = "The positions are lost.";
  EXPECT_EQ(judgement.verdict(), Verdict::not_testable);
  EXPECT_EQ(decider_of(judgement), Decider::lost);
  EXPECT_EQ(what_decides(judgement), "The positions are lost.");
  judgement.checks[0].outcome = unknown;
  EXPECT_EQ(judgement.verdict(), Verdict::unknown) << "there are no runs";
}

TEST(Verdict, DoesNotHangOnWhatIsToldBeside) {
  EXPECT_EQ(of({{trend, holds}, {beside, fails}, {beside, unknown}}).verdict(), Verdict::reproduced);
  EXPECT_EQ(of({{beside, holds}}).verdict(), Verdict::unknown);
}

TEST(WhatDecides, IsTheFactBeforeTheChoiceBeforeTheNumber) {
  Judgement judgement = of({{trend, fails}});
  EXPECT_EQ(what_decides(judgement),
            "No other choices were tried for it. A number: 1.000 +- 0.010, required 0.9 to 1.1.");
  Sensitivity z{"z", "> 2", {.low = 2}, {{"", {1, 0.1, 4}, fails}, {"with drag", {1.1, 0.1, 4}, fails}}};
  judgement.sensitivities = {z};
  EXPECT_EQ(what_decides(judgement),
            "None of the choices tried meets the criterion. A number: 1.000 +- 0.010, required 0.9 to 1.1.");
  EXPECT_EQ(decider_of(judgement), Decider::none);
  judgement.sensitivities[0].entries.push_back({"with glue", {2.1, 0.5, 4}, undecided});
  EXPECT_EQ(what_decides(judgement),
            "None of the choices tried meets the criterion; 1 of 2 is undecided and wants seeds. A number: 1.000 +- "
            "0.010, required 0.9 to 1.1.");
  judgement.sensitivities[0].entries.push_back({"on a coarse grid", {2.5, 0.9, 4}, holds});
  EXPECT_EQ(what_decides(judgement).find("None of the choices tried meets the criterion; 2 of 3 are undecided"), 0u)
      << "what the change's error leaves open turns nothing";
  judgement.sensitivities[0].entries.push_back({"without friction", {3, 0.1, 4}, holds});
  EXPECT_EQ(what_decides(judgement), "z meets its criterion (> 2) without friction.");
  EXPECT_EQ(decider_of(judgement), Decider::protocol);
  judgement.sensitivities[0].entries.back().kind = Decider::reading;
  EXPECT_EQ(decider_of(judgement), Decider::reading);
  judgement.decides = "The glue.";
  EXPECT_EQ(what_decides(judgement), "The glue.");
}

TEST(WhatDecides, IsNoChoiceThatDiffersByChance) {
  Judgement judgement = of({{trend, undecided}});
  judgement.sensitivities = {
      {"z", "> 2", {.low = 2}, {{"", {2.05, 0.1, 4}, undecided}, {"without friction", {2.2, 0.05, 4}, holds}}}};
  EXPECT_EQ(what_decides(judgement),
            "About 1.0 times as many seeds would decide it. A number: 1.000 +- 0.010, required 0.9 to 1.1.");
  EXPECT_EQ(decider_of(judgement), Decider::seeds);
}

TEST(WhatDecides, IsTheGridWhereGridsMoveANumberAcrossItsBound) {
  Judgement judgement = of({{trend, undecided}});
  const auto with = [&](Decider kind, double finer) {
    judgement.sensitivities = {{"the mean in small grains",
                                "< 1",
                                {.high = 1},
                                {{"", {1.002, 0.0015, 4}, undecided},
                                 {"with 512 nodes", {0.976, 0.002, 4}, holds, kind},
                                 {"with 2048 nodes", {finer, 0.002, 4}, finer > 1 ? fails : holds, kind}}}};
    return decider_of(judgement);
  };
  EXPECT_EQ(with(Decider::protocol, 1.019), Decider::seeds)
      << "more of them tell what holds with the reference settings";
  EXPECT_EQ(with(Decider::grid, 0.98), Decider::seeds) << "no grid gives the other end";
  EXPECT_EQ(with(Decider::grid, 1.019), Decider::grid);
  EXPECT_EQ(what_decides(judgement),
            "The grid decides it. The mean in small grains: 0.9760 +- 0.0020 with 512 nodes, 1.0020 +- 0.0015 with the "
            "reference settings and 1.0190 +- 0.0020 with 2048 nodes, required < 1.");
}

TEST(WhatDecides, IsWhatTheDecidingCheckSaysOfItself) {
  Judgement judgement = of({{trend, holds}, {number, fails}});
  judgement.checks[1].decider = Decider::lost;
  EXPECT_EQ(decider_of(judgement), Decider::lost);
  EXPECT_EQ(decider_of(of({{trend, holds}, {source, fails}})), Decider::source);
  EXPECT_EQ(decider_of(of({{trend, unknown}})), Decider::runs);
  EXPECT_EQ(decider_of(of({{trend, holds}})), Decider::none);
}

TEST(WhatDecides, TellsHowManyTimesAsManySeedsItTakes) {
  const auto factor = [](double value, double error, double freedom) {
    return seeds_factor(above("", "", {value, error, freedom}, 0));
  };
  // Ten seeds: 0.037 +- 0.022 is beyond its error with 18 (0.037 over 0.0164 is 2.26 > t of 17 degrees of freedom,
  // 2.11).
  EXPECT_NEAR(factor(0.037, 0.022, 9), 1.6, 0.1);
  EXPECT_NEAR(factor(-0.037, 0.022, 9), 1.6, 0.1) << "or fails with as many";
  EXPECT_EQ(factor(3, 1, 9), 1) << "decided";
  EXPECT_EQ(factor(0.001, 1, 9), most_times_seeds);
  EXPECT_TRUE(std::isnan(factor(1, statistics::unknown, 0)));
}

TEST(WhatDecides, OfWhatIsReproducedIsTheChoiceThatSpoilsIt) {
  Judgement judgement = of({{trend, holds}});
  judgement.sensitivities = {
      {"z",
       "> 2",
       {.low = 2},
       {{"", {3, 0.1, 4}, holds}, {"without friction", {1, 0.1, 4}, fails}, {"with drag", {3.1, 0.1, 4}, holds}}}};
  EXPECT_EQ(what_decides(judgement), "z no longer meets its criterion (> 2) without friction.");
  judgement.sensitivities[0].entries.erase(judgement.sensitivities[0].entries.begin() + 1);
  EXPECT_EQ(what_decides(judgement), "None of the choices tried reverses it.");
}

TEST(Claims, HaveIdsOfTheirOwnAndStudiesThatComeWithTheProgram) {
  std::vector<std::string> ids;
  for (const Claim& claim : claims()) {
    EXPECT_TRUE(claim.id[0] == 'T' || claim.id[0] == 'P') << claim.id;
    EXPECT_EQ(std::count(ids.begin(), ids.end(), claim.id), 0) << claim.id;
    ids.emplace_back(claim.id);
    for (const auto& study : claim.studies) EXPECT_NE(find_study(study), nullptr) << claim.id << " names " << study;
  }
}

TEST(Claims, HaveTheirFigureOnThePageOfTheirFirstStudy) {
  for (const Claim& claim : claims()) {
    if (figure_place(claim).empty()) continue;
    const auto figures =
        report::read_figures(embedded_text(claim.studies.front(), "figures.toml"), claim.studies.front());
    EXPECT_TRUE(
        std::any_of(figures.begin(), figures.end(), [&](const auto& figure) { return figure.id == claim.figure; }))
        << claim.id << ": " << figure_place(claim);
  }
}

TEST(Claims, AreUnknownWithoutRunsUnlessTheSourceContradictsItself) {
  for (const Claim& claim : claims()) {
    const Judgement judgement = claim.judge(Results());
    const Verdict wanted = std::string(claim.id) == "T5" ? Verdict::source_inconsistent : Verdict::unknown;
    EXPECT_EQ(judgement.verdict(), wanted) << claim.id;
    EXPECT_FALSE(what_decides(judgement).empty()) << claim.id;
  }
}

}  // namespace claim_test
}  // namespace arenite::validation
