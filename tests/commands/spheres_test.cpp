// Recipes of spheres, from the file to the numbers.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
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

std::string written(const TemporaryFolder& folder, const std::string& recipe) {
  const auto path = folder / "recipe.toml";
  std::ofstream(path) << recipe;
  return path.string();
}

Json numbers_shown(const std::filesystem::path& out) {
  const auto outcome = arenite("show " + out.string() + " --json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return Json::parse(outcome.out);
}

/// O'Hern et al., PRE 68, 011306 (2003): 0.639 +- 0.010 as the size grows, and z = 6 without rattlers, both from above
/// at a pressure above 0. Bands are five times the scatter of so few.
TEST(Spheres, WithoutFrictionTheyJamWhereTheyAreKnownTo) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run = arenite("run " + written(folder, test::small_spheres) + " --quiet --out " + out.string());
  ASSERT_EQ(run.status, 0) << run.err;
  const Json j = numbers_shown(out);
  EXPECT_NEAR(j["solid_fraction"]["value"].get<double>(), 0.64, 0.02);
  EXPECT_NEAR(j["coordination"]["without_rattlers"]["value"].get<double>(), 6.2, 0.3);
  EXPECT_NEAR(j["stress_details"]["pressure_Pa"].get<double>() / 10e3, 1, 5e-3);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(j["stress"]["value"][axis][axis].get<double>() / -10e3, 1, 5e-3) << axis;
  const auto told = arenite("show " + out.string());
  EXPECT_TRUE(test::contains(told.out, "in equilibrium")) << told.out;
}

/// Platens at the top and the bottom, and a pressure on the four sides: the stress along the axis is what the platen
/// bears, and the sides keep theirs.
TEST(Spheres, ATriaxialTestKeepsItsSidePressure) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run = arenite("run " + written(folder, test::small_triaxial) + " --quiet --out " + out.string());
  ASSERT_EQ(run.status, 0) << run.err;
  const Json j = numbers_shown(out);
  const Json& walls = j["stages"].back()["last_state"]["walls"];
  const auto side = [&](const char* of, const char* what) { return walls[of][what].get<double>(); };
  const double width = side("right", "position_m") - side("left", "position_m"),
               depth = side("front", "position_m") - side("back", "position_m"),
               height = side("top", "position_m") - side("bottom", "position_m");
  const Json& stress = j["stress"]["value"];
  EXPECT_NEAR(side("top", "force_N") / (width * depth) / -stress[1][1].get<double>(), 1, 0.05);
  EXPECT_NEAR(side("right", "force_N") / (height * depth) / 10e3, 1, 0.05);
  EXPECT_NEAR(side("front", "force_N") / (height * width) / 10e3, 1, 0.05);
  EXPECT_GT(stress[1][1].get<double>() / stress[0][0].get<double>(), 1.5) << "the axis bears more";
  EXPECT_GT(std::abs(j["fabric"]["axis"][1].get<double>()), 0.8) << "contacts turn to it";
}

TEST(Spheres, WhatSpaceDoesNotHaveIsRefusedInASentence) {
  const TemporaryFolder folder;
  const std::string recipe = written(folder, test::small_spheres);
  for (const auto& [set, part] : {std::pair{"stages.compress.open.top=true", "no wall at the top"},
                                  {"integration.track_energy=true", "no energy balance"},
                                  {"populations.0.shape=pentagon", "no clumps"},
                                  {"packing.method=lattice", "random"},
                                  {"packing.solid_fraction=0.7", "0.62 or less"},
                                  {"stages.compress.until=\"time > 1 s\"", "`until`"},
                                  {"container.thickness=\"10 mm\"", "dimension = 2"}}) {
    const auto outcome = arenite("check " + recipe + " --set '" + set + "'");
    EXPECT_EQ(outcome.status, 2) << set;
    EXPECT_TRUE(test::contains(outcome.err, part)) << set << ": " << outcome.err;
  }
  const auto flat = arenite("check " + recipe + " --set dimension=2");
  EXPECT_EQ(flat.status, 2);
  EXPECT_TRUE(test::contains(flat.err, "dimension = 3")) << flat.err;
}

TEST(Spheres, ThreadsAndKernelsGiveTheSameBytes) {
  const TemporaryFolder folder;
  const std::string recipe = written(folder, test::small_spheres);
  const auto run = [&](const char* name, const std::string& more) {
    EXPECT_EQ(arenite("run " + recipe + " --quiet --out " + (folder / name).string() + " " + more).status, 0);
    return arenite("show " + (folder / name).string() + " --json").out;
  };
  const Json one = Json::parse(run("one", "--set integration.kernel=portable")),
             two = Json::parse(run("two", "--threads 2"));
  EXPECT_EQ(one["stress"], two["stress"]);
  EXPECT_EQ(one["fabric"], two["fabric"]);
}

}  // namespace
