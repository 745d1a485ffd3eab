#include <fmt/core.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/thread_count.hpp"
#include "core/units.hpp"
#include "film_source.hpp"
#include "module.hpp"
#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/frame_statistics.hpp"
#include "thermal/thermography/grains/follow_grains.hpp"
#include "thermal/thermography/grains/grain_means.hpp"
#include "thermal/thermography/grains/grain_motion.hpp"
#include "thermal/thermography/phase_pictures.hpp"
#include "workflow/film/film_correction.hpp"

/// The steps of the workflow from a film to grain stresses, each by itself.
namespace arenite::python {
namespace {

using thermography::Correction, thermography::FrameStatistics;

constexpr std::size_t frames_looked_at = 200;

/// A reference in a file is read as the film is said to be; one in an array is taken as it is.
std::optional<FrameStatistics> reference(const std::optional<FilmLike>& film, const FilmInfo& of, const char* name,
                                         const recipe::FilmSection& said) {
  if (!film) return std::nullopt;
  const auto source = py::isinstance<py::array>(*film) ? film_of(*film) : film_of(*film, said);
  const FilmInfo& info = source->info();
  if (info.width != of.width || info.height != of.height)
    throw InputError(fmt::format(
        "{} has frames of {} x {} pixels, but the film has {} x {}; film the reference with the same camera and window",
        name, info.width, info.height, of.width, of.height));
  return thermography::frame_statistics(*source, frames_looked_at);
}

struct References {
  std::optional<FrameStatistics> cold, warm;
};

References references_of(const FilmInfo& film, const std::optional<FilmLike>& cold, const std::optional<FilmLike>& warm,
                         const recipe::FilmSection& said) {
  if (warm && !cold) throw InputError("warm is given without cold; one reference alone is `cold`");
  return {reference(cold, film, "cold", said), reference(warm, film, "warm", said)};
}

std::vector<std::uint8_t> bad_in(FilmSource& film, const References& references) {
  auto bad = references.warm
                 ? thermography::find_bad_pixels(*references.cold, *references.warm)
                 : thermography::find_bad_pixels(
                       references.cold ? *references.cold : thermography::frame_statistics(film, frames_looked_at));
  for (auto& each : bad) each = each != 0;
  return bad;
}

py::array_t<bool> bad_pixels(const FilmLike& film, const std::optional<FilmLike>& cold,
                             const std::optional<FilmLike>& warm, const py::kwargs& more) {
  const recipe::FilmSection said = film_said("find_bad_pixels", more);
  const auto source = film_of(film, said);
  const References references = references_of(source->info(), cold, warm, said);
  Call call;
  return taken_over_as_bool(call.without_lock([&] { return bad_in(*source, references); }),
                            {source->info().height, source->info().width});
}

py::array_t<float> all_frames(FilmSource& film, const Correction& correction) {
  const FilmInfo& info = film.info();
  thermography::CorrectedFilm corrected(film, correction);
  FrameBlock block;
  Call call;
  call.without_lock([&] {
    corrected.read(0, static_cast<std::size_t>(info.frames), block);
    return 0;
  });
  return taken_over(std::move(block.value), {static_cast<py::ssize_t>(info.frames), info.height, info.width});
}

struct CorrectionOfFilm : recipe::FilmSection {
  recipe::CorrectionSection correction;
};
void declare(ParameterVisitor& v, CorrectionOfFilm& parts) {
  recipe::declare(v, static_cast<recipe::FilmSection&>(parts));
  recipe::declare(v, parts.correction);
}

const Keywords& correction_keywords() {
  static const Keywords keywords(recipe::every_key<CorrectionOfFilm>(),
                                 with_film_keywords({{"bad_pixels", "bad_pixels"}}));
  return keywords;
}

py::array_t<float> corrected(const FilmLike& film, const std::optional<FilmLike>& cold,
                             const std::optional<FilmLike>& warm, const py::kwargs& more) {
  CorrectionOfFilm parts;
  read_keywords(parts, correction_keywords().given("correct_film", more));
  const auto source = film_of(film, parts);
  const FilmInfo& info = source->info();
  const References references = references_of(info, cold, warm, parts);
  Correction correction;
  correction.width = info.width;
  correction.height = info.height;
  if (references.warm) thermography::correct_gains(*references.cold, *references.warm, correction);
  else if (references.cold) thermography::correct_offsets(*references.cold, correction);
  if (parts.correction.bad_pixels)
    correction.bad = thermography::replacements(bad_in(*source, references), info.width, info.height);
  return all_frames(*source, correction);
}

py::array_t<float> in_kelvin(const FilmLike& film, const recipe::FilmRecipe& recipe) {
  const bool is_file = !py::isinstance<py::array>(film);
  const auto source = film_of(film, {is_file ? std::optional(recipe.choice()) : std::nullopt});
  return all_frames(*source, workflow::make_correction(recipe, *source).correction);
}

const Keywords& means_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::ForcesSection>(), {{"share", "central_share"}});
  return keywords;
}

py::dict means(const LockinMaps& maps, const PictureGrains& grains, const std::vector<Quantity>& factor,
               const py::kwargs& more) {
  recipe::ForcesSection forces;
  read_keywords(forces, means_keywords().given("grain_means", more));
  auto found = thermography::grain_means(maps, grains,
                                         {forces.central_share, si(factor, dimension::thermoelastic_factor, "factor")});
  py::dict d;
  d["temperature"] = taken_over(std::move(found.temperature));
  d["sigma_hyd"] = taken_over(std::move(found.sigma_hyd));
  d["error"] = taken_over(std::move(found.error));
  d["pixels"] = taken_over(std::move(found.pixels));
  return d;
}

