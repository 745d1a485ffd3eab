#include "recipe/film_recipe_keys.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace arenite::study {
namespace {

using Visitor = ParameterVisitor;

void declare(Visitor& v, FilmMaterial& material) {
  v.number({"thermoelastic_factor", "A: temperature rise per fall of the sum of principal stresses.", true}, material.thermoelastic_factor,
           "K/MPa", range::positive);
  v.number({"brightness", "In the picture that grains are found in; only the order of the materials counts."}, material.brightness, "",
           range::between(0, 1));
  v.number({"emissivity", "In the camera's band; unless given, that of [temperature]."}, material.emissivity, "", range::above(0, 1));
  v.number({"stiffness", "Of its contacts, as in the recipe of a packing: where means leave forces open, they go the stiffer way; 0: not known, alike for all."},
           material.stiffness, "kN/mm", range::not_negative);
}

void declare(Visitor& v, ReadingSection& film) {
  v.number({"frame_rate", "Instead of what the film says; its time stamps are then left aside."}, film.frame_rate, "Hz", range::positive);
  v.number({"scale", "Temperature of one level: pixels become scale times their number, plus offset."}, film.scale, "K", range::positive);
  v.number({"offset", "Temperature of level 0."}, film.offset, "K", range::any);
  v.text({"dataset", "Of an HDF5 file that holds several that can be films."}, film.dataset);
}

void declare(Visitor& v, FilmFrame& frame) {
  v.number({"width", "Inner width.", true}, frame.width, "mm", range::positive);
  v.number({"height", "Inner height at the smallest load.", true}, frame.height, "mm", range::positive);
  v.number({"thickness", "Length of the cylinders, out of the plane.", true}, frame.thickness, "mm", range::positive);
  v.number({"left", "Column of the frame's inner left side in the film; unless given, the frame is in the middle."}, frame.left, "", range::any);
  v.number({"top", "Row of its inner upper side, from the top."}, frame.top, "", range::any);
  v.number({"load_swing", "Force on the lower wall, largest less smallest; 0: not known."}, frame.load_swing, "kN", range::not_negative);
  v.number({"travel", "Way of the lower wall, upwards, from the smallest to the largest load."}, frame.travel, "mm", range::any);
}

void declare(Visitor& v, PictureSection& picture) {
  v.number({"pixel", "Side of the film's pixels on the sample.", true}, picture.pixel, "mm", range::positive);
  v.file({"grains", "CSV of hand-made positions (id, x, y, radius, material); without it grains are found by program."}, picture.grains);
  v.file({"optical", "Picture of an ordinary camera in which grains are found; without it they are found in the film."}, picture.optical);
  v.number({"optical_pixel", "Side of the optical picture's pixels on the sample; 0: as the film's."}, picture.optical_pixel, "mm", range::not_negative);
  v.numbers({"radii", "Size classes of the grains; without them they are found."}, picture.radii, "mm", range::positive);
}

void declare(Visitor& v, CorrectionSection& correction) {
  v.file({"cold", "Film of an even plate: one-point correction of every pixel's offset."}, correction.cold);
  v.file({"warm", "Film of a warmer plate: with it gains are corrected, too."}, correction.warm);
  v.require(correction.warm.empty() || !correction.cold.empty(), {"cold", "warm"}, "is needed beside warm");
  v.number({"cold_temperature", "Of the first plate; 0: not known."}, correction.cold_temperature, "K", range::not_negative);
  v.number({"warm_temperature", "Of the second plate; 0: not known."}, correction.warm_temperature, "K", range::not_negative);
  v.flag({"bad_pixels", "Pixels that stand out by level, gain or noise are replaced by their neighbours."}, correction.bad_pixels);
}

void declare(Visitor& v, TemperatureSection& temperature) {
  using From = TemperatureSection::From;
  v.choice({"from", "What turns digital levels into temperatures."}, temperature.from,
           {{"plates", "the two plates of [correction] and Planck's law between them, emissivity taken into account"},
            {"radiometry", "levels are proportional to photons; Planck's law and the film's mean at [temperature] ambient"},
            {"curve", "a calibration curve"},
            {"film", "the film holds temperatures already"}});
  v.when(temperature.from == From::curve, "from = \"curve\"", [&](Visitor& inner) {
    inner.file({"curve", "CSV with columns level and temperature, of a black body; for one taken of the grains themselves give emissivity = 1.", true},
               temperature.curve);
  });
  v.when(temperature.from == From::film, "from = \"film\"", [&](Visitor& inner) {
    inner.number({"assumed_emissivity", "That the film's temperatures were made with; with it they are corrected to the materials'."},
                 temperature.assumed_emissivity, "", range::above(0, 1));
  });
  v.number({"emissivity", "Of materials that do not say their own; 0.9 unless given."}, temperature.emissivity, "", range::above(0, 1));
  v.number({"ambient", "Temperature of the surroundings that grains mirror; 296 K unless given."}, temperature.ambient, "K", range::positive);
  v.numbers({"band", "Shortest and longest wavelength that the camera sees; unless given, what the film says, or 3.6 to 5.1 um."}, temperature.band, "um",
            range::positive);
  v.require(temperature.band.empty() || (temperature.band.size() == 2 && temperature.band[1] > temperature.band[0]), {"band"},
            "must be the shortest and the longest wavelength, such as [\"3.6 um\", \"5.1 um\"]");
}

void declare(Visitor& v, LockinSection& lockin) {
  v.number({"frequency", "Of the load; it is refined on the film.", true}, lockin.frequency, "Hz", range::positive);
  v.choice({"method", "How a swing is found in the film."}, lockin.method,
           {{"least_squares", "drift and harmonics fitted to every pixel"}, {"nearest_bin", "plain Fourier transform, as in the thesis"}});
  v.integer({"drift", "Order of the polynomial that slow changes follow."}, lockin.drift, {0, 8});
  v.integer({"harmonics", "Multiples of the load frequency that are fitted."}, lockin.harmonics, {1, 4});
  v.number({"phase", "When the load is largest: what its cycle has gone through since the first frame, 360 deg a cycle; unless given, it is found on the film."},
           lockin.phase, "deg", range::between(-2 * std::numbers::pi, 2 * std::numbers::pi));
  v.flag({"motion", "Motion of the grains is fitted and taken out."}, lockin.motion);
  v.number({"diffusivity", "Of heat in the grains: it is told where heat diffuses not far less than a pixel within a cycle. The default is about that of plastics."},
           lockin.diffusivity, "mm^2/s", range::positive);
}

void declare(Visitor& v, ForcesSection& forces) {
  v.choice({"from", "What contact forces are inferred from."}, forces.from,
           {{"pixels", "every pixel of the grains"}, {"means", "the grains' means alone"}, {"none", "no forces"}});
  v.number({"central_share", "Share of a grain's area, round its centre, over which its stress is averaged."}, forces.central_share, "%",
           range::above(0, 1));
  v.number({"blur", "Standard deviation of the lens' blur, in pixels. Where the rims of the film show another one it is told, and errors hold the difference."}, forces.blur, "", range::between(0, 5));
  v.number({"friction", "Coefficient of friction: bounds tangential forces of a state."}, forces.friction, "", range::not_negative);
  v.flag({"state", "The film shows a state that starts from no load, so that the friction cone holds; otherwise the swing between two."},
         forces.state);
}

void declare(Visitor& v, TwinSection& twin) {
  v.file({"recipe", "Recipe of the packing; its grains are replaced by those found.", true}, twin.recipe);
  v.text({"low", "Stage at whose end the load is smallest.", true}, twin.low);
  v.text({"high", "Stage at whose end it is largest.", true}, twin.high);
}

}  // namespace

