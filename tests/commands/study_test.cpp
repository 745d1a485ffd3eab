#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>

#include "core/random.hpp"
#include "support/program.hpp"
#include "support/small_study.hpp"

namespace {

namespace fs = std::filesystem;
using arenite::test::arenite;
using arenite::test::contains;
using arenite::test::runs_begun;
using arenite::test::shell;
using arenite::test::slurp;
using arenite::test::small_cemented_recipe;
using arenite::test::small_study;
using arenite::test::TemporaryFolder;

std::string write_study(const TemporaryFolder& folder, const std::string& text) {
  const auto file = folder / "study.toml";
  std::ofstream(file) << text;
  return file.string();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
  return n;
}

/// All lines of a store's account.
std::string account(const fs::path& study) {
  std::string text;
  for (const auto& entry : fs::directory_iterator(study / "store" / "account")) text += slurp(entry.path());
  return text;
}

std::string study_line(const std::string& what, const std::string& recipe, const fs::path& out,
                       const std::string& more = "") {
  return "study " + what + " " + recipe + " --out " + out.string() + " " + more;
}

TEST(Study, TheSamePackingUnderSeveralCementsIsMadeOnceAndTheResultsAreThoseOfSingleRuns) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  const auto out = folder / "out";
  const auto run = arenite(study_line("run", file, out, "--quiet --jobs 3"));
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "6 runs: 6 done\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "16 stages computed")) << run.out;
  EXPECT_TRUE(contains(run.out, "8 reused")) << run.out;
  for (const auto& [stage, made] : {std::pair("packing", 2u), {"prepare", 2u}, {"cement", 6u}, {"tension", 6u}}) {
    std::size_t computed = 0;
    std::istringstream lines(account(out));
    for (std::string line; std::getline(lines, line);)
      computed += line.starts_with("computed") && contains(line, stage);
    EXPECT_EQ(computed, made) << stage;
  }
  const auto one = folder / "single.toml";
  std::ofstream(one) << small_cemented_recipe;
  ASSERT_EQ(arenite("run " + one.string() + " --quiet --set seed=4 --set cement.width=0.4 --out " +
                    (folder / "single").string())
                .status,
            0);
  const auto files = arenite::test::files_of_runs(out);
  EXPECT_EQ(files.size(), 6u * 9);  // with the page of each run
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(folder / "single")) {
    if (entry.path().extension() != ".h5") continue;
    for (const auto& [name, bytes] : files) {
      if (!name.ends_with(entry.path().filename().string())) continue;
      ++compared;
      EXPECT_TRUE(bytes == slurp(entry.path())) << name;
    }
  }
  EXPECT_EQ(compared, 3 + 3 + 1 + 1) << "packing and loading of three runs, cement and load of one";
}

TEST(Study, KilledAtRandomMomentsItEndsWithTheSameBytes) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  using clock = std::chrono::steady_clock;
  const auto began = clock::now();
  ASSERT_EQ(arenite(study_line("run", file, folder / "whole", "--quiet --jobs 2")).status, 0);
  const double whole = std::chrono::duration<double>(clock::now() - began).count();
  const auto expected = arenite::test::files_of_runs(folder / "whole");
  ::arenite::RandomStream moments(1, ::arenite::Purpose::test);
  int kills = 0;
  for (int life = 0; life < 8; ++life) {
    const double seconds = whole * moments.uniform(0.1, 0.7);
    const auto outcome = shell("timeout -s KILL " + std::to_string(seconds) + " " ARENITE_BINARY " " +
                               study_line("run", file, folder / "killed", "--quiet --jobs 2 --checkpoint-every 0"));
    if (outcome.status == 0) break;
    ++kills;
  }
  ASSERT_EQ(arenite(study_line("run", file, folder / "killed", "--quiet")).status, 0);
  EXPECT_GT(kills, 0);
  EXPECT_EQ(arenite::test::files_of_runs(folder / "killed"), expected) << "after " << kills << " kills";
}

