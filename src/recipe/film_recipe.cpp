#include "recipe/film_recipe.hpp"

#include <filesystem>

#include "core/error.hpp"
#include "io/read_file.hpp"
#include "recipe/recipe_document.hpp"
#include "recipe/film_recipe_keys.hpp"
#include "recipe/recipe_reader.hpp"
#include "recipe/recipe_record.hpp"

namespace arenite::study {
namespace {

Visit declaration_of(FilmRecipe& recipe) {
  return [&recipe](ParameterVisitor& visitor) { declare(visitor, recipe); };
}

bool of_simulation(const Node& root) { return root.find("packing") || root.find("populations") || root.find("stages"); }

/// A recipe of a simulation has most of its keys wrong as one of a film; that it is the wrong kind helps more than their list.
void refuse_simulations(const Node& root, const std::string& file) {
  if (!root.find("lockin") && of_simulation(root))
    throw InputError(file, 0, "is a recipe of a simulation (`arenite run`), not of a film; `arenite init film r.toml` writes one of a film");
}

FilmRecipe read_from(std::string_view text, Reading& reading, const std::vector<std::string>& overrides) {
  const Node root = read_tree(text, reading, overrides, "film");
  refuse_simulations(root, reading.file_name);
  FilmRecipe recipe;
  recipe.source_file = reading.file_name;
  read_declared(root, reading, declaration_of(recipe));
  return recipe;
}

}  // namespace

bool describes_film(std::string_view text) {
  try {
    const Node root = read_document(text, {});
    return !of_simulation(root) && (root.find("lockin") || root.find("picture") || root.find("camera"));
  } catch (const InputError&) {
    return false;
  }
}

std::vector<double> emissivities(const FilmRecipe& recipe) {
  std::vector<double> all;
  for (const FilmMaterial& m : recipe.materials) all.push_back(m.emissivity.value_or(recipe.temperature.emissivity.value_or(0.9)));
  return all;
}

bool has_plates(const FilmRecipe& recipe) {
  const CorrectionSection& c = recipe.correction;
  return recipe.temperature.from != TemperatureSection::From::plates ||
         (!c.cold.empty() && !c.warm.empty() && c.cold_temperature > 0 && c.warm_temperature > c.cold_temperature);
}

FilmRecipe read_film_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  Reading reading{file, std::filesystem::path(file).parent_path().string(), true, {}};
  return read_from(io::read_file(file), reading, overrides);
}

FilmRecipe parse_film_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides) {
  Reading reading{file_name, {}, false, {}};
  return read_from(text, reading, overrides);
}

std::string to_toml(const FilmRecipe& recipe) {
  FilmRecipe copy = recipe;
  return write_toml(record_of(declaration_of(copy)));
}

std::string to_commented_toml(const FilmRecipe& recipe) {
  FilmRecipe copy = recipe, defaults;
  return write_commented_toml(record_of(declaration_of(copy)), record_of_all_keys(declaration_of(defaults)));
}

std::string film_key_reference() {
  FilmRecipe defaults;
  return "# The recipe of a film\n\n"
         "What `arenite film` and `arenite camera` are told beside the film itself. It is written as every recipe\n"
         "([recipe.md](recipe.md)): TOML, quantities with their units, every problem reported at once. `arenite init film` writes a\n"
         "commented one to start from. This page is generated: `arenite man --film-keys`.\n\n" +
         write_key_tables(record_of_all_keys(declaration_of(defaults)));
}

FilmRecipe film_template() {
  FilmRecipe recipe;
  recipe.title = "Cylinders of POM and HDPE, cycled between 6 and 60 kN at 3 Hz";
  recipe.materials = {{"HDPE", 0.0258e-6, 0.9, {}}, {"POM", 0.0150e-6, 0.1, {}}};
  recipe.frame.width = recipe.frame.height = 0.35;
  recipe.frame.thickness = 0.06;
  recipe.frame.load_swing = 54e3;
  recipe.picture.pixel = 1.6e-3;
  recipe.temperature.from = TemperatureSection::From::film;
  recipe.lockin.frequency = 3;
  return recipe;
}

}  // namespace arenite::study