namespace {

/// Emissivities that nothing would read, or that contradict each other.
void require_emissivities_used(Visitor& v, const FilmRecipe& recipe) {
  const auto& t = recipe.temperature;
  const auto has_own = [](const FilmMaterial& m) { return m.emissivity.has_value(); };
  const bool every = !recipe.materials.empty() && std::all_of(recipe.materials.begin(), recipe.materials.end(), has_own);
  v.require(!(every && t.emissivity), {"temperature"}, "emissivity is for materials that do not say their own, and every one does; remove it, or theirs");
  const bool of_surfaces = std::any_of(recipe.materials.begin(), recipe.materials.end(), has_own) || t.emissivity || t.ambient || !t.band.empty();
  const bool unread = t.from == TemperatureSection::From::film && !t.assumed_emissivity && of_surfaces;
  v.require(!unread || recipe.camera, {"temperature", "materials"}, unread_emissivity);
}

}  // namespace

void declare(ParameterVisitor& v, FilmRecipe& recipe) {
  v.text({"title", "One line for the head of reports."}, recipe.title);
  std::int64_t seed = static_cast<std::int64_t>(recipe.seed);
  v.integer({"seed", "Seed of a virtual camera's random numbers."}, seed, {0, std::numeric_limits<std::int64_t>::max()});
  recipe.seed = static_cast<std::uint64_t>(seed);
  v.sections({"materials", "Materials of the grains, by name.", true},
             {[&] { return recipe.materials.size(); }, [&](std::size_t n) { recipe.materials.resize(n); },
              [&](Visitor& inner, std::size_t i) { declare(inner, recipe.materials[i]); },
              [&](std::size_t i) -> std::string& { return recipe.materials[i].name; }});
  v.optional_section<ReadingSection>({"film", "What the film does not say about itself, or says wrongly."}, recipe.film,
                                     [](Visitor& inner, ReadingSection& film) { declare(inner, film); });
  v.section({"frame", "The frame that holds the grains.", true}, [&](Visitor& inner) { declare(inner, recipe.frame); });
  v.section({"picture", "Where grains are in the film.", true}, [&](Visitor& inner) { declare(inner, recipe.picture); });
  v.section({"lockin", "From the film to the swing of every pixel.", true}, [&](Visitor& inner) { declare(inner, recipe.lockin); });
  v.section({"correction", "Faults of the camera that are taken out of the film."}, [&](Visitor& inner) { declare(inner, recipe.correction); });
  v.section({"temperature", "From digital levels to kelvin."}, [&](Visitor& inner) { declare(inner, recipe.temperature); });
  v.section({"forces", "From the swing to stresses of grains and forces of contacts."}, [&](Visitor& inner) { declare(inner, recipe.forces); });
  v.optional_section<TwinSection>({"twin", "A simulation of the same packing, held beside the film."}, recipe.twin,
                                  [](Visitor& inner, TwinSection& twin) { declare(inner, twin); });
  v.optional_section<CameraSection>({"camera", "A virtual camera that films simulated states; for `arenite camera`."}, recipe.camera,
                                    [](Visitor& inner, CameraSection& camera) { declare(inner, camera); });
  // A virtual camera films its plates itself, and its recipe need not say what only a film is measured with.
  v.require(recipe.camera || has_plates(recipe), {"temperature", "correction"}, needs_plates);
  require_emissivities_used(v, recipe);
}

}  // namespace arenite::study
