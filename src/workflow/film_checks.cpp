#include "workflow/film_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::study {
namespace {

// Dead and hot pixels are some per mille of a detector; a film that shows something has far more that are neither.
bool nearly_all(std::size_t some, const FilmInfo& film) { return 100 * some >= 99 * film.pixels(); }

}  // namespace

void refuse_temperatures(const FilmRecipe& recipe, const std::filesystem::path& path, const FilmInfo& film) {
  if (!has_plates(recipe)) throw InputError(recipe.source_file, 0, fmt::format("temperature: {}", needs_plates));
  if (recipe.temperature.from == TemperatureSection::From::film && film.quantity == FilmQuantity::digital_level)
    throw InputError(path.string(), 0, fmt::format("says that it holds digital levels, and temperature.from = \"film\" of {} takes them for kelvin; "
                                                   "choose \"plates\", \"curve\" or \"radiometry\" there", recipe.source_file));
}

void refuse_saturated(const thermography::FrameStatistics& seen, const FilmInfo& film) {
  const std::size_t saturated = thermography::doubtful(seen, film.bits).saturated;
  if (nearly_all(saturated, film))
    throw InputError(fmt::format("{} of {} pixels reach the top of the camera's range ({}), so what they saw is not known; film with a shorter integration",
                                 saturated, film.pixels(), (1 << film.bits) - 1));
}

void refuse_constant(const thermography::FrameStatistics& seen, const FilmInfo& film) {
  const std::size_t constant = thermography::doubtful(seen, film.bits).constant;
  if (nearly_all(constant, film))
    throw InputError(fmt::format("{} of {} pixels never change in the first {} frames, not even by noise; give the film as the camera recorded it",
                                 constant, film.pixels(), seen.frames));
}

std::string no_load_sentence(const LockinMaps& maps, double frequency, std::string_view told_by) {
  if (maps.swings_at > 0)
    return fmt::format("nothing but noise swings at {:.6g} Hz, but the film swings at {:.4g} Hz; if that is the load, give its frequency ({})", frequency,
                       maps.swings_at, told_by);
  if (maps.chance < 0.01)
    return fmt::format("what swings at {:.6g} Hz has no common phase, as under a load, but is a line of the camera; give the frequency of the load ({}), or a film of "
                       "a loaded sample", frequency, told_by);
  return fmt::format("nothing but noise swings at {:.6g} Hz; give the frequency of the load ({}), or a film of a loaded sample", frequency, told_by);
}

void refuse_without_load(const LockinMaps& maps, double told_frequency) {
  if (!thermography::shows_swing(maps)) throw InputError(no_load_sentence(maps, told_frequency, "lockin.frequency"));
}

Recipe read_twin_recipe(const FilmRecipe& recipe) {
  const auto file = (std::filesystem::path(recipe.source_file).parent_path() / recipe.twin->recipe).string();
  Recipe twin = read_recipe(file);
  twin.source_file = file;
  for (const auto& name : {recipe.twin->low, recipe.twin->high}) {
    const auto named = [&](const Stage& stage) { return stage.name == name; };
    if (std::none_of(twin.stages.begin(), twin.stages.end(), named))
      throw InputError(file, 0, fmt::format("has no stage \"{}\", which [twin] of {} names", name, recipe.source_file));
  }
  return twin;
}

}  // namespace arenite::study
