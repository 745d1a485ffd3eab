#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "support/numbers_of.hpp"
#include "support/program.hpp"
#include "support/sample_results.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;

StageResult sample() {
  auto result = test::two_snapshots(6);
  result.texture = {};
  return result;
}

TEST(Show, JsonHasProvenanceStagesAndTheTextureOfTheLastState) {
  const TemporaryFolder folder;
  io::write_stage(folder / "01-compact.h5", sample());
  const auto shown = arenite("show " + (folder / "01-compact.h5").string() + " --json");
  ASSERT_EQ(shown.status, 0) << shown.err;
  const Json j = Json::parse(shown.out);
  EXPECT_EQ(j["provenance"]["seed"], 7);
  EXPECT_EQ(j["provenance"]["kernel"], "portable");
  EXPECT_EQ(j["provenance"]["recipe"], "title = \"two snapshots\"\n");
  ASSERT_EQ(j["stages"].size(), 1u);
  EXPECT_EQ(j["stages"][0]["states"], 2);
  EXPECT_EQ(j["stages"][0]["last_state"]["walls"]["top"]["force_N"], 103.0);
  EXPECT_EQ(j["stages"][0]["last_state"]["energies_J"]["work_gravity"], 10.5);
  EXPECT_EQ(j["grains"], 6);
  EXPECT_EQ(j["contacts"], 5);
  EXPECT_NEAR(j["coordination"]["all"]["value"], 2.0 * 5 / 6, 1e-12);
  EXPECT_NEAR(j["force"]["mean_N"]["value"], 110, 1e-9);
  for (const char* field : {"solid_fraction", "fabric", "stress", "sigma_norm"})
    EXPECT_TRUE(j.contains(field)) << field;
}

TEST(Show, NumbersHaveTheirErrorUnitAndSentence) {
  const TemporaryFolder folder;
  io::write_stage(folder / "01-compact.h5", sample());
  const auto shown = arenite("show " + (folder / "01-compact.h5").string() + " --numbers");
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_NE(shown.out.find("coordination.all "), std::string::npos) << shown.out;
  EXPECT_NE(shown.out.find("Mean number of contacts per grain"), std::string::npos) << shown.out;
}

TEST(Show, AStoredTextureIsNotMeasuredAgain) {
  const TemporaryFolder folder;
  auto result = sample();
  result.texture = test::numbers_of(R"({"grains": 12345})");
  io::write_stage(folder / "r.h5", result);
  EXPECT_EQ(Json::parse(arenite("show --json " + (folder / "r.h5").string()).out)["grains"], 12345);
}

void expect_refused(const std::string& command, const std::string& words);

TEST(Show, StoredNumbersOfAnotherShapeAreOneSentence) {
  const TemporaryFolder folder;
  auto result = sample();
  result.texture = test::numbers_of(R"({"coordination": 5, "stages": 7, "provenance": "me"})");
  io::write_stage(folder / "r.h5", result);
  expect_refused("show --json " + (folder / "r.h5").string(), "compute the result again");
}

