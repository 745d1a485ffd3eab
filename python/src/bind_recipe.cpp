#include <fmt/core.h>
#include <pybind11/stl.h>

#include "calls.hpp"
#include "module.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::python {
namespace {

using recipe::FilmRecipe;
using recipe::Recipe;

Recipe from_template(const std::string& name, const py::dict& changes) {
  std::string known;
  for (const auto& each : recipe::recipe_templates()) {
    if (name == each.name) return recipe::parse_recipe(recipe::to_toml(each.make()), name, overrides_of(changes));
    known += (known.empty() ? "" : ", ") + std::string(each.name);
  }
  if (name == "film") throw InputError("the template \"film\" is for films; use FilmRecipe.template()");
  throw InputError(fmt::format("there is no template \"{}\"; there are {}", name, known));
}

/// Files that the recipe names are looked for beside the file that it came from, so that stays its name.
Recipe changed(const Recipe& recipe, const py::dict& changes) {
  Recipe result = recipe::parse_recipe(recipe::to_toml(recipe), recipe.source_file, overrides_of(changes));
  result.source_file = recipe.source_file;
  return result;
}

/// As for recipes of packings: films of references and the recipe of the companion simulation lie beside the file.
FilmRecipe changed(const FilmRecipe& recipe, const py::dict& changes) {
  FilmRecipe result = recipe::parse_film_recipe(recipe::to_toml(recipe), recipe.source_file, overrides_of(changes));
  result.source_file = recipe.source_file;
  return result;
}

void bind_film_recipe(py::module_& m) {
  py::class_<FilmRecipe>(m, "FilmRecipe",
                         "Input of `arenite film` and `arenite camera`: materials, container, picture, correction, "
                         "temperature, lock-in, forces, simulation, camera (docs/film-recipe.md).")
      .def(py::init([](const Path& file, const py::dict& changes) {
             return recipe::read_film_recipe(file.string(), overrides_of(changes));
           }),
           py::arg("file"), py::arg("changes") = py::dict(),
           "Reads a film's recipe from a file; `changes` as for Recipe.")
      .def_static(
          "template",
          [](const py::dict& changes) {
            return recipe::parse_film_recipe(recipe::to_toml(recipe::film_template()), "film", overrides_of(changes));
          },
          py::arg("changes") = py::dict(), "The template that `arenite init film` writes.")
      .def_static(
          "from_text",
          [](const std::string& text, const py::dict& changes) {
            return recipe::parse_film_recipe(text, "recipe", overrides_of(changes));
          },
          py::arg("text"), py::arg("changes") = py::dict(), "A film's recipe from TOML text.")
      .def("changed", py::overload_cast<const FilmRecipe&, const py::dict&>(&changed), py::arg("changes"),
           "The same recipe with these keys changed.")
      .def(
          "toml", [](const FilmRecipe& r) { return recipe::to_toml(r); },
          "The resolved recipe as TOML, every key with its unit.")
      .def_readonly("title", &FilmRecipe::title, "As pages show it.")
      .def_readonly("seed", &FilmRecipe::seed, "Seed of the virtual camera's noise.")
      .def(
          "__eq__", [](const FilmRecipe& a, const FilmRecipe& b) { return recipe::to_toml(a) == recipe::to_toml(b); },
          py::is_operator(), py::arg("other"), "Whether all keys are equal.")
      .def("__repr__", [](const FilmRecipe& r) { return "<arenite.FilmRecipe \"" + r.title + "\">"; });
}

}  // namespace

void bind_recipe(py::module_& m) {
  bind_film_recipe(m);
  py::class_<Recipe>(
      m, "Recipe",
      "Input of `arenite run`: materials, container, packing, stages of loading, cement, grid, loads (docs/recipe.md).")
      .def(py::init([](const Path& file, const py::dict& changes) {
             return recipe::read_recipe(file.string(), overrides_of(changes));
           }),
           py::arg("file"), py::arg("changes") = py::dict(),
           "Reads a recipe from a file; `changes` are {\"dotted.key\": value}, with units in text: "
           "{\"container.width\": \"35 cm\"}.")
      .def_static("template", &from_template, py::arg("name"), py::arg("changes") = py::dict(),
                  "A template; `templates()` lists them.")
      .def_static(
          "from_text",
          [](const std::string& text, const py::dict& changes) {
            return recipe::parse_recipe(text, "recipe", overrides_of(changes));
          },
          py::arg("text"), py::arg("changes") = py::dict(), "A recipe from TOML text.")
      .def("changed", py::overload_cast<const Recipe&, const py::dict&>(&changed), py::arg("changes"),
           "The same recipe with these keys changed.")
      .def(
          "toml", [](const Recipe& r) { return recipe::to_toml(r); },
          "The resolved recipe as TOML, every key with its unit.")
      .def_readonly("title", &Recipe::title, "As pages show it.")
      .def_readonly("seed", &Recipe::seed, "Seed of all random numbers.")
      .def_property_readonly(
          "stages",
          [](const Recipe& r) {
            std::vector<std::string> names;
            for (const auto& stage : r.stages) names.push_back(stage.name);
            return names;
          },
          "Names of the stages of loading.")
      .def_property_readonly(
          "loads",
          [](const Recipe& r) {
            std::vector<std::string> names;
            for (const auto& load : r.loads) names.push_back(load.name);
            return names;
          },
          "Names of the loads of the cemented sample.")
      .def(
          "__eq__", [](const Recipe& a, const Recipe& b) { return recipe::to_toml(a) == recipe::to_toml(b); },
          py::is_operator(), py::arg("other"), "Whether all keys are equal.")
      .def("__repr__", [](const Recipe& r) { return "<arenite.Recipe \"" + r.title + "\">"; });
  m.def(
      "templates",
      [] {
        py::dict d;
        for (const auto& each : recipe::recipe_templates()) d[each.name] = each.sentence;
        return d;
      },
      "Names of the templates, with a sentence each.");
}

}  // namespace arenite::python
