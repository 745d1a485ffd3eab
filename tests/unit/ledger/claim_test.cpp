#include "ledger/claim.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "ledger/results.hpp"
#include "ledger/studies.hpp"
#include "report/figure_list.hpp"

namespace arenite::ledger {
namespace {

Verdict of(std::initializer_list<Holds> all) {
  Verdict verdict;
  for (const Holds holds : all) verdict.checks.push_back({"a number", "1", "", "+- 0.1", 1, 0.01, holds});
  return verdict;
}

TEST(Verdict, HoldsWhenAllChecksDo) { EXPECT_EQ(of({Holds::yes, Holds::yes}).holds(), Holds::yes); }

TEST(Verdict, FailsWhenOneFailsWhateverIsUnknown) { EXPECT_EQ(of({Holds::unknown, Holds::no, Holds::yes}).holds(), Holds::no); }

TEST(Verdict, IsUnknownWhileOneIsUnknownOrThereIsNone) {
  EXPECT_EQ(of({Holds::yes, Holds::unknown}).holds(), Holds::unknown);
  EXPECT_EQ(of({}).holds(), Holds::unknown);
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
    EXPECT_TRUE(std::any_of(figures.begin(), figures.end(), [&](const auto& figure) { return figure.id == claim.figure; })) << claim.id << ": " << figure_place(claim);
  }
}

TEST(Claims, AreUnknownWithoutRuns) {
  for (const Claim& claim : claims()) {
    if (claim.studies.empty()) continue;
    const Judgement judgement = claim.judge(Results());
    EXPECT_EQ(judgement.stated.holds(), Holds::unknown) << claim.id;
    EXPECT_EQ(judgement.sharpened.holds(), Holds::unknown) << claim.id;
  }
}

}  // namespace
}  // namespace arenite::ledger
