#include "study/film_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.hpp"

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

double swing_over_noise(const LockinMaps& maps) {
  double sum = 0;
  std::size_t known = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const double share = static_cast<double>(maps.amplitude[i]) / static_cast<double>(maps.standard_error[i]);
    if (!std::isfinite(share)) continue;
    sum += share * share;
    ++known;
  }
  return known > 0 ? sum / static_cast<double>(known) : 0;
}

bool shows_no_load(const LockinMaps& maps) {
  // Pixels' noise is theirs alone, so its mean over a film's thousands of pixels is within a few hundredths of 2, also at the
  // best of the frequencies that the refinement tried. A film whose load shows less than this tells nothing of single grains.
  constexpr double noise_alone = 2, least = 1.25 * noise_alone;
  return swing_over_noise(maps) < least;
}

std::string no_load_sentence(double frequency, std::string_view told_by) {
  return fmt::format("nothing but noise swings at {:.6g} Hz; give the frequency of the load ({}), or a film of a loaded sample", frequency, told_by);
}

void refuse_without_load(const LockinMaps& maps, double told_frequency) {
  if (shows_no_load(maps)) throw InputError(no_load_sentence(told_frequency, "lockin.frequency"));
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
