#include "workflow/film/film_correction.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "io/table/laboratory_table.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::workflow {
namespace {

using From = recipe::TemperatureSection::From;
using thermography::FrameStatistics;

constexpr std::size_t frames_looked_at = 200;

// Dead and hot pixels are some per mille of a detector; a film that shows something has far more that are neither.
bool nearly_all(std::size_t some, const FilmInfo& film) { return 100 * some >= 99 * film.pixels(); }

void refuse_saturated(const thermography::Doubtful& seen, const FilmInfo& film) {
  if (nearly_all(seen.saturated, film))
    throw refusal(
        "{} of {} pixels reach the top of the camera's range ({}), so their signal is lost; use a shorter integration "
        "time",
        seen.saturated, film.pixels(), (1 << film.bits) - 1);
}

void refuse_constant(const thermography::Doubtful& seen, const FilmInfo& film, std::size_t frames) {
  if (nearly_all(seen.constant, film))
    throw refusal(
        "{} of {} pixels are constant in the first {} frames, even without noise; give the film as recorded by the "
        "camera",
        seen.constant, film.pixels(), frames);
}

std::optional<FrameStatistics> reference(const recipe::FilmRecipe& recipe, const std::string& file,
                                         const FilmInfo& film) {
  if (file.empty()) return std::nullopt;
  const auto path = recipe.beside(file);
  const auto source = io::open_film(path, recipe.choice());
  if (source->info().width != film.width || source->info().height != film.height)
    refuse(path.string(),
           "has frames of {} x {} pixels, and the film of {} x {}; film the reference with the same camera and window",
           source->info().width, source->info().height, film.width, film.height);
  auto seen = thermography::frame_statistics(*source, frames_looked_at);
  try {
    refuse_saturated(thermography::doubtful(seen, source->info().bits), source->info());
  } catch (const InputError& error) { throw in_file(error, path.string()); }
  return seen;
}

/// The band that the recipe gives, the film, or none of them.
radiometry::Band band_of(const recipe::FilmRecipe& recipe, const FilmInfo& film, std::vector<std::string>& notes) {
  const bool film_says = film.band_low > 0 && film.band_high > film.band_low;
  const auto& given = recipe.temperature.band;
  const auto um = [](double low, double high) { return fmt::format("{:.3g} to {:.3g} um", 1e6 * low, 1e6 * high); };
  if (!given.empty()) {
    if (film_says && (std::abs(film.band_low / given[0] - 1) > 0.01 || std::abs(film.band_high / given[1] - 1) > 0.01))
      notes.push_back(fmt::format("the film gives the band {}; temperature.band, {}, is used instead",
                                  um(film.band_low, film.band_high), um(given[0], given[1])));
    return {given[0], given[1]};
  }
  if (film_says) return {film.band_low, film.band_high};
  const radiometry::Band usual;
  notes.push_back(fmt::format("neither the film nor temperature.band gives the band of the camera; {} is used",
                              um(usual.low, usual.high)));
  return usual;
}

thermography::LevelRange range_of(const FilmInfo& film) {
  return {0, static_cast<double>((1 << std::clamp(film.bits, 8, 16)) - 1)};
}

/// What the film's levels are first taken for: the surface that all materials are, or a black one, whose temperatures
/// are corrected grain by grain; of a film in kelvin the one that its temperatures were made with.
thermography::GrainSurfaces surfaces_of(const recipe::FilmRecipe& recipe, const radiometry::Band& band) {
  const auto& t = recipe.temperature;
  thermography::GrainSurfaces surfaces{
      band, {1, t.ambient.value_or(radiometry::Surface{}.ambient)}, emissivities(recipe)};
  const auto& all = surfaces.emissivity;
  const bool alike = std::all_of(all.begin(), all.end(), [&](double e) { return e == all.front(); });
  if (t.from == From::film) surfaces.assumed.emissivity = *t.assumed_emissivity;
  else if (alike && !all.empty()) surfaces.assumed.emissivity = all.front();
  return surfaces;
}

thermography::LevelCurve read_curve(const recipe::FilmRecipe& recipe, const FilmInfo& film,
                                    const thermography::GrainSurfaces& surfaces) {
  std::vector<thermography::LevelPoint> points;
  const auto curve = io::read_calibration_curve(recipe.beside(recipe.temperature.curve).string());
  for (std::size_t i = 0; i < curve.level.size(); ++i) points.push_back({curve.level[i], curve.temperature[i]});
  return thermography::curve_through(points, surfaces.band, surfaces.assumed, range_of(film));
}

thermography::LevelCurve curve_for(const recipe::FilmRecipe& recipe, const FilmInfo& film,
                                   const std::optional<FrameStatistics>& cold,
                                   const std::optional<FrameStatistics>& warm, const FrameStatistics& first,
                                   const thermography::GrainSurfaces& surfaces) {
  const auto& [band, surface, emissivity] = surfaces;
  switch (recipe.temperature.from) {
    case From::references:
      return thermography::curve_by_references(
          band, {thermography::reference_level(*cold), recipe.correction.cold_temperature},
          {thermography::reference_level(*warm), recipe.correction.warm_temperature}, surface, range_of(film));
    case From::radiometry:
      return thermography::curve_by_radiometry(band, {thermography::reference_level(first), surface.ambient}, surface,
                                               range_of(film));
    case From::curve: return read_curve(recipe, film, surfaces);
    case From::film: break;
  }
  return {};
}

/// Whole numbers of which nothing says what they are would be temperatures in steps of a kelvin.
void refuse_bare_levels(const FilmInfo& film) {
  if (!film.floating && film.quantity == FilmQuantity::unknown)
    throw InputError(
        "holds whole numbers of unknown quantity, and temperature.from = \"film\" takes them for kelvin; give [film] "
        "scale and offset (" +
        option("scale") + ", " + option("offset") + "), or choose \"references\", \"curve\" or \"radiometry\"");
}

void note_doubtful(const thermography::Doubtful& seen, const FilmInfo& film, std::vector<std::string>& notes) {
  if (seen.constant > 0) notes.push_back(fmt::format("{} of {} pixels never change", seen.constant, film.pixels()));
  if (seen.saturated > 0)
    notes.push_back(fmt::format("{} of {} pixels reach the top of the camera's range; shorten the integration",
                                seen.saturated, film.pixels()));
}

/// Whether a surface has a say in the film's temperatures.
bool corrects_surfaces(const recipe::FilmRecipe& recipe) {
  const auto& t = recipe.temperature;
  if (t.from != From::film || t.assumed_emissivity) return true;
  const bool own = std::any_of(recipe.materials.begin(), recipe.materials.end(),
                               [](const auto& m) { return m.emissivity.has_value(); });
  if (own || t.emissivity || t.ambient || !t.band.empty())
    refuse(recipe.source_file, "temperature: {}", recipe::unread_emissivity);
  return false;
}

}  // namespace

