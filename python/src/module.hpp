#pragma once
#include <pybind11/pybind11.h>

/// The Python module, one file a part of the workflow; every part binds plain functions and the data that they take and
/// give.
namespace arenite::python {

void bind_packing(pybind11::module_& m);
void bind_texture(pybind11::module_& m);
void bind_grain_fields(pybind11::module_& m);
void bind_chains(pybind11::module_& m);
void bind_recipe(pybind11::module_& m);
void bind_phase_map(pybind11::module_& m);
void bind_voxels(pybind11::module_& m);
void bind_spheres(pybind11::module_& m);
void bind_maps(pybind11::module_& m);
void bind_film(pybind11::module_& m);
void bind_film_parts(pybind11::module_& m);
void bind_results(pybind11::module_& m);
void bind_curves(pybind11::module_& m);
void bind_over_runs(pybind11::module_& m);
void bind_drawn_numbers(pybind11::module_& m);
void bind_figures(pybind11::module_& m);
void bind_pictures(pybind11::module_& m);
void bind_store(pybind11::module_& m);
void bind_running_stage(pybind11::module_& m);
void bind_stages(pybind11::module_& m);
void bind_field(pybind11::module_& m);
void bind_film_workflow(pybind11::module_& m);
void bind_identify(pybind11::module_& m);
void bind_study(pybind11::module_& m);

}  // namespace arenite::python
