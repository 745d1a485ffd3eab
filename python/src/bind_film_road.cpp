#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "module.hpp"
#include "report/film_text.hpp"
#include "study/film_road.hpp"
#include "study/shoot_film.hpp"

namespace arenite::python {
namespace {

py::dict twin_of(const FilmResult& f) {
  const auto array = [](const std::vector<double>& values) { return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data()); };
  py::dict d;
  if (f.twin.empty()) return d;
  d["swing"] = array(f.twin.swing);
  d["state"] = array(f.twin.state);
  return d;
}

FilmResult film(const std::string& path, const std::string& recipe, const std::string& out, const py::dict& changes, int threads, const py::object& progress) {
  const auto asked = study::read_film_recipe(recipe, overrides_of(changes));
  Call call;
  return call.without_lock([&] {
    study::FilmRunOptions options;
    options.out = out;
    options.threads = threads;
    options.progress = [&](const study::Progress& p) { call.tell(progress, p.share, p.name); };
    options.asked_to_stop = [&] { return call.asked_to_stop(); };
    return study::run_film(path, asked, options).result;
  });
}

std::vector<std::string> camera(const std::string& result, const std::string& recipe, const std::string& out, const std::string& format, const py::dict& changes,
                                const py::object& progress) {
  const auto asked = study::read_film_recipe(recipe, overrides_of(changes));
  Call call;
  return call.without_lock([&] {
    study::ShootOptions options;
    options.out = out;
    options.format = format;
    options.progress = [&](double share) {
      call.tell(progress, share, "film");
      return !call.asked_to_stop();
    };
    std::vector<std::string> files;
    for (const auto& file : study::shoot_film(asked, result, options)) files.push_back(file.string());
    return files;
  });
}

}  // namespace

void bind_film_road(py::module_& m) {
  py::class_<FilmResult> c(m, "FilmResult", "What a film of a loaded packing gives: maps in kelvin (height, width), grains, their stresses, contact forces.");
  c.def_readonly("name", &FilmResult::name)
      .def_readonly("outcome", &FilmResult::outcome)
      .def_readonly("pixel", &FilmResult::pixel, "Side of a pixel on the sample, m.")
      .def_property_readonly("origin", [](const FilmResult& f) { return py::make_tuple(f.origin.x, f.origin.y); }, "Centre of the upper left pixel, m; y up.")
      .def_property_readonly("picture", [](const py::object& self) {
        const auto& f = self.cast<const FilmResult&>();
        return image_view(f.picture, f.maps.height, f.maps.width, self);
      }, "Mean of the frames at the smallest load, K.")
      .def_property_readonly("maps", [](const FilmResult& f) -> const LockinMaps& { return f.maps; }, py::return_value_policy::reference_internal)
      .def_property_readonly("grains", [](const FilmResult& f) -> const PictureGrains& { return f.grains; }, py::return_value_policy::reference_internal)
      .def_property_readonly("packing", [](const FilmResult& f) -> const Packing& { return f.packing; }, py::return_value_policy::reference_internal,
                             "Grains in metres at the largest load; contact forces are those of the swing.")
      .def_property_readonly("twin", &twin_of, "sigma_hyd (Pa) of the simulation of the same grains: swing and state; empty without one.")
      .def_property_readonly("numbers", [](const FilmResult& f) { return from_json(report::film_json(f)); });
  array_property(c, "sigma_hyd", [](const FilmResult& f) -> auto& { return f.swing.sigma_hyd; }, "Full swing of the hydrostatic stress of every grain, Pa, tension positive.");
  array_property(c, "sigma_hyd_error", [](const FilmResult& f) -> auto& { return f.swing.error; }, "Its standard error, Pa.");
  array_property(c, "fn_error", [](const FilmResult& f) -> auto& { return f.fn_error; }, "Standard error of every normal force, N.");
  array_property(c, "ft_error", [](const FilmResult& f) -> auto& { return f.ft_error; }, "Standard error of every tangential force, N.");
  array_property(c, "absent", [](const FilmResult& f) -> auto& { return f.absent; }, "1 for contacts that may not be there.");
  m.def("film", &film, py::arg("film"), py::arg("recipe"), py::arg("out"), py::arg("changes") = py::dict(), py::kw_only(), py::arg("threads") = 1, py::arg("progress") = py::none(),
        "The whole road from a film to grain stresses and contact forces, as `arenite film` goes it (docs/film-recipe.md).");
  m.def("camera", &camera, py::arg("result"), py::arg("recipe"), py::arg("out"), py::arg("format") = "ptw", py::arg("changes") = py::dict(), py::kw_only(),
        py::arg("progress") = py::none(), "Films simulated states with a virtual infrared camera; gives the files that were written.");
}

}  // namespace arenite::python
