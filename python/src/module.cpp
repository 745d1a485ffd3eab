#include "core/error.hpp"
#include "core/version.hpp"
#include "module.hpp"
#include "sentences.hpp"
#include "statistics/numbers.hpp"

PYBIND11_MODULE(_core, m) {
  namespace py = pybind11;
  m.doc() = "Micromechanics of composite and cemented granular materials. All numbers are in SI units; stresses are positive in tension, "
            "contact forces in compression.";
  m.attr("__version__") = arenite::version;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const arenite::InputError& error) {
      PyErr_SetString(PyExc_ValueError, arenite::python::with_arguments(error.what()).c_str());
    } catch (const arenite::NumbersError&) {
      PyErr_SetString(PyExc_ValueError, "the numbers stored in the result are not those that this version writes; make the result again");
    }
  });
  // What is given comes before what takes it, so that docstrings name types as Python does.
  arenite::python::bind_packing(m);
  arenite::python::bind_texture(m);
  arenite::python::bind_recipe(m);
  arenite::python::bind_phase_map(m);
  arenite::python::bind_maps(m);
  arenite::python::bind_film(m);
  arenite::python::bind_film_parts(m);
  arenite::python::bind_film_road(m);
  arenite::python::bind_results(m);
  arenite::python::bind_store(m);
  arenite::python::bind_stages(m);
  arenite::python::bind_field(m);
  arenite::python::bind_identify(m);
  arenite::python::bind_study(m);
}
