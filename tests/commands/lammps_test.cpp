// Stages that LAMMPS runs, from the recipe to the numbers.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.hpp"
#include "support/small_spheres.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::contains;
using test::TemporaryFolder;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string one_rank = " --engine lammps --lammps-command lmp --quiet --out ";
const std::string two_ranks =
    " --engine lammps --lammps-command \"mpirun --allow-run-as-root --oversubscribe -np 2 lmp\" --quiet --out ";

/// Sixty of them, in a cell just wide enough, to a rest that costs little.
std::string sixty_spheres() {
  std::string recipe = test::small_spheres + "[stages.equilibrium]\nunbalanced = 1e-3\n";
  for (const auto& [from, to] :
       {std::pair{"grains = 150", "grains = 60"}, {"width = \"22", "width = \"16"}, {"depth = \"22", "depth = \"16"}})
    recipe.replace(recipe.find(from), std::string(from).size(), to);
  return recipe;
}

bool is_here() { return test::shell("command -v lmp && command -v mpirun").status == 0; }
constexpr const char* absent = "lmp or mpirun (Debian packages lammps, openmpi-bin) is not installed";

std::string recipe_in(const TemporaryFolder& folder, const std::string& recipe) {
  const auto path = folder / "recipe.toml";
  std::ofstream(path) << recipe;
  return path.string();
}

Json told_by_show(const fs::path& out) {
  const auto outcome = arenite("show " + out.string() + " --json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return Json::parse(outcome.out);
}

/// The one folder in which LAMMPS ran.
fs::path job_of(const fs::path& out) { return fs::directory_iterator(out / "lammps")->path(); }

/// The number behind a phrase of the sentence on LAMMPS's part.
double part_told(const fs::path& out, const std::string& phrase) {
  const std::string text = test::slurp(job_of(out) / "agreement");
  const auto at = text.find(phrase);
  EXPECT_NE(at, text.npos) << text;
  return std::stod(text.substr(at + phrase.size()));
}

/// Without friction the state under a pressure does not hang on the way there, but for the scatter of so few.
TEST(Lammps, JamsSpheresWhereTheyAreKnownTo) {
  if (!is_here()) GTEST_SKIP() << absent;
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run = arenite("run " + recipe_in(folder, sixty_spheres()) + one_rank + out.string());
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_LT(part_told(out, "by at most "), 1e-9);
  const Json j = told_by_show(out);
  EXPECT_NEAR(j["solid_fraction"]["value"].get<double>(), 0.64, 0.03);
  EXPECT_NEAR(j["coordination"]["without_rattlers"]["value"].get<double>(), 6.2, 0.4);
  EXPECT_NEAR(j["stress_details"]["pressure_Pa"].get<double>() / 10e3, 1, 5e-3);
  EXPECT_TRUE(fs::exists(out / "report.html"));
  // Read, not run again; the recipe alone gives another result.
  EXPECT_EQ(arenite("run " + (folder / "recipe.toml").string() + one_rank + out.string()).status, 0);
  EXPECT_EQ(told_by_show(out), j);
}

TEST(Lammps, OnTwoRanksCarriesSpheresAsOurLawHasIt) {
  if (!is_here()) GTEST_SKIP() << absent;
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const std::string recipe = recipe_in(folder, test::small_spheres + "duration = \"0.01 s\"\n");
  const auto run = arenite("run " + recipe + two_ranks + out.string());
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_LT(part_told(out, "by at most "), 1e-6);
  EXPECT_TRUE(contains(test::slurp(job_of(out) / "log.lammps"), "on 2 procs"));
}

/// A recipe in the plane with all that LAMMPS is told: two materials, friction with its springs, walls at rest, moving
/// and under a load, weight, drag.
const std::string disks_of_two = R"(title = "disks"
[materials.a]
density = "1400 kg/m^3"
stiffness = "1000 kN/m"
[materials.b]
density = "950 kg/m^3"
stiffness = "500 kN/m"
[container]
width = "100 mm"
thickness = "60 mm"
[packing]
grains = 120
[[populations]]
material = "a"
ratio = 1
size = { law = "uniform", min = "3 mm", max = "5 mm" }
[[populations]]
material = "b"
ratio = 1
size = { law = "uniform", min = "3 mm", max = "5 mm" }
)";

double agreement_of(const std::string& recipe) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run = arenite("run " + recipe_in(folder, recipe) + one_rank + out.string());
  EXPECT_EQ(run.status, 0) << run.err;
  return run.status == 0 ? part_told(out, "by at most ") : 1;
}

