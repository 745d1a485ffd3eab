#include "recipe/recipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "recipe/document.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/keys.hpp"
#include "recipe/reader.hpp"
#include "recipe/writer.hpp"

namespace arenite::recipe {
namespace {

/// The declaration of a recipe of which a visitor sees, or sets, the keys.
Visit declaration_of(Recipe& recipe) {
  return [&recipe](ParameterVisitor& visitor) { declare(visitor, recipe); };
}

Recipe read_from(std::string_view text, Reading& reading, const std::vector<std::string>& overrides) {
  Recipe recipe;
  recipe.source_file = reading.file_name;
  Node root = read_tree(text, reading, overrides, "composite");
  const auto sweep = std::find_if(root.entries.begin(), root.entries.end(), [](const Entry& entry) { return entry.key == "sweep"; });
  if (sweep != root.entries.end()) {
    reading.problems.push_back({reading.file_name, sweep->place.line, sweep->place.column,
                                fmt::format("sweep: this recipe is a study of many runs; `arenite study plan {0}` shows them, "
                                            "`arenite study run {0}` runs them",
                                            reading.file_name)});
    root.entries.erase(sweep);
  }
  read_declared(root, reading, declaration_of(recipe));
  recipe.notices = reading.notices;
  return recipe;
}

}  // namespace

CementSection Recipe::cement_or_none() const {
  CementSection none;
  none.law.kind = cement::CementParameters::Kind::none;
  return cement.value_or(none);
}

Recipe recipe_from(const Node& root, const std::string& file) {
  Reading reading{file, std::filesystem::path(file).parent_path().string(), true, {}};
  Recipe recipe;
  recipe.source_file = file;
  read_declared(root, reading, declaration_of(recipe));
  return recipe;
}

Recipe read_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  Reading reading{file, std::filesystem::path(file).parent_path().string(), true, {}};
  return read_from(io::read_file(file), reading, overrides);
}

Recipe parse_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides) {
  Reading reading{file_name, {}, false, {}};
  return read_from(text, reading, overrides);
}

std::string to_toml(const Recipe& recipe) {
  Recipe copy = recipe;
  return write_toml(record_of(declaration_of(copy)));
}

std::string changed_keys(const Recipe& recipe) {
  static const RecordTable all = [] {
    Recipe defaults;
    return record_of_all_keys(declaration_of(defaults));
  }();
  Recipe copy = recipe;
  return write_changes(record_of(declaration_of(copy)), all);
}

std::string to_commented_toml(const Recipe& recipe) {
  Recipe copy = recipe, defaults;
  return write_commented_toml(record_of(declaration_of(copy)), record_of_all_keys(declaration_of(defaults)));
}

std::string title_in(const std::string& text) {
  try {
    const Node root = read_document(text, {});
    const Entry* title = root.find("title");
    return title && title->value.kind == Node::Kind::text ? title->value.text : "";
  } catch (const InputError&) { return {}; }
}

std::string key_reference() {
  Recipe defaults;
  return "# The recipe\n\n"
         "A recipe is a TOML file. Quantities are texts with their unit (`\"27.35 kN/mm\"`, `\"350 mm\"`, `\"30 %\"`); units are\n"
         "products, quotients and powers of m, g, s, K, N, Pa, J, W, Hz, bar, t, min, h, deg and % with the SI prefixes, and any\n"
         "unit of the right dimension will do. A bare number where a unit is needed, an unknown key and a value out of range are\n"
         "errors, all of them reported at once with their places. `arenite check RECIPE.toml` prints the recipe as it was\n"
         "understood, `arenite init composite` a commented one to start from, and `--set stages.0.bottom.force=\"60 kN\"` changes a\n"
         "key for one run (items of lists are counted from 0). A section [sweep] makes many runs of one recipe:\n"
         "[studies.md](studies.md).\n\n"
         "`base = \"../paper/recipe.toml\"`, before any section, lays a recipe over another, looked for beside it, which may have a\n"
         "base of its own. Sections are merged key by key; any other value and whole lists such as `[[stages]]` count as they are\n"
         "given here, where they are. The base's [sweep] is left out, and files that the base names are looked for beside the recipe\n"
         "that is laid over it.\n\n"
         "This page is generated from the declarations that the program reads recipes with: `arenite man --keys`.\n\n" +
         write_key_tables(record_of_all_keys(declaration_of(defaults)));
}

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

