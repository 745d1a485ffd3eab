#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;
using arenite::test::arenite;
using arenite::test::contains;
using arenite::test::slurp;
using arenite::test::TemporaryFolder;

/// A loose filling of 60 disks of two sizes, and what its container and stages say.
std::string recipe(const std::string& container, const std::string& stages) {
  return "title = \"A small sample\"\n[container]\nwidth = \"120 mm\"\nthickness = \"60 mm\"\n" + container +
         "[materials.POM]\ndensity = \"1410 kg/m^3\"\nstiffness = \"27.35 kN/mm\"\n"
         "[[populations]]\nmaterial = \"POM\"\ncount = 60\nsize = { law = \"uniform\", min = \"10 mm\", max = \"16 "
         "mm\" }\n"
         "[contact]\nrestitution = 0.5\nfriction_law = \"cundall_strack\"\n" +
         stages;
}

std::string write(const TemporaryFolder& folder, const std::string& text) {
  const auto file = folder / "recipe.toml";
  std::ofstream(file) << text;
  return file.string();
}

TEST(PeriodicCell, PressureOnBothDirectionsEndsAtRestWithTheStressAsked) {
  const TemporaryFolder folder;
  const auto file = write(
      folder,
      recipe("periodic_x = true\nperiodic_y = true\n",
             "[[stages]]\nname = \"isotropic\"\nright = { pressure = \"100 kPa\" }\ntop = { pressure = \"100 kPa\" }\n"
             "[[stages]]\nname = \"biaxial\"\nleft = { pressure = \"100 kPa\" }\ntop = { pressure = \"140 kPa\" }\n"));
  const auto out = (folder / "out").string();
  const auto run = arenite("run " + file + " --quiet --out " + out);
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "biaxial      equilibrium")) << run.out;
  const auto shown = nlohmann::json::parse(arenite("show --json " + out).out);
  const auto& stress = shown.at("stress").at("value");
  EXPECT_NEAR(stress[0][0].get<double>(), -100e3, 500);
  EXPECT_NEAR(stress[1][1].get<double>(), -140e3, 700);
  EXPECT_NEAR(stress[0][1].get<double>(), stress[1][0].get<double>(), 100) << "no couple acts on the cell";
}

/// The stage file of `out` whose name contains `stage`.
fs::path stage_file(const fs::path& out, const std::string& stage) {
  for (const auto& entry : fs::directory_iterator(out))
    if (contains(entry.path().filename().string(), stage) && entry.path().extension() == ".h5") return entry.path();
  return {};
}

TEST(DamagedStageFile, IsComputedAgainWithANoticeAndTheSameBytes) {
  const TemporaryFolder folder;
  const auto file =
      write(folder,
            recipe("", "[[stages]]\nname = \"load\"\ntop = { force = \"1 kN\" }\nequilibrium = { max_steps = 400 }\n"));
  const auto out = folder / "out";
  ASSERT_EQ(arenite("run " + file + " --quiet --out " + out.string()).status, 3);
  for (const std::string stage : {"packing", "load"}) {
    const auto path = stage_file(out, stage);
    const std::string whole = slurp(path);
    std::string changed = whole;
    changed[changed.size() / 2] ^= 1;
    for (const auto& bytes : {std::string(), whole.substr(0, whole.size() / 2), changed}) {
      std::ofstream(path, std::ios::binary) << bytes;
      const auto shown = arenite("show " + path.string());
      EXPECT_EQ(shown.status, 2) << "only who can make it again may pass over it";
      const auto again = arenite("run " + file + " --quiet --out " + out.string());
      EXPECT_EQ(again.status, 3) << again.err;
      EXPECT_TRUE(again.err.starts_with(path.string() + ": ") && contains(again.err, "computed again")) << again.err;
      EXPECT_EQ(std::count(again.err.begin(), again.err.end(), '\n'), 1) << again.err;
      EXPECT_EQ(slurp(path), whole);
    }
  }
}

const char* const short_load =
    "[[stages]]\nname = \"load\"\ntop = { force = \"1 kN\" }\nequilibrium = { max_steps = 400 }\n";

TEST(RunFolder, SaysWhatItPutsAsideAndWhichExportsAreStale) {
  const TemporaryFolder folder;
  const auto file = write(folder, recipe("", short_load));
  const auto out = folder / "out";
  const std::string run = "run " + file + " --quiet --out " + out.string();
  EXPECT_EQ(arenite(run).err, "");
  ASSERT_EQ(arenite("export " + out.string() + " --to vtk").status, 0);
  const auto before = stage_file(out, "load");
  const auto other = arenite(run + " --set contact.friction=0.1");
  EXPECT_TRUE(contains(other.err, "a result of other settings moved to " + (out / "earlier").string())) << other.err;
  EXPECT_TRUE(contains(other.err, before.filename().string())) << other.err;
  EXPECT_TRUE(contains(other.err, "write again: " + (out / "vtk").string())) << other.err;
  EXPECT_EQ(std::count(other.err.begin(), other.err.end(), '\n'), 1) << other.err;
  EXPECT_TRUE(fs::exists(out / "earlier" / before.filename()));
  EXPECT_EQ(arenite(run + " --set contact.friction=0.1").err, "") << "nothing moved";
}

TEST(RunFolder, AFileWhoseNameAgreesButWhoseHashDoesNotIsMadeAnew) {
  const TemporaryFolder folder;
  const auto file = write(folder, recipe("", short_load));
  const auto out = folder / "out", other = folder / "other";
  arenite("run " + file + " --quiet --out " + out.string());
  arenite("run " + file + " --quiet --set seed=2 --out " + other.string());
  const auto path = stage_file(out, "packing");
  const std::string whole = slurp(path);
  fs::copy_file(stage_file(other, "packing"), path, fs::copy_options::overwrite_existing);
  arenite("run " + file + " --quiet --out " + out.string());
  EXPECT_EQ(slurp(path), whole);
}

