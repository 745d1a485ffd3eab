// A cemented packing with the library: packed, loaded by its walls, cemented, discretised into nodes, loaded in
// tension, measured, stored and read back.
#include <arenite/arenite.hpp>
#include <cstdio>
#include <numeric>

using namespace arenite;

namespace {

recipe::Recipe small_recipe() {
  for (const auto& known : recipe::recipe_templates())
    if (std::string(known.name) == "cemented")
      return recipe::parse_recipe(recipe::to_toml(known.make()), "cemented",
                                  {"bidisperse.box_area=80", "bidisperse.size_ratio=1.67"});
  throw InputError("there is no template \"cemented\"");
}

StageResult run_stage(const Packing& start, const recipe::Recipe& recipe, const dem::Stage& stage) {
  dem::Engine engine(start, recipe.contact, recipe.integration);
  dem::StageRun run = dem::begin_stage(engine, stage);
  while (!run.finished) dem::continue_stage(engine, stage, run);
  run.result.name = stage.name;
  run.result.provenance = {version, stage.name, "", recipe::to_toml(recipe), recipe.seed, engine.kernel->name, {}};
  return run.result;
}

/// Large and small grains, divided at the mean radius.
std::vector<GrainClass> classes(const Grains& grains) {
  const double mean =
      std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0) / static_cast<double>(grains.size());
  std::vector<GrainClass> classes;
  for (const double r : grains.radius) classes.push_back(r > mean ? GrainClass::large : GrainClass::small);
  return classes;
}

void stretch(const Packing& packing) {
  cement::CementParameters law;
  law.gap = 7.5e-5;
  cement::CementReport report;
  const Cement matrix = cement::make_cement(packing, law, grid::crop_window(packing, 9e-3), report);
  grid::GridReport counted;
  const PhaseMap map = grid::rasterise(packing, matrix, {128, 9e-3}, classes(packing.grains), counted);
  peridynamics::LoadOptions options;
  options.stiffness = recipe::StiffnessSection{}.resolved();
  const auto loaded = peridynamics::load(map, options);
  std::printf("matrix saturation %.3f, modulus %.3f GPa\n", report.saturation, loaded.report.modulus / 1e9);
  const Numbers stresses = stress::measure(map, loaded.field).numbers;
  for (const auto& [phase, found] : stresses["sigma_yy"]["sets"].items())
    std::printf("sigma_yy, %s: mean %.0f +- %.0f Pa\n", phase.c_str(), found["mean_Pa"]["value"].get<double>(),
                found["mean_Pa"]["error"].get<double>());
}

}  // namespace

int main() try {
  const recipe::Recipe recipe = small_recipe();
  Packing packing = workflow::make_packing(recipe).snapshots.back().packing;
  StageResult result;
  for (const auto& stage : recipe.stages) {
    result = run_stage(packing, recipe, stage);
    packing = result.snapshots.back().packing;
    std::printf("%s: %s\n", stage.name.c_str(), result.outcome.c_str());
  }
  const texture::Texture texture = texture::measure(packing);
  const Numbers& z = texture.numbers["coordination"]["all"];
  std::printf("%zu grains, z = %.2f +- %.2f\n", packing.grains.size(), z["value"].get<double>(),
              z["error"].get<double>());

  io::write_stage("compacted.h5", result);
  stretch(io::read_stage("compacted.h5").snapshots.back().packing);
} catch (const InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
