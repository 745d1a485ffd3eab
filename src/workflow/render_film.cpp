#include "workflow/run_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "io/film/film.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::workflow {
namespace {

namespace fs = std::filesystem;

/// Factors and emissivities as the recipe gives them, in the order of the packing's materials.
void take_materials(Packing& packing, const recipe::FilmRecipe& recipe, camera::Parameters& p, std::vector<double>& brightness) {
  p.surroundings.emissivity.clear();
  brightness.clear();
  const std::vector<double> emissivity = emissivities(recipe);
  for (Material& material : packing.materials) {
    const auto same = [&](const recipe::FilmMaterial& m) { return m.name == material.name; };
    const auto at = std::find_if(recipe.materials.begin(), recipe.materials.end(), same);
    if (at == recipe.materials.end())
      refuse(recipe.source_file, "there is no section [materials.{0}], which grains of the sample are made of; add it", material.name);
    material.thermoelastic_factor = at->thermoelastic_factor;
    p.surroundings.emissivity.push_back(emissivity[static_cast<std::size_t>(at - recipe.materials.begin())]);
    brightness.push_back(at->brightness);
  }
}

double load_on_bottom(const Packing& packing) { return packing.domain.wall[bottom].force; }

/// What only the virtual camera knows for sure: its lens, its surroundings, when the load is largest, and the wall's way.
void forget_secrets(recipe::FilmRecipe& lab) {
  const recipe::FilmRecipe unknowing;
  lab.temperature.ambient = unknowing.temperature.ambient;
  lab.lockin.phase.reset();
  lab.forces.blur = unknowing.forces.blur;
  lab.container.travel = 0;
}

/// What a laboratory would know of this film, and unless it is `blind` what the camera knows beside.
recipe::FilmRecipe laboratory_recipe(const recipe::FilmRecipe& recipe, const Packing* low, const Packing& high, const std::string& ending, bool blind) {
  recipe::FilmRecipe lab = recipe;
  const Domain& start = low ? low->domain : high.domain;
  const recipe::CameraSection& section = *recipe.camera;
  lab.camera.reset();
  for (recipe::FilmMaterial& m : lab.materials)
    for (const Material& of : high.materials)
      if (of.name == m.name) m.stiffness = of.stiffness;
  lab.container = {start.width(),
                   start.height(),
                   start.thickness,
                   {},
                   {},
                   load_on_bottom(high) - (low ? load_on_bottom(*low) : 0.0),
                   section.parameters.motion ? high.domain.wall[bottom].position - start.wall[bottom].position : 0};
  lab.picture.pixel = section.parameters.optics.pixel;
  lab.picture.optical = "optical.tif";
  lab.picture.optical_pixel = section.parameters.photograph.pixel;
  lab.correction = {"cold." + ending, "warm." + ending, section.reference_cold, section.reference_warm, true};
  const std::vector<double> emissivity = emissivities(recipe);
  for (std::size_t m = 0; m < lab.materials.size(); ++m) lab.materials[m].emissivity = section.parameters.surroundings.radiometry ? emissivity[m] : 1;
  lab.temperature = {};
  lab.temperature.from = recipe::TemperatureSection::From::references;
  lab.temperature.band = {section.parameters.band.low, section.parameters.band.high};
  lab.temperature.ambient = section.parameters.surroundings.ambient;
  lab.lockin.frequency = section.parameters.timing.load_frequency;
  lab.lockin.phase = std::numbers::pi;
  lab.forces.blur = section.parameters.optics.blur;
  lab.forces.state = low == nullptr;
  if (blind) forget_secrets(lab);
  return lab;
}

void write_optical(const fs::path& file, const FloatImage& picture) {
  Film film;
  film.about.width = picture.width;
  film.about.height = picture.height;
  film.about.frames = 1;
  film.about.bits = 16;
  for (const float level : picture.value) film.level.push_back(static_cast<std::uint16_t>(std::lround(level * 65535)));
  io::write_film(file, film);
}

/// What is filmed, and what of it a laboratory knows.
struct Filmed {
  camera::Scene scene;
  recipe::FilmRecipe laboratory;
};

Filmed film_of_field(const recipe::FilmRecipe& recipe, FieldResult& field, camera::Parameters& p, std::vector<double>& brightness, const std::string& ending,
                     bool blind) {
  if (!recipe.camera->low.empty()) refuse(recipe.source_file, "a load of a cemented sample is filmed from no load; leave out camera.low");
  take_materials(field.packing, recipe, p, brightness);
  Filmed filmed{camera::scene_of_field(field, p), {}};
  Packing window;
  window.domain = filmed.scene.low;
  filmed.laboratory = laboratory_recipe(recipe, nullptr, window, ending, blind);
  filmed.laboratory.forces.from = recipe::ForcesSection::From::none;  // matrix carries between the grains
  return filmed;
}

Filmed film_of_states(const recipe::FilmRecipe& recipe, Packing& high, const fs::path& result, camera::Parameters& p, std::vector<double>& brightness,
                      const std::string& ending, bool blind) {
  const std::string& released = recipe.camera->low;
  std::optional<Packing> low;
  if (!released.empty() && !(low = last_state(result, released))) refuse_stage(result, released);
  if (low) take_materials(*low, recipe, p, brightness);
  take_materials(high, recipe, p, brightness);
  return {low ? camera::scene_between(*low, high, p) : camera::scene_of_state(high, p), laboratory_recipe(recipe, low ? &*low : nullptr, high, ending, blind)};
}

}  // namespace

std::vector<fs::path> render_film(const recipe::FilmRecipe& recipe, const fs::path& result, const RenderOptions& options) {
  if (!recipe.camera) refuse(recipe.source_file, "there is no section [camera]; add it with high = \"NAME\" of the stage that is filmed");
  const recipe::CameraSection& section = *recipe.camera;
  camera::Parameters p = section.parameters;
  std::vector<double> brightness;
  auto state = last_state(result, section.high);
  auto field = state ? std::nullopt : load_named(result, section.high);
  if (!state && !field) refuse_stage(result, section.high);
  const auto [scene, laboratory] = state ? film_of_states(recipe, *state, result, p, brightness, options.format, options.blind)
                                         : film_of_field(recipe, *field, p, brightness, options.format, options.blind);

  make_folder(options.out);
  const auto named = [&](const std::string& name) { return options.out / (name + "." + options.format); };
  const auto quietly = [&](double) { return options.progress(0); };
  if (!io::write_film(named("cold"), *camera::uniform_film(p, section.reference_cold, section.reference_frames, recipe.seed), {}, quietly)) return {};
  if (!io::write_film(named("warm"), *camera::uniform_film(p, section.reference_warm, section.reference_frames, recipe.seed), {}, quietly)) return {};
  write_optical(options.out / "optical.tif", camera::optical_picture(scene, p, brightness, recipe.seed));
  if (!io::write_film(named("film"), *camera::film(scene, p, recipe.seed), {}, options.progress)) return {};
  io::write_atomically(options.out / "film.toml", to_toml(laboratory));
  return {named("film"), named("cold"), named("warm"), options.out / "optical.tif", options.out / "film.toml"};
}

}  // namespace arenite::workflow
