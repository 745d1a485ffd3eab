#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/atomic_file.hpp"
#include "io/read_file.hpp"
#include "io/stage_file.hpp"
#include "support/program.hpp"
#include "support/sample_results.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;

StageResult sample() {
  auto result = test::two_frames(6);
  result.texture_json.clear();
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
  EXPECT_EQ(j["provenance"]["recipe"], "title = \"two frames\"\n");
  ASSERT_EQ(j["stages"].size(), 1u);
  EXPECT_EQ(j["stages"][0]["states"], 2);
  EXPECT_EQ(j["stages"][0]["last_state"]["walls"]["top"]["force_N"], 103.0);
  EXPECT_EQ(j["stages"][0]["last_state"]["energies_J"]["work_gravity"], 10.5);
  EXPECT_EQ(j["grains"], 6);
  EXPECT_EQ(j["contacts"], 5);
  EXPECT_NEAR(j["coordination"]["all"]["value"], 2.0 * 5 / 6, 1e-12);
  EXPECT_NEAR(j["force"]["mean_N"]["value"], 110, 1e-9);
  for (const char* field : {"solid_fraction", "fabric", "stress", "sigma_norm"}) EXPECT_TRUE(j.contains(field)) << field;
}

TEST(Show, AStoredTextureIsNotMeasuredAgain) {
  const TemporaryFolder folder;
  auto result = sample();
  result.texture_json = R"({"grains": 12345})";
  io::write_stage(folder / "r.h5", result);
  EXPECT_EQ(Json::parse(arenite("show --json " + (folder / "r.h5").string()).out)["grains"], 12345);
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
  const auto first = shown.out.find("compact"), next = shown.out.find("NOT AT REST: unbalanced ratio 3e-3");
  EXPECT_LT(first, next) << shown.out;
  EXPECT_NE(next, std::string::npos) << shown.out;
  EXPECT_NE(shown.out.find("force 103 N"), std::string::npos) << shown.out;
}

TEST(Show, BadFilesGiveStatus2AndOneSentence) {
  const TemporaryFolder folder;
  io::write_stage(folder / "r.h5", sample());
  const std::string whole = io::read_file(folder / "r.h5");
  io::write_atomically(folder / "cut.h5", whole.substr(0, whole.size() / 3));
  io::write_atomically(folder / "foreign.h5", whole.substr(512));
  io::write_atomically(folder / "empty.h5", "");
  for (const auto& [name, words] : std::map<std::string, std::string>{
           {"cut.h5", "cut short"}, {"foreign.h5", "another program"}, {"empty.h5", "is empty"}, {"none.h5", "no such file"}}) {
    const auto shown = arenite("show " + (folder / name).string());
    EXPECT_EQ(shown.status, 2) << name;
    EXPECT_NE(shown.err.find(words), std::string::npos) << shown.err;
    EXPECT_EQ(std::count(shown.err.begin(), shown.err.end(), '\n'), 1) << shown.err;
    EXPECT_TRUE(shown.out.empty());
  }
}

}  // namespace