void refuse_temperatures(const recipe::FilmRecipe& recipe, const std::filesystem::path& path, const FilmInfo& film) {
  if (!has_references(recipe)) refuse(recipe.source_file, "temperature: {}", recipe::needs_references);
  if (recipe.temperature.from == recipe::TemperatureSection::From::film && film.quantity == FilmQuantity::digital_level)
    refuse(path.string(),
           "states that it holds digital levels, and temperature.from = \"film\" of {} takes them for kelvin; choose "
           "\"references\", \"curve\" or \"radiometry\" there",
           recipe.source_file);
}

FilmCorrection make_correction(const recipe::FilmRecipe& recipe, FilmSource& film) {
  const FilmInfo& info = film.info();
  if (recipe.temperature.from == From::film) refuse_bare_levels(info);
  const auto first = thermography::frame_statistics(film, frames_looked_at);
  const auto doubtful = thermography::doubtful(first, info.bits);
  refuse_saturated(doubtful, info);
  refuse_constant(doubtful, info, first.frames);
  const auto cold = reference(recipe, recipe.correction.cold, info),
             warm = reference(recipe, recipe.correction.warm, info);
  FilmCorrection made;
  note_doubtful(doubtful, info, made.notes);
  auto& correction = made.correction;
  correction.width = info.width;
  correction.height = info.height;
  if (cold && warm) thermography::correct_gains(*cold, *warm, correction);
  else if (cold) thermography::correct_offsets(*cold, correction);
  if (recipe.correction.bad_pixels) {
    made.bad = cold && warm ? thermography::find_bad_pixels(*cold, *warm)
                            : thermography::find_bad_pixels(cold ? *cold : first);
    for (auto& b : made.bad) b = b != 0;
    correction.bad = thermography::replacements(made.bad, info.width, info.height);
  }
  if (corrects_surfaces(recipe)) made.surfaces = surfaces_of(recipe, band_of(recipe, info, made.notes));
  correction.curve = curve_for(recipe, info, cold, warm, first, made.surfaces);
  return made;
}

std::optional<thermography::LoadSignal> load_signal_of(const std::filesystem::path& path, const FilmInfo& film,
                                                       double given,
                                                       const std::function<void(const std::string&)>& notice) {
  const auto line = io::lock_in_line(path);
  if (line.empty()) return std::nullopt;
  const auto time = thermography::frame_times(film);
  const auto signal = thermography::fit_load_signal(time, line, given);
  if (!signal) {
    notice(fmt::format("the film's lock-in line shows no cycle near {:.6g} Hz; it is ignored", given));
  } else if (std::abs(signal->frequency - given) > 1 / (time.back() - time.front())) {
    notice(fmt::format("the film's lock-in line cycles at {:.6g} Hz instead of the given {:.6g} Hz; the former is used",
                       signal->frequency, given));
  }
  return signal;
}

}  // namespace arenite::workflow
