#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/disk/file.hpp"
#include "support/document_of_page.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string recipe = ARENITE_SOURCE_DIR "/examples/07-cemented-packing/recipe.toml";
const std::string small = " --quiet --set bidisperse.box_area=60 --set grid.nodes=160 --set 'grid.crop=\"8 mm\"'";

std::string run(const fs::path& out, const std::string& more = "") {
  return "run " + recipe + small + " " + more + " --out " + out.string();
}

Json shown(const fs::path& result) { return Json::parse(arenite("show --json " + result.string()).out); }

fs::path file_of(const fs::path& folder, const std::string& stage) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().find("-" + stage + "-") != std::string::npos) return entry.path();
  return {};
}

TEST(Cemented, ExampleGoesFromSamplingToStressesByPhase) {
  const TemporaryFolder folder;
  const auto ran = arenite(run(folder / "out", "--set loads.0.statistics.clamp_rows=8"));
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* stage : {"packing", "compact", "rest", "cement", "tension"})
    EXPECT_FALSE(file_of(folder / "out", stage).empty()) << stage;
  EXPECT_TRUE(fs::exists(folder / "out/report.html"));
  const Json loaded = test::document_of_page(folder / "out/report.html")["fields"][1];
  const Json& stress = loaded["numbers"]["stress"];
  EXPECT_EQ(stress["options"]["clamp_rows"], 8);
  const std::string variance = test::number_in_key(loaded, "all", "var");
  ASSERT_FALSE(variance.empty());
  EXPECT_NEAR(std::stod(variance), stress["sigma_yy"]["sets"]["all"]["variance"]["value"].get<double>(),
              1.01 * test::half_digit(variance));
  const Json j = shown(folder / "out");
  EXPECT_EQ(j["map"]["width"], 160);
  EXPECT_NEAR(j["map"]["dx_m"].get<double>(), 8e-3 / 160, 1e-12);
  const Json& phases = j["phases"];
  EXPECT_NEAR(phases["particle"].get<double>() + phases["matrix"].get<double>() + phases["void"].get<double>(), 1,
              1e-12);
  EXPECT_NEAR(j["S_m"].get<double>(), phases["matrix"].get<double>() / (1 - phases["particle"].get<double>()), 1e-12);
  EXPECT_GT(phases["particle"].get<double>(), 0.7);
  EXPECT_GT(j["coordination"]["Z_l"]["value"].get<double>(), j["coordination"]["Z_s"]["value"].get<double>());
  EXPECT_NEAR(j["coordination"]["gap_m"].get<double>(), 0.075e-3, 1e-12);
  EXPECT_EQ(j["load"]["ending"], "solved");
  EXPECT_LT(std::abs(j["load"]["reaction_balance_error"].get<double>()), 1e-5);
  EXPECT_GT(j["modulus_Pa"].get<double>(), 0.1e9);
  EXPECT_LT(j["modulus_Pa"].get<double>(), 4e9);
  // Strain 1e-4: the mean stress over the whole area is the modulus times it.
  EXPECT_NEAR(j["stress"]["sigma_yy"]["mean_over_area_Pa"]["value"].get<double>(), 1e-4 * j["modulus_Pa"].get<double>(),
              0.1 * 1e-4 * j["modulus_Pa"].get<double>());
  const double correlation = j["grain_stress_against_contacts"]["sigma_yy"]["all"]["correlation"]["value"];
  EXPECT_GT(correlation, 0);
  EXPECT_LE(correlation, 1);
  ASSERT_EQ(j["stages"].size(), 5u);
  EXPECT_EQ(j["stages"][3]["name"], "cement");
  EXPECT_TRUE(j.contains("texture"));
  const auto text = arenite("show --all " + (folder / "out").string());
  ASSERT_EQ(text.status, 0) << text.err;
  for (const char* words : {"S_m", "Apparent modulus", "stress.sigma_yy.sample_mean_Pa", "matrix"})
    EXPECT_NE(text.out.find(words), std::string::npos) << words;
}

