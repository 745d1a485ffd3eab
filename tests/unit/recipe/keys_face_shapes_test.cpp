#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "geometry/face.hpp"
#include "grains/fields/discharge.hpp"
#include "recipe/recipe.hpp"
#include "unit/recipe/glass_grains.hpp"

namespace arenite::recipe {
namespace {

/// A recipe of spheres with this in it, and a stage that is told this.
std::string in_space(const std::string& boundaries, const std::string& stage = "") {
  return R"(dimension = 3
[container]
width = "100 mm"
height = "200 mm"
depth = "80 mm"
[packing]
area = { bottom = "60 mm", front = "70 mm" }
)" + testing::glass_grains +
         boundaries + "[[stages]]\nname = \"flow\"\nduration = \"1 s\"\n" + stage;
}

std::string boundary(const std::string& keys) { return "[[boundaries]]\nname = \"floor\"\n" + keys + "\n"; }

std::string problem_of(const std::string& text) {
  try {
    parse_recipe(text, "r.toml");
  } catch (const InputError& error) { return error.what(); }
  return {};
}

double area_of(const BoundaryIn<3>& boundary) {
  double area = 0;
  for (const geometry::Face face : geometry::faces_of(boundary.points, boundary.corners))
    area += 0.5 * norm(geometry::area_vector(face));
  return area;
}

BoundaryIn<3> read(const std::string& keys) {
  const Recipe recipe = parse_recipe(in_space(boundary(keys)), "r.toml");
  EXPECT_TRUE(parse_recipe(to_toml(recipe), "r.toml") == recipe) << to_toml(recipe);
  return recipe.boundaries_in_space.at(0);
}

TEST(FaceShapes, AreReadByTheirCorners) {
  const std::string corners =
      R"(corners = [["0 mm", "5 cm", "0 mm"], ["40 mm", "5 cm", "0 mm"], ["0 mm", "5 cm", "40 mm"]])";
  const BoundaryIn<3> one = read(corners);
  EXPECT_EQ(one.points, (std::vector<Vec3>{{0, 0.05, 0}, {0.04, 0.05, 0}, {0, 0.05, 0.04}}));
  EXPECT_EQ(one.corners, (std::vector<std::int32_t>{3}));
  const BoundaryIn<3> two = read(R"(faces = [3, 3]
corners = [["0 mm", "0 mm", "0 mm"], ["1 mm", "0 mm", "0 mm"], ["0 mm", "0 mm", "1 mm"],
           ["0 mm", "0 mm", "0 mm"], ["1 mm", "0 mm", "0 mm"], ["0 mm", "1 mm", "0 mm"]])");
  EXPECT_EQ(two.corners, (std::vector<std::int32_t>{3, 3}));
  EXPECT_EQ(two.points[5], (Vec3{0, 0.001, 0}));
}

TEST(FaceShapes, APlateHasAnOpeningOfItsArea) {
  const double whole = 0.1 * 0.08;
  EXPECT_NEAR(area_of(read(R"(plate = { y = "50 mm" })")), whole, 1e-12);
  EXPECT_NEAR(area_of(read(R"(plate = { y = "50 mm", left = "20 mm", back = "10 mm" })")), 0.08 * 0.07, 1e-12);
  const BoundaryIn<3> round = read(R"(plate = { y = "50 mm", diameter = "30 mm", segments = 24, x = "40 mm" })");
  const double gap = 12 * 0.015 * 0.015 * std::sin(2 * std::numbers::pi / 24);
  EXPECT_NEAR(area_of(round), whole - gap, 1e-12);
  EXPECT_EQ(round.corners.size(), 24U);
  for (const Vec3& p : round.points) {
    EXPECT_EQ(p.y, 0.05);
    EXPECT_GE(std::hypot(p.x - 0.04, p.z - 0.04), 0.015 - 1e-12);
  }
  EXPECT_NEAR(area_of(read(R"(plate = { y = "50 mm", opening_width = "20 mm", opening_depth = "30 mm" })")),
              whole - 6e-4, 1e-12);
  const BoundaryIn<3> slot = read(R"(plate = { y = "50 mm", opening_width = "20 mm", opening_depth = "80 mm" })");
  EXPECT_EQ(slot.corners.size(), 2U);  // left and right of it
  EXPECT_NEAR(area_of(slot), 0.08 * 0.08, 1e-12);
}

TEST(FaceShapes, AConeHasTheAreaOfItsTrapezoids) {
  const BoundaryIn<3> cone =
      read(R"(cone = { x = "50 mm", z = "40 mm", bottom = "20 mm", top = "50 mm", bottom_diameter = "20 mm", )"
           R"(top_diameter = "60 mm", segments = 16 })");
  const double half = std::sin(std::numbers::pi / 16), rise = std::hypot(0.03, 0.02 * std::cos(std::numbers::pi / 16));
  EXPECT_NEAR(area_of(cone), 16 * (0.01 + 0.03) * half * rise, 1e-12);
}

TEST(FaceShapes, ABallClosesOverTheVolumeOfItsFaces) {
  const BoundaryIn<3> ball =
      read(R"(ball = { x = "50 mm", y = "120 mm", z = "40 mm", diameter = "20 mm", segments = 24 })");
  EXPECT_EQ(ball.corners.size(), 24U * 12U);
  const Vec3 centre{0.05, 0.12, 0.04};
  for (const Vec3& p : ball.points) EXPECT_NEAR(norm(p - centre), 0.01, 1e-12);
  double volume = 0;
  Vec3 all{};  // of a closed surface seen from one side the areas cancel
  for (const geometry::Face face : geometry::faces_of(ball.points, ball.corners)) {
    all += geometry::area_vector(face);
    const double part = dot(face[0] - centre, geometry::area_vector(face)) / 6;
    EXPECT_GT(std::abs(part), 0);
    volume += std::abs(part);
  }
  EXPECT_NEAR(norm(all), 0, 1e-15);
  // A circle of latitude becomes a polygon of 24 sides, a band a frustum.
  const double pi = std::numbers::pi, side = 12 * std::sin(2 * pi / 24);
  double wanted = 0;
  for (int band = 0; band < 12; ++band) {
    const double a = -pi / 2 + band * pi / 12, b = a + pi / 12, p = std::cos(a), q = std::cos(b);
    wanted += 1e-6 * side * (std::sin(b) - std::sin(a)) * (p * p + p * q + q * q) / 3;
  }
  EXPECT_NEAR(volume, wanted, 1e-12 * 1e-6);
}

TEST(FaceShapes, MoveAlongThreeAxes) {
  const Recipe recipe =
      parse_recipe(in_space(boundary(R"(plate = { y = "50 mm" })"),
                            R"(boundaries = [{ name = "floor", velocity = ["1 mm/s", "0 mm/s", "2 mm/s"], )"
                            R"(spin = ["0 deg/s", "180 deg/s", "0 deg/s"] }]
)"),
                   "r.toml");
  const auto& motion = recipe.stages[0].boundaries_in_space.at(0);
  EXPECT_EQ(motion.velocity, (Vec3{0.001, 0, 0.002}));
  EXPECT_DOUBLE_EQ(motion.spin.y, std::numbers::pi);
  EXPECT_TRUE(parse_recipe(to_toml(recipe), "r.toml") == recipe);
  EXPECT_EQ(recipe.packing.area->edge[front], 0.07);
}

TEST(FaceShapes, ThatMakeNoSenseAreRefused) {
  const auto refused = [](const std::string& keys) { return problem_of(in_space(boundary(keys))); };
  EXPECT_NE(refused("").find("give corners, or a plate, a cone or a ball"), std::string::npos);
  EXPECT_NE(refused(R"(corners = [["0 mm", "0 mm", "0 mm"], ["1 mm", "0 mm", "0 mm"]])").find("flat and convex"),
            std::string::npos);
  EXPECT_NE(refused(R"(plate = { y = "5 mm", opening_width = "2 mm" })").find("a width and a depth"),
            std::string::npos);
  EXPECT_NE(
      refused(R"(ball = { x = "1 mm", y = "1 mm", z = "1 mm", diameter = "1 mm", segments = 7 })").find("must be even"),
      std::string::npos);
  EXPECT_NE(refused(R"(points = [["0 mm", "0 mm"], ["1 mm", "0 mm"]])")
                .find("the keys here are: ball, cone, corners, faces, name, plate"),
            std::string::npos);
  EXPECT_NE(
      problem_of(in_space(boundary(R"(plate = { y = "5 mm" })"), "boundaries = [{ name = \"gate\", absent = true }]\n"))
          .find("there is no boundary \"gate\""),
      std::string::npos);
}

// Its parts meet to rounding only, wherever the opening is.
TEST(FaceShapes, AnOpeningInAPlateIsAsWideAsItIsAskedFor) {
  for (const double asked : {0.024, 0.03, 0.036, 0.0073})
    for (const char* place : {"", "x = \"33.3 mm\", z = \"41.7 mm\", "}) {
      const std::string plate =
          std::string("plate = { y = \"40 mm\", ") + place + "diameter = \"" + std::to_string(1e3 * asked) + " mm\" }";
      DomainIn<3> domain;
      domain.boundaries = parse_recipe(in_space(boundary(plate)), "r.toml").boundaries_in_space;
      EXPECT_NEAR(fields::narrowest_opening(domain), asked, 0.006 * asked) << plate;  // edges within a circle
    }
  DomainIn<3> domain;
  domain.boundaries =
      parse_recipe(in_space(boundary(R"(plate = { y = "5 mm", opening_width = "10 mm", opening_depth = "12 mm" })")),
                   "r.toml")
          .boundaries_in_space;
  EXPECT_NEAR(fields::narrowest_opening(domain), 4 * 0.120 / 44, 1e-9);
}

TEST(FaceShapes, AreDrivenByTables) {
  const auto driven = [](const std::string& of, const std::string& unit, const std::string& more = "") {
    return in_space(boundary(R"(plate = { y = "5 mm" })"), "programmes = [{ of = \"" + of + "\", " + more +
                                                               "table = [[\"0 s\", \"0 " + unit +
                                                               "\"], [\"1 s\", \"1 " + unit + "\"]] }]\n");
  };
  const std::string of_floor = "boundary = \"floor\", ";
  const Recipe lifted = parse_recipe(driven("boundary.z", "mm", of_floor), "r.toml");
  EXPECT_EQ(lifted.stages[0].programmes.at(0).of.way(), 2);
  EXPECT_TRUE(parse_recipe(to_toml(lifted), "r.toml") == lifted);
  EXPECT_TRUE(parse_recipe(driven("boundary.spin_x", "deg/s", of_floor), "r.toml").stages[0].programmes[0].of.turns());
  EXPECT_EQ(parse_recipe(driven("front.pressure", "kPa"), "r.toml").stages[0].side[front].kind,
            dem::SideDrive::Kind::pressure);
  EXPECT_NE(problem_of(driven("boundary.z", "mm", "boundary = \"gate\", ")).find("there is no boundary \"gate\""),
            std::string::npos);
  EXPECT_NE(problem_of(driven("boundary.force_z", "N", of_floor)).find("a force moves only a boundary with a mass"),
            std::string::npos);
}

}  // namespace
}  // namespace arenite::recipe
