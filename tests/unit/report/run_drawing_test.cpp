#include "report/run_drawing.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numbers>

#include "core/error.hpp"
#include "model/shapes.hpp"
#include "support/numbers_of.hpp"

namespace arenite::report {
namespace {

using Json = nlohmann::json;

workflow::FinalState state() {
  workflow::FinalState state;
  state.packing.materials = {{"POM", 1410, 1e7, 0}, {"HDPE", 950, 1e6, 0}};
  Grains& grains = state.packing.grains;
  grains.resize(2);
  grains.position = {{0.11, 0.02}, {0.14, 0.02}};
  grains.radius = {0.01, 0.02};
  grains.material = {1, 0};
  grains.zone = {0, 1};
  state.packing.contacts.add(0, 1, {-1, 0}, 5, 0, 0.01, 0.02);
  state.texture.per_grain.sigma_norm = {0.5, 1.5};
  return state;
}

TEST(SampleDrawing, GrainsStandInTheirBoxWithMaterialsAndGlue) {
  const Json j = Json::parse(to_json(sample_drawing(state(), FigureKind::grains)));
  EXPECT_EQ(j["size"], Json::parse("[60.0,40.0]"));
  EXPECT_EQ(j["x"], Json::parse("[10.0,40.0]"));
  EXPECT_EQ(j["y"], Json::parse("[20.0,20.0]"));
  EXPECT_EQ(j["material"], Json::parse("[1,0]"));
  EXPECT_EQ(j["glued"], Json::parse("[0,1]"));
  EXPECT_EQ(j["materials"], Json::parse(R"(["POM","HDPE"])"));
  EXPECT_FALSE(j.contains("f") || j.contains("stress"));
}

/// A square that has turned by 45 degrees beside an open boundary that is absent and ends far away.
TEST(SampleDrawing, BodiesHaveTheirRimsAndBoundariesWhatIsSeenOfThem) {
  auto of_polygon = state();
  Grains& grains = of_polygon.packing.grains;
  constexpr double sharp = 1e-6;
  for (const double half : {0.01, 0.02})
    add_shape(grains.shapes,
              {{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, std::vector<double>(4, sharp), true},
              half);
  grains.angle = {std::numbers::pi / 4, 0};
  Boundary lid;
  lid.points = {{0.1, 0.05}, {9, 0.05}};
  lid.present = false;
  of_polygon.packing.domain.boundaries = {lid};
  const Json j = Json::parse(to_json(sample_drawing(of_polygon, FigureKind::grains)));
  ASSERT_EQ(j["rims"].size(), 2u);
  const double tip = 10 * std::numbers::sqrt2, rounding = 0.02;
  double least = 1e9, most = -1e9;
  for (const double x : j["rims"][0]["x"]) least = std::min(least, x), most = std::max(most, x);
  EXPECT_NEAR(most - least, 2 * tip, rounding);
  EXPECT_NEAR(most, j["x"][0].get<double>() + tip, rounding);
  const Json& seen = j["boundaries"][0];
  EXPECT_EQ(seen["present"], false);
  EXPECT_EQ(seen["closed"], false);
  EXPECT_NEAR(seen["x"][1].get<double>() - seen["x"][0].get<double>(), 8900, 0.01);
  EXPECT_LT(j["size"][0].get<double>(), 100);
}

TEST(SampleDrawing, ForcesOrStressesAreThereWhereTheyAreShown) {
  const Json forces = Json::parse(to_json(sample_drawing(state(), FigureKind::forces)));
  EXPECT_EQ(forces["f"], Json::parse("[1.0]"));
  EXPECT_DOUBLE_EQ(forces["tension"].get<double>(), -1e-3);  // of the mean, as everywhere
  EXPECT_EQ(Json::parse(to_json(sample_drawing(state(), FigureKind::stresses)))["stress"], Json::parse("[0.5,1.5]"));
}

TEST(SampleDrawing, OfAFilmShowsTheGrainsThatWereFound) {
  const Json j = Json::parse(to_json(film_drawing(test::numbers_of(
      R"({"found":{"x":[0.1],"y":[0.2],"radius":[0.01],"material":[1],"zone":[1],
          "sigma_norm":[1.234],"simulation":[1.2]}})"))));
  EXPECT_EQ(j["size"], Json::parse("[20.0,20.0]"));
  EXPECT_EQ(j["stress"], Json::parse("[1.23]"));
  EXPECT_EQ(j["glued"], Json::parse("[1]"));
  EXPECT_THROW(film_drawing(test::numbers_of(R"({"correlation":0.99})")), InputError);
  EXPECT_THROW(film_drawing(test::numbers_of("{")), InputError);
}

}  // namespace
}  // namespace arenite::report
