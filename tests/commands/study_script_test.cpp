#include <gtest/gtest.h>

#include <fstream>

#include "support/program.hpp"
#include "support/small_study.hpp"

namespace {
using arenite::test::arenite;
using arenite::test::contains;
using arenite::test::TemporaryFolder;

TEST(StudyScript, LogsShowProgressUnlessItIsToBeQuiet) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "study.toml").string();
  std::ofstream(recipe) << arenite::test::small_study;
  const std::string line = "study script --slurm " + recipe + " --out " + (folder / "out").string();
  const auto script = arenite(line), quiet = arenite(line + " --quiet");
  ASSERT_EQ(script.status, 0) << script.err;
  EXPECT_TRUE(contains(script.out, " study run ")) << script.out;
  EXPECT_FALSE(contains(script.out, "--quiet"));
  EXPECT_TRUE(contains(quiet.out, "--quiet"));
}

TEST(StudyScript, RefusesWhatItsTasksDecideThemselves) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "study.toml").string();
  std::ofstream(recipe) << arenite::test::small_study;
  for (const char* each : {"--shard 1/2", "--retry"}) {
    const std::string option = each;
    const auto refused = arenite("study script --slurm " + recipe + " --out " + (folder / "out").string() + " " + option);
    EXPECT_EQ(refused.status, 2) << option;
    EXPECT_EQ(refused.out, "");
    EXPECT_TRUE(contains(refused.err, option.substr(0, option.find(' ')) + " is an option of run")) << refused.err;
  }
}

}  // namespace
