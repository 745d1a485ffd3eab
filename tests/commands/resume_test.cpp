#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "core/random.hpp"
#include "support/program.hpp"
#include "support/small_spheres.hpp"
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

TEST(Resume, KilledAtRandomMomentsARunOfSpheresEndsWithTheSameBytes) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "recipe.toml") << test::small_triaxial;
  kill_at_random_moments(folder / "recipe.toml", 3, 1, 2);
}

TEST(Resume, KilledAtRandomMomentsSpheresPulledUntilTheyBreakEndWithTheSameBytes) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "recipe.toml") << test::small_spheres
                                        << "[cement]\nwidth = 0.5\n[grid]\nnodes = 14\n[[loads]]\nname = \"break\"\n"
                                           "failure = true\nband = 0.3\nend_stress = 0.5\n";
  kill_at_random_moments(folder / "recipe.toml", 3, 1, 2);
}

/// Grains come in and leave, in a stage and in the one after.
const char* const exchanged = R"(
title = "grains that come and go"
seed = 3
[materials.POM]
density = "1410 kg/m^3"
stiffness = "0.3 kN/mm"
[[populations]]
material = "POM"
count = 60
size = { law = "uniform", min = "10 mm", max = "16 mm" }
[container]
width = "100 mm"
height = "300 mm"
thickness = "60 mm"
[packing]
area = { bottom = "30 mm", top = "200 mm" }
[contact]
friction_law = "cundall_strack"
[integration]
track_energy = true
[[stages]]
name = "feed"
gravity = true
duration = "0.4 s"
snapshots = 4
[[stages.inflow]]
bottom = "250 mm"
rate = "80 1/s"
velocity = ["0 m/s", "-1 m/s"]
[[stages.outlets]]
top = "20 mm"
right = "20 mm"
[[stages]]
name = "recycle"
gravity = true
duration = "0.3 s"
[[stages.outlets]]
top = "30 mm"
right = "40 mm"
recycle_to = { bottom = "230 mm" }
)";

TEST(Resume, KilledAtRandomMomentsARunThatGrainsComeIntoEndsWithTheSameBytes) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "recipe.toml") << exchanged;
  kill_at_random_moments(folder / "recipe.toml", 3, 4, 5);
}

TEST(Exchange, IsPredictedToldAndCounted) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "recipe.toml").string(), out = (folder / "out").string();
  std::ofstream(file) << exchanged;
  const auto checked = test::arenite("check " + file);
  ASSERT_EQ(checked.status, 0) << checked.err;
  EXPECT_TRUE(test::contains(checked.err, "32 grains come in")) << checked.err;
  const auto ran = test::arenite("run " + file + " --quiet --out " + out);
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(test::contains(ran.out, "grains came in")) << ran.out;
  const auto page = test::shell("node " ARENITE_SOURCE_DIR "/web/test/exchange_page.test.mjs " + out + "/report.html");
  EXPECT_EQ(page.status, 0) << page.out << page.err;
  const auto shown = test::arenite("show " + out + " --json");
  for (const char* part : {"\"exchange\"", "\"inserted\": ", "\"removed_kg\"", "\"exchanged\"", "\"closed\": true"})
    EXPECT_TRUE(test::contains(shown.out, part)) << part << shown.out;
  const auto text = test::arenite("show " + out);
  EXPECT_TRUE(test::contains(text.out, "32 grains came in")) << text.out;
}

TEST(Exchange, IsRefusedWithTheMendAtItsLine) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "recipe.toml").string();
  std::ofstream(file) << exchanged;
  const std::pair<const char*, const char*> wrong[] = {
      {"stages.0.inflow.0.top=400 mm", "must lie in the container"},
      {"stages.0.inflow.0.mass_rate=1 kg/s", "give either rate or mass_rate"},
      {"stages.0.inflow.0.material=gold", "no population is of"},
      {"stages.1.rough.bottom=true", "rough wall"},
      {"stages.1.count_below=30 mm", "leave count_below out"},
      {"contact.bonds=parallel", "bonded grains cannot come in or leave"},
      {"populations.0.shape=square", "leave shape out of the populations"}};
  for (const auto& [change, part] : wrong) {
    const auto refused = test::arenite("check " + file + " --set '" + change + "'");
    EXPECT_EQ(refused.status, 2) << change;
    EXPECT_TRUE(test::contains(refused.err, part)) << change << ": " << refused.err;
  }
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