TEST(Study, AskedToStopItLeavesAndGoesOnLater) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  const auto out = folder / "out";
  // Not before the study has begun: until then a signal ends the program as any other.
  const auto stopped =
      shell(ARENITE_BINARY " " + study_line("run", file, out, "--quiet --jobs 1") + " & for i in $(seq 500); do [ -d " +
            (out / "journal").string() + " ] && break; sleep 0.01; done; kill -TERM $!; wait $!; echo ended $?");
  if (contains(stopped.out, "ended 0\n")) GTEST_SKIP() << "this machine ran the study before it could be stopped";
  EXPECT_TRUE(contains(stopped.err, "stopped; the same command continues with the ")) << stopped.err;
  EXPECT_TRUE(shell("pgrep -f '[s]tudy run .*" + out.string() + "'").out.empty()) << "no process stays behind";
  ASSERT_EQ(arenite(study_line("run", file, out, "--quiet")).status, 0);
  EXPECT_TRUE(contains(arenite(study_line("status", file, out)).out, "6 runs: 6 done\n"));
}

TEST(Study, ARunThatAnotherShardIsAtHasNoPageOfItsFirstStages) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  const std::filesystem::path whole = folder / "whole", shards = folder / "shards";
  ASSERT_EQ(arenite(study_line("run", file, whole, "--quiet")).status, 0);
  ASSERT_EQ(arenite(study_line("run", file, shards, "--quiet --shard 1/2")).status, 0);
  std::vector<std::filesystem::path> begun;
  for (const auto& run : std::filesystem::directory_iterator(whole / "runs")) {
    const auto there = shards / "runs" / run.path().filename();
    if (std::filesystem::exists(there)) continue;
    std::filesystem::create_directories(there);
    for (const auto& stage : std::filesystem::directory_iterator(run))
      if (stage.path().filename().string().starts_with("01-")) std::filesystem::copy(stage, there);
    begun.push_back(there);
  }
  ASSERT_FALSE(begun.empty());
  ASSERT_EQ(arenite(study_line("page", file, shards, "")).status, 0);
  for (const auto& run : begun) EXPECT_FALSE(std::filesystem::exists(run / "report.html")) << run;
  ASSERT_EQ(arenite(study_line("run", file, shards, "--quiet --shard 2/2")).status, 0);
  EXPECT_EQ(arenite::test::files_of_runs(shards), arenite::test::files_of_runs(whole));
}

TEST(Study, ShardsDoTheirPartsAtOnceAndTogetherTheWhole) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  ASSERT_EQ(arenite(study_line("run", file, folder / "whole", "--quiet")).status, 0);
  const std::string program = ARENITE_BINARY " ", out = folder / "shards";
  const auto both = shell(program + study_line("run", file, out, "--quiet --jobs 1 --shard 1/2") + " & " + program +
                          study_line("run", file, out, "--quiet --jobs 1 --shard 2/2") + " && wait $!");
  EXPECT_EQ(both.status, 0) << both.err;
  EXPECT_EQ(arenite::test::files_of_runs(out), arenite::test::files_of_runs(folder / "whole"));
  for (const std::string shard : {"0/2", "3/2", "2", "1/x"})
    EXPECT_EQ(arenite(study_line("run", file, out, "--shard " + shard)).status, 2) << shard;
}

