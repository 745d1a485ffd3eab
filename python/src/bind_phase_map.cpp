#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <variant>

#include "arrays.hpp"
#include "calls.hpp"
#include "file_notes.hpp"
#include "keywords.hpp"
#include "model/cement.hpp"
#include "model/kinds.hpp"
#include "module.hpp"
#include "phase_words.hpp"
#include "solid/grid/cavity_statistics.hpp"
#include "thermal/imaging/label_grains.hpp"
#include "workflow/read_map.hpp"

namespace arenite::python {
namespace {

/// Labels of one's own: as many grains as the largest names.
void take_labels(PhaseMap& map, const ArrayLike& grain) {
  map.grain = whole_numbers(grain, -1, static_cast<std::int32_t>(map.size()) - 1, "grain", 2);
  const std::int32_t last = map.grain.empty() ? -1 : *std::max_element(map.grain.begin(), map.grain.end());
  map.grain_class.assign(static_cast<std::size_t>(last + 1), GrainClass::none);
}

PhaseMap map_of(const ArrayLike& phase, const std::optional<ArrayLike>& grain, const Quantity& dx) {
  const auto nodes = whole_numbers(phase, 0, 2, "phase (0 void, 1 matrix, 2 particle)", 2);
  const auto shape = py::array(phase).request().shape;
  PhaseMap map = make_phase_map(static_cast<int>(shape[1]), static_cast<int>(shape[0]), dx.si(dimension::length, "dx"));
  for (std::size_t k = 0; k < map.size(); ++k) map.phase[k] = static_cast<Phase>(nodes[k]);
  if (grain && py::array(*grain).request().shape != shape)
    throw InputError("grain: the labels must have the phase map's shape");
  if (grain) take_labels(map, *grain);
  else if (map.size() > 0) imaging::label_grains(map, {});
  check(map);
  return map;
}

const Keywords& map_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::MapSection>(), {{"file", "file", "", true},
                                                                           {"dx", "dx", "", true},
                                                                           {"labels", "labels", "", true},
                                                                           {"phases", "phases", "", true},
                                                                           {"crop", "crop", "", true},
                                                                           {"smoothing", "smoothing"},
                                                                           {"periodic", "periodic"},
                                                                           {"slice", "slice"},
                                                                           {"dataset", "dataset"},
                                                                           {"label_slice", "label_slice"},
                                                                           {"label_dataset", "label_dataset"}});
  return keywords;
}

PhaseMap read_map(const Path& file, const Quantity& dx, const Path& labels, const PhaseWords& phases,
                  const std::optional<std::tuple<int, int, int, int>>& crop, const py::kwargs& more) {
  auto given = map_keywords().given("read_phase_map", more);
  const auto add = [&](const char* name, const py::object& value) {
    given.push_back(map_keywords().given(name, value));
  };
  add("file", py::str(file.string()));
  add("dx", dx);
  add("labels", py::str(labels.string()));
  add("phases", py::str(text_of(phases)));
  if (crop)
    add("crop", py::str(fmt::format("{},{},{},{}", std::get<0>(*crop), std::get<1>(*crop), std::get<2>(*crop),
                                    std::get<3>(*crop))));
  recipe::MapSection map;
  read_keywords(map, given);
  if (map.has_label_file() && !std::filesystem::exists(labels))
    throw InputError(
        fmt::format("labels is \"{}\", which is not a file; give \"components\", \"watershed\", \"none\", or a label "
                    "image",
                    map.labels));
  std::vector<std::string> notes = workflow::idle_keys(map);
  Call call;
  auto read = call.without_lock(
      [&] { return workflow::read_map(map, [&](const std::string& note) { notes.push_back(note); }); });
  warn_of_notes(notes);
  return read;
}

}  // namespace

void bind_phase_map(py::module_& m) {
  py::class_<Cement>(m, "Cement", "The binding matrix of a packing, as geometry (P II.B).")
      .def_readonly("full", &Cement::full, "Whether matrix fills everything outside the grains.")
      .def_readonly("coating", &Cement::coating, "Thickness of the layer around every grain, m.")
      .def_property_readonly(
          "bridges", [](const Cement& c) { return c.bridges.size(); }, "Number of necks (bridges).")
      .def_property_readonly(
          "menisci", [](const Cement& c) { return c.menisci.size(); }, "Number of menisci.");
  py::class_<PhaseMap>(
      m, "PhaseMap",
      "A cemented packing on a square lattice of nodes; arrays are (height, width), the bottom row first.")
      .def(py::init(&map_of), py::arg("phase"), py::arg("grain") = py::none(), py::kw_only(), py::arg("dx"),
           "A map from your own data, which are copied: `phase` is 0 (void), 1 (matrix) or 2 (particle), `grain` "
           "numbers the particles from 0, -1 elsewhere (connected particles if not given), `dx` is the node spacing "
           "(m, or text with a unit).")
      .def_readonly("width", &PhaseMap::width, "Nodes.")
      .def_readonly("height", &PhaseMap::height, "Nodes.")
      .def_readonly("dx", &PhaseMap::dx, "Distance between neighbouring nodes, m.")
      .def_property_readonly(
          "phase",
          [](const py::object& self) {
            const auto& map = self.cast<const PhaseMap&>();
            py::array_t<std::uint8_t> array({map.height, map.width},
                                            reinterpret_cast<const std::uint8_t*>(map.phase.data()), self);
            array.attr("setflags")(py::arg("write") = false);
            return array;
          },
          "0 void, 1 matrix, 2 particle; uint8, (height, width).")
      .def_property_readonly(
          "grain",
          [](const py::object& self) {
            const auto& map = self.cast<const PhaseMap&>();
            return image_view(map.grain, map.height, map.width, self);
          },
          "Number of the grain, -1 outside grains; int32, (height, width).")
      .def_property_readonly(
          "grain_class",
          [](const py::object& self) {
            const auto& map = self.cast<const PhaseMap&>();
            py::array_t<std::uint8_t> array(static_cast<py::ssize_t>(map.grain_class.size()),
                                            reinterpret_cast<const std::uint8_t*>(map.grain_class.data()), self);
            array.attr("setflags")(py::arg("write") = false);
            return array;
          },
          "0 none, 1 small, 2 large; one per grain, uint8.")
      .def("__repr__", [](const PhaseMap& map) {
        return "<arenite.PhaseMap " + std::to_string(map.width) + " x " + std::to_string(map.height) + ">";
      });
  m.def("_fractions_by_kind", &grid::fractions_by_kind, py::arg("map"),
        "Fractions of the nodes of each kind, in the order of `_drawn[\"kinds\"]`.");
  m.def(
      "_kinds_of_nodes",
      [](const PhaseMap& map) {
        const auto kinds = kinds_of(map);
        return py::array_t<std::uint8_t>({map.height, map.width}, reinterpret_cast<const std::uint8_t*>(kinds.data()));
      },
      py::arg("map"), "The kind of every node, by its place in `_drawn[\"kinds\"]`; uint8, (height, width).");
  def_with_keywords(
      m, "read_phase_map", &read_map, map_keywords(),
      "A phase map from a picture with exact values (docs/formats.md), as `arenite load` reads it. `phases` "
      "may be {0: \"void\", 85: \"particle\", 170: \"matrix\"}, and `crop` a tuple.",
      py::arg("file"), py::kw_only(), py::arg("dx"), py::arg("labels") = recipe::MapSection{}.labels,
      py::arg("phases") = "", py::arg("crop") = py::none());
}

}  // namespace arenite::python
