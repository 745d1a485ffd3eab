// The small studies give the verdicts that expected-small.json has; one that changes is looked at by somebody before it is
// written there. They are of small samples and few seeds: no ledger.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

using namespace arenite;

namespace {

using Json = nlohmann::json;
using Verdicts = std::map<std::string, std::string>;

Verdicts found(const Json& claims, char source) {
  Verdicts all;
  for (const auto& [id, claim] : claims.items())
    if (id.front() == source) all[id] = claim.at("verdict").get<std::string>();
  return all;
}

Verdicts expected(const Json& file, char source) {
  Verdicts all;
  for (const auto& [id, verdict] : file.items())
    if (id.front() == source) all[id] = verdict.get<std::string>();
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
  const auto ours = found(Json::parse(outcome.out).at("claims"), letter);
  const auto wanted = expected(Json::parse(test::slurp(ARENITE_SOURCE_DIR "/tests/ledger/expected-small.json")), letter);
  ASSERT_FALSE(ours.empty());
  for (const auto& [id, verdict] : ours) {
    const auto at = wanted.find(id);
    ASSERT_NE(at, wanted.end()) << id << " is missing in expected-small.json";
    EXPECT_EQ(verdict, at->second) << id;
  }
  EXPECT_EQ(ours.size(), wanted.size()) << "expected-small.json has claims that are no more";
}

INSTANTIATE_TEST_SUITE_P(All, Ledger, ::testing::Values("thesis", "paper"), [](const auto& source) { return std::string(source.param); });