FilmRecipe read_film_from(std::string_view text, Reading& reading, const std::vector<std::string>& overrides) {
  const Node root = read_tree(text, reading, overrides, "film");
  refuse_simulations(root, reading.file_name);
  FilmRecipe recipe;
  recipe.source_file = reading.file_name;
  read_declared(root, reading, declaration_of(recipe));
  recipe.notices = reading.notices;
  return recipe;
}

}  // namespace

bool describes_film(std::string_view text) {
  try {
    const Node root = read_document(text, {});
    return !of_simulation(root) && (root.find("lockin") || root.find("picture") || root.find("camera"));
  } catch (const InputError&) { return false; }
}

std::vector<double> emissivities(const FilmRecipe& recipe) {
  std::vector<double> all;
  for (const FilmMaterial& m : recipe.materials) all.push_back(m.emissivity.value_or(recipe.temperature.emissivity.value_or(0.9)));
  return all;
}

bool has_references(const FilmRecipe& recipe) {
  const CorrectionSection& c = recipe.correction;
  return recipe.temperature.from != TemperatureSection::From::references ||
         (!c.cold.empty() && !c.warm.empty() && c.cold_temperature > 0 && c.warm_temperature > c.cold_temperature);
}

FilmRecipe read_film_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  Reading reading{file, std::filesystem::path(file).parent_path().string(), true, {}};
  return read_film_from(io::read_file(file), reading, overrides);
}

FilmRecipe parse_film_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides) {
  Reading reading{file_name, {}, false, {}};
  return read_film_from(text, reading, overrides);
}

std::string to_toml(const FilmRecipe& recipe) {
  FilmRecipe copy = recipe;
  return write_toml(record_of(declaration_of(copy)));
}

std::string changed_keys(const FilmRecipe& recipe) {
  static const RecordTable all = [] {
    FilmRecipe defaults;
    return record_of_all_keys(declaration_of(defaults));
  }();
  FilmRecipe copy = recipe;
  return write_changes(record_of(declaration_of(copy)), all);
}

std::string to_commented_toml(const FilmRecipe& recipe) {
  FilmRecipe copy = recipe, defaults;
  return write_commented_toml(record_of(declaration_of(copy)), record_of_all_keys(declaration_of(defaults)));
}

std::string film_key_reference() {
  FilmRecipe defaults;
  return "# The recipe of a film\n\n"
         "What `arenite film` and `arenite camera` are given beside the film itself. It is written as every recipe\n"
         "([recipe.md](recipe.md)): TOML, quantities with their units, every problem reported at once. `arenite init film` writes a\n"
         "commented one to start from. This page is generated: `arenite man --film-keys`.\n\n" +
         write_key_tables(record_of_all_keys(declaration_of(defaults)));
}

FilmRecipe film_template() {
  FilmRecipe recipe;
  recipe.title = "Cylinders of POM and HDPE, cycled between 6 and 60 kN at 3 Hz";
  recipe.materials = {{"HDPE", 0.0258e-6, 0.9, {}}, {"POM", 0.0150e-6, 0.1, {}}};
  recipe.container.width = recipe.container.height = 0.35;
  recipe.container.thickness = 0.06;
  recipe.container.load_peak_to_peak = 54e3;
  recipe.picture.pixel = 1.6e-3;
  recipe.temperature.from = TemperatureSection::From::film;
  recipe.lockin.frequency = 3;
  return recipe;
}

}  // namespace arenite::recipe
