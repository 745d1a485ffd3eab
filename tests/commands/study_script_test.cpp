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

TEST(StudyScript, NamesOfFilesBecomeNoLinesOfIt) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "my\ntouch broken\n#").string() + ".toml";
  std::ofstream(recipe) << arenite::test::small_study;
  const auto script =
      arenite("study script --slurm '" + recipe + "' --out '" + (folder / "two words %j").string() + "'");
  ASSERT_EQ(script.status, 0) << script.err;
  EXPECT_TRUE(contains(script.out, "#SBATCH --job-name=my_touch_broken_")) << script.out;
  EXPECT_TRUE(contains(script.out, "two words %%j/slurm-%A-%a.log\"\n")) << script.out;
  EXPECT_FALSE(contains(script.out, "\ntouch broken\n#SBATCH")) << script.out;
  const auto refused =
      arenite("study script --slurm '" + recipe + "' --out '" + (folder / "out").string() + "' --time '1:00\ntouch x'");
  EXPECT_EQ(refused.status, 2) << refused.out;
  EXPECT_TRUE(contains(refused.err, "--time")) << refused.err;
}

TEST(StudyScript, RefusesWhatItsTasksDecideThemselves) {
  const TemporaryFolder folder;
  const auto recipe = (folder / "study.toml").string();
  std::ofstream(recipe) << arenite::test::small_study;
  for (const char* each : {"--shard 1/2", "--retry"}) {
    const std::string option = each;
    const auto refused =
        arenite("study script --slurm " + recipe + " --out " + (folder / "out").string() + " " + option);
    EXPECT_EQ(refused.status, 2) << option;
    EXPECT_EQ(refused.out, "");
    EXPECT_TRUE(contains(refused.err, option.substr(0, option.find(' ')) + " is an option of run")) << refused.err;
  }
}

}  // namespace
