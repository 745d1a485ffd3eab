// The small studies give the verdicts that expected-small.csv has; one that changes is looked at by somebody before it
// is written there. They are of small samples and few seeds: no ledger.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

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

/// Of lines "T1,reproduced".
Verdicts expected(const std::string& file, char source) {
  Verdicts all;
  std::istringstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    std::erase(line, '"');
    if (line.front() == source) all[line.substr(0, line.find(','))] = line.substr(line.find(',') + 1);
  }
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
  const auto wanted = expected(test::slurp(ARENITE_SOURCE_DIR "/tests/ledger/expected-small.csv"), letter);
  ASSERT_FALSE(ours.empty());
  for (const auto& [id, verdict] : ours) {
    const auto at = wanted.find(id);
    ASSERT_NE(at, wanted.end()) << id << " is missing in expected-small.csv";
    EXPECT_EQ(verdict, at->second) << id;
  }
  EXPECT_EQ(ours.size(), wanted.size()) << "expected-small.csv has claims that are no more";
}

INSTANTIATE_TEST_SUITE_P(All, Ledger, ::testing::Values("thesis", "paper"),
                         [](const auto& source) { return std::string(source.param); });
