#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "support/program.hpp"

namespace arenite::test {
namespace {

using Json = nlohmann::json;

double value(const Json& statistic) { return statistic.at("value").get<double>(); }
double error(const Json& statistic) { return statistic.at("error").get<double>(); }

/// Runs an example to its 50 kN, in fewer increments than as shipped, and reads what `show` says of the end.
Json loaded(const std::string& example) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const Outcome run =
      arenite("run " + std::string(ARENITE_SOURCE_DIR) + "/examples/" + example + "/recipe.toml --quiet --out " + out +
              " --set integration.track_energy=false --set stages.1.increments=2");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::file_size(folder / "out" / "report.html") > 100'000);
  const Outcome shown = arenite("show --json " + out);
  EXPECT_EQ(shown.status, 0) << shown.err;
  return shown.status == 0 ? Json::parse(shown.out) : Json();
}

/// Weight of cylinders 60 mm long, N; diameters in m.
double weight(int pom, double pom_diameter, int hdpe) {
  const auto one = [](double diameter, double density) {
    return density * std::numbers::pi / 4 * diameter * diameter * 0.06 * 9.81;
  };
  return pom * one(pom_diameter, 1410) + hdpe * one(0.0105, 950);
}

/// The frame holds what the lower wall and gravity put on it, but for what grains at rest may keep unbalanced: 1e-4 of
/// the mean force each.
void expect_balance(const Json& result, double sample_weight) {
  const Json walls = result["stages"].back()["last_state"]["walls"];
  const auto force = [&](const char* side, const char* kind) { return walls[side][kind].get<double>(); };
  EXPECT_NEAR(force("bottom", "force_N"), 50e3, 50);
  const double vertical = force("bottom", "force_N") - force("top", "force_N") - force("left", "shear_force_N") -
                          force("right", "shear_force_N") - sample_weight;
  const double horizontal = force("left", "force_N") - force("right", "force_N") - force("bottom", "shear_force_N") -
                            force("top", "shear_force_N");
  const double residual = 1e-4 * value(result["force"]["mean_N"]) * result["grains"].get<double>();
  EXPECT_LT(std::abs(vertical), residual);
  EXPECT_LT(std::abs(horizontal), residual);
  EXPECT_LT(result["quality"]["median_imbalance"], 1e-3);
}

TEST(ThesisSamples, Sample8IsQuasiIsotropicAndUnevenlyStressed) {
  const Json result = loaded("01-thesis-sample-08");
  EXPECT_EQ(result["grains"], 705);
  expect_balance(result, weight(334, 0.0164, 371));
  EXPECT_NEAR(value(result["solid_fraction"]), 0.845, 0.02);
  EXPECT_GT(value(result["coordination"]["all"]), 3.2);
  EXPECT_LT(value(result["coordination"]["all"]), 4.6);
  // One sample has a noise of 0.07: the claim's 0.15 is judged over many (ledger), here within two standard errors.
  EXPECT_LT(value(result["fabric"]["a_c"]) - 2 * error(result["fabric"]["a_c"]), 0.15);
  EXPECT_LT(value(result["sigma_norm"]["P0"]), 0.52);
  EXPECT_GT(value(result["fabric"]["sets"]["strong"]["a_c_signed"]),
            value(result["fabric"]["sets"]["weak"]["a_c_signed"]));
}

TEST(ThesisSamples, StackedSample2IsACrystalUnderLoad) {
  const Json result = loaded("02-thesis-sample-02");
  EXPECT_EQ(result["grains"], 1235);
  expect_balance(result, weight(638, 0.0105, 597));
  const Json six = result["fabric"]["modes"]["6"];
  EXPECT_GT(value(six["amplitude"]), 0.5);
  const double phase = std::fmod(value(six["phase_deg"]) + 30, 60) - 30;
  EXPECT_LT(std::abs(phase), 10);
}

TEST(ThesisSamples, Sample12StressesSmallGrainsThoughLargeOnesCarryTheForces) {
  const Json result = loaded("03-thesis-sample-12");
  EXPECT_EQ(result["grains"], 552);
  expect_balance(result, weight(86, 0.0309, 466));
  const Json sigma = result["sigma_norm"]["by_material"], force = result["force"]["by_type"];
  const auto largest = [&](const char* material) {
    return sigma[material]["maximum"].get<double>() * value(sigma[material]["mean_Pa"]);
  };
  EXPECT_LT(largest("HDPE"), largest("POM"));  // tension positive: more negative is more pressed
  EXPECT_GT(value(force["POM-POM"]["mean_N"]), value(force["HDPE-HDPE"]["mean_N"]));
}

TEST(ThesisSamples, SeveralRecipesOfOneCommandGetAFolderEach) {
  const TemporaryFolder folder;
  const std::string samples = std::string(ARENITE_SOURCE_DIR) + "/examples/04-thesis-samples/",
                    out = (folder / "out").string();
  const Outcome run =
      arenite("run " + samples + "sample-10.toml " + samples + "sample-11.toml --quiet --out " + out +
              " --set stages.1.increments=1 --set 'stages.1.bottom.force=1 kN' --set 'container.thickness=50 mm'");
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* name : {"sample-10", "sample-11"})
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / name / "report.html")) << name;
  EXPECT_NE(run.out.find("118 POM"), std::string::npos);
}

TEST(ThesisSamples, AllTwelveAreRecipesWithTheTablesNumbers) {
  int grains = 0;
  for (int n = 1; n <= 12; ++n) {
    const Outcome checked = arenite("check " + std::string(ARENITE_SOURCE_DIR) + "/examples/04-thesis-samples/sample-" +
                                    (n < 10 ? "0" : "") + std::to_string(n) + ".toml");
    ASSERT_EQ(checked.status, 0) << checked.err;
    for (std::size_t at = checked.out.find("count = "); at != std::string::npos;
         at = checked.out.find("count = ", at + 1))
      grains += std::stoi(checked.out.substr(at + 8));
  }
  EXPECT_EQ(grains, 1235 + 1235 + 1242 + 934 + 986 + 1050 + 660 + 705 + 847 + 255 + 395 + 552);
}

}  // namespace
}  // namespace arenite::test