TEST(StageWithoutEquilibrium, EndsWithStatusThreeAndSaysWhatItReached) {
  const TemporaryFolder folder;
  const auto file = write(
      folder, recipe("",
                     "[[stages]]\nname = \"load\"\ntop = { force = \"1 kN\" }\nequilibrium = { max_steps = 400 }\n"
                     "[[stages]]\nname = \"more\"\ntop = { force = \"2 kN\" }\n"));
  const auto run = arenite("run " + file + " --quiet --out " + (folder / "out").string());
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_TRUE(contains(run.out, "no equilibrium within 400 steps (equilibrium.max_steps): unbalanced force ratio"))
      << run.out;
  EXPECT_FALSE(contains(run.out, "more")) << "no stage starts from one that is not at rest";
}

TEST(StageOverATime, SpeaksOfForcesOnSidesOnlyWhereItMeasuresThem) {
  const TemporaryFolder folder;
  const auto file = write(
      folder, recipe("", "[[stages]]\nname = \"shove\"\ntop = { velocity = \"10 mm/s\" }\nduration = \"1 ms\"\n"));
  const auto run = arenite("run " + file + " --quiet --out " + (folder / "out").string());
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "0.001 s passed; unbalanced force ratio")) << run.out;
  EXPECT_FALSE(contains(run.out, "aim")) << run.out;
}

TEST(Show, BeginsWithTheTitleAndLeavesOutWhatASampleWithoutContactsHasNot) {
  const TemporaryFolder folder;
  const auto file =
      write(folder,
            recipe("", "[[stages]]\nname = \"load\"\ntop = { force = \"1 kN\" }\nequilibrium = { max_steps = 400 }\n"));
  const auto out = folder / "out";
  ASSERT_EQ(arenite("run " + file + " --quiet --out " + out.string()).status, 3);
  const auto shown = arenite("show " + stage_file(out, "packing").string());
  EXPECT_TRUE(shown.out.starts_with("A small sample\nMade by Arenite ")) << shown.out;
  EXPECT_FALSE(contains(shown.out, "nan")) << shown.out;
  const auto json = nlohmann::json::parse(arenite("show --json " + out.string()).out);
  EXPECT_EQ(json.at("provenance").at("title"), "A small sample");
}

TEST(RunThatCannotStart, IsOneLineWithItsPlaceAndLeavesNoFolder) {
  const TemporaryFolder folder;
  const auto file =
      write(folder, recipe("height = \"20 mm\"\n", "[[stages]]\nname = \"load\"\ntop = { force = \"1 kN\" }\n"));
  const auto out = folder / "out";
  const auto refused = arenite("run " + file + " --quiet --out " + out.string());
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(refused.err.starts_with(file + ": the grains cover ") && contains(refused.err, "container.height"))
      << refused.err;
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  EXPECT_FALSE(fs::exists(out));
  const auto late = arenite("run " + file + " --quiet --out " + out.string() +
                            " --set 'container.height=200 mm' --set 'integration.time_step=1 s'");
  EXPECT_EQ(late.status, 2);
  EXPECT_TRUE(late.err.starts_with(
                  "--set integration.time_step=1 s: integration.time_step of 1 s is too long for this packing: ") &&
              contains(late.err, " s, or leave the key out"))
      << late.err;
  EXPECT_EQ(std::count(late.err.begin(), late.err.end(), '\n'), 1) << late.err;
}

TEST(CommandLine, ThatCannotBeReadIsOneLine) {
  for (const char* line :
       {"run", "run x.toml --threads 0", "run x.toml --thread 2", "export x --to xls", "init granite"}) {
    const auto refused = arenite(line);
    EXPECT_EQ(refused.status, 2) << line;
    EXPECT_TRUE(refused.err.starts_with("arenite ") && contains(refused.err, " --help`")) << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

TEST(ExportThatCannotEnd, TakesBackWhatItWrote) {
  const TemporaryFolder folder;
  const auto file = write(folder, recipe("",
                                         "[[stages]]\nname = \"load\"\ntop = { force = \"1 kN\" }\nincrements = "
                                         "2\nequilibrium = { unbalanced = 0.01, kinetic = 0.01 }\n"));
  const auto out = (folder / "out").string();
  ASSERT_EQ(arenite("run " + file + " --quiet --out " + out).status, 0);
  // In units of 512 bytes: the loose packing's tables fit below the limit, those of the loaded states do not.
  const auto refused = arenite::test::shell("ulimit -f 18; " + std::string(ARENITE_BINARY) + " export " + out +
                                            " --to csv --out " + out + "/csv");
  EXPECT_EQ(refused.status, 2) << refused.out;
  EXPECT_TRUE(contains(refused.err, "csv: ") || contains(refused.err, ".csv: cannot be written: ")) << refused.err;
  EXPECT_FALSE(fs::exists(out + "/csv"));
}

TEST(Run, ThatCannotGoOnHasAStatusOfItsOwn) {
  const TemporaryFolder folder;
  const auto file =
      write(folder, recipe("height = \"200 mm\"\n",
                           "[[stages]]\nname = \"shoot\"\nduration = \"1 s\"\nbottom = { velocity = \"1e6 m/s\" }\n"));
  const auto run = arenite("run " + file + " --quiet --out " + (folder / "out").string());
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_TRUE(contains(run.err, "has left the container through a wall at step")) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

}  // namespace
