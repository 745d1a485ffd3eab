#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace arenite::test {
namespace {

using Json = nlohmann::json;

const std::string source = ARENITE_SOURCE_DIR;

/// Runs `measure --json` and reads what it prints.
Json measured(const std::string& arguments) {
  const Outcome run = arenite("measure --json " + arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  return run.status == 0 ? Json::parse(run.out) : Json();
}

double value(const Json& statistic) { return statistic.at("value").get<double>(); }
double error(const Json& statistic) { return statistic.at("error").get<double>(); }

Json sheared(const char* state, const char* tilt) {
  const std::string folder = source + "/examples/20-dem-shear-periodic/";
  return measured(folder + "grains-" + state + ".csv " + folder + "contacts-" + state +
                  ".csv --periodic --box 62.7755,62.7755," + tilt + " --thickness 1");
}

TEST(MeasureShearedPacking, FindsItsSolidFractionFrictionAndBalance) {
  for (const auto& [state, tilt, contacts] :
       {std::tuple{"5000", "31.38775", 1928}, std::tuple{"5005", "31.419138", 1930}}) {
    const Json t = sheared(state, tilt);
    EXPECT_EQ(t["grains"], 1024);
    EXPECT_EQ(t["contacts"], contacts);
    EXPECT_NEAR(value(t["solid_fraction"]), 0.8325, 1e-4);
    EXPECT_NEAR(value(t["coordination"]["all"]), 2.0 * contacts / 1024, 1e-12);
    EXPECT_GT(value(t["coordination"]["without_rattlers"]), 2.0 * contacts / 1024);
    EXPECT_LT(t["quality"]["median_imbalance"], 3e-4);
    EXPECT_NEAR(t["quality"]["friction_ratio_max"], 0.1, 1e-5);
    EXPECT_NEAR(t["quality"]["sliding_share"], 0.28, 0.01);
  }
}

TEST(MeasureShearedPacking, LeansToTheCompressionOfShearAndObeysStressForceFabric) {
  const Json t = sheared("5000", "31.38775");
  const Json stress = t["stress"]["value"];
  const double xx = stress[0][0], yy = stress[1][1], xy = stress[0][1], yx = stress[1][0];
  EXPECT_LT(xx, 0);               // compression
  EXPECT_GT(xy, 0);               // sheared to the right
  EXPECT_NEAR(xy / yx, 1, 1e-3);  // no torque is left on grains
  EXPECT_NEAR(value(t["fabric"]["theta_c_deg"]), 135, 3 * error(t["fabric"]["theta_c_deg"]));
  const double ratio = std::hypot(0.5 * (xx - yy), xy) / (-0.5 * (xx + yy));
  // Rothenburg and Bathurst's relation, whose neglect of branch lengths costs a few per cent.
  const double a_c = value(t["fabric"]["a_c"]), a_n = value(t["fabric"]["a_n"]), a_t = value(t["fabric"]["a_t"]);
  EXPECT_NEAR((a_c + a_n + a_t) / (2 + a_c * a_n), ratio, 0.06 * ratio);
  EXPECT_GT(value(t["stress_details"]["strong_share_of_deviator"]), 0.85);
  EXPECT_GT(value(t["fabric"]["sets"]["strong"]["a_c_signed"]), value(t["fabric"]["sets"]["weak"]["a_c_signed"]) + 0.2);
  // The sum over grains is the sum over contacts.
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      EXPECT_NEAR(t["stress_details"]["sum_over_grains"][a][b].get<double>(), stress[a][b].get<double>(),
                  1e-12 * std::abs(xx));
}

TEST(MeasureShearedPacking, DoesNotDependOnTheLineThatCutsTheCell) {
  const std::string folder = source + "/examples/20-dem-shear-periodic/";
  const std::string files = folder + "grains-5000.csv " + folder +
                            "contacts-5000.csv --periodic --box 62.7755,62.7755,31.38775 --thickness 1";
  const Json a = measured(files), b = measured(files + " --origin 11,-7");
  EXPECT_NEAR(value(a["solid_fraction"]), value(b["solid_fraction"]), 1e-12);
  EXPECT_NEAR(a["stress"]["value"][0][1].get<double>(), b["stress"]["value"][0][1].get<double>(), 1e-17);
}

TEST(MeasureShearBox, SeesShearBuildUpAndSaysThatGrainsAreNotInBalance) {
  const std::string folder = source + "/examples/21-force-network-shear-box/DSC";
  const auto state = [&](const std::string& name) {
    return measured(folder + name + "_ParticleData.dlm " + folder + name +
                    "_bonds.txt --y-down --grain-columns \"-,x,y,radius,-\" --columns \"i,j,-,ft,fn\"");
  };
  const Json first = state("05384"), last = state("05410");
  EXPECT_EQ(first["grains"], 826);
  EXPECT_EQ(first["contacts"], 785);
  EXPECT_EQ(last["contacts"], 1024);
  EXPECT_GT(value(last["coordination"]["all"]),
            value(first["coordination"]["all"]) + 3 * error(first["coordination"]["all"]));
  EXPECT_NEAR(first["quality"]["median_imbalance"], 0.5, 0.05);
  EXPECT_FALSE(first.contains("stress"));
  EXPECT_FALSE(first.contains("solid_fraction"));
  EXPECT_NE(first["notes"].dump().find("box is not known"), std::string::npos);
  EXPECT_NE(first["notes"].dump().find("not in balance"), std::string::npos);
  EXPECT_GT(value(last["fabric"]["sets"]["strong"]["a_c"]), value(last["fabric"]["sets"]["weak"]["a_c"]));
}

TEST(Measure, GrainsWithNeighboursWithoutEndAreRefused) {
  const TemporaryFolder folder;
  const auto refusal = [&](const char* radius, const char* more) {
    std::ofstream table(folder / "grains.csv");
    table << "id,x [m],y [m],radius [m]\n";
    for (int k = 0; k < 1000; ++k)
      table << k << ',' << 0.01 * (k % 32) + 0.02 << ',' << 0.01 * (k / 32) + 0.02 << ',' << radius << '\n';
    table.close();
    const Outcome run =
        arenite("measure " + (folder / "grains.csv").string() + " --box 0.36,0.36 --thickness 1 " + more);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    return run.err;
  };
  EXPECT_NE(refusal("0.005", "--touching \"0.1 m\"").find("wider than the mean radius"), std::string::npos);
  EXPECT_NE(refusal("8.2", "--touching \"0.1 m\" --periodic").find("unit of the radii"), std::string::npos);
}

TEST(MeasureAnnulus, ReportsDoubledRowsNegativeForcesAndImbalance) {
  const std::string folder = source + "/examples/22-force-network-annulus/";
  const std::string files = folder + "positions-1.txt " + folder +
                            "forces-1.txt --y-down --grain-columns \"-,id,x,y,radius,-\" --columns \"-,i,j,ft,fn\"";
  const Outcome refused = arenite("measure " + files);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("forces-1.txt:17: the contact of 7 and 23 is already in line 5"), std::string::npos)
      << refused.err;
  EXPECT_NE(refused.err.find("and 1213 more"), std::string::npos);
  const Json t = measured(files + " --doubled merge");
  EXPECT_EQ(t["contacts"], 1233);
  EXPECT_EQ(t["quality"]["doubled_rows"], 1233);
  EXPECT_EQ(t["quality"]["negative_forces"], 26);
  EXPECT_GT(t["quality"]["median_imbalance"], 0.2);
  const std::string notes = t["notes"].dump();
  for (const char* part :
       {"1233 rows repeat", "26 of 1233 normal forces are tensile", "not in balance", "times the mean"})
    EXPECT_NE(notes.find(part), std::string::npos) << part;
}

TEST(MeasureLammps, GivesLammpsOwnStress) {
  const std::string folder = source + "/tests/data/lammps/";
  const Json t = measured(folder + "atoms.dump " + folder + "pairs.dump --thickness 1");
  EXPECT_EQ(t["grains"], 300);
  EXPECT_NEAR(t["stress"]["value"][0][0], -80.6074767394, 1e-8);
  EXPECT_NEAR(t["stress"]["value"][1][1], -84.2452281495, 1e-8);
  EXPECT_NEAR(t["stress"]["value"][1][0], 1.23216588521, 1e-8);  // x times the y component of force
  EXPECT_LT(t["quality"]["median_imbalance"], 1e-12);
  EXPECT_NEAR(t["quality"]["friction_ratio_max"], 0.3, 1e-3);
  EXPECT_TRUE(t["coordination"].contains("type1-type2"));
}

TEST(MeasureYade, AContactAcrossAPeriodicSideIsNeverTakenForAWalls) {
  const std::string files = source + "/tests/data/yade/periodic-spheres.txt " + source +
                            "/tests/data/yade/periodic-interactions.vtk --thickness 1 ";
  const Json t = measured(files + "--box 0.6167414232494,0.6167414232494 --periodic");
  EXPECT_EQ(t["contacts"], 130);
  EXPECT_EQ(t["wall_contacts"], 0);
  EXPECT_LT(t["quality"]["median_imbalance"], 1e-4);                                // YADE writes six digits
  const auto wrong = arenite("measure " + files + "--box 0.623,0.623 --periodic");  // 1 % off
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("19 of 130 interactions end at no grain's centre"), std::string::npos) << wrong.err;
  EXPECT_NE(wrong.err.find("correct --box"), std::string::npos) << wrong.err;
  const auto none = arenite("measure " + files);
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("give the cell by --box and --periodic"), std::string::npos) << none.err;
}

