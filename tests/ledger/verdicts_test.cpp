// The small studies give the verdicts that docs/ledger-expected.json has; one that changes, to either side, is looked at by
// somebody before it is written there.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

using namespace arenite;

namespace {

using Json = nlohmann::json;
using Verdicts = std::map<std::string, std::pair<std::string, std::string>>;

Verdicts verdicts(const Json& claims, char source) {
  Verdicts all;
  for (const auto& [id, claim] : claims.items())
    if (id.front() == source) all[id] = {claim.at("stated").get<std::string>(), claim.at("sharpened").get<std::string>()};
  return all;
}

}  // namespace

class Ledger : public ::testing::TestWithParam<const char*> {};

TEST_P(Ledger, OfSmallStudiesHasTheVerdictsThatAreExpected) {
  const test::TemporaryFolder folder;
  const std::string source = GetParam();
  const auto outcome = test::arenite("verify " + source + " --small --json --quiet --out " + folder.path().string());
  ASSERT_TRUE(outcome.status == 0 || outcome.status == 3) << outcome.err;
  const char letter = source == "thesis" ? 'T' : 'P';
  const auto ours = verdicts(Json::parse(outcome.out).at("claims"), letter);
  const auto expected = verdicts(Json::parse(test::slurp(ARENITE_SOURCE_DIR "/docs/ledger-expected.json")), letter);
  ASSERT_FALSE(ours.empty());
  for (const auto& [id, verdict] : ours) {
    const auto at = expected.find(id);
    ASSERT_NE(at, expected.end()) << id << " is missing in docs/ledger-expected.json";
    EXPECT_EQ(verdict.first, at->second.first) << id << " as its source states it";
    EXPECT_EQ(verdict.second, at->second.second) << id << " as sharpened";
  }
  EXPECT_EQ(ours.size(), expected.size()) << "docs/ledger-expected.json has claims that are no more";
}

INSTANTIATE_TEST_SUITE_P(All, Ledger, ::testing::Values("thesis", "paper"), [](const auto& source) { return std::string(source.param); });
