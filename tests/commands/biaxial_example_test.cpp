#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using test::arenite;
using test::TemporaryFolder;

using Row = std::map<std::string, std::string>;

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> list;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) list.push_back(field);
  return list;
}

/// Rows of a CSV whose first line names the columns.
std::vector<Row> rows(const std::string& csv) {
  std::istringstream stream(csv);
  std::string line;
  std::getline(stream, line);
  const auto names = fields(line);
  std::vector<Row> table;
  while (std::getline(stream, line)) {
    const auto values = fields(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
    table.push_back(row);
  }
  return table;
}
double number(const Row& row, const char* name) { return std::stod(row.at(name)); }

TEST(BiaxialExample, ADenseSampleShearsAtTheSidePressureMobilisesFrictionAndDilates) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const auto run =
      arenite("run " ARENITE_SOURCE_DIR
              "/examples/05-biaxial-test/recipe.toml --quiet --set packing.grains=200 --set 'container.width=\"90 "
              "mm\"' --set 'stages.1.duration=\"0.06 s\"' --set stages.1.snapshots=12 --out " +
              out);
  ASSERT_EQ(run.status, 0) << run.err;
  const auto shown = arenite("show " + out + " --states");
  ASSERT_EQ(shown.status, 0) << shown.err;

  std::vector<Row> shear;
  for (const Row& row : rows(shown.out)) {
    if (row.at("stage") == "densify") {
      EXPECT_NEAR(number(row, "p [Pa]"), 50e3, 1e3);
      EXPECT_LT(number(row, "q_over_p"), 0.1);
      EXPECT_LT(number(row, "mobilisation"), 1e-6);  // friction is off
    }
    if (row.at("stage") == "shear") shear.push_back(row);
  }
  ASSERT_EQ(shear.size(), 12u);
  double side = 0, strong = 0, weak = 0, share = 0, peak = 0;
  for (std::size_t i = 2; i < shear.size(); ++i) {
    const double x = number(shear[i], "strain_x"), y = number(shear[i], "strain_y");
    EXPECT_NEAR(number(shear[i], "volumetric_strain"), 1 - (1 - x) * (1 - y), 1e-5);
    side += (number(shear[i], "p [Pa]") - number(shear[i], "q [Pa]")) / 10;
    strong += number(shear[i], "a_c_strong") / 10;
    weak += number(shear[i], "a_c_weak") / 10;
    share += number(shear[i], "strong_share") / 10;
    peak = std::max(peak, number(shear[i], "q_over_p"));
  }
  const auto load = nlohmann::json::parse(test::arenite("show " + out + " --json").out)["loads"]["right"];
  const double asked = load["asked_Pa"], reached = load["reached_Pa"]["value"], error = load["reached_Pa"]["error"];
  EXPECT_EQ(asked, 50e3);
  EXPECT_NEAR(reached, asked, 0.005 * asked);
  EXPECT_NEAR(reached, asked, 3 * error);
  // The smaller principal stress of ten states is the pressure on the side, but for the fluctuations of each.
  EXPECT_NEAR(side, asked, 0.05 * asked);
  EXPECT_GT(peak, 0.25);  // below the sine of what mu = 0.5 and dilation allow, above that of smooth grains
  EXPECT_LT(peak, 0.75);
  EXPECT_LT(number(shear.back(), "volumetric_strain"), -0.003);  // dense: dilates
  EXPECT_GT(strong, weak + 0.2);                                 // strong contacts lean to the compression
  EXPECT_NEAR(share, 0.42, 0.06);

  const auto stored = std::get<StageResult>(io::read_result(io::stage_files(out).back()));
  EXPECT_NEAR(stored.texture["end"]["strain"].get<double>(),
              std::max(number(shear.back(), "strain_x"), number(shear.back(), "strain_y")), 1e-3);
}

TEST(Course, ExcludesJson) { EXPECT_EQ(arenite("show x.h5 --states --json").status, 2); }

}  // namespace