TEST(Study, AFailingRunIsListedWithItsReasonAndStopsNoOther) {
  const TemporaryFolder folder;
  const auto file = write_study(
      folder,
      small_cemented_recipe +
          "[sweep.grid]\n\"grid.crop\" = [\"80 mm\", \"5 m\"]\n\"stages.0.equilibrium.max_steps\" = [20, 10000000]\n");
  const auto out = folder / "out";
  const auto run = arenite(study_line("run", file, out, "--quiet"));
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_TRUE(contains(run.out, "4 runs: 1 done, 2 unfinished, 1 failed\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "failed (grid.crop = \"5 m\", stages.0.equilibrium.max_steps = 10000000): "))
      << run.out;
  EXPECT_TRUE(contains(run.out, "unfinished (grid.crop = \"80 mm\", stages.0.equilibrium.max_steps = 20): prepare: "))
      << run.out;
  const auto computed = count(account(out), "computed");
  EXPECT_EQ(arenite(study_line("run", file, out, "--quiet")).status, 3) << "failed runs are done again on demand only";
  EXPECT_EQ(count(account(out), "reused") + computed, count(account(out), "\n"));
  EXPECT_EQ(runs_begun(out), 4u);
  EXPECT_EQ(arenite(study_line("run", file, out, "--quiet --retry")).status, 3);
  EXPECT_EQ(runs_begun(out), 7u);
}

TEST(Study, ARunThatFailedBeforeItsFirstStateIsShownWithItsReason) {
  const TemporaryFolder folder;
  const std::string jams = ARENITE_SOURCE_DIR "/validation/errors/isotropic.toml";
  const auto out = folder / "out";
  const std::string dense = "--quiet --set packing.grains=30 --set sweep.replicates=1";
  EXPECT_EQ(arenite(study_line("run", jams, out, dense)).status, 3);
  int runs = 0;
  for (const auto& entry : fs::directory_iterator(out / "runs")) {
    const auto shown = arenite("show " + entry.path().string());
    EXPECT_EQ(shown.status, 2);
    EXPECT_TRUE(contains(shown.err, "is a run that failed, without a result: ") && contains(shown.err, " jams "))
        << shown.err;
    ++runs;
  }
  EXPECT_EQ(runs, 1);
}

TEST(Study, NumbersCanBeKeptWithoutTheFieldsTheyCameFrom) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  ASSERT_EQ(arenite(study_line("run", file, folder / "all", "--quiet")).status, 0);
  ASSERT_EQ(arenite(study_line("run", file, folder / "few", "--quiet --keep numbers")).status, 0);
  std::size_t left = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "few")) {
    left += entry.path().extension() == ".h5";
    EXPECT_FALSE(contains(entry.path().string(), "cement") || contains(entry.path().string(), "tension"))
        << entry.path();
  }
  EXPECT_EQ(left, 6u * 2 + 4) << "packings and loadings stay, in runs and store";
  for (const std::string study : {"all", "few"})
    ASSERT_EQ(arenite(study_line("collect", file, folder / study)).status, 0);
  EXPECT_EQ(slurp(folder / "all" / "numbers.csv"), slurp(folder / "few" / "numbers.csv"));
  EXPECT_TRUE(contains(slurp(folder / "all" / "numbers.csv"), "run,status,cement.width,seed,"));
  EXPECT_EQ(count(slurp(folder / "all" / "numbers.csv"), "\n"), 7u);
  ASSERT_EQ(arenite(study_line("collect", file, folder / "all", "--by cement.width")).status, 0);
  EXPECT_EQ(count(slurp(folder / "all" / "numbers-by-cement.width.csv"), "\n"), 4u);
}

