#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string examples = ARENITE_SOURCE_DIR "/examples/";

Json shown(const fs::path& result) {
  const auto told = arenite("show --json " + result.string());
  EXPECT_EQ(told.status, 0) << told.err;
  return Json::parse(told.out);
}

TEST(SpaceExamples, CastIronIsLoadedByItsRecipe) {
  const TemporaryFolder folder;
  const std::string run = "run " + examples +
                          "32-cast-iron/recipe.toml --quiet --set loads.0.effective_stiffness=false " + "--out " +
                          (folder / "out").string();
  const auto first = arenite(run);
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.out.find("tension"), std::string::npos) << first.out;
  EXPECT_TRUE(fs::exists(folder / "out/report.html"));
  EXPECT_TRUE(fs::exists(folder / "out/recipe.toml"));
  const Json j = shown(folder / "out");
  EXPECT_EQ(j["map"]["voxels"], (Json{100, 100, 100}));
  // Between Voigt's bound and Reuss' (phases 0.886 and 0.114).
  EXPECT_LT(j["modulus_Pa"].get<double>(), 0.886 * 210e9 + 0.114 * 39.7e9);
  EXPECT_GT(j["modulus_Pa"].get<double>(), 1 / (0.886 / 210e9 + 0.114 / 39.7e9));
  EXPECT_LT(std::abs(j["load"]["reaction_balance_error"].get<double>()), 1e-4);
  const auto again = arenite(run);
  EXPECT_EQ(again.status, 0);
  EXPECT_EQ(shown(folder / "out"), j);
}

/// Runs an example's recipe without its effective stiffness, and gives its numbers.
Json loaded_example(const std::string& example, const fs::path& out) {
  const auto run = arenite("run " + examples + example +
                           "/recipe.toml --quiet --set loads.0.effective_stiffness=false" + " --out " + out.string());
  EXPECT_EQ(run.status, 0) << run.err;
  return shown(out);
}

TEST(SpaceExamples, AnElectrodeOfThreePhasesIsLoaded) {
  const TemporaryFolder folder;
  const Json j = loaded_example("34-electrode-in-space", folder / "out");
  EXPECT_EQ(j["map"]["voxels"], (Json{64, 64, 64}));
  EXPECT_EQ(j["map"]["grains"], 37);
  EXPECT_EQ(j["map"]["lengths"], "in voxels, since dx was not given");
  EXPECT_NEAR(j["map"]["phases"]["particle"].get<double>(), 0.3594, 1e-4);
  EXPECT_NEAR(j["modulus_Pa"].get<double>() / 0.333e9, 1, 1e-3);
  EXPECT_LT(std::abs(j["load"]["reaction_balance_error"].get<double>()), 1e-4);
}

TEST(SpaceExamples, APorousRockIsCutIntoGrainsAndLoaded) {
  const TemporaryFolder folder;
  const Json j = loaded_example("35-berea", folder / "out");
  EXPECT_EQ(j["map"]["voxels"], (Json{64, 64, 64}));
  EXPECT_GT(j["map"]["grains"], 8);
  EXPECT_EQ(j["map"]["phases"]["matrix"], 0);
  // Below Voigt's bound, which counts interfaces as grains.
  EXPECT_LT(j["modulus_Pa"].get<double>(), 0.831 * 80e9);
  EXPECT_LT(std::abs(j["load"]["reaction_balance_error"].get<double>()), 1e-4);
}

TEST(SpaceExamples, AStackOfPicturesOfALimestoneIsCutIntoGrainsAndPressed) {
  const TemporaryFolder folder;
  const Json j = loaded_example("39-ketton", folder / "out");
  EXPECT_EQ(j["map"]["voxels"], (Json{64, 64, 64}));
  EXPECT_EQ(j["map"]["grains"], 56);
  EXPECT_NEAR(j["map"]["phases"]["void"].get<double>(), 28572 / 262144.0, 1e-12);  // zeros of the file
  EXPECT_EQ(j["load"]["loading"], "compression");
  EXPECT_NEAR(j["modulus_Pa"].get<double>() / 48.28e9, 1, 1e-3);  // as its page says
  EXPECT_LT(std::abs(j["load"]["reaction_balance_error"].get<double>()), 1e-4);
}

TEST(SpaceExamples, SpheresAreCementedAndSwept) {
  const TemporaryFolder folder;
  std::ofstream(folder / "study.toml") << "base = \"" << examples << "33-cemented-spheres/recipe.toml\"\n"
                                       << "[map]\nfile = \"" << examples << "33-cemented-spheres/spheres.out\"\n"
                                       << "voxels = 40\n[sweep]\nlist = [{ \"map.cement.width\" = 0.3 }, "
                                          "{ \"map.cement.width\" = 0.7 }]\n";
  const auto studied =
      arenite("study run " + (folder / "study.toml").string() + " --out " + (folder / "out").string() + " --quiet");
  ASSERT_EQ(studied.status, 0) << studied.err;
  std::vector<double> moduli, matrix;
  for (const auto& entry : fs::directory_iterator(folder / "out/runs")) {
    const Json numbers = Json::parse(test::slurp(entry.path() / "numbers.json"));
    moduli.push_back(numbers["effective_stiffness"]["isotropic_mean_Pa"]["young"]);
    matrix.push_back(numbers["map"]["phases"]["matrix"]);
    EXPECT_NEAR(numbers["map"]["phases"]["particle"].get<double>(), 0.645, 0.01);
  }
  ASSERT_EQ(moduli.size(), 2u);
  EXPECT_LT(3 * std::min(matrix[0], matrix[1]), std::max(matrix[0], matrix[1]));
  EXPECT_GT(moduli[matrix[0] > matrix[1] ? 0 : 1], 1.5 * moduli[matrix[0] > matrix[1] ? 1 : 0]);
}

TEST(SpaceExamples, SpheresInATriaxialTestPeak) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run = arenite("run " + examples + "36-triaxial-spheres/recipe.toml --quiet --out " + out.string() +
                           " --set packing.grains=150 --set 'variables.W=\"24 mm\"' --set 'variables.rate=\"4 1/s\"'");
  ASSERT_EQ(run.status, 0) << run.err;
  const Json j = shown(out);  // a sample as loose as this may have no peak above its critical state
  EXPECT_GT(
      j.contains("peak") ? j["peak"]["q_over_p"].get<double>() : j["critical_state"]["q_over_p"]["value"].get<double>(),
      0.55);
}

TEST(SpaceExamples, ShearedSpheresFindTheirCriticalState) {
  const TemporaryFolder folder;
  const auto out = folder / "out";
  const auto run =
      arenite("run " + examples + "42-sheared-spheres/recipe.toml --quiet --out " + out.string() +
              " --set packing.grains=120 --set 'container.width=\"20 mm\"' --set 'container.depth=\"20 mm\"'" +
              " --set 'stages.1.shear_rate=\"63 1/s\"' --set 'stages.1.duration=\"100 ms\"'");
  ASSERT_EQ(run.status, 0) << run.err;
  const Json critical = shown(out)["critical_state"];
  EXPECT_NEAR(critical["inertial_number"].get<double>(), 0.1, 0.01);
  EXPECT_NEAR(critical["mu"]["value"].get<double>(), 0.42, 0.06);
  EXPECT_NEAR(critical["solid_fraction"]["value"].get<double>(), 0.58, 0.02);
}

}  // namespace
