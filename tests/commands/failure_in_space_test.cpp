// Cemented spheres pulled until they break, as their user meets it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using test::arenite;
using Json = nlohmann::json;

const std::string small_example =
    "run " ARENITE_SOURCE_DIR
    "/examples/41-failure-in-space/recipe.toml --quiet --set packing.grains=70 --set grid.nodes=16 "
    "--set grid.crop='\"12 mm\"' --set container.width='\"18 mm\"' --set container.depth='\"18 mm\"' --out ";

std::string text_of(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(FailureInSpace, TheExampleBreaksAndItsPageAndFilesShowTheCracks) {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const auto run = arenite(small_example + out);
  ASSERT_EQ(run.status, 0) << run.err;
  const Json numbers = Json::parse(arenite("show " + out + " --json").out);
  const Json& failure = numbers["failure"];
  EXPECT_GT(numbers["strength_Pa"].get<double>(), 1e4);
  EXPECT_EQ(numbers["load"]["ending"], "dropped");
  EXPECT_LT(failure["energy_balance_error"].get<double>(), 1e-4);
  EXPECT_GT(failure["broken"]["interface"].get<int>(), 50);
  EXPECT_LT(failure["released_J"].get<double>(), failure["work_J"].get<double>());
  EXPECT_TRUE(std::filesystem::exists(folder / "out/report.html"));
  const auto vtk = arenite("export " + out + " --to vtk --out " + (folder / "vtk").string());
  ASSERT_EQ(vtk.status, 0) << vtk.err;
  EXPECT_TRUE(test::contains(text_of(folder / "vtk/break-cracks.vtp"), "NumberOfPolys=\""));
  EXPECT_TRUE(test::contains(text_of(folder / "vtk/break.vti"), "Name=\"damage\""));
}

/// A block of 10 x 6 x 20 voxels with a notch beyond its middle at half of its height.
std::string notched_block(const test::TemporaryFolder& folder) {
  std::string voxels(10 * 6 * 20, '\1');
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 6; ++x)
      for (const int z : {9, 10}) voxels[static_cast<std::size_t>(x + 10 * (y + 6 * z))] = '\0';
  std::ofstream(folder / "scan.raw", std::ios::binary) << voxels;
  std::ofstream(folder / "scan.mhd") << "NDims = 3\nDimSize = 10 6 20\nElementType = MET_UCHAR\n"
                                        "ElementDataFile = scan.raw\n";
  return "load " + (folder / "scan.mhd").string() + " --phases 0=void,1=matrix --failure ";
}

TEST(FailureInSpace, ANotchedBlockShowsItsCrackInABrowser) {
  const test::TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const auto loaded = arenite(notched_block(folder) + "--dx '1 mm' --out " + out);
  ASSERT_EQ(loaded.status, 0) << loaded.err;
  const auto drawn =
      test::shell("node " ARENITE_SOURCE_DIR "/web/test/failure_in_space_page.test.mjs " + out + "/report.html");
  EXPECT_EQ(drawn.status, 0) << drawn.out << drawn.err;
}

TEST(FailureInSpace, ATestWithoutALengthIsRefusedAndItsHorizonTold) {
  const test::TemporaryFolder folder;
  const std::string block = notched_block(folder);
  const auto without = arenite(block);
  EXPECT_EQ(without.status, 2);
  EXPECT_TRUE(test::contains(without.err, "a crack needs a length")) << without.err;
  const auto with = arenite(block + "--dx '1 mm' --horizon-in-space 3 --json");
  ASSERT_EQ(with.status, 0) << with.err;
  EXPECT_EQ(Json::parse(with.out)["load"]["horizon_in_space"], 3);
}

}  // namespace