TEST(Study, FiguresShowOneRunsStatesAndFieldsWhetherTheseWereKeptOrNot) {
  const TemporaryFolder folder;
  std::string recipe = small_study;
  recipe.insert(recipe.find("[sweep]"), "[[loads]]\nname = \"break\"\nfailure = true\n");
  const auto file = write_study(folder, recipe);
  std::ofstream(folder / "figures.toml")
      << "[[figures]]\nid = \"start\"\ntitle = \"Start\"\nkind = \"grains\"\nstage = \"packing\"\n"
         "[[figures]]\nid = \"end\"\ntitle = \"End\"\nkind = \"forces\"\nstage = \"prepare\"\n"
         "[[figures]]\nid = \"none\"\ntitle = \"None\"\nkind = \"grains\"\nstage = \"nowhere\"\n"
         "[[figures]]\nid = \"phases\"\ntitle = \"Phases\"\nkind = \"phases\"\n"
         "[[figures]]\nid = \"zoom\"\ntitle = \"Zoom\"\nkind = \"zoom\"\n"
         "[[figures]]\nid = \"cracks\"\ntitle = \"Cracks\"\nkind = \"cracks\"\nstage = \"break\"\n"
         "[[figures]]\nid = \"film\"\ntitle = \"Film\"\nkind = \"film\"\n";
  ASSERT_EQ(arenite(study_line("run", file, folder / "all", "--quiet")).status, 0);
  ASSERT_EQ(arenite(study_line("run", file, folder / "few", "--quiet --keep numbers")).status, 0);
  const std::string page = slurp(folder / "all" / "study.html");
  EXPECT_TRUE(page == slurp(folder / "few" / "study.html")) << "fields that were dropped are made again, bit by bit";
  EXPECT_TRUE(contains(page, "there is no stage \\\"nowhere\\\" of this run"));
  EXPECT_TRUE(contains(page, "no film of this run was made"));
  EXPECT_EQ(count(page, "\"missing\":"), 2u);
  EXPECT_TRUE(contains(page, "\"phases\":[") && contains(page, "\"edges\":[") && contains(page, "\"cracks\":{\"x\":["));
  EXPECT_EQ(count(page, "\"materials\":[\"POM\"]"), 2u);
}

TEST(Study, WithoutFiguresOfItsOwnHasAPageOfItsRunsAndMainNumbers) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  const auto ran = arenite(study_line("run", file, folder / "out", "--quiet"));
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "page:    ")) << ran.out;
  const std::string page = slurp(folder / "out" / "study.html");
  for (const char* part : {"\"id\":\"modulus_Pa\"", "\"id\":\"S_m\"", "\"keys\":[\"cement width\",\"seed\"]"})
    EXPECT_TRUE(contains(page, part)) << part;
  EXPECT_FALSE(contains(page, "tables of the source"));
  EXPECT_EQ(count(page, "\"link\":\"runs/"), 6u);
  for (const auto& run : fs::directory_iterator(folder / "out" / "runs"))
    EXPECT_TRUE(contains(slurp(run.path() / "report.html"), "<title>small sample: cement width = 0."));
}

TEST(Study, ThePlanTellsRunsSharedStagesAndTimeWithoutTouchingTheDisk) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  const auto out = folder / "out";
  const auto before = arenite(study_line("plan", file, out));
  EXPECT_EQ(before.status, 0);
  EXPECT_TRUE(contains(before.out, "cement.width = 0.4, seed = 4\n")) << before.out;
  EXPECT_TRUE(contains(before.out, "packing                 6          2              0\n")) << before.out;
  EXPECT_TRUE(contains(before.out, "time: not known until")) << before.out;
  EXPECT_FALSE(fs::exists(out));
  ASSERT_EQ(arenite(study_line("run", file, out, "--quiet --shard 1/2")).status, 0);
  EXPECT_TRUE(contains(arenite(study_line("plan", file, out)).out, "time: about "))
      << "costs of the first half estimate the second";
  ASSERT_EQ(arenite(study_line("run", file, out, "--quiet --shard 2/2")).status, 0);
  EXPECT_TRUE(contains(arenite(study_line("plan", file, out)).out, "time: all stages are in the store\n"));
}

TEST(Study, WhereARecipeIsOneRunOrManyTheOtherCommandIsNamed) {
  const TemporaryFolder folder;
  const auto file = write_study(folder, small_study);
  const auto one = arenite("run " + file);
  EXPECT_EQ(one.status, 2);
  EXPECT_TRUE(contains(one.err, "study.toml:28:2: sweep: this recipe is a study of many runs; `arenite study plan "))
      << one.err;
  const auto single = write_study(folder, small_cemented_recipe);
  const auto refused = arenite(study_line("run", single, folder / "out"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(contains(refused.err, "has no section [sweep], so it is one run: `arenite run ")) << refused.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
  EXPECT_EQ(arenite(study_line("status", single, folder / "out")).status, 2);
  EXPECT_EQ(arenite("study script " + file + " --out " + (folder / "out").string()).status, 2)
      << "for which scheduler?";
}

}  // namespace
