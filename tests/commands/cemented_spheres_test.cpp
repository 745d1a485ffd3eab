// One recipe from the first sphere to the stress in every voxel.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/program.hpp"
#include "support/small_spheres.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;

const std::string cemented = test::small_spheres + R"([cement]
width = 0.5
[grid]
nodes = 32
[[loads]]
name = "pull"
method = "elements"
[[loads]]
name = "shear"
method = "elements"
loading = "shear"
)";

std::string written(const TemporaryFolder& folder, const std::string& recipe) {
  const auto path = folder / "recipe.toml";
  std::ofstream(path) << recipe;
  return path.string();
}

std::filesystem::path result_of(const std::filesystem::path& out, const std::string& stage) {
  for (const auto& file : std::filesystem::directory_iterator(out))
    if (file.path().filename().string().starts_with(stage)) return file.path();
  ADD_FAILURE() << "no " << stage;
  return {};
}

/// What the voxels hold of grains is what the packing has, and all of that is loaded; a second run computes nothing.
TEST(CementedSpheres, ArePackedPressedCementedAndLoadedByOneRecipe) {
  const TemporaryFolder folder;
  const std::string recipe = written(folder, cemented), out = (folder / "out").string();
  const auto run = arenite("run " + recipe + " --quiet --out " + out);
  ASSERT_EQ(run.status, 0) << run.err;
  const auto numbers_of = [&](const std::string& stage) {
    const auto shown = arenite("show " + result_of(folder / "out", stage).string() + " --json");
    EXPECT_EQ(shown.status, 0) << shown.err;
    return Json::parse(shown.out);
  };
  const Json pull = numbers_of("03-pull"), shear = numbers_of("04-shear");
  EXPECT_NEAR(pull["map"]["phases"]["particle"].get<double>(), 0.64, 0.03);
  EXPECT_GT(pull["map"]["grains"].get<int>(), 140) << "images carry the numbers of their spheres";
  EXPECT_GT(pull["modulus_Pa"].get<double>(), 1e8);
  EXPECT_LT(pull["modulus_Pa"].get<double>(), 4e9);
  EXPECT_LT(shear["modulus_Pa"].get<double>(), pull["modulus_Pa"].get<double>());
  const auto made = std::filesystem::last_write_time(result_of(folder / "out", "03-pull"));
  EXPECT_EQ(arenite("run " + recipe + " --quiet --out " + out).status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(result_of(folder / "out", "03-pull")), made);
}

TEST(CementedSpheres, TheExampleRuns) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run = arenite("run " ARENITE_SOURCE_DIR "/examples/38-cemented-in-space/recipe.toml --quiet --out " +
                           out.string() + " --set packing.grains=150 --set grid.nodes=24 --set grid.crop='\"16 mm\"'" +
                           " --set container.width='\"22 mm\"' --set container.depth='\"22 mm\"'");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(out / "report.html"));
  EXPECT_FALSE(result_of(out, "04-shear").empty());
  const auto arrays = arenite("export " + out.string() + " --to npy");
  EXPECT_EQ(arrays.status, 0) << arrays.err;
  EXPECT_TRUE(test::contains(arrays.err, "left out, for npy does not hold it: 01-packing")) << arrays.err;
  const auto shown = arenite("show " + out.string());
  EXPECT_TRUE(test::contains(shown.out, "\nNumbers of shear, each +-")) << shown.out;
}

TEST(CementedSpheres, WhatTheirSampleCannotBeIsRefusedInASentence) {
  const TemporaryFolder folder;
  const std::string recipe = written(folder, cemented);
  for (const auto& [set, part] : {std::pair{"loads.0.method=relaxation", "dynamic solvers"},
                                  {"loads.0.axis=x", "along z"},
                                  {"grid.fewest_nodes=9", "pores and voids"}}) {
    const auto outcome = arenite("check " + recipe + " --set '" + set + "'");
    EXPECT_EQ(outcome.status, 2) << set;
    EXPECT_TRUE(test::contains(outcome.err, part)) << set << ": " << outcome.err;
  }
  const auto alone = arenite("check " + written(folder, test::small_spheres + "[cement]\nwidth = 0.5\n"));
  EXPECT_EQ(alone.status, 2);
  EXPECT_TRUE(test::contains(alone.err, "[[loads]]")) << alone.err;
}

}  // namespace
