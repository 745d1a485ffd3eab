#include <fmt/core.h>
#include <pybind11/stl.h>

#include <cmath>

#include "calls.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "module.hpp"
#include "workflow/identify_curves.hpp"
#include "workflow/identify_factor.hpp"

namespace arenite::python {
namespace {

std::optional<statistics::Measured> measured(const std::optional<MeasuredLike>& value, Dimension wanted,
                                             const std::string& name) {
  if (!value) return std::nullopt;
  statistics::Measured m;
  m.error = 0;
  if (!py::isinstance<py::tuple>(*value) && !py::isinstance<py::list>(*value)) {
    m.value = Quantity(*value).si(wanted, name);
    return m;
  }
  if (py::len(*value) != 2) throw InputError(name + ": give a number, or a pair (value, error)");
  m.value = Quantity((*value)[py::int_(0)]).si(wanted, name);
  m.error = Quantity((*value)[py::int_(1)]).si(wanted, name);
  return m;
}

/// 151.4e-6, "151.4 mm^2" or "30.9 mm x 4.9 mm".
std::optional<double> section_of(const std::optional<Quantity>& section) {
  if (!section || !py::isinstance<py::str>(*section)) return si(section, dimension::area, "section");
  const auto text = section->cast<std::string>();
  const auto times = text.find(" x ");
  if (times == std::string::npos) return section->si(dimension::area, "section");
  return parse_si(text.substr(0, times), dimension::length) * parse_si(text.substr(times + 3), dimension::length);
}

py::dict stiffness(const Path& file, const Quantity& preload, const std::optional<Quantity>& length,
                   const std::string& branch) {
  if (branch != "loading" && branch != "unloading")
    throw InputError(fmt::format("branch is \"{}\"; give \"loading\" or \"unloading\"", branch));
  workflow::StiffnessRequest request;
  request.curve = {preload.si(dimension::force, "preload"),
                   branch == "unloading" ? identify::Branch::unloading : identify::Branch::loading};
  request.length = si(length, dimension::length, "length");
  return to_python(identify::numbers(workflow::identify_stiffness(file.string(), request)));
}

py::dict adhesion(const Path& file, const std::optional<MeasuredLike>& stiffness,
                  const std::optional<std::pair<Quantity, Quantity>>& radii) {
  workflow::AdhesionRequest request;
  request.stiffness = measured(stiffness, dimension::stiffness, "stiffness");
  if (radii)
    request.radii = {radii->first.si(dimension::length, "radii"), radii->second.si(dimension::length, "radii")};
  return to_python(identify::numbers(workflow::identify_adhesion(file.string(), request)));
}

py::dict factor(const Path& file, const std::optional<Quantity>& section, bool temperature_amplitudes,
                bool load_amplitudes, const std::optional<MeasuredLike>& young,
                const std::optional<MeasuredLike>& poisson, bool through_origin) {
  workflow::FactorRequest request;
  request.section = section_of(section);
  if (temperature_amplitudes) request.temperature = AmplitudeConvention::amplitude;
  if (load_amplitudes) request.load = AmplitudeConvention::amplitude;
  request.young = measured(young, dimension::pressure, "young");
  request.poisson = measured(poisson, dimension::none, "poisson");
  if (request.poisson && !(request.poisson->value < 1)) throw InputError("poisson: must be below 1");
  request.through_origin = through_origin;
  return to_python(identify::numbers(workflow::identify_factor(file.string(), request)));
}

}  // namespace

void bind_identify(py::module_& m) {
  m.def("identify_stiffness", &stiffness, py::arg("file"), py::kw_only(), py::arg("preload") = 1000.0,
        py::arg("length") = py::none(), py::arg("branch") = "loading",
        "Contact stiffness of every group of a file: slope of force-displacement beyond the preload (N, or text with a "
        "unit), T ch. 2; also per length of the cylinders if `length` (m) is given. The names in the dict end with "
        "their units.");
  m.def("identify_adhesion", &adhesion, py::arg("file"), py::kw_only(), py::arg("stiffness") = py::none(),
        py::arg("radii") = py::none(),
        "Separation force and surface energy sqrt(4 k F_c/r_eff) (T eq. 1.25) of every group of a file. `stiffness`: "
        "N/m, or (value, error); `radii`: of both cylinders, m; or text with units.");
  m.def("identify_factor", &factor, py::arg("file"), py::kw_only(), py::arg("section") = py::none(),
        py::arg("temperature_amplitudes") = false, py::arg("load_amplitudes") = false, py::arg("young") = py::none(),
        py::arg("poisson") = py::none(), py::arg("through_origin") = false,
        "Thermoelastic factor A (K/Pa) of every material of a file, by the methods that its columns allow (T 1.4). "
        "Columns hold peak-to-peak values unless `temperature_amplitudes` or `load_amplitudes`. `section`: of the "
        "specimen, m^2 or \"30.9 mm x 4.9 mm\"; `young` (Pa) and `poisson` if the file gives strains: a number, or "
        "(value, error).");
}

}  // namespace arenite::python
