#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "cement/cement.hpp"
#include "core/units.hpp"
#include "imaging/label_grains.hpp"
#include "io/phase_map_image.hpp"
#include "module.hpp"
#include "raster/cavities.hpp"
#include "raster/raster.hpp"
#include "stress/stress.hpp"
#include "study/field_stages.hpp"
#include "study/load_map.hpp"
#include "study/recipe_words.hpp"

namespace arenite::python {
namespace {

using study::Recipe;

/// 0.3 or "0.3 mm".
double si(const py::object& value, Dimension dimension) {
  return py::isinstance<py::str>(value) ? parse_si(value.cast<std::string>(), dimension) : value.cast<double>();
}

Cement cemented(const Packing& packing, const std::string& kind, const py::object& gap, double width, bool full_width, const py::object& thickness, double volume,
                const py::object& saturation) {
  cement::CementParameters p;
  p.kind = study::chosen<cement::CementParameters::Kind>(kind, "cement");
  p.gap = si(gap, dimension::length);
  p.width = width;
  p.full_width = full_width;
  p.thickness = si(thickness, dimension::length);
  p.volume = volume;
  if (!saturation.is_none()) p.saturation = saturation.cast<double>();
  Call call;
  return call.without_lock([&] {
    cement::CementReport report;
    return cement::make_cement(packing, p, raster::crop_window(packing, 0), report);
  });
}

PhaseMap rasterised(const Packing& packing, const Cement& cement, std::int64_t nodes, const py::object& crop) {
  raster::RasterParameters p;
  p.nodes = nodes;
  p.crop = si(crop, dimension::length);
  Call call;
  return call.without_lock([&] {
    raster::RasterReport report;
    return raster::rasterise(packing, cement, p, study::classes(packing, study::class_materials({}, packing)), report);
  });
}

PhaseMap map_of(const py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>& phase, const py::object& grain, const py::object& dx) {
  if (phase.ndim() != 2) throw InputError("a phase map is an array with two dimensions, its first row at the bottom");
  PhaseMap map = make_phase_map(static_cast<int>(phase.shape(1)), static_cast<int>(phase.shape(0)), si(dx, dimension::length));
  for (std::size_t k = 0; k < map.size(); ++k) {
    if (phase.data()[k] > 2) throw InputError("a node of a phase map is 0 (void), 1 (matrix) or 2 (particle)");
    map.phase[k] = static_cast<Phase>(phase.data()[k]);
  }
  if (grain.is_none()) {
    imaging::label_grains(map, {});
    return map;
  }
  const auto labels = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>::ensure(grain);
  if (!labels || labels.ndim() != 2 || labels.shape(0) != phase.shape(0) || labels.shape(1) != phase.shape(1)) throw InputError("grain labels must have the phase map's shape");
  std::int32_t last = -1;
  for (std::size_t k = 0; k < map.size(); ++k) last = std::max(last, map.grain[k] = labels.data()[k]);
  map.grain_class.assign(static_cast<std::size_t>(last + 1), GrainClass::none);
  check(map);
  return map;
}

PhaseMap read_map(const std::string& file, const py::object& dx, const std::string& labels, double smoothing) {
  io::PhaseMapOptions options;
  options.dx = si(dx, dimension::length);
  Call call;
  return call.without_lock([&] {
    auto read = io::read_phase_map(file, options);
    if (!read.labelled) imaging::label_grains(read.map, {labels == "watershed" ? imaging::Labelling::watershed : imaging::Labelling::components, smoothing});
    return std::move(read.map);
  });
}

FieldResult loaded(const PhaseMap& map, const std::string& loading, double strain, const std::string& axis, const std::string& lower, const std::string& method, double tolerance,
                   bool moduli, bool failure, const py::object& matrix, const py::object& interface, const py::object& particle, const py::object& progress) {
  using peridynamics::Loading, peridynamics::LowerEdge, peridynamics::Method;
  study::Load load;
  load.name = failure ? "failure" : loading;
  load.loading = study::chosen<Loading>(loading, "loading");
  load.axis = study::chosen<study::Load::Axis>(axis, "axis");
  load.lower = study::chosen<LowerEdge>(lower, "lower edge");
  load.method = study::chosen<Method>(method, "method");
  load.strain = strain;
  load.tolerance = tolerance;
  load.moduli = moduli;
  load.failure = failure;
  load.stiffness.matrix = si(matrix, dimension::pressure);
  if (!interface.is_none()) load.stiffness.interface = si(interface, dimension::pressure);
  if (!particle.is_none()) load.stiffness.particle = si(particle, dimension::pressure);
  Call call;
  auto result = call.without_lock([&] {
    const peridynamics::Watch watch = [&](const auto& at) {
      call.tell(progress, at.share, load.name);
      return !call.asked_to_stop();
    };
    return study::apply_load(load, study::sample_of_map(map), watch);
  });
  return result ? std::move(*result) : FieldResult{};
}

}  // namespace

void bind_phase_map(py::module_& m) {
  py::class_<Cement>(m, "Cement", "The binding matrix of a packing, as geometry (P II.B).")
      .def_readonly("full", &Cement::full)
      .def_readonly("coating", &Cement::coating, "Thickness of the layer round every grain, m.")
      .def_property_readonly("bridges", [](const Cement& c) { return c.bridges.size(); }, "Number of bridges.")
      .def_property_readonly("menisci", [](const Cement& c) { return c.menisci.size(); }, "Number of menisci.");
  py::class_<PhaseMap>(m, "PhaseMap", "A cemented packing on a square lattice of nodes; arrays are (height, width), the bottom row first.")
      .def(py::init(&map_of), py::arg("phase"), py::arg("grain") = py::none(), py::kw_only(), py::arg("dx"),
           "A map of your own: `phase` is 0 (void), 1 (matrix) or 2 (particle), `grain` numbers the particles from 0, -1 elsewhere (found by connection if not given), `dx` is the "
           "distance of nodes (m, or text with a unit).")
      .def_readonly("width", &PhaseMap::width, "Nodes.")
      .def_readonly("height", &PhaseMap::height, "Nodes.")
      .def_readonly("dx", &PhaseMap::dx, "Distance between neighbouring nodes, m.")
      .def_property_readonly("phase", [](const py::object& self) {
        const auto& map = self.cast<const PhaseMap&>();
        py::array_t<std::uint8_t> array({map.height, map.width}, reinterpret_cast<const std::uint8_t*>(map.phase.data()), self);
        array.attr("setflags")(py::arg("write") = false);
        return array;
      }, "0 void, 1 matrix, 2 particle; uint8, (height, width).")
      .def_property_readonly("grain", [](const py::object& self) {
        const auto& map = self.cast<const PhaseMap&>();
        return image_view(map.grain, map.height, map.width, self);
      }, "Number of the grain, -1 where there is none; int32, (height, width).")
      .def_property_readonly("grain_class", [](const py::object& self) {
        const auto& map = self.cast<const PhaseMap&>();
        py::array_t<std::uint8_t> array(static_cast<py::ssize_t>(map.grain_class.size()), reinterpret_cast<const std::uint8_t*>(map.grain_class.data()), self);
        array.attr("setflags")(py::arg("write") = false);
        return array;
      }, "0 none, 1 small, 2 large; one a grain, uint8.")
      .def("__repr__", [](const PhaseMap& map) { return "<arenite.PhaseMap " + std::to_string(map.width) + " x " + std::to_string(map.height) + ">"; });
}

void bind_field(py::module_& m) {
  m.def("cement", &cemented, py::arg("packing"), py::arg("kind") = "bridges", py::kw_only(), py::arg("gap") = 0.0, py::arg("width") = 0.4, py::arg("full_width") = false,
        py::arg("thickness") = 0.0, py::arg("volume") = 0.0, py::arg("saturation") = py::none(),
        "Matrix between grains: kind \"bridges\" (surface gap up to `gap`, half base `width` times the radius: P II.B), \"full\", \"coating\" (`thickness`), \"menisci\" (`volume`, "
        "m^2 each) or \"none\". With `saturation` (S_m) the free parameter is found by program. Lengths in m, or text with a unit.");
  m.def("rasterise", &rasterised, py::arg("packing"), py::arg("cement"), py::kw_only(), py::arg("nodes") = 1024, py::arg("crop") = 0.0,
        "The centred square of side `crop` (m; 0: the largest that fits) as nodes x nodes, by phase and grain. Of two materials the one with larger grains is class large.");
  m.def("read_phase_map", &read_map, py::arg("file"), py::kw_only(), py::arg("dx"), py::arg("labels") = "components", py::arg("smoothing") = 1.0,
        "A phase map from a picture (PNG, TIFF, HDF5); grains are labelled by \"components\" or \"watershed\" where the file has no labels. `dx`: side of a pixel.");
  m.def("cavities", [](const PhaseMap& map, const std::string& kind, bool eight_connected, int fewest_nodes, bool leave_out_border) {
    const raster::CavityRules rules{eight_connected, fewest_nodes, leave_out_border};
    const auto found = raster::find_cavities(map, study::chosen<raster::Cavity>(kind, "cavity"), rules);
    return py::array_t<std::int64_t>(static_cast<py::ssize_t>(found.nodes.size()), found.nodes.data());
  }, py::arg("map"), py::arg("kind") = "pore", py::kw_only(), py::arg("eight_connected") = false, py::arg("fewest_nodes") = 5, py::arg("leave_out_border") = true,
        "Sizes (nodes) of the pores (not grain) or voids (neither grain nor matrix) by flood fill (P III).");
  m.def("cement_sample", [](const Recipe& recipe, const Packing& packing) {
    Call call;
    return call.without_lock([&] { return study::make_cemented_sample(recipe, packing); });
  }, py::arg("recipe"), py::arg("packing"), "Cement and raster as the recipe says, with phases, pores, voids and coordination as numbers.");
  m.def("load", &loaded, py::arg("map"), py::arg("loading") = "tension", py::kw_only(), py::arg("strain") = 1e-4, py::arg("axis") = "y", py::arg("lower") = "fixed",
        py::arg("method") = "static_solve", py::arg("tolerance") = 1e-6, py::arg("moduli") = false, py::arg("failure") = false, py::arg("matrix") = "1 GPa",
        py::arg("interface") = py::none(), py::arg("particle") = py::none(), py::arg("progress") = py::none(),
        "Loads a phase map by peridynamics (P II.C): \"tension\", \"compression\" or \"shear\" by displacement of the top row. `matrix`, `interface` (E_m), `particle` (4 E_m): moduli of "
        "the bonds, Pa or text. `failure`: pulled until it breaks. `moduli`: effective moduli along both axes and in shear too.");
}

}  // namespace arenite::python
