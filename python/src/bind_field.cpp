#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "module.hpp"
#include "solid/cement/cement.hpp"
#include "solid/grid/grid.hpp"
#include "workflow/field_stages.hpp"

namespace arenite::python {
namespace {

using recipe::Recipe;

Cement cemented(const Packing& packing, const std::string& kind, const Quantity& gap, const Quantity& width,
                bool full_width, const Quantity& thickness, const Quantity& volume,
                const std::optional<Quantity>& saturation, const Quantity& crop) {
  cement::CementParameters p;
  p.kind = recipe::chosen<cement::CementParameters::Kind>(kind, "cement");
  p.gap = gap.si(dimension::length, "gap");
  p.width = width.si(dimension::none, "width");
  p.full_width = full_width;
  p.thickness = thickness.si(dimension::length, "thickness");
  p.volume = volume.si(dimension::area, "volume");
  p.saturation = si(saturation, dimension::none, "saturation");
  const double side = crop.si(dimension::length, "crop");
  Call call;
  return call.without_lock([&] {
    cement::CementReport report;
    return cement::make_cement(packing, p, grid::crop_window(packing, side), report);
  });
}

PhaseMap rasterised(const Packing& packing, const Cement& cement, std::int64_t nodes, const Quantity& crop) {
  grid::GridParameters p;
  p.nodes = nodes;
  p.crop = crop.si(dimension::length, "crop");
  Call call;
  return call.without_lock([&] {
    grid::GridReport report;
    return grid::rasterise(packing, cement, p, workflow::classes(packing, workflow::class_materials({}, packing)),
                           report);
  });
}

FieldResult loaded(const PhaseMap& map, const std::string& loading, const Quantity& strain, const std::string& axis,
                   const std::string& lower, const std::string& method, const Quantity& tolerance, bool moduli,
                   bool failure, const Quantity& matrix, const std::optional<Quantity>& interface,
                   const std::optional<Quantity>& particle, bool stop_at_voids, const Quantity& toughness,
                   const std::optional<Quantity>& strength, bool cracks_stay_open, const Quantity& max_strain,
                   const Progress& progress) {
  using peridynamics::Loading, peridynamics::LowerEdge, peridynamics::Method;
  recipe::Load load;
  load.name = failure ? "failure" : loading;
  load.loading = recipe::chosen<Loading>(loading, "loading");
  load.axis = recipe::chosen<recipe::Load::Axis>(axis, "axis");
  load.lower = recipe::chosen<LowerEdge>(lower, "lower edge");
  load.method = recipe::chosen<Method>(method, "method");
  load.strain = strain.si(dimension::none, "strain");
  load.tolerance = tolerance.si(dimension::none, "tolerance");
  load.moduli = moduli;
  load.failure = failure;
  load.stiffness.matrix = matrix.si(dimension::pressure, "matrix");
  load.stiffness.interface = si(interface, dimension::pressure, "interface");
  load.stiffness.particle = si(particle, dimension::pressure, "particle");
  load.stop_at_voids = stop_at_voids;
  load.toughness.matrix = toughness.si(dimension::toughness, "toughness");
  load.strength.matrix = si(strength, dimension::pressure, "strength");
  load.cracks_stay_open = cracks_stay_open;
  load.max_strain = max_strain.si(dimension::none, "max_strain");
  Call call;
  auto result = call.without_lock([&] {
    const peridynamics::Watch watch = [&](const auto& at) {
      call.tell(progress, at.share, load.name);
      return !call.asked_to_stop();
    };
    return workflow::apply_load(load, workflow::sample_of_map(map), watch);
  });
  return result ? std::move(*result) : FieldResult{};
}

}  // namespace

void bind_field(py::module_& m) {
  m.def("cement", &cemented, py::arg("packing"), py::arg("kind") = "bridges", py::kw_only(), py::arg("gap") = 0.0,
        py::arg("width") = 0.4, py::arg("full_width") = false, py::arg("thickness") = 0.0, py::arg("volume") = 0.0,
        py::arg("saturation") = py::none(), py::arg("crop") = 0.0,
        "Matrix between grains: kind \"bridges\" (surface gap up to `gap`, half base `width` times the radius: P "
        "II.B), \"full\", \"coating\" (`thickness`), \"menisci\" (`volume`, m^2 each) or \"none\". With `saturation` "
        "the free parameter is computed so that S_m has this value in the centred square of side `crop` (0: the "
        "largest that fits), as in recipes; give `rasterise` the same. Lengths in m, or text with a unit.");
  m.def("rasterise", &rasterised, py::arg("packing"), py::arg("cement"), py::kw_only(), py::arg("nodes") = 1024,
        py::arg("crop") = 0.0,
        "The centred square of side `crop` (m; 0: the largest that fits) as nodes x nodes, by phase and grain. The "
        "material with the larger grains is class large.");
  m.def(
      "cavities",
      [](const PhaseMap& map, const std::string& kind, bool eight_connected, int fewest_nodes, bool leave_out_border) {
        const grid::CavityRules rules{eight_connected, fewest_nodes, leave_out_border};
        Call call;
        return taken_over(call.without_lock([&] {
                                return grid::find_cavities(map, recipe::chosen<grid::Cavity>(kind, "cavity"), rules);
                              })
                              .nodes);
      },
      py::arg("map"), py::arg("kind") = "pore", py::kw_only(), py::arg("eight_connected") = false,
      py::arg("fewest_nodes") = 5, py::arg("leave_out_border") = true,
      "Sizes (nodes, int64) of the pores (not grain) or voids (neither grain nor matrix) by flood fill (P III).");
  m.def(
      "cement_sample",
      [](const Recipe& recipe, const Packing& packing) {
        Call call;
        return call.without_lock([&] { return workflow::make_cemented_sample(recipe, packing); });
      },
      py::arg("recipe"), py::arg("packing"),
      "Cement and grid according to the recipe, with phases, pores, voids and coordination as numbers.");
  m.def("load", &loaded, py::arg("map"), py::arg("loading") = "tension", py::kw_only(), py::arg("strain") = 1e-4,
        py::arg("axis") = "y", py::arg("lower") = "fixed", py::arg("method") = "static_solve",
        py::arg("tolerance") = 1e-6, py::arg("moduli") = false, py::arg("failure") = false, py::arg("matrix") = "1 GPa",
        py::arg("interface") = py::none(), py::arg("particle") = py::none(), py::arg("stop_at_voids") = false,
        py::arg("toughness") = "0.1 MPa m^0.5", py::arg("strength") = py::none(), py::arg("cracks_stay_open") = false,
        py::arg("max_strain") = 0.1, py::arg("progress") = py::none(),
        "Loads a phase map by peridynamics (P II.C): \"tension\", \"compression\" or \"shear\" by displacement of the "
        "top row. `matrix`, `interface` (E_m), `particle` (4 E_m): moduli of the bonds, Pa or text. `stop_at_voids`: "
        "no bond passes through a void node. `failure`: loaded to failure, with `toughness` and, if given, `strength` "
        "of the matrix and the interfaces (3.5 times as much in particles), to `max_strain` at most; faces that have "
        "parted push where they meet again, unless `cracks_stay_open`. `moduli`: also apparent moduli along both axes "
        "and in shear, between rigid clamps.");
}

}  // namespace arenite::python
