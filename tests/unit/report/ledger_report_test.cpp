#include "report/ledger_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "ledger/trends.hpp"

namespace arenite::report {
namespace {

using namespace ledger;

/// One claim that holds as sharpened and fails as stated, and one of which nothing is known.
Ledger two_claims() {
  static const Claim first{"T1", "table 1", "k is 3|4", {"made-up"}, "k", nullptr}, second{"T2", "table 2", "k is 5", {}, "", nullptr};
  Judgement judged;
  judged.stated.checks = {within("k", {3.5, 0.25}, 3, 0.1, "kN/mm")};
  judged.sharpened.checks = {within("k", {3.5, 0.25}, 3, 1, "kN/mm")};
  judged.findings = {"More of it would be better."};
  judged.sensitivities = {{"k|k", "> 2", {{"", 1, 0.5, Holds::no}, {"without friction", 3, 0.25, Holds::yes}, {"with drag", statistics::unknown, statistics::unknown, Holds::unknown}}},
                          {"z", "", {{"", 4, statistics::unknown, Holds::unknown}, {"without friction", 5, 0.5, Holds::unknown}, {"with drag", 6, 0.5, Holds::unknown}}},
                          {"q", "> 9", {{"", 4, 1, Holds::no}, {"with glue", 5, 0.5, Holds::no}}},
                          {"r", "> 9", {{"", 8, 1, Holds::no}, {"with sand", 9.5, 0.5, Holds::yes}}}};
  Judgement open;
  open.stated.checks = open.sharpened.checks = {positive("k", "5", {})};
  return {{{"made-up", 4, 2}}, {{&first, judged}, {&second, open}}};
}

TEST(LedgerReport, TextHasVerdictsNumbersAndFindings) {
  const std::string text = ledger_text(two_claims());
  EXPECT_NE(text.find("2 of 4 runs done"), std::string::npos);
  EXPECT_NE(text.find("as stated: fails"), std::string::npos);
  EXPECT_NE(text.find("as sharpened: holds"), std::string::npos);
  EXPECT_NE(text.find("k: 3.5 +- 0.25 kN/mm (source 3, wanted +- 0.1)"), std::string::npos);
  EXPECT_NE(text.find("More of it would be better."), std::string::npos);
  EXPECT_NE(text.find("as sharpened: unknown"), std::string::npos);
  EXPECT_NE(text.find("  figure: made-up/study.html#k\n"), std::string::npos);
}

TEST(LedgerReport, JsonHasNoNumberThatIsNotKnown) {
  const auto j = nlohmann::json::parse(ledger_json(two_claims()));
  EXPECT_EQ(j["claims"]["T1"]["stated"], "fails");
  EXPECT_EQ(j["claims"]["T1"]["sharpened_checks"][0]["ours"], 3.5);
  EXPECT_EQ(j["claims"]["T2"]["sharpened"], "unknown");
  EXPECT_FALSE(j["claims"]["T2"]["stated_checks"][0].contains("ours"));
}

TEST(LedgerReport, ChangedVerdictsAreToldInEitherDirection) {
  const std::string same = ledger_verdicts(two_claims());
  EXPECT_TRUE(changed_verdicts(two_claims(), same, "f").empty());
  const auto changes = changed_verdicts(two_claims(), R"({"T1": {"stated": "holds", "sharpened": "fails"}})", "f");
  ASSERT_EQ(changes.size(), 4u);
  EXPECT_EQ(changes[0], "T1 as stated: fails now, holds in f");
  EXPECT_EQ(changes[1], "T1 as sharpened: holds now, fails in f");
  EXPECT_EQ(changes[2], "T2 as stated: unknown now, missing in f");
  EXPECT_THROW(changed_verdicts(two_claims(), "[]", "f"), InputError);
}

TEST(LedgerReport, MarkdownKeepsItsCells) {
  const std::string page = ledger_markdown(two_claims(), "Made up");
  EXPECT_NE(page.find("| [T1](#t1) | k is 3\\|4 | fails | holds |"), std::string::npos);
  EXPECT_NE(page.find("### T2\n\nk is 5. (table 2)\n"), std::string::npos);
  EXPECT_NE(page.find("(table 1; here `made-up/study.html#k`)"), std::string::npos);
}

TEST(LedgerReport, OpenChoicesStandInTablesWithThoseThatGiveWhatIsWanted) {
  const std::string page = ledger_markdown(two_claims(), "Made up");
  EXPECT_NE(page.find("| | as it is | without friction | with drag |\n|---|---|---|---|\n"
                      "| k\\|k (wanted > 2) | 1 +- 0.5 | **3 +- 0.25** | |\n| z | 4 | 5 +- 0.5 | 6 +- 0.5 |\n"
                      "\nk|k: as wanted without friction.\n"), std::string::npos) << page;
  EXPECT_NE(page.find("| | as it is | with glue |\n"), std::string::npos);
  EXPECT_NE(page.find("q: no choice here gives what is wanted.\n"), std::string::npos);
  EXPECT_NE(page.find("r: as wanted, but no further from how it is than 2 s.e.: with sand.\n"), std::string::npos);
  EXPECT_NE(ledger_text(two_claims()).find("k|k (wanted > 2): 1 +- 0.5, without friction 3 +- 0.25; as wanted without friction.\n"), std::string::npos);
  const auto j = nlohmann::json::parse(ledger_json(two_claims()))["claims"]["T1"]["sensitivity"];
  EXPECT_EQ(j[0]["entries"].size(), 2u);
  EXPECT_EQ(j[0]["entries"][1]["verdict"], "holds");
  EXPECT_FALSE(j[1].contains("wanted"));
}

}  // namespace
}  // namespace arenite::report
