#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/units.hpp"
#include "film_source.hpp"
#include "io/film/film.hpp"
#include "keywords.hpp"
#include "module.hpp"
#include "recipe/film_recipe.hpp"
#include "thermal/imaging/circles.hpp"
#include "thermal/imaging/proposed_contacts.hpp"
#include "thermal/inference/contact_forces.hpp"
#include "thermal/inference/pixel_forces.hpp"
#include "thermal/thermography/lockin.hpp"
#include "thermal/thermography/step/step_load.hpp"

namespace arenite::python {
namespace {

/// Parts of a film's recipe, read together.
template <class Section> struct OfFilm : recipe::FilmSection { Section section; };
template <class Section> void declare(ParameterVisitor& v, OfFilm<Section>& parts) {
  recipe::declare(v, static_cast<recipe::FilmSection&>(parts));
  recipe::declare(v, parts.section);
}
using LockinOfFilm = OfFilm<recipe::LockinAlone>;
using StepOfFilm = OfFilm<recipe::StepSection>;

const Keywords& lockin_keywords() {
  static const Keywords keywords(recipe::every_key<LockinOfFilm>(),
                                 with_film_keywords({{"frequency", "frequency", "", true},
                                                     {"drift_order", "drift"},
                                                     {"harmonics", "harmonics"},
                                                     {"reference_phase", "phase"},
                                                     {"refine", "refine"},
                                                     {"peak_to_peak", "convention=peak-to-peak"},
                                                     {"nearest_bin", "method=nearest_bin"}}));
  return keywords;
}

LockinMaps locked_in(const FilmLike& film, const Quantity& frequency, const std::optional<ArrayLike>& time, int threads,
                     const Progress& progress, const py::kwargs& more) {
  auto given = lockin_keywords().given("lock_in", more);
  given.push_back(lockin_keywords().given("frequency", frequency));
  LockinOfFilm parts;
  read_keywords(parts, given);
  const auto source = film_of(film, parts, time);
  thermography::LockinOptions o = parts.section.options();
  o.threads = threads_given(threads);
  Call call;
  o.progress = [&](double share) {
    call.tell(progress, share, "lock-in");
    return !call.asked_to_stop();
  };
  const bool at_bin = parts.section.method == recipe::LockinSection::Method::nearest_bin;
  return call.without_lock(
      [&] { return at_bin ? thermography::nearest_bin_transform(*source, o) : thermography::lock_in(*source, o); });
}

const Keywords& step_keywords() {
  static const Keywords keywords(
      recipe::every_key<StepOfFilm>(),
      with_film_keywords({{"time", "time"}, {"rise", "rise"}, {"window", "window"}, {"drift_order", "drift"}}));
  return keywords;
}

py::dict stepped(const FilmLike& film, const py::kwargs& more) {
  StepOfFilm parts;
  read_keywords(parts, step_keywords().given("step_load", more));
  thermography::StepOptions o = parts.section.options();
  const auto source = film_of(film, parts);
  Call call;
  o.progress = [&](double) { return !call.asked_to_stop(); };
  auto maps = call.without_lock([&] { return thermography::step_load(*source, o); });
  const auto map = [&](std::vector<float>& values) { return taken_over(std::move(values), {maps.height, maps.width}); };
  py::dict d;
  d["time"] = maps.time;
  d["rise"] = maps.rise;
  d["doubts"] = maps.doubts;
  d["jump"] = map(maps.jump);
  d["standard_error"] = map(maps.standard_error);
  d["residual"] = map(maps.residual);
  d["level_jumps"] = maps.level_jumps;
  d["blank_frames"] = maps.blank;
  return d;
}

py::dict film_info(const Path& path, const py::kwargs& more) {
  const auto film = film_of(py::cast(path), film_said("film_info", more));
  const FilmInfo& i = film->info();
  py::dict d;
  d["width"] = i.width;
  d["height"] = i.height;
  d["frames"] = i.frames;
  d["frame_rate"] = i.frame_rate;
  d["integration"] = i.integration;
  d["bits"] = i.bits;
  d["format"] = i.format;
  d["camera"] = i.camera;
  d["remarks"] = i.remarks;
  return d;
}

py::array film_frames(const Path& path, std::int64_t first, std::int64_t count, const py::kwargs& more) {
  const auto film = film_of(py::cast(path), film_said("read_film", more));
  const FilmInfo& i = film->info();
  if (first < 0 || first >= i.frames)
    throw InputError(path.string(), 0, fmt::format("the film has frames 0 to {}; first is {}", i.frames - 1, first));
  if (count < 1)
    throw InputError(path.string(), 0, fmt::format("count is {}; give the number of frames, at least 1", count));
  count = std::min(count, i.frames - first);
  FrameBlock block;
  Call call;
  call.without_lock([&] {
    film->read(first, static_cast<std::size_t>(count), block);
    return 0;
  });
  std::vector<py::ssize_t> shape{count, i.height, i.width};
  if (i.floating) return taken_over(std::move(block.value), std::move(shape));
  return taken_over(std::move(block.level), std::move(shape));
}

const Keywords& circle_keywords() {
  static const Keywords keywords(recipe::every_key<imaging::CircleOptions>(), {{"radii", "radii"},
                                                                               {"smallest", "smallest"},
                                                                               {"largest", "largest"},
                                                                               {"materials", "materials"},
                                                                               {"contrast", "contrast"},
                                                                               {"least_score", "least_score"}});
  return keywords;
}

PictureGrains circles(const ArrayLike& pixels, const py::kwargs& more) {
  const Floats image = floats(pixels, 2, "image");
  FloatImage picture{
      static_cast<int>(image.shape(1)), static_cast<int>(image.shape(0)), {image.data(), image.data() + image.size()}};
  imaging::CircleOptions options;
  read_keywords(options, circle_keywords().given("find_grains", more));
  Call call;
  return call.without_lock([&] { return imaging::find_circles(picture, options).grains; });
}

struct ErrorsOfGrains {
  double position = 0, radius = 0;
};
void declare(ParameterVisitor& v, ErrorsOfGrains& errors) {
  v.number({"position_error", "Standard error of a grain's position."}, errors.position, "m", range::not_negative);
  v.number({"radius_error", "Standard error of a grain's radius."}, errors.radius, "m", range::not_negative);
}

const Keywords& touching_keywords() {
  static const Keywords keywords(recipe::every_key<ErrorsOfGrains>(),
                                 {{"position_error", "position_error"}, {"radius_error", "radius_error"}});
  return keywords;
}

Packing touching(const Packing& packing, const py::kwargs& more) {
  ErrorsOfGrains errors;
  read_keywords(errors, touching_keywords().given("propose_contacts", more));
  const std::size_t n = packing.grains.size();
  const std::vector<double> position(n, errors.position), radius(n, errors.radius);
  Packing result = packing;
  result.contacts = imaging::propose_contacts(packing.grains, packing.domain, {position, radius});
  return result;
}

/// Forces of walls by the names of their sides, taken as known to 0.1 %.
std::vector<inference::WallLoad> wall_loads(const std::map<std::string, Quantity>& walls) {
  std::vector<inference::WallLoad> loads;
  for (const auto& [name, force] : walls) {
    const auto side = std::find(side_names.begin(), side_names.end(), name);
    if (side == side_names.end())
      throw InputError(fmt::format("walls has \"{}\"; sides are left, right, bottom, top", name));
    const double newtons = force.si(dimension::force, "walls: " + name);
    loads.push_back({static_cast<int>(side - side_names.begin()), newtons, std::max(1e-3 * std::abs(newtons), 1e-6)});
  }
  return loads;
}

inference::ThermoelasticPicture picture_of(const ArrayLike& signal, const ArrayLike& error, double pixel, Vec2 first) {
  const Floats value = floats(signal, 2, "signal"), errors = floats(error, 2, "error");
  if (value.shape(0) != errors.shape(0) || value.shape(1) != errors.shape(1))
    throw InputError(
        fmt::format("the signal has {} x {} pixels and its error {} x {} (height x width); give both the same shape",
                    value.shape(0), value.shape(1), errors.shape(0), errors.shape(1)));
  return {static_cast<int>(value.shape(1)),
          static_cast<int>(value.shape(0)),
          pixel,
          first,
          {value.data(), value.data() + value.size()},
          {errors.data(), errors.data() + errors.size()}};
}

struct OfPixels {
  recipe::PictureSection picture;
  recipe::ForcesSection forces;
};
void declare(ParameterVisitor& v, OfPixels& parts) {
  recipe::declare(v, parts.picture);
  recipe::declare(v, parts.forces);
}

const Keywords& force_keywords() {
  static const Keywords keywords(recipe::every_key<OfPixels>(), {{"pixel", "pixel", "", true}, {"blur", "blur"}});
  return keywords;
}

py::dict inferred(const Packing& packing, const ArrayLike& signal, const ArrayLike& error, const Quantity& pixel,
                  const std::pair<Quantity, Quantity>& first, const std::vector<Quantity>& factor,
                  const std::map<std::string, Quantity>& walls, const py::kwargs& more) {
  OfPixels parts;
  auto given = force_keywords().given("infer_forces", more);
  given.push_back(force_keywords().given("pixel", pixel));
  read_keywords(parts, given);
  const Vec2 corner{first.first.si(dimension::length, "first"), first.second.si(dimension::length, "first")};
  const auto picture = picture_of(signal, error, parts.picture.pixel, corner);
  inference::ForceProblem problem{packing, si(factor, dimension::thermoelastic_factor, "factor"), wall_loads(walls)};
  inference::ForceOptions o;
  o.blur = parts.forces.blur;
  Call call;
  InferredForces f = call.without_lock([&] { return inference::infer_from_pixels(problem, picture, o); });
  py::dict d;
  d["fn"] = taken_over(std::move(f.contacts.fn));
  d["ft"] = taken_over(std::move(f.contacts.ft));
  d["fn_error"] = taken_over(std::move(f.fn_error));
  d["ft_error"] = taken_over(std::move(f.ft_error));
  d["presence"] = taken_over(std::move(f.presence));
  d["present"] = taken_over(std::move(f.present)).attr("astype")("bool");
  d["residual"] = f.residual;
  return d;
}

}  // namespace

void bind_film(py::module_& m) {
  def_with_keywords(m, "lock_in", &locked_in, lockin_keywords(),
                    "Lock-in of a film: a file, or an array (frames, height, width), uint16 or float32, which is not "
                    "copied, with its `frame_rate` or the `time` of every frame (s). Numbers are in SI, angles in rad.",
                    py::arg("film"), py::arg("frequency"), py::kw_only(), py::arg("time") = py::none(),
                    threads_argument(), py::arg("progress") = py::none());
  def_with_keywords(m, "step_load", &stepped, step_keywords(),
                    "The jump of every pixel at a step of the load: time (s), jump, standard_error, residual (height, "
                    "width), in the film's unit; blank_frames, which hold no whole picture and were left out.",
                    py::arg("film"));
  def_with_keywords(m, "film_info", &film_info, film_keywords(),
                    "Metadata of a film: width, height, frames, frame_rate (Hz), integration (s), bits, format, "
                    "camera, and remarks, sentences on what the file states that should be known.",
                    py::arg("path"));
  def_with_keywords(m, "read_film", &film_frames, film_keywords(),
                    "Frames of a film as an array (frames, height, width), top row first.", py::arg("path"),
                    py::arg("first") = 0, py::arg("count") = 1);
  def_with_keywords(m, "find_grains", &circles, circle_keywords(),
                    "Circles in a picture (height, width): centres, radii, material by brightness.", py::arg("image"));
  def_with_keywords(
      m, "propose_contacts", &touching, touching_keywords(),
      "The packing with contacts where surfaces are no farther apart than three standard errors; forces are 0.",
      py::arg("packing"));
  def_with_keywords(
      m, "infer_forces", &inferred, force_keywords(),
      "Contact forces (N) from a picture of the thermoelastic signal, peak to peak (K, rows from the top): `first`: "
      "centre of the upper left pixel (m), `factor`: A of every material (K/Pa), `walls`: wall forces by side, peak to "
      "peak, {\"bottom\": 1000.0} (N, taken as known to 0.1 %); each a number or text with a unit. Gives fn, ft, "
      "fn_error, ft_error (N), presence (probability that a contact exists), present (bool: the most probable "
      "contacts, as many as expected), residual.",
      py::arg("packing"), py::arg("signal"), py::arg("error"), py::kw_only(), py::arg("pixel"), py::arg("first"),
      py::arg("factor"), py::arg("walls") = std::map<std::string, Quantity>{});
}

}  // namespace arenite::python