TEST(MeasureYade, FindsGrainsInBalanceUnderTheirFrictionCap) {
  const std::string folder = source + "/tests/data/yade/";
  const Json t =
      measured(folder + "spheres.txt " + folder + "interactions.vtk --box 1,1 --origin 0,0 --thickness 1 --border 0");
  EXPECT_EQ(t["grains"], 121);
  EXPECT_EQ(t["wall_contacts"], 39);
  EXPECT_LT(t["quality"]["median_imbalance"], 1e-5);  // YADE writes six digits
  EXPECT_LE(t["quality"]["friction_ratio_max"], std::tan(0.4) + 1e-4);
  const Json whole = t["stress"]["value"], walls = t["stress_details"]["from_walls_and_weight"];
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      EXPECT_NEAR(whole[a][b].get<double>(), walls[a][b].get<double>(), 0.1) << a << b;  // of 3700 Pa
}

TEST(MeasureCommand, PrintsTheSameBytesTwiceAndATableWithoutJson) {
  const std::string folder = source + "/tests/data/lammps/";
  const std::string line = "measure --json --curves " + folder + "atoms.dump " + folder + "pairs.dump --thickness 1";
  const Outcome first = arenite(line);
  EXPECT_EQ(first.out, arenite(line).out);
  const Json t = Json::parse(first.out);
  EXPECT_EQ(t["by_grain"]["sigma_norm"].size(), 300u);
  EXPECT_EQ(t["fabric"]["sectors"].size(), 18u);
  const Outcome text = arenite("measure " + folder + "atoms.dump " + folder + "pairs.dump");
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("coordination.type1-ANY"), std::string::npos);
}