TEST(Lammps, ForcesOfDisksOfTwoMaterialsBetweenWallsAreThoseOfOurLaw) {
  if (!is_here()) GTEST_SKIP() << absent;
  EXPECT_LT(agreement_of(disks_of_two +
                         "[[stages]]\nname = \"fall\"\ngravity = true\ndrag = \"3 1/s\"\nduration = \"0.02 s\"\n"
                         "top = { velocity = \"100 mm/s\" }\n"),
            0.1);  // in the last look LAMMPS of 2021 damps otherwise at walls (docs/lammps.md)
  EXPECT_LT(agreement_of(disks_of_two + "[[stages]]\nname = \"press\"\ntop = { force = \"2 kN\" }\n"
                                        "left = { pressure = \"300 kPa\" }\n[stages.equilibrium]\nunbalanced = 1e-3\n"),
            1e-3);
}

TEST(Lammps, ForcesOfElasticSpheresAreThoseOfOurLaw) {
  if (!is_here()) GTEST_SKIP() << absent;
  std::string recipe = sixty_spheres();
  recipe.replace(recipe.find("stiffness = \"100 kN/m\""), 22, "youngs_modulus = \"100 MPa\"\npoisson = 0.3");
  recipe.replace(recipe.find("friction = 0"), 12, "normal = \"hertz_mindlin\"\nfriction = 0.3");
  EXPECT_LT(agreement_of(recipe), 1e-3);
}

/// What is added to a recipe that LAMMPS can run, and what it answers.
TEST(Lammps, WhatItCannotExpressIsRefusedInASentenceBeforeItRuns) {
  const TemporaryFolder folder;
  const std::string before =
      recipe_in(folder, disks_of_two + "[[stages]]\nname = \"press\"\ntop = { force = \"2 kN\" }\n");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"contact.rolling=elastic_plastic", "rolling resistance"},
      {"contact.sliding_viscosity=\"20 N s/m\"", "contact.sliding_viscosity alone"},
      {"contact.restitution=0.01", "restitution"},
      {"contact.normal=hertz", "several sizes"},
      {"contact.cohesion=dmt' --set 'contact.work_of_adhesion=\"1 J/m^2\"' --set 'contact.adhesion_range=\"10 um\"",
       "cohesion"},
      {"contact.bonds=parallel' --set 'contact.bond_modulus=\"1 GPa\"' --set "
       "'contact.bond_tensile_strength=\"1 MPa\"' --set 'contact.bond_cohesion=\"1 MPa\"",
       "bonds"},
      {"integration.track_energy=true", "track_energy"},
      {"stages.0.slide.top=\"1 mm/s\"' --set 'stages.0.duration=\"1 s\"", "walls that slide"},
      {"stages.0.rough.top=true", "rough"},
      {"stages.0.increments=3", "increments"}};
  for (const auto& [key, sentence] : cases) {
    const auto run = arenite("run " + before + " --set '" + key + "'" + two_ranks + (folder / "out").string());
    EXPECT_EQ(run.status, 2) << key << run.out << run.err;
    EXPECT_TRUE(contains(run.err, "LAMMPS cannot run")) << key << ": " << run.err;
    EXPECT_TRUE(contains(run.err, sentence)) << key << ": " << run.err;
    EXPECT_FALSE(fs::exists(folder / "out/lammps")) << key;
  }
  const auto narrow =
      arenite("run " + before + " --engine lammps --ranks 64 --quiet --out " + (folder / "out").string());
  EXPECT_EQ(narrow.status, 2);
  EXPECT_TRUE(contains(narrow.err, "fewer --ranks")) << narrow.err;
  const auto unknown =
      arenite("run " + before + " --lammps-stages '[\"pres\"]'" + two_ranks + (folder / "out").string());
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(contains(unknown.err, "no stage \"pres\"")) << unknown.err;
}

/// Files for a cluster; there LAMMPS is killed, and goes on from its restart file with what arenite finds here.
TEST(Lammps, AJobThatWasCutOffGoesOnFromItsRestartFile) {
  if (!is_here()) GTEST_SKIP() << absent;
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const std::string recipe =
      recipe_in(folder, disks_of_two + "[[stages]]\nname = \"press\"\ntop = { force = \"2 kN\" }\n");
  const std::string line = "run " + recipe + " --restart-every 500" + one_rank + out.string();
  const auto prepared = arenite(line + " --prepare");
  EXPECT_EQ(prepared.status, 1);
  EXPECT_TRUE(contains(prepared.err, "sbatch job.sh")) << prepared.err;
  const fs::path job = job_of(out);
  EXPECT_TRUE(contains(test::slurp(job / "job.sh"), "#SBATCH --ntasks=2\n"));
  EXPECT_FALSE(fs::exists(job / "begun"));
  const auto cut = test::shell("cd " + job.string() +
                               " && bash -c 'LAMMPS=lmp setsid bash job.sh & pid=$!; until [ -s restart2 ]; do sleep "
                               "0.02; done; kill -KILL -- -$pid; wait $pid'");
  EXPECT_FALSE(fs::exists(job / "ended")) << cut.err;
  const auto run = arenite(line);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(test::slurp(job / "log.lammps"), "Reading restart file"));
  EXPECT_LT(part_told(out, "by at most "), 1e-3);
  EXPECT_GT(part_told(out, "carried "), 1000);
}

}  // namespace
