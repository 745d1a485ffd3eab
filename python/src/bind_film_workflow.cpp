#include <pybind11/stl.h>

#include <variant>

#include "arrays.hpp"
#include "calls.hpp"
#include "io/film/written_format.hpp"
#include "keywords.hpp"
#include "module.hpp"
#include "report/film_text.hpp"
#include "workflow/film/render_film.hpp"
#include "workflow/film/run_film.hpp"

namespace arenite::python {
namespace {

py::dict simulation_of(const py::object& self) {
  const auto& simulation = self.cast<const FilmResult&>().simulation;
  py::dict d;
  if (simulation.empty()) return d;
  d["peak_to_peak"] = view(simulation.peak_to_peak, self);
  d["state"] = view(simulation.state, self);
  return d;
}

/// A picture as large as the maps.
template <class Get> void image_property(py::class_<FilmResult>& c, const char* name, Get get, const char* doc) {
  c.def_property_readonly(
      name,
      [get](const py::object& self) {
        const auto& f = self.cast<const FilmResult&>();
        return image_view(get(f), f.maps.height, f.maps.width, self);
      },
      doc);
}

using RecipeLike = std::variant<recipe::FilmRecipe, Path>;

/// The recipe with changes, read where a file is named.
recipe::FilmRecipe recipe_of(const RecipeLike& recipe, const py::dict& changes) {
  const auto overrides = overrides_of(changes);
  if (const auto* file = std::get_if<Path>(&recipe)) return recipe::read_film_recipe(file->string(), overrides);
  const auto& given = std::get<recipe::FilmRecipe>(recipe);
  auto changed = recipe::parse_film_recipe(recipe::to_toml(given), given.source_file, overrides);
  changed.source_file = given.source_file;
  return changed;
}

FilmResult film(const Path& path, const RecipeLike& recipe, const Path& out, const py::dict& changes, int threads,
                const Progress& progress) {
  const auto asked = recipe_of(recipe, changes);
  Call call;
  return call.without_lock([&] {
    workflow::FilmRunOptions options;
    options.out = out;
    options.threads = threads_given(threads);
    options.progress = [&](const workflow::Progress& p) { call.tell(progress, p.share, p.name); };
    options.asked_to_stop = [&] { return call.asked_to_stop(); };
    options.notice = [&](const std::string& sentence) { call.warn(sentence); };
    return workflow::run_film(path, asked, options).result;
  });
}

const Keywords& camera_keywords() {
  static const Keywords keywords{recipe::every_key<io::WrittenFilms>(), {{"format", "format", "", true}}};
  return keywords;
}

std::vector<std::string> camera(const Path& result, const RecipeLike& recipe, const Path& out,
                                const std::string& format, const py::dict& changes, const Progress& progress,
                                const py::kwargs& more) {
  camera_keywords().given("camera", more);
  io::WrittenFilms written;
  read_keywords(written, {camera_keywords().given("format", py::str(format))});
  const auto asked = recipe_of(recipe, changes);
  Call call;
  return call.without_lock([&] {
    workflow::RenderOptions options;
    options.out = out;
    options.format = written.format;
    options.progress = [&](double share) {
      call.tell(progress, share, "film");
      return !call.asked_to_stop();
    };
    std::vector<std::string> files;
    for (const auto& file : workflow::render_film(asked, result, options)) files.push_back(file.string());
    return files;
  });
}

}  // namespace

void bind_film_workflow(py::module_& m) {
  py::class_<FilmResult> c(
      m, "FilmResult",
      "Results of a film of a loaded packing: maps in kelvin (height, width), grains, their stresses, contact forces.");
  c.def_readonly("name", &FilmResult::name, "Name of the film.")
      .def_readonly("outcome", &FilmResult::outcome, "Outcome in a sentence.")
      .def_readonly("pixel", &FilmResult::pixel, "Side of a pixel on the sample, m.")
      .def_property_readonly(
          "origin", [](const FilmResult& f) { return py::make_tuple(f.origin.x, f.origin.y); },
          "Centre of the upper left pixel, m; y up.")
      .def_property_readonly(
          "maps", [](const FilmResult& f) -> const LockinMaps& { return f.maps; },
          py::return_value_policy::reference_internal, "The lock-in, in K, peak to peak.")
      .def_property_readonly(
          "grains", [](const FilmResult& f) -> const PictureGrains& { return f.grains; },
          py::return_value_policy::reference_internal, "Grains at the smallest load, in pixels.")
      .def_property_readonly(
          "packing", [](const FilmResult& f) -> const Packing& { return f.packing; },
          py::return_value_policy::reference_internal,
          "Grains in metres at the largest load; contact forces are peak to peak.")
      .def_property_readonly(
          "simulation", &simulation_of,
          "sigma_hyd (Pa) of the companion simulation of the same grains: peak_to_peak and state; empty without one.")
      .def_property_readonly(
          "numbers", [](const FilmResult& f) { return to_python(report::film_numbers(f)); },
          "As `arenite show --json` prints them; the end of a name is its unit.");
  array_property(
      c, "sigma_hyd", [](const FilmResult& f) -> auto& { return f.peak_to_peak.sigma_hyd; },
      "Peak-to-peak hydrostatic stress of every grain, Pa, tension positive.");
  array_property(
      c, "sigma_hyd_error", [](const FilmResult& f) -> auto& { return f.peak_to_peak.error; },
      "Its standard error, Pa.");
  array_property(
      c, "fn_error", [](const FilmResult& f) -> auto& { return f.fn_error; },
      "Standard error of every normal force, N.");
  array_property(
      c, "ft_error", [](const FilmResult& f) -> auto& { return f.ft_error; },
      "Standard error of every tangential force, N.");
  array_property(
      c, "presence", [](const FilmResult& f) -> auto& { return f.presence; },
      "Probability that a contact exists, for the contacts accepted.");
  image_property(
      c, "picture", [](const FilmResult& f) -> auto& { return f.picture; },
      "Mean of the frames at the smallest load, K.");
  image_property(
      c, "bad", [](const FilmResult& f) -> auto& { return f.bad; },
      "1 for pixels that were replaced by their neighbours, 0 for others; (height, width), uint8.");
  image_property(
      c, "fitted", [](const FilmResult& f) -> auto& { return f.fit.picture; },
      "Image reconstructed from the contact forces, K (height, width), for comparison with maps.in_phase; NaN outside "
      "grains.");
  m.def("film", &film, py::arg("film"), py::arg("recipe"), py::arg("out"), py::arg("changes") = py::dict(),
        py::kw_only(), threads_argument(), py::arg("progress") = py::none(),
        "The whole workflow from a film (a file) to grain stresses and contact forces, as `arenite film` runs it; "
        "`recipe`: a FilmRecipe or its file (docs/film-recipe.md).");
  def_with_keywords(
      m, "camera", &camera, camera_keywords(),
      "Films simulated states of a run's folder with a virtual infrared camera, according to [camera] of the recipe "
      "(a FilmRecipe or its file); returns the files written.",
      py::arg("result"), py::arg("recipe"), py::arg("out"), py::arg("format") = io::WrittenFilms{}.format,
      py::arg("changes") = py::dict(), py::kw_only(), py::arg("progress") = py::none());
}

}  // namespace arenite::python
