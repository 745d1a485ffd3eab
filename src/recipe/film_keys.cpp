#include "recipe/film_keys.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>

#include "core/units.hpp"
#include "recipe/film_recipe.hpp"
#include "thermal/radiometry/band.hpp"

namespace arenite::recipe {
namespace {

using Visitor = ParameterVisitor;

void declare(Visitor& v, CameraSection& camera) {
  v.text({"low", "Stage at whose end the load is smallest; if not given, the load starts from zero."}, camera.low);
  v.text({"high", "Stage at whose end the load is largest, or a load of the cemented sample.", true}, camera.high);
  camera.parameters.declare(v);
  v.integer({"reference_frames", "Frames in each of the two films of a black-body reference.", false, "plate_frames"},
            camera.reference_frames, {1, 1'000'000});
  v.number({"reference_cold", "Temperature of the first reference.", false, "plate_cold"}, camera.reference_cold, "K",
           range::positive);
  v.number({"reference_warm", "Temperature of the second reference.", false, "plate_warm"}, camera.reference_warm, "K",
           range::positive);
  v.require(camera.reference_warm > camera.reference_cold, {"reference_warm", "reference_cold"},
            "must be above reference_cold");
}

void declare(Visitor& v, FilmMaterial& material) {
  v.number({"thermoelastic_factor", "A: temperature rise per decrease of the sum of principal stresses.", true},
           material.thermoelastic_factor, "K/MPa", range::positive);
  v.number(
      {"brightness", "Brightness in the picture in which grains are found; only the order of the materials matters."},
      material.brightness, "", range::between(0, 1));
  v.number({"emissivity", "Emissivity in the band of the camera; unless given, that of [temperature]."},
           material.emissivity, "", range::above(0, 1));
  v.number({"stiffness",
            "Contact stiffness, as in a packing's recipe; used for forces that the grain means leave undetermined; 0: "
            "unknown, equal for all."},
           material.stiffness, "kN/mm", range::not_negative);
}

void declare(Visitor& v, io::FilmChoice& film) {
  v.number({"frame_rate", "Frame rate, instead of that of the film, whose time stamps are then ignored."},
           film.frame_rate, "Hz", range::positive);
  v.number({"scale", "Temperature per level: temperature = scale x level + offset."}, film.scale, "K", range::positive);
  v.number({"offset", "Temperature of level 0."}, film.offset, "K", range::any);
  v.text({"dataset",
          "Dataset to read from an HDF5 file that holds several, or channel of a TIFF hyperstack (\"channel 2\")."},
         film.dataset);
}

void declare(Visitor& v, FilmContainer& container) {
  v.number({"width", "Inner width.", true}, container.width, "mm", range::positive);
  v.number({"height", "Inner height at the smallest load.", true}, container.height, "mm", range::positive);
  v.number({"thickness", "Length of the cylinders, out of the plane.", true}, container.thickness, "mm",
           range::positive);
  v.number({"left",
            "Column of the container's inner left side in the film; whole numbers are the centres of pixels, so that "
            "the outer edge of the first column is -0.5. Unless given, the container is in the middle. If the rims of "
            "grains show another place, that is used, and a notice is given."},
           container.left, "", range::any);
  v.number({"top", "Row of its inner upper side, from the top, counted likewise."}, container.top, "", range::any);
  v.number({"load_peak_to_peak", "Force on the lower wall, largest minus smallest; 0: not known.", false, "load_swing"},
           container.load_peak_to_peak, "kN", range::not_negative);
  v.number({"load_error", "Standard error of that force, relative to it."}, container.load_error, "%",
           range::above(0, 1));
  v.number({"travel", "Displacement of the lower wall, upwards, from the smallest to the largest load."},
           container.travel, "mm", range::any);
}

Key pixel_key(bool required) { return {"pixel", "Side of a pixel on the sample.", required}; }

void declare(Visitor& v, TemperatureSection& temperature) {
  using From = TemperatureSection::From;
  v.choice(
      {"from", "Method that converts digital levels into temperatures."}, temperature.from,
      {{"references",
        "the two black-body references of [correction] and Planck's law between them, with emissivity taken into "
        "account",
        "plates"},
       {"radiometry", "levels are proportional to photons; Planck's law and the film's mean at [temperature] ambient"},
       {"curve", "a calibration curve"},
       {"film", "the film already holds temperatures"}});
  v.when(temperature.from == From::curve, "from = \"curve\"", [&](Visitor& inner) {
    inner.file({"curve",
                "CSV with columns level and temperature, calibrated on a black body; if calibrated on the grains "
                "themselves, give emissivity = 1.",
                true},
               temperature.curve);
  });
  v.when(temperature.from == From::film, "from = \"film\"", [&](Visitor& inner) {
    inner.number(
        {"assumed_emissivity",
         "Emissivity assumed in the temperatures of the film; they are then corrected to those of the materials."},
        temperature.assumed_emissivity, "", range::above(0, 1));
  });
  constexpr radiometry::Band usual;
  static const std::string
      emissivity =
          fmt::format("Emissivity of materials without their own; {} unless given.", radiometry::usual_emissivity),
      ambient = fmt::format("Temperature of the surroundings that the grains reflect; {} unless given.",
                            format_quantity(radiometry::Surface{}.ambient, "K")),
      band = fmt::format(
          "Shortest and longest wavelength of the camera's band; unless given, that of the film, or {} to {}.",
          format_quantity(usual.low, "um"), format_quantity(usual.high, "um"));
  v.number({"emissivity", emissivity}, temperature.emissivity, "", range::above(0, 1));
  v.number({"ambient", ambient}, temperature.ambient, "K", range::positive);
  v.numbers({"band", band}, temperature.band, "um", range::positive);
  v.require(temperature.band.empty() || (temperature.band.size() == 2 && temperature.band[1] > temperature.band[0]),
            {"band"}, "must be the shortest and the longest wavelength, such as [\"3.6 um\", \"5.1 um\"]");
}

void declare(Visitor& v, SimulationSection& simulation) {
  v.file({"recipe", "Recipe of the packing; its grains are replaced by those found.", true}, simulation.recipe);
  v.text({"low", "Stage at whose end the load is smallest.", true}, simulation.low);
  v.text({"high", "Stage at whose end it is largest.", true}, simulation.high);
}

/// Emissivities that nothing would read, or that contradict each other.
void require_emissivities_used(Visitor& v, const FilmRecipe& recipe) {
  const auto& t = recipe.temperature;
  const auto has_own = [](const FilmMaterial& m) { return m.emissivity.has_value(); };
  const bool every =
      !recipe.materials.empty() && std::all_of(recipe.materials.begin(), recipe.materials.end(), has_own);
  v.require(!(every && t.emissivity), {"temperature"},
            "emissivity is for materials without their own, but every material has one; remove it, or theirs");
  const bool of_surfaces = std::any_of(recipe.materials.begin(), recipe.materials.end(), has_own) || t.emissivity ||
                           t.ambient || !t.band.empty();
  const bool unread = t.from == TemperatureSection::From::film && !t.assumed_emissivity && of_surfaces;
  v.require(!unread || recipe.camera, {"temperature", "materials"}, unread_emissivity);
}

}  // namespace

void declare(Visitor& v, PictureSection& picture) {
  v.number(pixel_key(true), picture.pixel, "mm", range::positive);
  v.file({"grains",
          "CSV of positions made by hand (id, x, y, radius, material); if not given, grains are found automatically."},
         picture.grains);
  v.file(
      {"optical", "Picture of an ordinary camera in which grains are found; if not given, they are found in the film."},
      picture.optical);
  v.number({"optical_pixel", "Side of the optical picture's pixels on the sample; 0: that of the film."},
           picture.optical_pixel, "mm", range::not_negative);
  v.numbers({"radii", "Size classes of the grains; found automatically if not given."}, picture.radii, "mm",
            range::positive);
  imaging::declare_rims(v, picture.contrast, picture.least_score);
}

void declare(Visitor& v, CorrectionSection& correction) {
  v.file({"cold", "Film of a black-body reference: one-point non-uniformity correction of every pixel's offset."},
         correction.cold);
  v.file({"warm", "Film of a warmer reference: gains are then corrected as well."}, correction.warm);
  v.require(correction.warm.empty() || !correction.cold.empty(), {"cold", "warm"}, "is needed together with warm");
  v.number({"cold_temperature", "Temperature of the first reference; 0: not known."}, correction.cold_temperature, "K",
           range::not_negative);
  v.number({"warm_temperature", "Temperature of the second reference; 0: not known."}, correction.warm_temperature, "K",
           range::not_negative);
  v.flag({"bad_pixels", "Pixels with outlying level, gain or noise are replaced by their neighbours."},
         correction.bad_pixels);
}

void declare(Visitor& v, ForcesSection& forces) {
  v.choice({"from", "Data from which contact forces are inferred."}, forces.from,
           {{"pixels", "every pixel of the grains"}, {"means", "only the means of the grains"}, {"none", "no forces"}});
  v.number({"central_share", "Fraction of a grain's area, around its centre, over which its stress is averaged."},
           forces.central_share, "%", range::above(0, 1));
  v.number({"blur",
            "Standard deviation of the lens blur, in pixels. If the rims in the film show a different blur, a notice "
            "is given, and errors include the difference."},
           forces.blur, "", range::between(0, 5));
  v.number({"halo",
            "Fraction of the light that lens and housing scatter over many pixels; unless given, it is found in the "
            "inner pixels of grains. It is removed from the film."},
           forces.halo, "%", range::between(0, 0.4));
  v.number({"halo_width", "Standard deviation of a halo that is given, in pixels."}, forces.halo_width, "",
           range::above(0, 100));
  v.choice(
      {"factors", "Thermoelastic factors that are used."}, forces.factors,
      {{"given",
        "those of the materials, within their error; if film and load disagree with them, a notice is given and errors "
        "include the difference"},
       {"fit", "effective ones, inferred from the film, the balance of forces and the load, which must be known"}});
  v.number({"factor_error",
            "Standard error of the thermoelastic factors as given, relative, including what acts like a wrong factor: "
            "emissivity, calibration and thickness."},
           forces.factor_error, "%", range::between(0, 1));
  v.number({"friction", "Coefficient of friction: bounds tangential forces of a state."}, forces.friction, "",
           range::not_negative);
  v.flag({"state",
          "The film shows a state loaded from zero, for which the friction cone holds; otherwise the difference "
          "between two states."},
         forces.state);
}

void declare(Visitor& v, LockinSection& lockin) {
  v.number({"frequency", "Frequency of the load; it is refined on the film.", true}, lockin.frequency, "Hz",
           range::positive);
  v.choice({"method", "Method that finds the amplitude."}, lockin.method,
           {{"least_squares", "drift and harmonics fitted to every pixel"},
            {"nearest_bin", "plain Fourier transform, as in the thesis"}});
  v.integer({"drift", "Order of the polynomial that describes the drift."}, lockin.drift, {0, 8});
  v.integer({"harmonics", "Number of harmonics of the load frequency that are fitted."}, lockin.harmonics, {1, 4});
  v.number({"phase",
            "Phase angle from the first frame to the maximum of the load, 360 deg per cycle; unless given, it is found "
            "on the film."},
           lockin.phase, "deg", range::between(-2 * std::numbers::pi, 2 * std::numbers::pi));
  v.flag({"motion", "Motion of the grains is fitted and removed."}, lockin.motion);
  v.number({"diffusivity",
            "Thermal diffusivity of the grains: a notice is given if heat diffuses over about a pixel or more within a "
            "cycle. The default is about that of plastics."},
           lockin.diffusivity, "mm^2/s", range::positive);
}

void declare(Visitor& v, const Key& key, AmplitudeConvention& convention) {
  v.choice(key, convention,
           {{"amplitude", "that of the oscillation", "half"}, {"peak-to-peak", "twice the amplitude", "full"}});
}

void declare(Visitor& v, LockinAlone& lockin) {
  declare(v, static_cast<LockinSection&>(lockin));
  v.number(pixel_key(false), lockin.pixel, "mm", range::positive);
  declare(v, {"convention", "Convention of the maps."}, lockin.convention);
  v.flag({"refine", "The frequency is refined on the film."}, lockin.refine);
}

void declare(Visitor& v, StepSection& step) {
  v.number({"time", "Middle of the step after the first frame; if not given, it is found on the film."}, step.time, "s",
           range::any);
  v.number({"rise", "Time that the load takes to change; frames within it are left out."}, step.rise, "s",
           range::not_negative);
  v.number({"window", "Time before and after the step that is used; 0: the whole film."}, step.window, "s",
           range::not_negative);
  v.integer({"drift", "Order of the polynomial that describes the drift of pixels on each side of the step."},
            step.drift, {0, 4});
}

constexpr const char* film_sentence = "Metadata that are missing or wrong in the film.";

void declare(Visitor& v, FilmSection& section) {
  v.defaulted_section<io::FilmChoice>({"film", film_sentence}, section.film,
                                      [](Visitor& inner, io::FilmChoice& film) { declare(inner, film); });
}

void declare(ParameterVisitor& v, FilmRecipe& recipe) {
  v.text({"title", "Title of reports, one line."}, recipe.title);
  v.integer({"seed", "Seed of a virtual camera's random numbers."}, recipe.seed,
            {0, std::numeric_limits<std::int64_t>::max()});
  v.sections({"materials", "Materials of the grains, by name.", true},
             {[&] { return recipe.materials.size(); }, [&](std::size_t n) { recipe.materials.resize(n); },
              [&](Visitor& inner, std::size_t i) { declare(inner, recipe.materials[i]); },
              [&](std::size_t i) -> std::string& { return recipe.materials[i].name; }});
  v.defaulted_section<MeasuredFilm>({"film", film_sentence}, recipe.film, [](Visitor& inner, MeasuredFilm& film) {
    inner.text({"file", "The film, found beside the recipe; that of the command if it names one. A study needs it."},
               film.file);
    declare(inner, static_cast<io::FilmChoice&>(film));
  });
  v.section({"container", "Box that holds the grains.", true, "frame"},
            [&](Visitor& inner) { declare(inner, recipe.container); });
  v.section({"picture", "How grains are found in the film.", true},
            [&](Visitor& inner) { declare(inner, recipe.picture); });
  v.section({"lockin", "From the film to the amplitude of every pixel.", true},
            [&](Visitor& inner) { declare(inner, recipe.lockin); });
  v.section({"correction", "Correction of detector faults."},
            [&](Visitor& inner) { declare(inner, recipe.correction); });
  v.section({"temperature", "From digital levels to kelvin."},
            [&](Visitor& inner) { declare(inner, recipe.temperature); });
  v.section({"forces", "From the amplitude to stresses of grains and forces of contacts."},
            [&](Visitor& inner) { declare(inner, recipe.forces); });
  v.optional_section<SimulationSection>(
      {"simulation", "A companion simulation of the same packing, compared with the film.", false, "twin"},
      recipe.simulation, [](Visitor& inner, SimulationSection& simulation) { declare(inner, simulation); });
  v.optional_section<CameraSection>({"camera", "Virtual camera that films simulated states; for `arenite camera`."},
                                    recipe.camera,
                                    [](Visitor& inner, CameraSection& camera) { declare(inner, camera); });
  // A virtual camera films its references itself, and its recipe need not say what only a film is measured with.
  v.require(recipe.camera || has_references(recipe), {"temperature", "correction"}, needs_references);
  require_emissivities_used(v, recipe);
  const bool fitted = recipe.forces.factors == ForcesSection::Factors::fit;
  v.require(!fitted || recipe.container.load_peak_to_peak > 0, {"forces", "container"},
            "factors = \"fit\" needs container.load_peak_to_peak; give it");
  v.require(!fitted || recipe.forces.from == ForcesSection::From::pixels, {"forces"},
            "factors = \"fit\" needs from = \"pixels\"");
}

}  // namespace arenite::recipe
