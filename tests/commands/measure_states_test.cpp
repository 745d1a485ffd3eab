#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "support/program.hpp"

// What files of grains and contacts state is used, refused or told (tests/data/borders/README.md).
namespace arenite::test {
namespace {

using Json = nlohmann::json;

std::string borders(const std::string& files) {
  const std::string folder = ARENITE_SOURCE_DIR "/tests/data/borders/";
  std::string line = "measure --border 0";
  std::istringstream words(files);
  for (std::string word; words >> word;)
    line += " " + (word.find('.') != word.npos && word.front() != '-' ? folder + word : word);
  return line;
}

Json measured_borders(const std::string& files) {
  const Outcome run = arenite(borders(files) + " --json");
  EXPECT_EQ(run.status, 0) << run.err;
  return run.status == 0 ? Json::parse(run.out) : Json();
}

/// One sentence on stderr, status 2, and these words in it.
void expect_refusal(const std::string& files, const std::vector<std::string>& words) {
  const Outcome run = arenite(borders(files));
  EXPECT_EQ(run.status, 2) << files << run.out;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  for (const auto& word : words) EXPECT_NE(run.err.find(word), std::string::npos) << word << " is not in " << run.err;
}

void expect_note(const Json& t, const std::string& words) {
  EXPECT_NE(t["notes"].dump().find(words), std::string::npos) << words << " is not in " << t["notes"];
}

/// The crystal of 16 disks: z and the stress of 10 N along x and 30 N along y, `unit` N each and a cell of 3.96
/// `length` m.
void expect_crystal(const Json& t, double length = 1, double force = 1, double thickness = 1) {
  EXPECT_EQ(t["contacts"], 32);
  EXPECT_EQ(t["wall_contacts"], 0);
  EXPECT_DOUBLE_EQ(t["coordination"]["all"]["value"].get<double>(), 4);
  EXPECT_NEAR(t["mean_diameter_m"].get<double>(), length, 1e-12 * length);
  const double pressure = force * 16 * 0.99 / (3.96 * 3.96 * length * thickness);
  const Json stress = t["stress"]["value"];
  EXPECT_NEAR(stress[0][0].get<double>(), -10 * pressure, 1e-9 * pressure);
  EXPECT_NEAR(stress[1][1].get<double>(), -30 * pressure, 1e-9 * pressure);
  EXPECT_NEAR(stress[0][1].get<double>(), 0, 1e-9 * pressure);
}

TEST(MeasureStates, ACellOfThreeVectorsIsThatOfTwoBounds) {
  expect_crystal(measured_borders("crystal.dump crystal-pairs.dump --thickness 1m"));
  const Json t = measured_borders("crystal-vectors.dump crystal-pairs.dump --thickness 1m");
  expect_crystal(t);
  EXPECT_NEAR(t["solid_fraction"]["value"].get<double>(), 0.8013, 1e-4);
  const Json touching = measured_borders("crystal-vectors.dump --touching 1mm");
  EXPECT_EQ(touching["contacts"], 32);
  EXPECT_EQ(touching["wall_contacts"], 0);
}

TEST(MeasureStates, UnitsThatADumpNamesAreTaken) {
  expect_crystal(measured_borders("crystal-cgs.dump crystal-pairs.dump --thickness 1cm"), 1e-2, 1e-5, 1e-2);
  expect_refusal("crystal-cgs.dump crystal-pairs.dump --length-unit mm", {"states units cgs", "--length-unit"});
  expect_note(measured_borders("crystal.dump crystal-pairs.dump"), "no unit of length, so m was assumed");
  expect_note(measured_borders("crystal.dump crystal-pairs.dump"), "no unit of force, so N was assumed");
}

TEST(MeasureStates, GrainsAndContactsAreOfTheSameStep) {
  const Json t = measured_borders("crystal-two-steps.dump crystal-step-1000.dump --thickness 1m");
  expect_crystal(t);
  expect_note(t, "2 snapshots, of which that of step 1000 was taken");
  expect_refusal("crystal.dump crystal-step-1000.dump", {"step 1000", "step 1,", "the same steps"});
}

TEST(MeasureStates, OpaqueColumnsAreUnderstoodByTheirContentOrRefused) {
  for (const char* file : {"crystal-id-force.dump", "crystal-dist.dump"})
    expect_refusal(std::string("crystal.dump ") + file + " --thickness 1m",
                   {"it is not known which of the columns", "--columns"});
  const Json t =
      measured_borders("crystal.dump crystal-id-force.dump --thickness 1m --columns patom1,patom2,-,fx,fy,-");
  EXPECT_NEAR(t["stress"]["value"][1][1].get<double>(), -30.30, 0.01);
  EXPECT_NEAR(t["stress"]["value"][0][0].get<double>(), -10.10, 0.01);
}

TEST(MeasureStates, ALayerIsMeasuredInItsPlaneAndABedInSpaceIsOfSpheres) {
  for (const char* layer : {"layer-xz.dump", "layer-xz.txt"}) {
    const Json t = measured_borders(std::string(layer) + " --touching 100um");
    EXPECT_EQ(t["grains"], 16);
    EXPECT_EQ(t["contacts"], 33) << layer;
    expect_note(t, "plane x-z");
  }
  const Json bed = measured_borders("bed-in-space.dump --touching 100um");
  EXPECT_EQ(bed["dimension"], 3);
  EXPECT_FALSE(bed.contains("stress"));
  expect_refusal("bed-in-space.dump --touching 100um --dimension 2", {"fill space", "one layer"});
}

TEST(MeasureStates, PairsThatAreListedWithAGapAndNoForceDoNotTouch) {
  const Json t = measured_borders("four-grains.dump four-grains-pairs.dump --thickness 1m");
  EXPECT_EQ(t["contacts"], 2);
  EXPECT_DOUBLE_EQ(t["coordination"]["all"]["value"].get<double>(), 1);
  EXPECT_EQ(t["force"]["count"], 2);
  expect_note(t, "2 of 4 listed pairs have a gap between them and no force");
}

TEST(MeasureStates, YadeFilesWithoutASphereOrACellAreRefused) {
  expect_refusal("no-sphere.txt one-interaction.vtk", {"no-sphere.txt:2", "at least 4 values"});
  expect_refusal("two-spheres.txt one-interaction.vtk --periodic", {"give --box"});
}

TEST(MeasureStates, ARunOfClumpsThatIsExportedAndMeasuredAgainHasItsStress) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  ASSERT_EQ(arenite("run " ARENITE_SOURCE_DIR "/tests/data/borders/dumbbells.toml --out " + out).status, 0);
  ASSERT_EQ(arenite("export " + out + " --to csv --last").status, 0);
  const Json shown = Json::parse(arenite("show --json " + out).out);
  const Domain domain = io::read_stage(io::stage_files(out).back()).snapshots.back().packing.domain;
  const auto both = [](double a, double b) { return fmt::format("{},{}", a, b); };
  const Outcome again = arenite(fmt::format(
      "measure --json {0}/csv/grains_0000.csv {0}/csv/contacts_0000.csv --box {1} --origin={2} --thickness {3}", out,
      both(domain.width(), domain.height()), both(domain.wall[left].position, domain.wall[bottom].position),
      domain.thickness));
  ASSERT_EQ(again.status, 0) << again.err;
  const Json read = Json::parse(again.out);
  EXPECT_EQ(read["contacts"], shown["contacts"]);
  EXPECT_EQ(read["wall_contacts"], shown["wall_contacts"]);
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      EXPECT_NEAR(read["stress"]["value"][a][b].get<double>(), shown["stress"]["value"][a][b].get<double>(),
                  1e-6);  // of 10 kPa
}

}  // namespace
}  // namespace arenite::test