void expect_refused(const std::string& command, const std::string& words) {
  const auto outcome = arenite(command);
  EXPECT_EQ(outcome.status, 2) << command;
  EXPECT_EQ(outcome.out, "") << command;
  EXPECT_NE(outcome.err.find(words), std::string::npos) << command << ": " << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(Show, SaysWhatStandsThereWhereItIsNoResult) {
  const TemporaryFolder folder;
  namespace fs = std::filesystem;
  fs::create_directories(folder / "empty");
  fs::create_directories(folder / "study/runs/0123");
  fs::create_directories(folder / "maps");
  io::write_atomically(folder / "study/runs.tsv", "");
  for (const char* map : {"amplitude.tif", "in_phase.tif", "standard_error.tif"})
    io::write_atomically(folder / "maps" / map, "");
  io::write_atomically(folder / "r.toml", "seed = 1\n");
  io::write_atomically(folder / "words.txt", "version 2\n");
  const auto at = [&](const char* name) { return (folder / name).string(); };
  for (const char* each : {"show ", "show --states ", "export --to csv ", "figures "}) {
    const std::string command = each;
    expect_refused(command + at("empty"), "empty: is not a result; give the folder that");
    expect_refused(command + at("maps"), "maps: contains the maps of a film");
    expect_refused(command + at("r.toml"), "r.toml: is a recipe, not a result");
    expect_refused(command + "thesis-ch4", "thesis-ch4: is a built-in study");
    if (command != "figures ")
      expect_refused(command + at("study"), "study: is the folder of a study, not a result; give one of its runs");
  }
  expect_refused("show " + at("words.txt"), "words.txt: holds no rows of numbers");
}

TEST(Show, StatesHaveTheirUnitsInTheHeads) {
  const TemporaryFolder folder;
  io::write_stage(folder / "01-compact.h5", sample());
  const auto shown = arenite("show --states " + (folder / "01-compact.h5").string());
  ASSERT_EQ(shown.status, 0) << shown.err;
  const std::string head = shown.out.substr(0, shown.out.find('\n'));
  EXPECT_TRUE(head.starts_with("stage,label,time [s],strain_x,strain_y,volumetric_strain,")) << head;
  for (const char* name : {",z,z_error,", ",a_c_strong,", ",p [Pa],", ",q [Pa],", ",q_over_p", ",mobilisation"})
    EXPECT_TRUE(test::contains(head, name)) << name << " in " << head;
  EXPECT_EQ(std::count(shown.out.begin(), shown.out.end(), '\n'), 3);  // and one row for each of two states
}

TEST(Show, TextTellsStagesInOrderAndWhichIsNotAtRest) {
  const TemporaryFolder folder;
  auto second = sample();
  second.name = "shear";
  second.converged = false;
  second.outcome = "unbalanced ratio 3e-3 after 1000 steps";
  io::write_stage(folder / "01-compact.h5", sample());
  io::write_stage(folder / "02-shear.h5", second);
  const auto shown = arenite("show " + folder.path().string());
  ASSERT_EQ(shown.status, 0) << shown.err;
  const auto first = shown.out.find("compact"), next = shown.out.find("NOT IN EQUILIBRIUM: unbalanced ratio 3e-3");
  EXPECT_LT(first, next) << shown.out;
  EXPECT_NE(next, std::string::npos) << shown.out;
  EXPECT_NE(shown.out.find("top 103 N"), std::string::npos) << shown.out;
}

TEST(Figures, SayWhatBuildsTheModuleWhereOnlyItsPythonFilesAre) {
  const TemporaryFolder folder;
  io::write_stage(folder / "r.h5", sample());
  std::filesystem::create_directories(folder / "build/python/arenite/figures");
  std::filesystem::copy_file(ARENITE_BINARY, folder / "build/arenite");
  io::write_atomically(folder / "build/python/arenite/figures/__main__.py", "raise SystemExit(7)\n");
  const auto refused = test::shell((folder / "build/arenite").string() + " figures " + (folder / "r.h5").string());
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_NE(refused.err.find("`make build` in the source folder builds it"), std::string::npos) << refused.err;
}

TEST(Show, IsShortAndSaysWhatItsSymbolsMean) {
  const TemporaryFolder folder;
  auto result = test::two_snapshots(600);
  result.texture = {};
  io::write_stage(folder / "r.h5", result);
  const std::string file = (folder / "r.h5").string();
  const auto shown = arenite("show " + file), all = arenite("show " + file + " --all");
  ASSERT_EQ(shown.status, 0) << shown.err;
  ASSERT_EQ(all.status, 0) << all.err;
  EXPECT_LE(std::count(shown.out.begin(), shown.out.end(), '\n'), 30) << shown.out;
  EXPECT_GT(all.out.size(), shown.out.size());
  for (const char* part : {"coordination.all ", "Mean number of contacts per grain", "fabric.a_c ",
                           "Contact anisotropy", "force.mean_N ", "P ~ exp(-beta x)", "--all"})
    EXPECT_NE(shown.out.find(part), std::string::npos) << part << "\n" << shown.out;
  EXPECT_NE(all.out.find("dissipated by friction"), std::string::npos) << all.out;
}

TEST(Show, SaysThatAStateMovesThoughItsStageEndedByItsTime) {
  const TemporaryFolder folder;
  auto result = sample();
  result.outcome = "0.5 s passed";
  result.snapshots.back().equilibrium.unbalanced_ratio = 1e-5;
  result.snapshots.back().equilibrium.kinetic_ratio = 69;
  io::write_stage(folder / "r.h5", result);
  const auto moving = arenite("show " + (folder / "r.h5").string());
  EXPECT_NE(moving.out.find("NOT IN EQUILIBRIUM: unbalanced force ratio 1.0e-05, kinetic over elastic energy 6.9e+01"),
            std::string::npos)
      << moving.out;
  result.snapshots.back().equilibrium.kinetic_ratio = 1e-9;
  io::write_stage(folder / "r.h5", result);
  EXPECT_NE(arenite("show " + (folder / "r.h5").string()).out.find("in equilibrium: "), std::string::npos);
}

TEST(Show, BadFilesGiveStatus2AndOneSentence) {
  const TemporaryFolder folder;
  io::write_stage(folder / "r.h5", sample());
  const std::string whole = io::read_file(folder / "r.h5");
  io::write_atomically(folder / "cut.h5", whole.substr(0, whole.size() / 3));
  io::write_atomically(folder / "foreign.h5", whole.substr(512));
  io::write_atomically(folder / "empty.h5", "");
  for (const auto& [name, words] : std::map<std::string, std::string>{{"cut.h5", "truncated"},
                                                                      {"foreign.h5", "another program"},
                                                                      {"empty.h5", "is empty"},
                                                                      {"none.h5", "no such file"}}) {
    const auto shown = arenite("show " + (folder / name).string());
    EXPECT_EQ(shown.status, 2) << name;
    EXPECT_NE(shown.err.find(words), std::string::npos) << shown.err;
    EXPECT_EQ(std::count(shown.err.begin(), shown.err.end(), '\n'), 1) << shown.err;
    EXPECT_TRUE(shown.out.empty());
  }
}

TEST(Show, NotesOfAResultFollowItsNumbers) {
  const TemporaryFolder folder;
  const std::string out = (folder / "cut").string(), word = "  note: no solid joins the two clamps",
                    map = ARENITE_SOURCE_DIR "/tests/data/phase_maps/cut1.png --phases 0=void,1=matrix ";
  const auto loaded = arenite("load " + map + "--quiet --out " + out);
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  EXPECT_NE(loaded.out.find(word), std::string::npos) << loaded.out;
  const std::string shown = arenite("show " + out).out;
  EXPECT_NE(shown.find(word), std::string::npos) << shown;
  EXPECT_EQ(shown.find(word), shown.rfind(word));
}

}  // namespace
