#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <map>
#include <thread>

#include "support/program.hpp"
#include "support/small_study.hpp"

namespace {

namespace fs = std::filesystem;
using arenite::test::shell;

constexpr int cannot_run = 77;

/// A Slurm of this machine alone, for as long as this lives.
class OneBoxSlurm {
 public:
  OneBoxSlurm() : start(shell(script + " start " + folder.path().string())) {}
  ~OneBoxSlurm() { shell(script + " stop " + folder.path().string()); }
  std::string operator()(const std::string& line) const {
    return shell("SLURM_CONF=" + (folder / "slurm.conf").string() + " " + line).out;
  }

 private:
  const std::string script = ARENITE_SOURCE_DIR "/tests/commands/one_box_slurm.sh";
  const arenite::test::TemporaryFolder folder;

 public:
  const arenite::test::Outcome start;
};

/// Looks every tenth of a second; false if it did not come about in time.
template <class Condition> bool comes_about(double seconds, Condition condition) {
  for (int k = 0; k < static_cast<int>(10 * seconds); ++k) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

TEST(Study, OnSlurmFortyRunsInFourTasksWithOneKilledAndOneStoppedGiveTheLocalBits) {
  const OneBoxSlurm slurm;
  if (slurm.start.status == cannot_run) GTEST_SKIP() << slurm.start.err;
  ASSERT_EQ(slurm.start.status, 0) << slurm.start.err;
  const arenite::test::TemporaryFolder folder;
  const std::string recipe = folder / "study.toml", local = folder / "local", cluster = folder / "cluster",
                    script = folder / "study.sh";
  std::ofstream(recipe)
      << arenite::test::small_cemented_recipe
      << "[sweep]\nreplicates = 20\n[sweep.grid]\n\"grid.nodes\" = [96]\n\"cement.width\" = [0.2, 0.4]\n";
  ASSERT_EQ(arenite::test::arenite("study run " + recipe + " --quiet --out " + local).status, 0);
  const auto wrote = shell(ARENITE_BINARY " study script --slurm " + recipe +
                           " --tasks 4 --jobs 1 --time 0:10:00 --out " + cluster + " > " + script);
  ASSERT_EQ(wrote.status, 0) << wrote.err;

  std::string job = slurm("sbatch --parsable " + script);
  job.resize(job.find_last_not_of("\n ") + 1);
  ASSERT_FALSE(job.empty());
  const std::string tasks = "squeue --states=all --array --noheader --job=" + job + " --format='%K %T' | sort";
  const auto state_of = [&](const std::string& task) {
    const std::string states = slurm(tasks);
    const auto at = states.find(task + " ");
    return at == std::string::npos ? std::string() : states.substr(at + 2, states.find('\n', at) - at - 2);
  };
  // One that still waits would be cancelled for good.
  for (const std::string task : {"2", "4"})
    ASSERT_TRUE(comes_about(30, [&] { return state_of(task) == "RUNNING"; })) << slurm(tasks);
  ASSERT_TRUE(comes_about(30, [&] { return shell("grep -q done " + cluster + "/journal/*.log").status == 0; }));
  slurm("scancel --signal=KILL " + job + "_2");
  slurm("scancel --batch --signal=TERM " + job + "_4");
  // Slurm queues both again; the killed one by itself, the stopped one at the word of the script.
  for (const std::string task : {"2", "4"})
    ASSERT_TRUE(comes_about(20, [&] { return state_of(task) == "PENDING"; })) << slurm(tasks);
  EXPECT_TRUE(comes_about(40, [&] { return slurm(tasks) == "1 COMPLETED\n2 COMPLETED\n3 COMPLETED\n4 COMPLETED\n"; }))
      << slurm(tasks);

  EXPECT_NE(
      arenite::test::slurp(fs::path(cluster) / ("slurm-" + job + "-4.log")).find("stopped; the same command continues"),
      std::string::npos);
  const auto expected = arenite::test::files_of_runs(local), got = arenite::test::files_of_runs(cluster);
  EXPECT_EQ(expected.size(), 40u * 8);
  ASSERT_EQ(got.size(), expected.size());
  for (const auto& [name, bytes] : expected) EXPECT_TRUE(got.contains(name) && got.at(name) == bytes) << name;
}

}  // namespace
