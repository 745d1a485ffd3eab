#include "study/film_correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/error.hpp"
#include "io/film.hpp"
#include "io/calibration_curve.hpp"
#include "study/film_checks.hpp"
#include "thermography/bad_pixels.hpp"
#include "thermography/calibration.hpp"
#include "thermography/frame_statistics.hpp"
#include "thermography/nonuniformity.hpp"

namespace arenite::study {
namespace {

using From = TemperatureSection::From;
using thermography::FrameStatistics;

constexpr std::size_t frames_looked_at = 200;

std::filesystem::path beside(const FilmRecipe& recipe, const std::string& file) {
  return std::filesystem::path(recipe.source_file).parent_path() / file;
}

std::optional<FrameStatistics> plate(const FilmRecipe& recipe, const std::string& file, const FilmInfo& film) {
  if (file.empty()) return std::nullopt;
  const auto path = beside(recipe, file);
  const auto source = io::open_film(path);
  if (source->info().width != film.width || source->info().height != film.height)
    throw InputError(path.string(), 0, fmt::format("has frames of {} x {} pixels, and the film of {} x {}; take the plate with the same camera and window",
                                                   source->info().width, source->info().height, film.width, film.height));
  auto seen = thermography::frame_statistics(*source, frames_looked_at);
  try {
    refuse_saturated(seen, source->info());
  } catch (const InputError& error) {
    throw in_file(error, path.string());
  }
  return seen;
}

radiometry::Band band_of(const FilmInfo& film) {
  return film.band_low > 0 && film.band_high > film.band_low ? radiometry::Band{film.band_low, film.band_high} : radiometry::Band{};
}

thermography::LevelRange range_of(const FilmInfo& film) { return {0, static_cast<double>((1 << std::clamp(film.bits, 8, 16)) - 1)}; }

/// Materials' emissivity where all share one, that of [temperature] otherwise.
double emissivity_of(const FilmRecipe& recipe) {
  const auto& materials = recipe.materials;
  const bool alike = std::all_of(materials.begin(), materials.end(), [&](const auto& m) { return m.emissivity == materials.front().emissivity; });
  return alike && !materials.empty() ? materials.front().emissivity : recipe.temperature.emissivity;
}

thermography::LevelCurve curve_for(const FilmRecipe& recipe, const FilmInfo& film, const std::optional<FrameStatistics>& cold,
                                   const std::optional<FrameStatistics>& warm, const FrameStatistics& first) {
  const auto& t = recipe.temperature;
  const radiometry::Surface surface{emissivity_of(recipe), t.ambient};
  switch (t.from) {
    case From::plates:
      return thermography::curve_by_plates(band_of(film), {thermography::plate_level(*cold), recipe.correction.cold_temperature},
                                           {thermography::plate_level(*warm), recipe.correction.warm_temperature}, surface, range_of(film));
    case From::radiometry: return thermography::curve_by_radiometry(band_of(film), {thermography::plate_level(first), t.ambient}, surface, range_of(film));
    case From::curve: {
      std::vector<thermography::LevelPoint> points;
      const auto curve = io::read_calibration_curve(beside(recipe, t.curve).string());
      for (std::size_t i = 0; i < curve.level.size(); ++i) points.push_back({curve.level[i], curve.temperature[i]});
      return thermography::curve_through(points, range_of(film));
    }
    case From::film: break;
  }
  return {};
}

void note_doubtful(const FrameStatistics& first, const FilmInfo& film, std::vector<std::string>& notes) {
  const auto doubtful = thermography::doubtful(first, film.bits);
  if (doubtful.constant > 0) notes.push_back(fmt::format("{} of {} pixels never change", doubtful.constant, film.pixels()));
  if (doubtful.saturated > 0)
    notes.push_back(fmt::format("{} of {} pixels reach the top of the camera's range; shorten the integration", doubtful.saturated, film.pixels()));
}

}  // namespace

FilmCorrection make_correction(const FilmRecipe& recipe, FilmSource& film) {
  const FilmInfo& info = film.info();
  const auto first = thermography::frame_statistics(film, frames_looked_at);
  refuse_saturated(first, info);
  refuse_constant(first, info);
  const auto cold = plate(recipe, recipe.correction.cold, info), warm = plate(recipe, recipe.correction.warm, info);
  FilmCorrection made;
  note_doubtful(first, info, made.notes);
  auto& correction = made.correction;
  correction.width = info.width;
  correction.height = info.height;
  if (cold && warm) thermography::correct_gains(*cold, *warm, correction);
  else if (cold) thermography::correct_offsets(*cold, correction);
  if (recipe.correction.bad_pixels) {
    made.bad = cold && warm ? thermography::find_bad_pixels(*cold, *warm) : thermography::find_bad_pixels(cold ? *cold : first);
    for (auto& b : made.bad) b = b != 0;
    correction.bad = thermography::replacements(made.bad, info.width, info.height);
  }
  correction.curve = curve_for(recipe, info, cold, warm, first);
  made.kelvin = true;
  return made;
}

}  // namespace arenite::study