TEST(Cemented, StoredStagesAreReusedAndDamagedOnesMadeAgainWithTheSameBytes) {
  const TemporaryFolder folder;
  ASSERT_EQ(arenite(run(folder / "out")).status, 0);
  const fs::path cement = file_of(folder / "out", "cement"), tension = file_of(folder / "out", "tension");
  const std::string cement_bytes = io::read_file(cement), tension_bytes = io::read_file(tension);
  const auto written = fs::last_write_time(cement);
  io::write_atomically(tension, tension_bytes.substr(0, tension_bytes.size() / 2));
  const auto again = arenite(run(folder / "out"));
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("truncated"), std::string::npos) << again.err;
  EXPECT_EQ(io::read_file(tension), tension_bytes);
  EXPECT_EQ(fs::last_write_time(cement), written);
  ASSERT_EQ(arenite(run(folder / "out", "--set loads.0.strain=2e-4")).status, 0);
  EXPECT_EQ(fs::last_write_time(cement), written);
  EXPECT_TRUE(fs::exists(folder / "out/earlier" / tension.filename()));
  const Json j = shown(folder / "out");
  EXPECT_EQ(j["load"]["strain"], 2e-4);
}

TEST(Cemented, APackingThatDoesNotComeToRestIsNotCemented) {
  const TemporaryFolder folder;
  const auto ran = arenite(run(folder / "out", "--set stages.0.equilibrium.max_steps=1 --set grid.nodes=400"));
  // One step of compaction cannot come to rest: the packing is as loose as it was sampled, and the run ends there.
  EXPECT_EQ(ran.status, 3) << ran.err;
  EXPECT_TRUE(file_of(folder / "out", "cement").empty());
}

TEST(Cemented, ExportsOpenInVtkAndAsTables) {
  const TemporaryFolder folder;
  ASSERT_EQ(arenite(run(folder / "out")).status, 0);
  const fs::path file = file_of(folder / "out", "tension");
  const auto done = arenite("export " + file.string() + " --to vtk --out " + (folder / "vtk").string());
  ASSERT_EQ(done.status, 0) << done.err;
  const auto read = test::shell("/usr/bin/python3 " ARENITE_SOURCE_DIR "/tests/commands/compare_vti.py " +
                                file.string() + " " + (folder / "vtk/tension.vti").string());
  EXPECT_EQ(read.status, 0) << read.err;
  ASSERT_EQ(arenite("export " + file.string() + " --to csv --out " + (folder / "csv").string()).status, 0);
  const std::string nodes = io::read_file(folder / "csv/tension_nodes.csv");
  EXPECT_TRUE(nodes.starts_with("x [m],y [m],phase,grain,class,ux [m],uy [m],sigma_xx [Pa]"));
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), '\n'), 160 * 160 + 1);
  EXPECT_TRUE(io::read_file(folder / "csv/tension_grains.csv")
                  .starts_with("label,class,nodes,whole,x [m],y [m],sigma_xx [Pa]"));
  const auto refused = arenite("export " + file.string() + " --to lammps --out " + (folder / "lammps").string());
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("lammps holds grains only"), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists(folder / "lammps"));
  const auto all = arenite("export " + (folder / "out").string() + " --to vtk --out " + (folder / "all").string());
  ASSERT_EQ(all.status, 0) << all.err;
  for (const char* name : {"loading.pvd", "cement.vti", "tension.vti"})
    EXPECT_TRUE(fs::exists(folder / "all" / name)) << name;
}

