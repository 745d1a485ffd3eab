#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>

#include "core/random.hpp"
#include "support/films.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;
using Json = nlohmann::json;

std::string data(const std::string& name) {
  return std::string(ARENITE_SOURCE_DIR) + "/examples/data/thesis-identification/" + name;
}

Json found(const std::string& arguments) {
  const auto run = arenite("identify " + arguments + " --json");
  EXPECT_EQ(run.status, 0) << run.err;
  return run.status == 0 ? Json::parse(run.out) : Json::object();
}

void expect_refused(const std::string& arguments, const std::string& words) {
  const auto run = arenite("identify " + arguments);
  EXPECT_EQ(run.status, 2) << arguments;
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

TEST(Identify, AdhesionOfTheThesissTable) {
  const Json j = found("adhesion " + data("separation-force.csv") + " --k '27.35 kN/mm' --radius '6.2 mm'");
  const double printed[] = {0.268, 0.511, 0.745, 1.06};
  for (std::size_t g = 0; g < 4; ++g) {
    const Json& gamma = j["groups"][g]["surface_energy"];
    EXPECT_NEAR(gamma["value"].get<double>() / 1e6, printed[g], g < 3 ? 0.0005 : 0.005);
    EXPECT_GT(gamma["error"].get<double>(), 0);
    EXPECT_LT(gamma["confidence_95"][0], gamma["value"]);
    EXPECT_GT(gamma["confidence_95"][1], gamma["value"]);
    EXPECT_EQ(gamma["unit"], "N/m");
  }
  const Json wide = found("adhesion " + data("separation-force.csv") +
                          " --k '27.35 +- 0.80 kN/mm' --radius '6.2 mm,8.2 mm' --effective-radius sum");
  EXPECT_NEAR(wide["groups"][0]["surface_energy"]["value"].get<double>() /
                  j["groups"][0]["surface_energy"]["value"].get<double>(),
              std::sqrt(12.4 / 14.4), 1e-12);
  const auto forces = arenite("identify adhesion " + data("separation-force.csv"));
  EXPECT_EQ(forces.status, 0);
  EXPECT_NE(forces.out.find("8.14 +- 0.83 N"), std::string::npos) << forces.out;
  EXPECT_NE(forces.out.find("note: the surface energy needs the stiffness of the pair and the radii: --k"),
            std::string::npos);
}

TEST(Identify, StiffnessBesideWhatIsPrinted) {
  const auto run = arenite("identify stiffness " + data("contact-stiffness-pom.csv") + " --stated " +
                           data("stated-stiffness-pom.csv"));
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* words : {"stated 29.27: agrees", "stated 25.45, here 25.63: differs by +0.180 (+0.71 %)",
                            "stated 27.33: agrees", "stated 27.35, here 27.41: differs"})
    EXPECT_NE(run.out.find(words), std::string::npos) << words << "\n" << run.out;
  const Json j = found("stiffness " + data("contact-stiffness-hdpe.csv") + " --length '60 mm' --stated " +
                       data("stated-stiffness-hdpe.csv"));
  EXPECT_EQ(j["groups"][0]["stiffness"]["stated"]["agrees"], false);
  EXPECT_NEAR(j["groups"][0]["stiffness_per_length"]["value"].get<double>(), 38.5e6 / 6 / 0.06, 1);
}

/// Two cylinders, each loaded twice, with noise of 1 um.
std::string records() {
  RandomStream random(3, Purpose::test);
  std::string text = "diameter [mm],repeat,displacement [mm],force [kN]\n";
  for (const double diameter : {6.2, 16.4})
    for (int repeat = 1; repeat <= 2; ++repeat)
      for (int p = 0; p < 100; ++p) {
        const double force = 0.08 * p;
        text += std::to_string(diameter) + "," + std::to_string(repeat) + "," +
                std::to_string(-0.1 - force / (diameter < 10 ? 30.0 : 25.0) + 1e-3 * random.normal()) + "," +
                std::to_string(-force) + "\n";
      }
  return text;
}

