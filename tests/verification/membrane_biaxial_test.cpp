#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "grains/dem/run_stage.hpp"
#include "grains/fields/loading.hpp"
#include "recipe/recipe.hpp"
#include "workflow/make_packing.hpp"

namespace arenite::membranes {
namespace {

/// A dense sample, twice as high as wide, between smooth platens; `sides` of the shear and before.
std::string biaxial(const std::string& sides) {
  return R"(
[container]
width = "30 mm"
thickness = "10 mm"
[packing]
grains = 200
solid_fraction = 0.75
[materials.sand]
density = "2650 kg/m^3"
stiffness = "1 kN/mm"
[[populations]]
material = "sand"
ratio = 1
size = { law = "uniform", min = "2 mm", max = "4 mm" }
[contact]
friction = 0.5
wall_friction = 0
restitution = 0.4
[[stages]]
name = "densify"
friction = 0
right = { pressure = "100 kPa" }
top = { pressure = "100 kPa" }
equilibrium = { unbalanced = 1e-3, kinetic = 1e-4 }
[[stages]]
name = "cell"
top = { pressure = "100 kPa" }
equilibrium = { unbalanced = 1e-3, kinetic = 1e-4 }
)" + sides +
         R"(
[[stages]]
name = "shear"
)" + sides +
         R"(
top = { velocity = "200 mm/s" }
duration = "0.06 s"
)";
}

struct Shear {
  double q_over_p = 0, error = 0, volume = 0, bulge = 0;
};

/// Of the second half of the shear, over seeds; the farthest that a node lies from the plane of equal area, m.
Shear sheared_between(const std::string& sides) {
  constexpr int seeds = 3;
  double sum = 0, squares = 0;
  Shear test;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto recipe = recipe::parse_recipe("seed = " + std::to_string(seed) + biaxial(sides), "biaxial.toml");
    dem::Engine engine(workflow::make_packing(recipe).snapshots.back().packing, recipe.contact, recipe.integration);
    StageResult before, result;
    for (const dem::Stage& stage : recipe.stages) {
      before = std::move(result);
      dem::StageRun run = begin_stage(engine, stage);
      while (!run.finished) continue_stage(engine, stage, run);
      result = std::move(run.result);
    }
    const auto curves = fields::loading_of({result, &before.snapshots.back().packing})->curves;
    const std::vector<double>& ratio = curves["q_over_p"];
    double mean = 0;
    for (std::size_t k = ratio.size() / 2; k < ratio.size(); ++k)
      mean += ratio[k] / static_cast<double>(ratio.size() - ratio.size() / 2);
    sum += mean / seeds, squares += mean * mean / seeds;
    test.volume += curves["volumetric_strain"].back() / seeds;
    for (const Boundary& boundary : engine.domain.boundaries)
      for (const Vec2& p : boundary.points)
        test.bulge = std::max({test.bulge, -engine.domain.depth(left, p), -engine.domain.depth(right, p)});
  }
  test.q_over_p = sum;
  test.error = std::sqrt((squares - sum * sum) / (seeds - 1));
  return test;
}

TEST(BiaxialMembrane, AgreesWithRigidWallsInTheCriticalStateWhileItBulges) {
  const Shear rigid = sheared_between("right = { pressure = \"100 kPa\" }"),
              soft = sheared_between("left = { membrane = \"100 kPa\" }\nright = { membrane = \"100 kPa\" }");
  EXPECT_GT(rigid.q_over_p, 0.2);
  constexpr double student = 4.6;  // 99 % of a t with the four degrees of freedom of two times three seeds
  EXPECT_NEAR(soft.q_over_p, rigid.q_over_p, student * std::hypot(soft.error, rigid.error));
  EXPECT_GT(soft.bulge, 3e-3);  // a mean diameter
  EXPECT_LT(soft.volume, 0);    // dense: dilates, as between walls
  EXPECT_LT(rigid.volume, 0);
}

}  // namespace
}  // namespace arenite::membranes