TEST(Cemented, FailureExampleBreaks) {
  const TemporaryFolder folder;
  const auto ran = arenite("run " ARENITE_SOURCE_DIR
                           "/examples/08-failure/recipe.toml --quiet --set bidisperse.box_area=30 --set grid.nodes=64 "
                           "--set 'grid.crop=\"5 mm\"' --out " +
                           (folder / "out").string());
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json j = shown(folder / "out");
  EXPECT_GT(j["strength_Pa"].get<double>(), 0);
  EXPECT_GT(j["failure"]["broken"]["matrix"].get<int>() + j["failure"]["broken"]["interface"].get<int>(), 0);
  EXPECT_LT(j["failure"]["energy_balance_error"].get<double>(), 1e-3);
  ASSERT_EQ(
      arenite("export " + file_of(folder / "out", "failure").string() + " --to csv --out " + (folder / "csv").string())
          .status,
      0);
  EXPECT_TRUE(io::read_file(folder / "csv/failure_curve.csv").starts_with("strain,stress [Pa],work [J/m]"));
  ASSERT_EQ(
      arenite("export " + file_of(folder / "out", "failure").string() + " --to vtk --out " + (folder / "vtk").string())
          .status,
      0);
  const auto read =
      test::shell("/usr/bin/python3 " ARENITE_SOURCE_DIR "/tests/commands/compare_cracks.py " +
                  file_of(folder / "out", "failure").string() + " " + (folder / "vtk/failure-cracks.vtp").string());
  EXPECT_EQ(read.status, 0) << read.err;
}

TEST(Cemented, BreaksInShearAndSplitsInCompression) {
  const TemporaryFolder folder;
  for (const char* loading : {"shear", "compression"}) {
    const auto ran =
        arenite("run " ARENITE_SOURCE_DIR
                "/examples/08-failure/recipe.toml --quiet --set bidisperse.box_area=30 --set grid.nodes=48 --set "
                "'grid.crop=\"5 mm\"' --set loads.0.band=0.2 --set loads.0.max_strain=4e-3 --set loads.0.loading=" +
                std::string(loading) + " --out " + (folder / loading).string());
    ASSERT_EQ(ran.status, 0) << ran.err;
    const Json j = shown(folder / loading);
    EXPECT_GT(j["strength_Pa"].get<double>(), 0) << loading;
    EXPECT_GT(j["failure"]["broken"]["matrix"].get<int>() + j["failure"]["broken"]["interface"].get<int>(), 0)
        << loading;
    EXPECT_LT(j["failure"]["energy_balance_error"].get<double>(), 1e-3) << loading;
  }
}

TEST(Cemented, ThesisSampleInThreeLoadings) {
  const TemporaryFolder folder;
  const auto ran = arenite("run " ARENITE_SOURCE_DIR
                           "/examples/09-cemented-thesis-sample/recipe.toml --quiet --set populations.0.count=40 --set "
                           "populations.1.count=44 --set 'container.width=\"120 mm\"' --set "
                           "'stages.1.bottom.force=\"17 kN\"' --set grid.nodes=160 --out " +
                           (folder / "out").string());
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json j = shown(folder / "out");
  EXPECT_NEAR(j["exact"]["S_m"].get<double>(), 0.5, 1e-4);
  EXPECT_EQ(j["load"]["loading"], "shear");
  EXPECT_TRUE(j["stress"].contains("sigma_xy"));
  const Json tension = shown(file_of(folder / "out", "tension"));
  for (const char* name : {"E_x_Pa", "E_y_Pa", "G_Pa"})
    EXPECT_GT(tension["apparent_moduli"][name].get<double>(), 0) << name;
  EXPECT_DOUBLE_EQ(tension["apparent_moduli"]["E_y_Pa"].get<double>(), tension["modulus_Pa"].get<double>());
  EXPECT_LT(tension["apparent_moduli"]["G_Pa"].get<double>(), tension["apparent_moduli"]["E_y_Pa"].get<double>());
}

