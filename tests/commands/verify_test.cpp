// arenite verify without runs, or with few: what it says, writes, repeats and refuses.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/disk/file.hpp"
#include "support/program.hpp"

using namespace arenite;

namespace {

std::string read_only(const test::TemporaryFolder& folder, const std::string& more) {
  return "verify thesis paper --read --quiet --out " + (folder.path() / "runs").string() + " " + more;
}

}  // namespace

TEST(Verify, WithoutRunsJudgesTheSourcesTablesAndSaysWhatIsMissing) {
  const test::TemporaryFolder folder;
  const auto page = folder.path() / "ledger.md", table = folder.path() / "ledger.csv";
  const auto outcome =
      test::arenite(read_only(folder, "--json --markdown " + page.string() + " --csv " + table.string()));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto claims = nlohmann::json::parse(outcome.out).at("claims");
  EXPECT_EQ(claims.size(), 34u);
  EXPECT_EQ(claims["T1"]["verdict"], "source inconsistent");
  EXPECT_EQ(claims["T2"]["verdict"], "source inconsistent");
  EXPECT_EQ(claims["T1"]["decider"], "source");
  EXPECT_EQ(claims["T8"]["decider"], "missing runs");
  EXPECT_EQ(claims["T8"]["verdict"], "unknown");
  const std::string text = test::slurp(page.string());
  EXPECT_TRUE(text.starts_with("# The ledger of claims\n")) << text.substr(0, 60);
  EXPECT_NE(text.find("| [T8](#t8) |"), std::string::npos);
  EXPECT_NE(text.find("`thesis-ch4` (not started)"), std::string::npos);
  EXPECT_NE(text.find("[ledger.csv](ledger.csv)"), std::string::npos);
  EXPECT_EQ(test::slurp(table.string()).substr(0, 10), "claim,kind");
}

TEST(Verify, TakesABudgetWithItsUnitBeforeAnyRun) {
  const test::TemporaryFolder folder;
  const auto out = folder.path() / "runs";
  const auto bare = test::arenite("verify thesis --small --quiet --budget 5 --out " + out.string());
  EXPECT_EQ(bare.status, 2);
  EXPECT_NE(bare.err.find("--budget"), std::string::npos) << bare.err;
  EXPECT_NE(bare.err.find("min"), std::string::npos) << bare.err;
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(test::arenite("verify thesis --read --budget 5min --out " + out.string()).status, 2);
}

TEST(Verify, RepeatsRunsThatFoundNoEquilibriumOnDemandOnly) {
  const test::TemporaryFolder folder;
  const auto out = folder.path() / "runs";
  const auto verify = [&](const std::string& more) {
    return test::arenite("verify paper --small --quiet --only paper-linearity --set stages.0.equilibrium.max_steps=5 " +
                         more + "--out " + out.string());
  };
  const auto runs = [&] { return test::runs_begun(out / "paper-linearity"); };
  verify("");
  const std::size_t first = runs();
  ASSERT_GT(first, 0u);
  verify("");
  EXPECT_EQ(runs(), first);
  verify("--retry ");
  EXPECT_EQ(runs(), 2 * first);
  // Further seeds likewise, and once each.
  io::write_atomically(out / "further-seeds.csv", "study,where,seeds\npaper-linearity,,3\n");
  verify("--budget 1min ");
  const std::size_t all = runs() - first;
  EXPECT_GT(all, first);
  verify("--retry --budget 1min ");
  EXPECT_EQ(runs() - first, 2 * all);
  EXPECT_EQ(test::arenite("verify paper --read --retry --out " + out.string()).status, 2);
}

TEST(Verify, HoldsVerdictsAgainstEarlierOnesOfTheSameSize) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "verdicts.csv").string();
  ASSERT_EQ(test::arenite(read_only(folder, "--verdicts " + file)).status, 0);
  EXPECT_EQ(test::arenite(read_only(folder, "--expect " + file)).status, 0);
  const auto small =
      test::arenite(read_only(folder, "--expect " ARENITE_SOURCE_DIR "/tests/ledger/expected-small.csv"));
  EXPECT_EQ(small.status, 2);
  EXPECT_NE(small.err.find("small studies"), std::string::npos) << small.err;
}
