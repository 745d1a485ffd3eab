#include <pybind11/stl.h>

#include "calls.hpp"
#include "keywords.hpp"
#include "module.hpp"
#include "workflow/identify/identify_keys.hpp"

namespace arenite::python {
namespace {

const Keywords& stiffness_keywords() {
  static const Keywords keywords(recipe::every_key<workflow::StiffnessRequest>(),
                                 {{"preload", "preload"}, {"length", "length"}, {"branch", "branch"}});
  return keywords;
}

const Keywords& adhesion_keywords() {
  static const Keywords keywords(
      recipe::every_key<workflow::AdhesionRequest>(),
      {{"stiffness", "stiffness"}, {"radii", "radii"}, {"effective_radius", "effective_radius"}});
  return keywords;
}

const Keywords& factor_keywords() {
  static const Keywords keywords(recipe::every_key<workflow::FactorRequest>(),
                                 {{"section", "section"},
                                  {"temperature_convention", "temperature_convention"},
                                  {"load_convention", "load_convention"},
                                  {"young", "young"},
                                  {"poisson", "poisson"},
                                  {"through_origin", "through_origin"},
                                  {"responsivity", "responsivity"},
                                  {"responsivity_at", "responsivity_at"},
                                  {"surface_at", "surface_at"},
                                  {"amplification", "amplification"},
                                  {"emissivity", "emissivity"},
                                  {"band", "band"}});
  return keywords;
}

template <class Request> Request request_of(const Keywords& keywords, const char* function, const py::kwargs& more) {
  Request request;
  read_keywords(request, keywords.given(function, more));
  return request;
}

py::dict stiffness(const Path& file, const py::kwargs& more) {
  const auto request = request_of<workflow::StiffnessRequest>(stiffness_keywords(), "identify_stiffness", more);
  return to_python(identify::numbers(workflow::identify_stiffness(file.string(), request)));
}

py::dict adhesion(const Path& file, const py::kwargs& more) {
  const auto request = request_of<workflow::AdhesionRequest>(adhesion_keywords(), "identify_adhesion", more);
  return to_python(identify::numbers(workflow::identify_adhesion(file.string(), request)));
}

py::dict factor(const Path& file, const py::kwargs& more) {
  const auto request = request_of<workflow::FactorRequest>(factor_keywords(), "identify_factor", more);
  return to_python(identify::numbers(workflow::identify_factor(file.string(), request)));
}

}  // namespace

void bind_identify(py::module_& m) {
  def_with_keywords(m, "identify_stiffness", &stiffness, stiffness_keywords(),
                    "Contact stiffness of every group of a file: slope of force-displacement beyond the preload, T ch. "
                    "2. The names in the dict end with their units. Quantities in SI, or text with a unit.",
                    py::arg("file"));
  def_with_keywords(m, "identify_adhesion", &adhesion, adhesion_keywords(),
                    "Separation force and surface energy sqrt(4 k F_c/r_eff) (T eq. 1.25) of every group of a file. "
                    "Quantities in SI, or text with a unit; with its standard error (value, error).",
                    py::arg("file"));
  def_with_keywords(m, "identify_factor", &factor, factor_keywords(),
                    "Thermoelastic factor A (K/Pa) of every material of a file, by the methods that its columns allow "
                    "(T 1.4). Quantities in SI, or text with a unit; with its standard error (value, error).",
                    py::arg("file"));
}

}  // namespace arenite::python
