#include "validation/report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "validation/checks.hpp"
#include "validation/report_dots.hpp"

namespace arenite::validation {
namespace {

/// One claim whose numbers are not reproduced, one of which nothing is known, one that is reproduced.
Ledger three_claims() {
  static const Claim first{"T1", "table 1", "k is 3|4", "3|4 kN/mm", {"made-up"}, "k", nullptr},
      second{"T2", "table 2", "k is 5", "5", {}, "", nullptr}, third{"T3", "table 3", "k rises", "-", {}, "", nullptr};
  Judgement judged;
  judged.checks = {positive("rise of k", "rises", {0.2, 0.01, 4}),
                   number(within("k", {3.5, 0.025, 4}, 3, 0.1, "kN/mm")),
                   beside(below("k, under law R", "3", {9, 0.5, 4}, 4))};
  judged.findings = {"More of it would be better."};
  judged.sensitivities = {{"k|k",
                           "> 4",
                           {.low = 4},
                           {{"", {3.5, 0.025, 4}, Outcome::fails},
                            {"without friction", {5, 0.25, 2}, Outcome::holds},
                            {"with drag & glue", {}, Outcome::unknown}}},
                          {"z",
                           "",
                           {},
                           {{"", {4}, Outcome::unknown},
                            {"without friction", {5, 0.5, 2}, Outcome::unknown},
                            {"with drag & glue", {6, 0.5, 2}, Outcome::unknown}}}};
  Judgement open, rises;
  open.checks = {positive("k", "5", {})};
  rises.checks = {positive("rise of k", "rises", {0.2, 0.01, 4})};
  return {{{"made-up", 4, 2, "2026-01-30", "2026-01-31"}}, {{&first, judged}, {&second, open}, {&third, rises}}};
}

TEST(LedgerReport, TextHasVerdictsNumbersAndWhatDecides) {
  const std::string text = ledger_text(three_claims());
  for (const char* part :
       {"2 of 4 runs done",
        "trend reproduced, numbers not (decided by: protocol): source 3|4 kN/mm, ours k: 3.500 +- 0.025 kN/mm\n",
        "  k|k meets its criterion (> 4) without friction.\n",
        "fails     k: 3.500 +- 0.025 kN/mm (source 3, required 3 +- 0.1; number)\n", "More of it would be better.",
        "  unknown (decided by: missing runs): source 5, ours not known\n",
        "k|k (required > 4): 3.500 +- 0.025; without friction 5.00 +- 0.25 (holds)\n",
        "  figure: made-up/study.html#k\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(LedgerReport, JsonHasNoNumberThatIsNotKnown) {
  const auto j = nlohmann::json::parse(ledger_json(three_claims()))["claims"];
  EXPECT_EQ(j["T1"]["verdict"], "trend reproduced, numbers not");
  EXPECT_EQ(j["T1"]["checks"][1]["ours"], 3.5);
  EXPECT_EQ(j["T1"]["checks"][1]["freedom"], 4);
  EXPECT_EQ(j["T1"]["checks"][1]["kind"], "number");
  EXPECT_EQ(j["T1"]["sensitivity"][0]["entries"].size(), 2u);
  EXPECT_EQ(j["T1"]["sensitivity"][0]["entries"][1]["outcome"], "holds");
  EXPECT_FALSE(j["T1"]["sensitivity"][1].contains("wanted"));
  EXPECT_EQ(j["T1"]["decider"], "protocol");
  EXPECT_EQ(j["T2"]["decider"], "missing runs");
  EXPECT_EQ(j["T2"]["verdict"], "unknown");
  EXPECT_FALSE(j["T2"]["checks"][0].contains("ours"));
}

TEST(LedgerReport, ChangedVerdictsAreTold) {
  const std::string same = ledger_verdicts(three_claims(), true);
  EXPECT_TRUE(changed_verdicts(three_claims(), same, "f", true).empty());
  const std::string other =
      "claim,verdict\nof,\"the small studies (for tests only, not the ledger)\"\nT1,reproduced\nT3,undecided\n";
  const auto changes = changed_verdicts(three_claims(), other, "f", true);
  ASSERT_EQ(changes.size(), 3u);
  EXPECT_EQ(changes[0], "T1: trend reproduced, numbers not now, reproduced in f");
  EXPECT_EQ(changes[1], "T2: unknown now, missing in f");
  EXPECT_EQ(changes[2], "T3: reproduced now, undecided in f");
}

TEST(LedgerReport, VerdictsOfSmallStudiesAreNotTakenForTheLedger) {
  const std::string small = ledger_verdicts(three_claims(), true);
  EXPECT_NE(small.find("of,\"the small studies (for tests only, not the ledger)\"\n"), std::string::npos);
  EXPECT_THROW(changed_verdicts(three_claims(), small, "f", false), InputError);
  EXPECT_THROW(changed_verdicts(three_claims(), ledger_verdicts(three_claims(), false), "f", true), InputError);
  EXPECT_THROW(changed_verdicts(three_claims(), "[]", "f", true), InputError);
  EXPECT_THROW(changed_verdicts(three_claims(), "claim,verdict\nT1,holds\n", "f", true), InputError);
}

TEST(LedgerReport, ThePageHasOneRowAClaimAndSectionsOnlyForWhatIsNotReproduced) {
  const std::string page = ledger_page(three_claims(), "ledger");
  EXPECT_NE(page.find("| [T1](#t1) | k is 3\\|4 | 3\\|4 kN/mm | k: 3.500 ± 0.025 kN/mm | trend reproduced, numbers not "
                      "| protocol | k\\|k meets its criterion (> 4) without friction. |\n"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("| T3 | k rises |"), std::string::npos) << page;
  EXPECT_NE(page.find("\n### T1\n\n**trend reproduced, numbers not** (decided by: protocol). k is 3|4 (table 1; "
                      "figure: `made-up/study.html#k`)."),
            std::string::npos)
      << page;
  EXPECT_EQ(page.find("### T3"), std::string::npos);
  EXPECT_NE(page.find("Runs are missing: `made-up` (2 of 4 runs done)."), std::string::npos) << page;
  EXPECT_NE(page.find("| made-up | 2 of 4 runs done | 2026-01-30 to 2026-01-31 |\n"), std::string::npos) << page;
}

TEST(LedgerReport, ASectionHasOnlyChecksThatDoNotHoldAndOnePicture) {
  const std::string page = ledger_page(three_claims(), "ledger");
  const std::string section = page.substr(page.find("### T1"), page.find("### T2") - page.find("### T1"));
  EXPECT_NE(section.find("| k | 3 | 3.500 ± 0.025 kN/mm | 3 ± 0.1 | fails |\n"), std::string::npos) << section;
  EXPECT_EQ(section.find("rise of k"), std::string::npos) << section;
  EXPECT_EQ(section.find("law R"), std::string::npos) << section;
  EXPECT_NE(section.find("](ledger/T1.svg)"), std::string::npos) << section;
  EXPECT_EQ(page.find("T2.svg"), std::string::npos);
}

TEST(LedgerReport, CsvHasAllChecksAndChoices) {
  const std::string csv = ledger_csv(three_claims());
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "claim,kind,what,choice,source,wanted,ours,error,freedom,unit,outcome,decider");
  for (const char* row : {"T1,claim,k is 3|4,,3|4 kN/mm,,,,,,\"trend reproduced, numbers not\",protocol\n",
                          "T1,number,k,,3,3 +- 0.1,3.5,0.025,4,kN/mm,fails,\n",
                          "T1,supplementary,\"k, under law R\",,3,< 4,9,0.5,4,,fails,\n",
                          "T1,choice,k|k,without friction,,> 4,5,0.25,2,,holds,protocol\n",
                          "T1,choice,z,reference,,,4,,,,,\n", "T2,trend,k,,5,> 0,,,,,unknown,\n"})
    EXPECT_NE(csv.find(row), std::string::npos) << row << "\n" << csv;
}

TEST(LedgerDots, DrawWhatSomethingIsWantedOf) {
  const Ledger ledger = three_claims();
  EXPECT_TRUE(has_dots(ledger.claims[0].judgement));
  EXPECT_FALSE(has_dots(ledger.claims[1].judgement));
  const std::string svg = ledger_dots(ledger.claims[0].judgement);
  EXPECT_NE(svg.find("required > 4"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">without friction</text>"), std::string::npos);
  EXPECT_EQ(svg.find("drag"), std::string::npos) << "a choice without a number has no row";
  EXPECT_EQ(svg.find(">z</text>"), std::string::npos) << "nothing is required of z";
  EXPECT_NE(svg.find("class=\"holds\"/>"), std::string::npos);
  EXPECT_NE(svg.find("class=\"fails\"/>"), std::string::npos);
  EXPECT_NE(svg.find("prefers-color-scheme:dark"), std::string::npos);
}

}  // namespace
}  // namespace arenite::validation
