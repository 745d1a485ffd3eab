#include "model/packing.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

Stage loading(std::string name, int side, double force, std::int64_t increments, bool gravity) {
  Stage stage;
  stage.name = std::move(name);
  stage.gravity = gravity;
  stage.side[static_cast<std::size_t>(side)] = {SideDrive::Kind::force, force};
  stage.increments = increments;
  return stage;
}

/// Pressed from all sides, with masses that make the steps few.
Stage pressed(std::string name, double pressure) {
  Stage stage;
  stage.name = std::move(name);
  stage.side.fill({SideDrive::Kind::pressure, pressure});
  stage.mass_scaling = dem::MassScaling::uniform;
  return stage;
}

/// Sample #8 of the thesis (T Tables 2.1, 2.2, 3.2): 100 N on the upper wall, then gravity and 50 kN on the lower one.
Recipe composite() {
  Recipe recipe;
  recipe.title = "Composite of POM and HDPE cylinders, sample 8 of the thesis";
  recipe.seed = 8;
  recipe.container.width = 0.35;
  recipe.container.thickness = 0.06;
  recipe.materials = {{"HDPE", 950, 6.43e6, 0.0258e-6}, {"POM", 1410, 27.35e6, 0.0150e-6}};
  recipe.populations = {{"POM", 334, {}, {}, {}}, {"HDPE", 371, {}, {}, {}}};
  recipe.populations[0].size = packing::FixedSize{0.0164};
  recipe.populations[1].size = packing::FixedSize{0.0105};
  recipe.contact.friction_law = dem::CundallStrack{};
  recipe.contact.restitution = 0.5;
  recipe.integration.track_energy = true;
  recipe.stages = {loading("prepare", top, 100, 1, false), loading("load", bottom, 50'000, 10, true)};
  return recipe;
}

/// One sample of the paper (P II): gamma = 2.5, theta = 1.4, eta = 0.4, pressed to k_n/P = 10^4, then pulled.
Recipe cemented() {
  Recipe recipe;
  recipe.title = "Cemented disks of two sizes, pulled";
  recipe.packing.method = PackingParameters::Method::poisson;
  recipe.bidisperse.emplace();
  recipe.bidisperse->law.large_radius = 1e-3;
  recipe.container.thickness = 0.01;
  recipe.materials = {{"large", 2500, 1e6, 0}, {"small", 2500, 1e6, 0}};
  recipe.contact.friction_law = dem::CundallStrack{};
  recipe.contact.friction = 0.3;
  recipe.contact.restitution = 0.7;
  recipe.stages = {pressed("compact", 1e4), pressed("rest", 1e4)};
  recipe.stages[0].inertial_number = 1;
  recipe.stages[0].equilibrium.unbalanced = 0.01;
  recipe.stages[0].equilibrium.kinetic = 0.05;
  recipe.stages[1].critical_drag = 0.2;
  recipe.stages[1].equilibrium.kinetic = 1e-5;
  recipe.cement.emplace();
  recipe.grid.emplace();
  Load tension;
  tension.name = "tension";
  recipe.loads = {tension};
  return recipe;
}

}  // namespace

const std::vector<RecipeTemplate>& recipe_templates() {
  static const std::vector<RecipeTemplate> list{
      {"composite", "two materials in a rigid frame, compacted by the lower wall", composite},
      {"cemented", "two sizes of grains bound by a matrix, pulled, with the stress in every node", cemented},
  };
  return list;
}

std::string study_template() {
  return R"(title = "Coordination against friction"
seed = 1

[container]                               # rigid, square; its height follows from the grains
width = "120 mm"
thickness = "60 mm"

[materials.POM]
density = "1410 kg/m^3"
stiffness = "27.35 kN/mm"

[[populations]]
material = "POM"
count = 60
size = { law = "uniform", min = "10 mm", max = "16 mm" }

[contact]
friction_law = "cundall_strack"
friction = 0.3
restitution = 0.5

[[stages]]                                # each run: 100 N on the upper wall, then 10 kN on the lower one
name = "prepare"
top = { force = "100 N" }

[[stages]]
name = "load"
bottom = { force = "10 kN" }

[sweep]                                   # what makes it a study: all of the below with all of the below
replicates = 2                            # seeds 1 and 2 for every combination

[sweep.grid]                              # keys of the recipe with the values that they take
"contact.friction" = [0.1, 0.3, 0.5]
)";
}

}  // namespace arenite::recipe
