#include "validation/claim.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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
  for (const auto& [kind, outcome] : all) judgement.checks.push_back({"a number", "1", "", "0.9 to 1.1", {1, 0.01, 4}, {0.9, 1.1}, outcome, kind});
  return judgement;
}

constexpr auto trend = Kind::trend, number = Kind::number, source = Kind::source, beside = Kind::beside;
constexpr auto holds = Outcome::holds, fails = Outcome::fails, undecided = Outcome::undecided, unknown = Outcome::unknown;

TEST(Verdict, IsReproducedWhereTrendsAndNumbersHold) {
  EXPECT_EQ(of({{trend, holds}, {number, holds}, {source, holds}}).verdict(), Verdict::reproduced);
  EXPECT_EQ(of({{number, holds}}).verdict(), Verdict::reproduced);
}

TEST(Verdict, KeepsTrendsApartFromNumbers) {
  EXPECT_EQ(of({{trend, holds}, {number, fails}, {number, holds}}).verdict(), Verdict::trend_reproduced);
  EXPECT_EQ(of({{trend, fails}, {number, holds}}).verdict(), Verdict::not_reproduced);
  EXPECT_EQ(of({{number, fails}, {number, holds}}).verdict(), Verdict::not_reproduced) << "a claim of numbers alone stands and falls with them";
}

TEST(Verdict, IsUndecidedWhereNothingFailsThatDecides) {
  EXPECT_EQ(of({{trend, undecided}, {number, holds}}).verdict(), Verdict::undecided);
  EXPECT_EQ(of({{trend, undecided}, {number, fails}}).verdict(), Verdict::undecided) << "whether the trend is there is open";
  EXPECT_EQ(of({{trend, holds}, {number, undecided}}).verdict(), Verdict::undecided);
  EXPECT_EQ(of({{trend, undecided}, {trend, fails}}).verdict(), Verdict::not_reproduced);
}

TEST(Verdict, IsUnknownWhileRunsAreMissingUnlessATrendFails) {
  EXPECT_EQ(of({}).verdict(), Verdict::unknown);
  EXPECT_EQ(of({{trend, holds}, {number, unknown}}).verdict(), Verdict::unknown);
  EXPECT_EQ(of({{trend, holds}, {number, unknown}, {number, fails}}).verdict(), Verdict::unknown);
  EXPECT_EQ(of({{trend, unknown}, {trend, fails}}).verdict(), Verdict::not_reproduced);
}

TEST(Verdict, OfASourceThatContradictsItselfIsNeither) { EXPECT_EQ(of({{trend, fails}, {source, fails}}).verdict(), Verdict::source_inconsistent); }

TEST(Verdict, DoesNotHangOnWhatIsToldBeside) {
  EXPECT_EQ(of({{trend, holds}, {beside, fails}, {beside, unknown}}).verdict(), Verdict::reproduced);
  EXPECT_EQ(of({{beside, holds}}).verdict(), Verdict::unknown);
}

TEST(WhatDecides, IsTheFactBeforeTheChoiceBeforeTheNumber) {
  Judgement judgement = of({{trend, fails}});
  EXPECT_EQ(what_decides(judgement), "None of the choices tried meets the criterion. A number: 1.000 +- 0.010, required 0.9 to 1.1.");
  Sensitivity z{"z", "> 2", {.low = 2}, {{"", {1, 0.1, 4}, fails}, {"without friction", {3, 0.1, 4}, holds}, {"with drag", {1.1, 0.1, 4}, fails}}};
  judgement.sensitivities = {z};
  EXPECT_EQ(what_decides(judgement), "z meets its criterion (> 2) without friction.");
  judgement.decides = "The glue.";
  EXPECT_EQ(what_decides(judgement), "The glue.");
}

TEST(WhatDecides, IsNoChoiceThatDiffersByChance) {
  Judgement judgement = of({{trend, undecided}});
  judgement.sensitivities = {{"z", "> 2", {.low = 2}, {{"", {2.05, 0.1, 4}, undecided}, {"without friction", {2.2, 0.05, 4}, holds}}}};
  EXPECT_EQ(what_decides(judgement), "More samples are needed. A number: 1.000 +- 0.010, required 0.9 to 1.1.");
}

TEST(WhatDecides, OfWhatIsReproducedIsTheChoiceThatSpoilsIt) {
  Judgement judgement = of({{trend, holds}});
  judgement.sensitivities = {
      {"z", "> 2", {.low = 2}, {{"", {3, 0.1, 4}, holds}, {"without friction", {1, 0.1, 4}, fails}, {"with drag", {3.1, 0.1, 4}, holds}}}};
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
    const auto figures = report::read_figures(embedded_text(claim.studies.front(), "figures.toml"), claim.studies.front());
    EXPECT_TRUE(std::any_of(figures.begin(), figures.end(), [&](const auto& figure) { return figure.id == claim.figure; }))
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