TEST(Identify, StiffnessOfRecords) {
  const TemporaryFolder folder;
  const auto file = (folder / "curves.csv").string();
  test::spill(file, records());
  const Json j = found("stiffness " + file);
  ASSERT_EQ(j["groups"].size(), 2U);
  EXPECT_NEAR(j["groups"][0]["stiffness"]["value"].get<double>() / 30e6, 1, 5e-3);
  EXPECT_NEAR(j["groups"][1]["stiffness"]["value"].get<double>() / 25e6, 1, 5e-3);
  EXPECT_EQ(j["groups"][0]["tests"].size(), 2U);
  EXPECT_GT(j["groups"][0]["tests"][0]["stiffness"]["error"].get<double>(), 0);
  EXPECT_NE(j["notes"][0].get<std::string>().find("they are not equal"), std::string::npos);
}

TEST(Identify, AdhesionOfRecords) {
  const TemporaryFolder folder;
  std::string text = "specimen,displacement [mm],force [N]\n";
  for (const double peak : {100.0, 130.0})
    for (int p = 0; p < 60; ++p)
      text += std::to_string(int(peak)) + "," + std::to_string(0.01 * p) + "," +
              std::to_string(p <= 40 ? peak * p / 40 : 0.0) + "\n";
  const auto file = (folder / "pull.csv").string();
  test::spill(file, text);
  const Json j = found("adhesion " + file + " --k '27.35 kN/mm' --radius '6.2 mm'");
  EXPECT_NEAR(j["groups"][0]["separation_force"]["value"].get<double>(), 115, 1e-9);
  EXPECT_NEAR(j["groups"][0]["separation_force"]["error"].get<double>(), 15, 1e-9);
  EXPECT_EQ(j["groups"][0]["tests"][1]["separation_force"]["value"], 130.0);
}

/// POM as in T 2.3: force ratio 0.1, section 30.9 x 4.9 mm^2, A = 0.0150 K/MPa.
std::string calibration(double of_peak_to_peak) {
  std::string text = "material,force_min [N],force_max [N],dT [mK]\n";
  int k = 0;
  for (const double force : {200.0, 400.0, 600.0, 800.0})
    text += "POM," + std::to_string(0.1 * force) + "," + std::to_string(force) + "," +
            std::to_string(of_peak_to_peak * 1e3 * (0.0150 * 0.9 * force / (30.9 * 4.9) + (k++ % 2 ? 2e-4 : -2e-4))) +
            "\n";
  return text;
}

TEST(Identify, FactorByStressAndItsConventions) {
  const TemporaryFolder folder;
  const auto full = (folder / "full.csv").string(), half = (folder / "half.csv").string();
  test::spill(full, calibration(1));
  test::spill(half, calibration(0.5));
  const std::string section = " --section '30.9 mm x 4.9 mm'";
  const Json a = found("factor " + full + section)["groups"][0]["factor"],
             b = found("factor " + half + section + " --temperature-convention amplitude")["groups"][0]["factor"];
  EXPECT_NEAR(a["value"].get<double>() * 1e6, 0.0150, 3e-4);
  EXPECT_NEAR(a["value"].get<double>(), b["value"].get<double>(), 1e-12);
  EXPECT_EQ(found("factor " + half + section + " --temperature-swing half --load-swing full")["groups"][0]["factor"],
            b);  // former names
  EXPECT_LT(a["confidence_95"][0].get<double>() * 1e6, 0.0150);
  EXPECT_GT(a["confidence_95"][1].get<double>() * 1e6, 0.0150);
  EXPECT_EQ(a["unit"], "K/Pa");
  const auto text = arenite("identify factor " + full + section).out;
  EXPECT_NE(text.find("the stress is (F_max - F_min)/section"), std::string::npos) << text;
  EXPECT_NE(text.find("responses are taken as peak-to-peak values"), std::string::npos) << text;
}

