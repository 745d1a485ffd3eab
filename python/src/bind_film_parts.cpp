#include <fmt/core.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
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

/// The steps of the workflow from a film to grain stresses, each by itself, with the maps and grains that they give.
namespace arenite::python {
namespace {

void bind_lockin_maps(py::module_& m) {
  py::class_<LockinMaps> c(
      m, "LockinMaps",
      "Result of a lock-in for every pixel, in the film's unit; arrays are (height, width), the top row first.");
  c.def_readonly("frequency", &LockinMaps::frequency, "Hz, refined on the film.")
      .def_readonly("frequency_error", &LockinMaps::frequency_error, "Hz.")
      .def_readonly("reference_phase", &LockinMaps::reference_phase, "rad.")
      .def_readonly("frames", &LockinMaps::frames, "Number of frames used.")
      .def_property_readonly(
          "disturbances", [](const LockinMaps& l) { return l.disturbances; },
          "What the film shows beside the load and its drift, each a sentence.")
      .def_property_readonly(
          "blank_frames", [](const LockinMaps& l) { return l.blank; },
          "Frames that hold no picture (no numbers, or zeros) and were left out.")
      .def_property_readonly(
          "peak_to_peak", [](const LockinMaps& l) { return l.convention == AmplitudeConvention::peak_to_peak; },
          "Amplitudes are peak to peak.");
  const auto map = [&c](const char* name, std::vector<float> LockinMaps::*member, const char* doc) {
    c.def_property_readonly(
        name,
        [member](const py::object& self) {
          const auto& maps = self.cast<const LockinMaps&>();
          return image_view(maps.*member, maps.height, maps.width, self);
        },
        doc);
  };
  map("mean", &LockinMaps::mean, "Level at the middle of the film.");
  map("drift", &LockinMaps::drift, "Slope of the mean, unit/s.");
  map("amplitude", &LockinMaps::amplitude, "Amplitude at the load frequency.");
  map("phase", &LockinMaps::phase, "rad.");
  map("in_phase", &LockinMaps::in_phase,
      "Component in phase with the load, signed: positive if a pixel warms as the load rises.");
  map("quadrature", &LockinMaps::quadrature, "Component a quarter of a cycle off the load.");
  map("standard_error", &LockinMaps::standard_error, "Of `in_phase`.");
  map("noise_floor", &LockinMaps::noise_floor, "Mean amplitude due to noise alone.");
  map("second_harmonic", &LockinMaps::second_harmonic, "Amplitude at twice the frequency: slip, plasticity.");
  map("residual", &LockinMaps::residual, "Root mean square residual of the fit.");
}

void bind_grains(py::module_& m) {
  py::class_<PictureGrains> g(
      m, "PictureGrains",
      "Grains found in a picture, in pixels; the pixel in column c and row r has its centre at (c, r).");
  g.def("__len__", &PictureGrains::size, "Number of grains.");
  coordinate_property(
      g, "x", [](const PictureGrains& p) -> auto& { return p.centre; }, &Vec2::x, "Centres, pixels.");
  coordinate_property(
      g, "y", [](const PictureGrains& p) -> auto& { return p.centre; }, &Vec2::y, "Centres, pixels, downwards.");
  array_property(
      g, "radius", [](const PictureGrains& p) -> auto& { return p.radius; }, "Pixels.");
  array_property(
      g, "position_error", [](const PictureGrains& p) -> auto& { return p.position_error; },
      "Standard error of the centre along one axis, pixels.");
  array_property(
      g, "radius_error", [](const PictureGrains& p) -> auto& { return p.radius_error; }, "Pixels.");
  array_property(
      g, "brightness", [](const PictureGrains& p) -> auto& { return p.brightness; },
      "Mean over the inner half of the disk.");
  array_property(
      g, "score", [](const PictureGrains& p) -> auto& { return p.score; }, "Fraction of the rim that shows an edge.");
  array_property(
      g, "material", [](const PictureGrains& p) -> auto& { return p.material; },
      "Class by brightness, darkest first; -1 unknown.");
  array_property(
      g, "size_class", [](const PictureGrains& p) -> auto& { return p.size_class; },
      "Class by radius, smallest first.");
}

void bind_motion(py::module_& m) {
  py::class_<GrainMotion> c(m, "GrainMotion",
                            "Motion of every grain at the load frequency f, pixels, y down: x(t) = x + cos_x cos(2 pi "
                            "f t) + sin_x sin(2 pi f t), t in s after the first frame.");
  c.def("__len__", &GrainMotion::size, "Number of grains.");
  coordinate_property(
      c, "cos_x", [](const GrainMotion& p) -> auto& { return p.cosine; }, &Vec2::x, "Pixels.");
  coordinate_property(
      c, "sin_x", [](const GrainMotion& p) -> auto& { return p.sine; }, &Vec2::x, "Pixels.");
  coordinate_property(
      c, "cos_y", [](const GrainMotion& p) -> auto& { return p.cosine; }, &Vec2::y, "Pixels.");
  coordinate_property(
      c, "sin_y", [](const GrainMotion& p) -> auto& { return p.sine; }, &Vec2::y, "Pixels.");
  array_property(
      c, "error", [](const GrainMotion& p) -> auto& { return p.error; },
      "Standard error of each of the four, pixels; infinite for a grain that shows no contrast.");
  c.def_property_readonly(
      "lost", [](const GrainMotion& motion) { return taken_over_as_bool(thermography::lost_grains(motion)); },
      "True for grains that are not visible enough in the film to be tracked.");
}

using thermography::Correction, thermography::FrameStatistics;

constexpr std::size_t frames_looked_at = 200;

std::optional<FrameStatistics> reference(const std::optional<FilmLike>& film, const FilmInfo& of, const char* name) {
  if (!film) return std::nullopt;
  const auto source = film_of(*film);
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

References references_of(const FilmInfo& film, const std::optional<FilmLike>& cold,
                         const std::optional<FilmLike>& warm) {
  if (warm && !cold) throw InputError("warm is given without cold; one reference alone is `cold`");
  return {reference(cold, film, "cold"), reference(warm, film, "warm")};
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
                             const std::optional<FilmLike>& warm) {
  const auto source = film_of(film);
  const References references = references_of(source->info(), cold, warm);
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

py::array_t<float> corrected(const FilmLike& film, const std::optional<FilmLike>& cold,
                             const std::optional<FilmLike>& warm, bool replace_bad_pixels) {
  const auto source = film_of(film);
  const FilmInfo& info = source->info();
  const References references = references_of(info, cold, warm);
  Correction correction;
  correction.width = info.width;
  correction.height = info.height;
  if (references.warm) thermography::correct_gains(*references.cold, *references.warm, correction);
  else if (references.cold) thermography::correct_offsets(*references.cold, correction);
  if (replace_bad_pixels)
    correction.bad = thermography::replacements(bad_in(*source, references), info.width, info.height);
  return all_frames(*source, correction);
}

py::array_t<float> in_kelvin(const FilmLike& film, const recipe::FilmRecipe& recipe) {
  const auto source = film_of(film);
  return all_frames(*source, workflow::make_correction(recipe, *source).correction);
}

py::dict means(const LockinMaps& maps, const PictureGrains& grains, const std::vector<Quantity>& factor, double share) {
  auto found = thermography::grain_means(maps, grains, {share, si(factor, dimension::thermoelastic_factor, "factor")});
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
                      const Quantity& frame_rate, const std::optional<ArrayLike>& time) {
  const auto source = film_of(film, frame_rate.si(dimension::frequency, "frame_rate"), time);
  Call call;
  return call.without_lock([&] {
    const auto pictures = pictures_of(*source, maps, call);
    return pictures.size() > 0 ? thermography::grain_motion(pictures, grains) : GrainMotion{};
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

LockinMaps followed(const FilmLike& film, const LockinMaps& maps, const PictureGrains& grains,
                    const GrainMotion& motion, const Quantity& frame_rate, const std::optional<ArrayLike>& time,
                    double blur) {
  if (motion.size() != grains.size())
    throw InputError(fmt::format("the motion is that of {} grains, but there are {}; give grain_motion of these grains",
                                 motion.size(), grains.size()));
  require_all(maps);
  const auto source = film_of(film, frame_rate.si(dimension::frequency, "frame_rate"), time);
  Call call;
  return call.without_lock([&] {
    const auto pictures = pictures_of(*source, maps, call);
    return pictures.size() > 0
               ? thermography::follow_grains(pictures, maps, grains, motion, grains, std::nullopt, 1, blur)
               : LockinMaps{};
  });
}

}  // namespace

void bind_maps(py::module_& m) {
  bind_lockin_maps(m);
  bind_grains(m);
  bind_motion(m);
}

void bind_film_parts(py::module_& m) {
  m.def("find_bad_pixels", &bad_pixels, py::arg("film"), py::kw_only(), py::arg("cold") = py::none(),
        py::arg("warm") = py::none(),
        "Bad pixels, as bool (height, width), top row first: dead, hot, blinking and frozen ones, by level and noise "
        "of the film or of a film `cold` of a black-body reference; with a second one `warm` of another temperature "
        "also by their response.");
  m.def("correct_film", &corrected, py::arg("film"), py::kw_only(), py::arg("cold") = py::none(),
        py::arg("warm") = py::none(), py::arg("bad_pixels") = true,
        "All frames of a film in levels, float32 (frames, height, width), corrected: every pixel's offset by a film "
        "`cold` of a black-body reference, gain and offset with a second one, `warm`, and bad pixels replaced by their "
        "good neighbours.");
  m.def("film_in_kelvin", &in_kelvin, py::arg("film"), py::arg("recipe"),
        "All frames of a film in K, float32 (frames, height, width), corrected according to [correction] and "
        "[temperature] of its recipe.");
  m.def("grain_means", &means, py::arg("maps"), py::arg("grains"), py::arg("factor"), py::kw_only(),
        py::arg("share") = 0.5,
        "Peak-to-peak change of every grain from the mean of the signed map (K) over `share` of its area round its "
        "centre: arrays temperature (K), sigma_hyd = -dT/(2 A) and its standard error (Pa, tension positive), pixels "
        "(area). `factor`: A of every material (K/Pa, or text with a unit). For any convention of the maps.");
  m.def("grain_motion", &motion_of, py::arg("film"), py::arg("maps"), py::arg("grains"), py::kw_only(),
        py::arg("frame_rate") = 0.0, py::arg("time") = py::none(),
        "Motion of grains at the load frequency, from their rims in the film whose lock-in is `maps`; `grains` at "
        "their mean positions, as in maps.mean.");
  m.def("follow_grains", &followed, py::arg("film"), py::arg("maps"), py::arg("grains"), py::arg("motion"),
        py::kw_only(), py::arg("frame_rate") = 0.0, py::arg("time") = py::none(), py::arg("blur") = 0.5,
        "The maps recomputed with pixels that follow their grains; amplitudes have no value between grains. `blur` of "
        "the lens: standard deviation, pixels.");
}

}  // namespace arenite::python
