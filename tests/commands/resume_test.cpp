#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "core/random.hpp"
#include "support/program.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"

namespace arenite {
namespace {

namespace fs = std::filesystem;

const std::string recipe = test::small_packing_recipe + R"([contact]
friction_law = "cundall_strack"
[integration]
integrator = "velocity_verlet"
[[stages]]
name = "prepare"
top = { force = "100 N" }
[[stages]]
name = "load"
gravity = true
increments = 3
bottom = { force = "5 kN" }
)";

fs::path write_recipe(const test::TemporaryFolder& folder) {
  const auto path = folder / "recipe.toml";
  std::ofstream(path) << recipe;
  return path;
}

std::string run_line(const fs::path& recipe_file, const fs::path& out, const std::string& more) {
  return "run " + recipe_file.string() + " --quiet --out " + out.string() + " " + more;
}

/// Kills runs of a recipe at random moments until some were killed several times, and looks for the whole run's bytes.
void kill_at_random_moments(const fs::path& file, std::size_t files, int ended, int killed) {
  const test::TemporaryFolder folder;
  using clock = std::chrono::steady_clock;
  const auto began = clock::now();
  ASSERT_EQ(test::arenite(run_line(file, folder / "whole", "")).status, 0);
  double whole = std::chrono::duration<double>(clock::now() - began).count();
  const auto expected = test::stage_files(folder / "whole");
  ASSERT_EQ(expected.size(), files);

  RandomStream moments(1, Purpose::test);
  int kills = 0;
  for (int attempt = 0; attempt < 40 && (attempt < ended || kills <= killed); ++attempt) {
    const auto out = folder / ("killed" + std::to_string(attempt));
    test::Outcome outcome;
    // Every life gets a random share of the whole run's time; checkpoints at every look keep what it won. Lives grow
    // longer, in case that the machine became busier since and the program does not even start in the share it had.
    for (int life = 0; life < 200; ++life) {
      const double seconds = whole * moments.uniform(0.1, 0.7) * (1 + 0.05 * life);
      const auto born = clock::now();
      outcome = test::shell("timeout -s KILL " + std::to_string(seconds) + " " + ARENITE_BINARY + " " +
                            run_line(file, out, "--checkpoint-every 0"));
      // The first run may have been a slow one on a busy machine: lives must end before their runs do.
      if (outcome.status == 0 && life == 0) whole = std::chrono::duration<double>(clock::now() - born).count();
      if (outcome.status == 0) break;
      ++kills;
    }
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(test::stage_files(out), expected) << "after " << kills << " kills";
    EXPECT_FALSE(fs::exists(out / "run.checkpoint"));
  }
  EXPECT_GT(kills, killed);
}

TEST(Resume, KilledAtRandomMomentsTheRunEndsWithTheSameBytes) {
  const test::TemporaryFolder folder;
  kill_at_random_moments(write_recipe(folder), 3, 6, 5);
}

/// A few cemented disks in tension and pulled apart: most of the run's time goes into the pull.
const char* const pulled = R"(
title = "small cemented sample"
seed = 1
[packing]
method = "poisson"
[bidisperse]
large_radius = "1 mm"
size_ratio = 2
volume_ratio = 1.6
box_area = 25
[container]
thickness = "10 mm"
[materials.large]
density = "2500 kg/m^3"
stiffness = "1 kN/mm"
[materials.small]
density = "2500 kg/m^3"
stiffness = "1 kN/mm"
[contact]
friction_law = "cundall_strack"
friction = 0.3
restitution = 0.7
[[stages]]
name = "compact"
left = { pressure = "10 kPa" }
right = { pressure = "10 kPa" }
bottom = { pressure = "10 kPa" }
top = { pressure = "10 kPa" }
mass_scaling = "uniform"
inertial_number = 1
equilibrium = { unbalanced = 0.01, kinetic = 0.05 }
[cement]
kind = "bridges"
saturation = 0.6
[grid]
nodes = 48
[[loads]]
name = "tension"
[[loads]]
name = "failure"
failure = true
band = 0.1
)";

TEST(Resume, KilledAtRandomMomentsAPullToFailureEndsWithTheSameBytes) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "recipe.toml") << pulled;
  kill_at_random_moments(folder / "recipe.toml", 5, 2, 5);
}

TEST(Resume, NothingIsComputedTwice) {
  const test::TemporaryFolder folder;
  const auto file = write_recipe(folder);
  const auto out = folder / "out";
  ASSERT_EQ(test::arenite("run " + file.string() + " --out " + out.string()).status, 0);
  const auto first = test::stage_files(out);
  const auto again = test::arenite("run " + file.string() + " --out " + out.string());
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.err.find("2/2 load"), std::string::npos) << again.err;
  EXPECT_EQ(again.err.find("step"), std::string::npos) << again.err;
  EXPECT_EQ(test::stage_files(out), first);
}

TEST(Resume, AChangedLaterStageKeepsTheEarlierOnes) {
  const test::TemporaryFolder folder;
  const auto file = write_recipe(folder);
  const auto out = folder / "out";
  ASSERT_EQ(test::arenite(run_line(file, out, "")).status, 0);
  const auto first = test::stage_files(out);
  ASSERT_EQ(test::arenite(run_line(file, out, "--set 'stages.1.bottom.force=6 kN'")).status, 0);
  const auto second = test::stage_files(out);
  ASSERT_EQ(second.size(), 3u);
  int kept = 0;
  for (const auto& [name, bytes] : second) kept += first.contains(name);
  EXPECT_EQ(kept, 2);
  ASSERT_EQ(test::arenite(run_line(file, out, "")).status, 0);
  EXPECT_EQ(test::stage_files(out), first);
}

TEST(Resume, ThreadsChangeNoByte) {
  const test::TemporaryFolder folder;
  const auto file = write_recipe(folder);
  ASSERT_EQ(test::arenite(run_line(file, folder / "one", "--threads 1")).status, 0);
  ASSERT_EQ(test::arenite(run_line(file, folder / "two", "--threads 2")).status, 0);
  EXPECT_EQ(test::stage_files(folder / "one"), test::stage_files(folder / "two"));
}

}  // namespace
}  // namespace arenite
