#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/error.hpp"
#include "film_source.hpp"
#include "module.hpp"
#include "workflow/film_correction.hpp"
#include "thermal/thermography/bad_pixels.hpp"
#include "thermal/thermography/grain_means.hpp"
#include "thermal/thermography/grain_motion.hpp"
#include "thermal/thermography/nonuniformity.hpp"
#include "thermal/thermography/phase_pictures.hpp"

/// The steps of the road from a film to grain stresses, each by itself.
namespace arenite::python {
namespace {

using thermography::Correction, thermography::FrameStatistics;

constexpr std::size_t frames_looked_at = 200;

std::optional<FrameStatistics> plate(const std::optional<FilmLike>& film, const FilmInfo& of, const char* name) {
  if (!film) return std::nullopt;
  const auto source = film_of(*film);
  const FilmInfo& info = source->info();
  if (info.width != of.width || info.height != of.height)
    throw InputError(fmt::format("{} has frames of {} x {} pixels, and the film of {} x {}; take the plate with the same camera and window", name, info.width, info.height, of.width,
                                 of.height));
  return thermography::frame_statistics(*source, frames_looked_at);
}

struct Plates {
  std::optional<FrameStatistics> cold, warm;
};

Plates plates_of(const FilmInfo& film, const std::optional<FilmLike>& cold, const std::optional<FilmLike>& warm) {
  if (warm && !cold) throw InputError("warm is given without cold; one plate alone is `cold`");
  return {plate(cold, film, "cold"), plate(warm, film, "warm")};
}

std::vector<std::uint8_t> bad_in(FilmSource& film, const Plates& plates) {
  auto bad = plates.warm ? thermography::find_bad_pixels(*plates.cold, *plates.warm)
                         : thermography::find_bad_pixels(plates.cold ? *plates.cold : thermography::frame_statistics(film, frames_looked_at));
  for (auto& each : bad) each = each != 0;
  return bad;
}

py::array_t<bool> bad_pixels(const FilmLike& film, const std::optional<FilmLike>& cold, const std::optional<FilmLike>& warm) {
  const auto source = film_of(film);
  const Plates plates = plates_of(source->info(), cold, warm);
  Call call;
  return taken_over_as_bool(call.without_lock([&] { return bad_in(*source, plates); }), {source->info().height, source->info().width});
}

py::array_t<float> all_frames(FilmSource& film, const Correction& correction) {
  const FilmInfo& info = film.info();
  thermography::CorrectedFilm corrected(film, correction);
  FrameBlock block;
  Call call;
  call.without_lock([&] { corrected.read(0, static_cast<std::size_t>(info.frames), block); return 0; });
  return taken_over(std::move(block.value), {static_cast<py::ssize_t>(info.frames), info.height, info.width});
}

py::array_t<float> corrected(const FilmLike& film, const std::optional<FilmLike>& cold, const std::optional<FilmLike>& warm, bool replace_bad_pixels) {
  const auto source = film_of(film);
  const FilmInfo& info = source->info();
  const Plates plates = plates_of(info, cold, warm);
  Correction correction;
  correction.width = info.width;
  correction.height = info.height;
  if (plates.warm) thermography::correct_gains(*plates.cold, *plates.warm, correction);
  else if (plates.cold) thermography::correct_offsets(*plates.cold, correction);
  if (replace_bad_pixels) correction.bad = thermography::replacements(bad_in(*source, plates), info.width, info.height);
  return all_frames(*source, correction);
}

py::array_t<float> in_kelvin(const FilmLike& film, const study::FilmRecipe& recipe) {
  const auto source = film_of(film);
  return all_frames(*source, study::make_correction(recipe, *source).correction);
}

py::dict means(const LockinMaps& maps, const PictureGrains& grains, const std::vector<Quantity>& factor, double share) {
  auto swing = thermography::grain_means(maps, grains, {share, si(factor, dimension::thermoelastic_factor, "factor")});
  py::dict d;
  d["temperature"] = taken_over(std::move(swing.temperature));
  d["sigma_hyd"] = taken_over(std::move(swing.sigma_hyd));
  d["error"] = taken_over(std::move(swing.error));
  d["pixels"] = taken_over(std::move(swing.pixels));
  return d;
}

thermography::PhasePictures pictures_of(FilmSource& film, const LockinMaps& maps, double frame_rate, Call& call) {
  if (film.info().width != maps.width || film.info().height != maps.height) throw InputError("the maps are of another film: their size is not that of its frames");
  thermography::LockinOptions o;
  o.frequency = maps.frequency;
  o.frame_rate = frame_rate;
  o.progress = [&](double) { return !call.asked_to_stop(); };
  return thermography::phase_pictures(film, maps, o);
}

GrainMotion motion_of(const FilmLike& film, const LockinMaps& maps, const PictureGrains& grains, const Quantity& frame_rate, const std::optional<ArrayLike>& time) {
  const double rate = frame_rate.si(dimension::frequency, "frame_rate");
  const auto source = film_of(film, rate, time);
  Call call;
  return call.without_lock([&] {
    const auto pictures = pictures_of(*source, maps, rate, call);
    return pictures.size() > 0 ? thermography::grain_motion(pictures, grains) : GrainMotion{};
  });
}

LockinMaps followed(const FilmLike& film, const LockinMaps& maps, const PictureGrains& grains, const GrainMotion& motion, const Quantity& frame_rate,
                    const std::optional<ArrayLike>& time, double blur) {
  if (motion.size() != grains.size()) throw InputError(fmt::format("the motion is of {} grains, and there are {}; give grain_motion of these grains", motion.size(), grains.size()));
  const double rate = frame_rate.si(dimension::frequency, "frame_rate");
  const auto source = film_of(film, rate, time);
  Call call;
  return call.without_lock([&] {
    const auto pictures = pictures_of(*source, maps, rate, call);
    return pictures.size() > 0 ? thermography::follow_grains(pictures, maps, grains, motion, grains, std::nullopt, 1, blur) : LockinMaps{};
  });
}

}  // namespace

void bind_film_parts(py::module_& m) {
  m.def("find_bad_pixels", &bad_pixels, py::arg("film"), py::kw_only(), py::arg("cold") = py::none(), py::arg("warm") = py::none(),
        "Pixels that are not to be believed, as bool (height, width), top row first: dead, hot, blinking and frozen ones, by level and noise of the film or of a film `cold` of an even "
        "plate; with a plate `warm` of another temperature by their answer too.");
  m.def("correct_film", &corrected, py::arg("film"), py::kw_only(), py::arg("cold") = py::none(), py::arg("warm") = py::none(), py::arg("bad_pixels") = true,
        "All frames of a film in levels, float32 (frames, height, width), corrected: every pixel's offset by a film `cold` of an even plate, gain and offset with a second one, "
        "`warm`, and bad pixels replaced by their good neighbours.");
  m.def("film_in_kelvin", &in_kelvin, py::arg("film"), py::arg("recipe"),
        "All frames of a film in K, float32 (frames, height, width), corrected as [correction] and [temperature] of its recipe say.");
  m.def("grain_means", &means, py::arg("maps"), py::arg("grains"), py::arg("factor"), py::kw_only(), py::arg("share") = 0.5,
        "Swing of every grain from the mean of the signed map (K) over `share` of its area round its centre: arrays temperature (K), sigma_hyd = -dT/(2 A) and its standard error (Pa, "
        "tension positive), pixels (area). `factor`: A of every material (K/Pa, or text with a unit). Full swings, whatever the maps' convention.");
  m.def("grain_motion", &motion_of, py::arg("film"), py::arg("maps"), py::arg("grains"), py::kw_only(), py::arg("frame_rate") = 0.0, py::arg("time") = py::none(),
        "How grains move at the load frequency, by their rims in the film whose lock-in is `maps`; `grains` at their mean places, as maps.mean shows them.");
  m.def("follow_grains", &followed, py::arg("film"), py::arg("maps"), py::arg("grains"), py::arg("motion"), py::kw_only(), py::arg("frame_rate") = 0.0, py::arg("time") = py::none(),
        py::arg("blur") = 0.5,
        "The maps anew with pixels that follow their grains; swings have no value between grains. `blur` of the lens: standard deviation, pixels.");
}

}  // namespace arenite::python
