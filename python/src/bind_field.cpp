#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "keywords.hpp"
#include "load_keywords.hpp"
#include "model/grain_classes.hpp"
#include "module.hpp"
#include "solid/cement/cement.hpp"
#include "solid/grid/rasterise.hpp"
#include "workflow/apply_load.hpp"
#include "workflow/cemented_sample.hpp"
#include "workflow/read_map.hpp"

namespace arenite::python {
namespace {

using recipe::Recipe;

/// Declared sections of a recipe that are read together.
struct CementSection {
  cement::CementParameters law;
  recipe::GridSection grid;
};
void declare(ParameterVisitor& v, CementSection& section) {
  recipe::declare(v, section.law, 2);
  recipe::declare(v, section.grid);
}

const Keywords& cement_keywords() {
  static const Keywords keywords(recipe::every_key<CementSection>(), {{"kind", "kind", "", true},
                                                                      {"gap", "gap"},
                                                                      {"width", "width"},
                                                                      {"full_width", "full_width"},
                                                                      {"thickness", "thickness"},
                                                                      {"volume", "volume"},
                                                                      {"saturation", "saturation"},
                                                                      {"crop", "crop"}});
  return keywords;
}

Cement cemented(const Packing& packing, const std::string& kind, const py::kwargs& more) {
  auto given = cement_keywords().given("cement", more);
  given.push_back(cement_keywords().given("kind", py::str(kind)));
  CementSection section;
  read_keywords(section, given);
  Call call;
  return call.without_lock([&] {
    cement::CementReport report;
    return cement::make_cement(packing, section.law, grid::crop_window(packing, section.grid.crop.value_or(0)), report);
  });
}

const Keywords& grid_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::GridSection>(), {{"nodes", "nodes"}, {"crop", "crop"}});
  return keywords;
}

PhaseMap rasterised(const Packing& packing, const Cement& cement, const py::kwargs& more) {
  recipe::GridSection grid;
  read_keywords(grid, grid_keywords().given("rasterise", more));
  const grid::GridParameters p{grid.nodes, grid.crop.value_or(0)};
  Call call;
  return call.without_lock([&] {
    grid::GridReport report;
    return grid::rasterise(packing, cement, p, classes_of(packing, classes_by_radius(packing)), report);
  });
}

const Keywords& cavity_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::GridSection>(), {{"eight_connected", "eight_connected"},
                                                                            {"fewest_nodes", "fewest_nodes"},
                                                                            {"leave_out_border", "leave_out_border"}});
  return keywords;
}

py::array_t<std::int64_t> cavities(const PhaseMap& map, const std::string& kind, const py::kwargs& more) {
  recipe::GridSection grid;
  read_keywords(grid, cavity_keywords().given("cavities", more));
  const auto what = recipe::chosen<grid::Cavity>(kind, "cavity");
  Call call;
  return taken_over(call.without_lock([&] { return grid::find_cavities(map, what, grid.cavities); }).nodes);
}

FieldResult loaded(const PhaseMap& map, const std::string& loading, const Progress& progress, const py::kwargs& more) {
  const recipe::Load load = load_of("load", loading, more);
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
  def_with_keywords(
      m, "cement", &cemented, cement_keywords(),
      "Matrix between the grains of a packing (P II.B). With `saturation` the free parameter is computed so "
      "that it holds in the square of side `crop`, as in recipes; give `rasterise` the same. Lengths in m, or text "
      "with "
      "a unit.",
      py::arg("packing"), py::arg("kind") = recipe::word_of(cement::CementParameters{}.kind));
  def_with_keywords(
      m, "rasterise", &rasterised, grid_keywords(),
      "The centred square of a packing as nodes x nodes, by phase and grain. The material with the larger "
      "grains is class large. Lengths in m, or text with a unit.",
      py::arg("packing"), py::arg("cement"));
  def_with_keywords(
      m, "cavities", &cavities, cavity_keywords(),
      "Sizes (nodes, int64) of the pores (not grain) or voids (neither grain nor matrix) by flood fill (P "
      "III).",
      py::arg("map"), py::arg("kind") = "pore");
  m.def(
      "cement_sample",
      [](const Recipe& recipe, const Packing& packing) {
        Call call;
        return call.without_lock([&] { return workflow::make_cemented_sample(recipe, packing); });
      },
      py::arg("recipe"), py::arg("packing"),
      "Cement and grid according to the recipe, with phases, pores, voids and coordination as numbers.");
  def_with_keywords(m, "load", &loaded, load_keywords(),
                    "Loads a phase map by peridynamics (P II.C) by displacement of its top row. What is not given of "
                    "interfaces and particles follows from the matrix as in recipes. Quantities in SI, or text with a "
                    "unit.",
                    py::arg("map"), py::arg("loading") = recipe::word_of(recipe::Load{}.loading), py::kw_only(),
                    py::arg("progress") = py::none());
}

}  // namespace arenite::python
