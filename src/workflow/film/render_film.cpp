#include "workflow/film/render_film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "io/film/film.hpp"
#include "thermal/camera/expose.hpp"
#include "thermal/camera/scene.hpp"
#include "thermal/camera/virtual_film.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {
namespace {

namespace fs = std::filesystem;

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

class Rendering {
 public:
  Rendering(const recipe::FilmRecipe& recipe, const fs::path& result, const RenderOptions& options)
      : recipe_(recipe),
        result_(result),
        options_(options) {}

  /// Films, pictures and recipe of the state or field that the camera looks at; none if it was stopped.
  std::vector<fs::path> run() {
    auto state = last_state(result_, section_.high);
    auto field = state ? std::nullopt : load_named(result_, section_.high);
    if (!state && !field) refuse_stage(result_, section_.high);
    const auto [scene, laboratory] = state ? of_states(*state) : of_field(*field);

    make_folder(options_.out);
    const auto quietly = [&](double) { return options_.progress(0); };
    const auto reference = [&](double temperature) {
      return camera::uniform_film(p_, temperature, section_.reference_frames, recipe_.seed);
    };
    if (!io::write_film(film("cold"), *reference(section_.reference_cold), {}, quietly)) return {};
    if (!io::write_film(film("warm"), *reference(section_.reference_warm), {}, quietly)) return {};
    const fs::path optical = options_.out / "optical.tif", lab = options_.out / "film.toml";
    write_optical(optical, camera::optical_picture(scene, p_, brightness_, recipe_.seed));
    if (!io::write_film(film("film"), *camera::film(scene, p_, recipe_.seed), {}, options_.progress)) return {};
    io::write_atomically(lab, to_toml(laboratory));
    return {film("film"), film("cold"), film("warm"), optical, lab};
  }

 private:
  fs::path film(const std::string& name) const { return options_.out / (name + "." + options_.format); }

  Filmed of_field(FieldResult& field) {
    if (!section_.low.empty())
      refuse(recipe_.source_file, "a load of a cemented sample is filmed from no load; leave out camera.low");
    take_materials(field.packing);
    Filmed filmed{camera::scene_of_field(field, p_), {}};
    Packing window;
    window.domain = filmed.scene.low;
    filmed.laboratory = laboratory_recipe(nullptr, window);
    filmed.laboratory.forces.from = recipe::ForcesSection::From::none;  // matrix carries between the grains
    return filmed;
  }

  Filmed of_states(Packing& high) {
    std::optional<Packing> low;
    if (!section_.low.empty() && !(low = last_state(result_, section_.low))) refuse_stage(result_, section_.low);
    if (low) take_materials(*low);
    take_materials(high);
    return {low ? camera::scene_between(*low, high, p_) : camera::scene_of_state(high, p_),
            laboratory_recipe(low ? &*low : nullptr, high)};
  }

  /// Factors and emissivities as the recipe gives them, in the order of the packing's materials.
  void take_materials(Packing& packing) {
    p_.surroundings.emissivity.clear();
    brightness_.clear();
    for (Material& material : packing.materials) {
      const std::size_t at = index_of(recipe_.materials, material.name);
      if (at == recipe_.materials.size())
        refuse(recipe_.source_file,
               "there is no section [materials.{0}], which grains of the sample are made of; add it", material.name);
      material.thermoelastic_factor = recipe_.materials[at].thermoelastic_factor;
      p_.surroundings.emissivity.push_back(emissivity_[at]);
      brightness_.push_back(recipe_.materials[at].brightness);
    }
  }

  /// What a laboratory would know of this film, and unless it is to be blind what the camera knows beside.
  recipe::FilmRecipe laboratory_recipe(const Packing* low, const Packing& high) const {
    recipe::FilmRecipe lab = recipe_;
    const Domain& start = low ? low->domain : high.domain;
    const camera::WallChange change = camera::change_of_lower_wall(low, high);
    lab.camera.reset();
    for (std::size_t m = 0; m < lab.materials.size(); ++m) {
      for (const Material& of : high.materials)
        if (of.name == lab.materials[m].name) lab.materials[m].stiffness = of.stiffness;
      lab.materials[m].emissivity = p_.surroundings.radiometry ? emissivity_[m] : 1;
    }
    lab.container = {.width = start.width(),
                     .height = start.height(),
                     .thickness = start.thickness,
                     .left = {},
                     .top = {},
                     .load_peak_to_peak = change.force,
                     .travel = p_.motion ? change.travel : 0};
    lab.picture.pixel = p_.optics.pixel;
    lab.picture.optical = "optical.tif";
    lab.picture.optical_pixel = p_.photograph.pixel;
    lab.correction = {"cold." + options_.format, "warm." + options_.format, section_.reference_cold,
                      section_.reference_warm, true};
    lab.temperature = {};
    lab.temperature.from = recipe::TemperatureSection::From::references;
    lab.temperature.band = {p_.band.low, p_.band.high};
    lab.lockin.frequency = p_.timing.load_frequency;
    lab.forces.state = low == nullptr;
    // What only the virtual camera knows for sure: its lens, its surroundings, when the load is largest, and the wall's
    // way.
    if (options_.blind) {
      lab.lockin.phase.reset();
      lab.forces.blur = recipe::FilmRecipe{}.forces.blur;
      lab.container.travel = 0;
    } else {
      lab.temperature.ambient = p_.surroundings.ambient;
      lab.lockin.phase = camera::phase_at_first_frame;
      lab.forces.blur = p_.optics.blur;
    }
    return lab;
  }

  const recipe::FilmRecipe& recipe_;
  const fs::path& result_;
  const RenderOptions& options_;
  const recipe::CameraSection& section_ = *recipe_.camera;
  camera::Parameters p_ = section_.parameters;
  const std::vector<double> emissivity_ = emissivities(recipe_);
  std::vector<double> brightness_;  ///< of the packing's materials
};

}  // namespace

std::vector<fs::path> render_film(const recipe::FilmRecipe& recipe, const fs::path& result,
                                  const RenderOptions& options) {
  if (!recipe.camera)
    refuse(recipe.source_file, "there is no section [camera]; add it with high = \"NAME\" of the stage that is filmed");
  return Rendering(recipe, result, options).run();
}

}  // namespace arenite::workflow