TEST(Identify, FactorByStrainPropertiesAndSignal) {
  const TemporaryFolder folder;
  const auto file = (folder / "strain.csv").string();
  test::spill(file, "strain [%],temperature [K],signal\n0.01,0.006,10\n0.02,0.012,20\n0.03,0.018,30\n");
  const Json j =
      found("factor " + file + " --young '2.6 +- 0.1 GPa' --poisson 0.35 --responsivity '0.6 mK'")["groups"][0];
  const double modulus = 2.6e9 / 0.65;
  EXPECT_NEAR(j["factor"]["value"].get<double>(), 60 / modulus, 1e-15);
  EXPECT_NEAR(j["factor"]["error"].get<double>() / j["factor"]["value"].get<double>(), 0.1 / 2.6, 1e-9);
  EXPECT_NEAR(j["signal_constant"]["value"].get<double>(), modulus * 1e-5, 1e-3);
  EXPECT_NEAR(j["signal_constant_direct"]["value"].get<double>(), modulus * 1e-5, 1e-3);
  EXPECT_NEAR(j["exitance_exponent"]["value"].get<double>(), 10.6, 0.1);
  const Json p = found("factor " + data("properties.csv"));
  EXPECT_NEAR(p["groups"][0]["factor"]["value"].get<double>() * 1e6, 0.0157, 5e-5);
  EXPECT_NEAR(p["groups"][1]["factor"]["value"].get<double>() * 1e6, 0.0265, 5e-5);
}

TEST(Identify, BadInputIsOneSentenceAndStatusTwo) {
  const TemporaryFolder folder;
  const auto file = (folder / "a.csv").string();
  const auto refused = [&](const std::string& text, const std::string& arguments, const std::string& words) {
    test::spill(file, text);
    expect_refused(arguments, words);
  };
  refused("time [s],pressure [Pa]\n1,2\n", "stiffness " + file, "a.csv:1: has no columns for a stiffness");
  refused("specimen,force [N]\n1,2\n", "stiffness " + file, "a.csv:1: has no columns for a stiffness");
  refused("displacement [N],force [N]\n1,2\n", "stiffness " + file,
          "a.csv:1: column displacement: \"N\" is not a length");
  refused("displacement [mm],force [N]\n1,200\n2,400\n3,600\n", "stiffness " + file,
          "a.csv:4: the force never exceeds the preload of 1000 N");
  refused("displacement [mm],force [kN]\n1,0\n2,2\n3,4\n", "stiffness " + file,
          "a.csv:4: a cycle has 2 points beyond the preload");
  refused("displacement [mm],force [kN]\n1,2\n2,3\n3,4\n4,5\n5,4\n6,5\n7,6\n8,7\n", "stiffness " + file,
          "a.csv:6: the force falls from 5000 to 4000 N and rises again");
  refused("displacement [mm],force [kN]\n1,2\n2,x\n", "stiffness " + file,
          "a.csv:3: force is \"x\", which is not a finite number");
  refused("repeat,stiffness [kN/mm]\n1,2\n2,0\n", "stiffness " + file,
          "a.csv:3: the stiffness is 0 N/m; it must be above 0");
  refused("specimen,force [N]\n1,2\n", "adhesion " + file, "a.csv:1: has no columns for an adhesion");
  refused("specimen,latex [N]\n1,-2\n", "adhesion " + file,
          "a.csv:2: latex, specimen 1: the separation force is -2 N; write tension as a positive force");
  refused("stress [MPa],dT [K]\n1,2\n2,3\n", "factor " + file, "a.csv:3: 2 points are too few for a slope");
  refused("stress [MPa],dT [K]\n1,2\n1,3\n1,4\n", "factor " + file, "a.csv:2: the load is the same in every row");
  refused("force [N],dT [K]\n1,2\n", "factor " + file, "a.csv:1: forces need the specimen's section");
  refused("strain,dT [K]\n1,2\n", "factor " + file, "a.csv:1: strains need the modulus");
  refused("strength,heat\n1,2\n", "factor " + file, "a.csv:1: has no columns for a factor");
  refused("glue [N],x\n", "adhesion " + file, "a.csv:1: has a header but no rows");
  expect_refused("stiffness " + (folder / "none.csv").string(), "none.csv");
  expect_refused("adhesion " + data("separation-force.csv") + " --k '27.35 mm'", "--k: \"27.35 mm\" is a length");
  expect_refused("adhesion " + data("separation-force.csv") + " --radius '0 mm'", "must be above 0 mm");
  expect_refused("stiffness " + data("contact-stiffness-pom.csv") + " --stated " + data("stated-surface-energy.csv"),
                 "states none of the quantities found");
  expect_refused("hardness " + file, "what: hardness not in");
}

}  // namespace
