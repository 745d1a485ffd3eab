#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <variant>

#include "arrays.hpp"
#include "calls.hpp"
#include "io/image/phase_map.hpp"
#include "model/cement.hpp"
#include "module.hpp"
#include "thermal/imaging/label_grains.hpp"

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

void label(PhaseMap& map, const std::string& way, double smoothing) {
  if (way == "none") io::label_alike(map);
  else
    imaging::label_grains(
        map, {way == "watershed" ? imaging::Labelling::watershed : imaging::Labelling::components, smoothing});
}

io::Crop crop_of(const std::tuple<int, int, int, int>& crop) {
  return {std::get<0>(crop), std::get<1>(crop), std::get<2>(crop), std::get<3>(crop)};
}

/// "0=void,85=particle", or {0: "void", 85: "particle"}.
io::PhaseTable phases_of(const std::variant<std::string, std::map<std::int32_t, std::string>>& phases) {
  if (const auto* text = std::get_if<std::string>(&phases))
    return text->empty() ? io::PhaseTable{} : io::parse_phase_table(*text);
  std::string text;
  if (std::get<1>(phases).empty()) return {};
  for (const auto& [value, name] : std::get<1>(phases))
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", value, name);
  return io::parse_phase_table(text);
}

PhaseMap read_map(const Path& file, const Quantity& dx, const Path& labels, double smoothing,
                  const std::variant<std::string, std::map<std::int32_t, std::string>>& phases,
                  const std::optional<std::int64_t>& slice, const std::optional<std::tuple<int, int, int, int>>& crop,
                  const std::string& dataset, const std::optional<std::int64_t>& label_slice,
                  const std::string& label_dataset) {
  const std::string way = labels.string();
  const bool by_program = way == "components" || way == "watershed" || way == "none";
  if (!by_program && !std::filesystem::exists(labels))
    throw InputError(fmt::format(
        "labels is \"{}\", which is not a file; give \"components\", \"watershed\", \"none\", or a label image", way));
  io::PhaseMapOptions options;
  options.dx = dx.si(dimension::length, "dx");
  if (!(options.dx > 0)) throw InputError(fmt::format("dx is {} m; give a length above 0", options.dx));
  if (!by_program) options.labels = labels;
  options.phases = phases_of(phases);
  options.image = {slice, dataset};
  options.label_image = {label_slice, label_dataset};
  if (crop) options.crop = crop_of(*crop);
  Call call;
  return call.without_lock([&] {
    auto read = io::read_phase_map(file, options);
    if (!read.labelled) label(read.map, way, smoothing);
    return std::move(read.map);
  });
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
  m.def("read_phase_map", &read_map, py::arg("file"), py::kw_only(), py::arg("dx"), py::arg("labels") = "components",
        py::arg("smoothing") = 1.0, py::arg("phases") = "", py::arg("slice") = py::none(), py::arg("crop") = py::none(),
        py::arg("dataset") = "", py::arg("label_slice") = py::none(), py::arg("label_dataset") = "",
        "A phase map from a picture with exact values (docs/formats.md), as `arenite load` reads it. `dx`: side of a "
        "pixel (m, or text with a unit). `labels`: grains are \"components\", cut at necks by \"watershed\" "
        "(`smoothing`: depth of a neck that is not cut, pixels), \"none\" (all one), or numbered by the values of a "
        "picture. `phases`: which grey value is what, {0: \"void\", 85: \"particle\", 170: \"matrix\"} or the same as "
        "text; a picture of two values needs none. `slice` of a stack, from 0; `crop`: (x, y, width, height), pixels "
        "from the upper left corner; `dataset` of an HDF5 file that holds several.");
}

}  // namespace arenite::python
