#include <pybind11/stl.h>

#include <cmath>

#include "calls.hpp"
#include "module.hpp"
#include "study/identify.hpp"

namespace arenite::python {
namespace {

statistics::Measured measured(const py::object& value) {
  statistics::Measured m;
  if (py::isinstance<py::tuple>(value)) {
    m.value = value.cast<py::tuple>()[0].cast<double>();
    m.error = value.cast<py::tuple>()[1].cast<double>();
  } else {
    m.value = value.cast<double>();
    m.error = 0;
  }
  return m;
}

}  // namespace

void bind_identify(py::module_& m) {
  m.def("identify_stiffness", [](const std::string& file, double preload, const py::object& length) {
    study::StiffnessRequest request;
    request.curve.preload = preload;
    if (!length.is_none()) request.length = length.cast<double>();
    return from_json(identify::to_json(study::identify_stiffness(file, request)));
  }, py::arg("file"), py::kw_only(), py::arg("preload") = 1000.0, py::arg("length") = py::none(),
        "Contact stiffness of every group of a file: slope of force-displacement beyond the preload (N), T ch. 2.");
  m.def("identify_adhesion", [](const std::string& file, const py::object& stiffness, const py::object& radii) {
    study::AdhesionRequest request;
    if (!stiffness.is_none()) request.stiffness = measured(stiffness);
    if (!radii.is_none()) request.radii = radii.cast<std::pair<double, double>>();
    return from_json(identify::to_json(study::identify_adhesion(file, request)));
  }, py::arg("file"), py::kw_only(), py::arg("stiffness") = py::none(), py::arg("radii") = py::none(),
        "Separation force and surface energy sqrt(4 k F_c/r_eff) (T eq. 1.25) of every group of a file. `stiffness`: N/m, or (value, error); `radii`: of both cylinders, m.");
  m.def("identify_factor", [](const std::string& file, const py::object& section, bool half_temperature, bool half_stress) {
    study::FactorRequest request;
    if (!section.is_none()) request.section = section.cast<double>();
    request.temperature_swing = half_temperature ? study::Swing::half : study::Swing::full;
    request.stress_swing = half_stress ? study::Swing::half : study::Swing::full;
    return from_json(identify::to_json(study::identify_factor(file, request)));
  }, py::arg("file"), py::kw_only(), py::arg("section") = py::none(), py::arg("half_temperature_swing") = false, py::arg("half_stress_swing") = false,
        "Thermoelastic factor A (K/Pa) of every material of a file, by the ways that its columns allow (T 1.4). `section`: of the specimen, m^2.");
}

}  // namespace arenite::python