thermography::PhasePictures pictures_of(FilmSource& film, const LockinMaps& maps, Call& call) {
  if (film.info().width != maps.width || film.info().height != maps.height)
    throw InputError("the maps belong to another film: their size differs from that of its frames");
  thermography::LockinOptions o;
  o.frequency = maps.frequency;
  o.progress = [&](double) { return !call.asked_to_stop(); };
  return thermography::phase_pictures(film, maps, o);
}

GrainMotion motion_of(const FilmLike& film, const LockinMaps& maps, const PictureGrains& grains,
                      const std::optional<ArrayLike>& time, const py::kwargs& more) {
  const recipe::FilmSection said = film_said("grain_motion", more);
  const auto source = film_of(film, said, time);
  Call call;
  return call.without_lock([&] {
    const auto pictures = pictures_of(*source, maps, call);
    return pictures.size() > 0 ? thermography::grain_motion(pictures, grains, Threads{}.threads) : GrainMotion{};
  });
}

/// Refuses maps of which a part was not kept, as those of a stored result are.
void require_all(const LockinMaps& maps) {
  for (const auto& [name, map] : {std::pair{"mean", &maps.mean},
                                  {"amplitude", &maps.amplitude},
                                  {"phase", &maps.phase},
                                  {"residual", &maps.residual},
                                  {"standard_error", &maps.standard_error},
                                  {"noise_floor", &maps.noise_floor}})
    if (map->size() != static_cast<std::size_t>(maps.width) * static_cast<std::size_t>(maps.height))
      throw InputError(
          fmt::format("these maps lack `{}`, as those of a stored result do; give maps made by lock_in", name));
}

struct ForcesOfFilm : recipe::FilmSection {
  recipe::ForcesSection forces;
};
void declare(ParameterVisitor& v, ForcesOfFilm& parts) {
  recipe::declare(v, static_cast<recipe::FilmSection&>(parts));
  recipe::declare(v, parts.forces);
}

const Keywords& following_keywords() {
  static const Keywords keywords(recipe::every_key<ForcesOfFilm>(), with_film_keywords({{"blur", "blur"}}));
  return keywords;
}

LockinMaps followed(const FilmLike& film, const LockinMaps& maps, const PictureGrains& grains,
                    const GrainMotion& motion, const std::optional<ArrayLike>& time, const py::kwargs& more) {
  ForcesOfFilm parts;
  read_keywords(parts, following_keywords().given("follow_grains", more));
  if (motion.size() != grains.size())
    throw InputError(fmt::format("the motion is that of {} grains, but there are {}; give grain_motion of these grains",
                                 motion.size(), grains.size()));
  require_all(maps);
  const auto source = film_of(film, parts, time);
  Call call;
  return call.without_lock([&] {
    const auto pictures = pictures_of(*source, maps, call);
    return pictures.size() > 0 ? thermography::follow_grains(pictures, maps, grains, motion, grains, Threads{}.threads,
                                                             std::nullopt, parts.forces.blur)
                               : LockinMaps{};
  });
}

}  // namespace

void bind_film_parts(py::module_& m) {
  def_with_keywords(m, "find_bad_pixels", &bad_pixels, film_keywords(),
                    "Bad pixels, as bool (height, width), top row first: dead, hot, blinking and frozen ones, by level "
                    "and noise of the film or of a film `cold` of a black-body reference; with a second one `warm` of "
                    "another temperature also by their response.",
                    py::arg("film"), py::kw_only(), py::arg("cold") = py::none(), py::arg("warm") = py::none());
  def_with_keywords(m, "correct_film", &corrected, correction_keywords(),
                    "All frames of a film in levels, float32 (frames, height, width), corrected: every pixel's offset "
                    "by a film `cold` of a black-body reference, gain and offset with a second one, `warm`.",
                    py::arg("film"), py::kw_only(), py::arg("cold") = py::none(), py::arg("warm") = py::none());
  m.def("film_in_kelvin", &in_kelvin, py::arg("film"), py::arg("recipe"),
        "All frames of a film in K, float32 (frames, height, width), corrected according to [correction] and "
        "[temperature] of its recipe; a file is read as its [film] says.");
  def_with_keywords(
      m, "grain_means", &means, means_keywords(),
      "Peak-to-peak change of every grain from the mean of the signed map (K): arrays temperature (K), sigma_hyd = "
      "-dT/(2 A) and its standard error (Pa, tension positive), pixels (area). `factor`: A of every material (K/Pa, or "
      "text with a unit). For any convention of the maps.",
      py::arg("maps"), py::arg("grains"), py::arg("factor"), py::kw_only());
  def_with_keywords(m, "grain_motion", &motion_of, film_keywords(),
                    "Motion of grains at the load frequency, from their rims in the film whose lock-in is `maps`; "
                    "`grains` at their mean positions, as in maps.mean; `time` of every frame of an array, s.",
                    py::arg("film"), py::arg("maps"), py::arg("grains"), py::kw_only(), py::arg("time") = py::none());
  def_with_keywords(m, "follow_grains", &followed, following_keywords(),
                    "The maps recomputed with pixels that follow their grains; amplitudes have no value between "
                    "grains. `time` of every frame of an array, s.",
                    py::arg("film"), py::arg("maps"), py::arg("grains"), py::arg("motion"), py::kw_only(),
                    py::arg("time") = py::none());
}

}  // namespace arenite::python
