#include <exception>

#include "core/error.hpp"
#include "core/option.hpp"
#include "core/version.hpp"
#include "file_notes.hpp"
#include "module.hpp"
#include "option_names.hpp"
#include "statistics/numbers.hpp"

PYBIND11_MODULE(_core, m) {
  namespace py = pybind11;
  m.doc() =
      "Micromechanics of composite and cemented granular materials. All numbers are in SI units; stresses are positive "
      "in tension, contact forces in compression.";
  m.attr("__version__") = arenite::version;
  arenite::word_options(arenite::python::argument_of);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const arenite::InputError& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    } catch (const arenite::NumbersError&) {
      PyErr_SetString(
          PyExc_ValueError,
          "the numbers stored in the result are not those that this version writes; compute the result again");
    }
  });
  // What is given comes before what takes it, so that docstrings name types as Python does.
  arenite::python::bind_file_notes(m);
  arenite::python::bind_packing(m);
  arenite::python::bind_spheres(m);
  arenite::python::bind_texture(m);
  arenite::python::bind_grain_fields(m);
  arenite::python::bind_chains(m);
  arenite::python::bind_recipe(m);
  arenite::python::bind_phase_map(m);
  arenite::python::bind_voxels(m);
  arenite::python::bind_maps(m);
  arenite::python::bind_film(m);
  arenite::python::bind_film_parts(m);
  arenite::python::bind_film_workflow(m);
  arenite::python::bind_results(m);
  arenite::python::bind_curves(m);
  arenite::python::bind_over_runs(m);
  arenite::python::bind_drawn_numbers(m);
  arenite::python::bind_figures(m);
  arenite::python::bind_pictures(m);
  arenite::python::bind_store(m);
  arenite::python::bind_running_stage(m);
  arenite::python::bind_stages(m);
  arenite::python::bind_field(m);
  arenite::python::bind_identify(m);
  arenite::python::bind_study(m);
}