TEST(MeasureCommand, SaysInWhichUnitBareLengthsWereTaken) {
  const std::string folder = source + "/examples/20-dem-shear-periodic/";
  const std::string line = folder + "grains-5000.csv " + folder + "contacts-5000.csv --periodic --thickness ";
  const auto notes = [&](const std::string& options) { return measured(line + options)["notes"].dump(); };
  EXPECT_NE(
      notes("1 --box 62.7755,62.7755,31.38775").find("--box, --thickness: lengths without a unit were taken in m"),
      std::string::npos);
  EXPECT_EQ(notes("1m --box 62.7755m,62.7755m,31.38775m").find("lengths without a unit"), std::string::npos);
  EXPECT_EQ(notes("1 --box 62.7755,62.7755,31.38775 --length-unit m").find("lengths without a unit"),
            std::string::npos);
}

TEST(MeasureCommand, RefusesBadOptionsWithStatusTwo) {
  const std::string folder = source + "/tests/data/lammps/", files = folder + "atoms.dump " + folder + "pairs.dump ";
  for (const auto& [options, part] : {std::pair{"--box 3", "--box"},
                                      {"--box 3,-4", "must be positive"},
                                      {"--length-unit kN", "not a length"},
                                      {"--thickness 0", "--thickness"},
                                      {"--force-unit smoots", "smoots"},
                                      {"--format pfc", "pfc"},
                                      {"--materials /nowhere.csv", "/nowhere.csv"}}) {
    const Outcome run = arenite("measure " + files + options);
    EXPECT_EQ(run.status, 2) << options;
    EXPECT_NE(run.err.find(part), std::string::npos) << options << ": " << run.err;
    EXPECT_TRUE(run.out.empty()) << options;
  }
}

}  // namespace
}  // namespace arenite::test