TEST(Cemented, SlipsAreOneSentenceEachAndLeaveNothing) {
  const TemporaryFolder folder;
  for (const auto& [slip, words] : std::vector<std::pair<std::string, std::string>>{
           {"--set bidisperse.volume_ratio=90", "out of reach"},
           {"--set bidisperse.size_ratio=0.5", "out of range"},
           {"--set 'loads.0.stiffness.matrix=\"-1 GPa\"'", "above 0"},
           {"--set 'loads.0.stiffness.matrix=\"1 kN\"'", "a pressure"},
           {"--set loads.0.loading=twist", "unknown word"},
           {"--set loads.0.loading=shear --set loads.0.lower=sliding", "carries no shear"},
           {"--set loads.0.name=compact", "names must differ"},
           {"--set bidisperse.small=large", "give each its own material"},
           {"--set 'container.width=\"3 mm\"'", "is only valid with"},
           {"--set cement.kind=coating", "cement.thickness: is missing"},
           {"--set cement.kind=full --set cement.saturation=0.5", "is only valid with"}}) {
    const auto refused = arenite(run(folder / "none", slip));
    EXPECT_EQ(refused.status, 2) << slip;
    EXPECT_NE(refused.err.find(words), std::string::npos) << slip << "\n" << refused.err;
    EXPECT_TRUE(refused.out.empty());
    EXPECT_FALSE(fs::exists(folder / "none")) << slip;
  }
}

TEST(Cemented, FullCementLeavesNoVoid) {
  const TemporaryFolder folder;
  ASSERT_EQ(arenite(run(folder / "out", "--set cement.kind=full")).status, 0);
  const Json j = shown(folder / "out");
  EXPECT_EQ(j["phases"]["void"], 0);
  EXPECT_EQ(j["S_m"], 1);
  EXPECT_EQ(j["voids"]["count"], 0);
  EXPECT_GT(j["modulus_Pa"].get<double>(), 1e9);
  EXPECT_LT(j["modulus_Pa"].get<double>(), 4e9);
}

TEST(Cemented, ACropBeyondTheSampleIsRefusedWithItsSize) {
  const TemporaryFolder folder;
  const auto refused = arenite(run(folder / "out", "--set 'grid.crop=\"80 mm\"'"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  EXPECT_TRUE(file_of(folder / "out", "cement").empty());
}

TEST(Cemented, SaturationOutOfReachSaysWhatCanBeReached) {
  const TemporaryFolder folder;
  const auto refused = arenite(run(folder / "out", "--set cement.saturation=0.9999 --set 'cement.gap=\"0 mm\"'"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  EXPECT_NE(refused.err.find("saturation"), std::string::npos) << refused.err;
}

#ifndef __SANITIZE_ADDRESS__  // which wants all addresses
TEST(Cemented, EndsWithASentenceWhereMemoryIsShort) {
  const TemporaryFolder folder;
  ASSERT_EQ(arenite(run(folder / "out")).status, 0);
  int short_of_memory = 0;
  for (const int megabytes : {220, 260, 300, 340, 380}) {
    const std::string more = "--set loads.0.statistics.clamp_rows=" + std::to_string(megabytes / 20);
    const auto ended = test::shell("ulimit -v " + std::to_string(megabytes << 10) + "; timeout -s KILL 100 " +
                                   std::string(ARENITE_BINARY) + " " + run(folder / "out", more));
    EXPECT_TRUE(ended.status == 0 || ended.status == 1) << megabytes << ": " << ended.status;
    if (ended.status == 0) continue;
    ++short_of_memory;
    EXPECT_NE(ended.err.find("out of memory"), std::string::npos) << megabytes << ": " << ended.err;
  }
  EXPECT_GT(short_of_memory, 0);
}
#endif

TEST(Init, TemplatesAreListedAndCemented) {
  const auto listed = arenite("init");
  EXPECT_EQ(listed.status, 0);
  EXPECT_NE(listed.out.find("cemented"), std::string::npos);
  const TemporaryFolder folder;
  ASSERT_EQ(arenite("init cemented " + (folder / "r.toml").string()).status, 0);
  EXPECT_EQ(arenite("check " + (folder / "r.toml").string()).status, 0);
}

}  // namespace
