#include "recipe/recipe.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "io/table/table.hpp"
#include "recipe/document.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/templates.hpp"

namespace arenite::recipe {

namespace fs = std::filesystem;

namespace {

void lay_under(Node& own, Node&& base) {
  for (Entry& entry : base.entries) {
    const auto at = std::ranges::find(own.entries, entry.key, &Entry::key);
    if (at == own.entries.end()) own.entries.push_back(std::move(entry));
    else if (at->value.kind == Node::Kind::table && entry.value.kind == Node::Kind::table)
      lay_under(at->value, std::move(entry.value));
  }
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

/// What is wrong with a base; empty if it can be read.
std::string refusal(const Entry& base, const fs::path& path, const Reading& reading) {
  if (base.value.kind != Node::Kind::text || base.value.text.empty())
    return "must be the name of another recipe, for example \"../paper/recipe.toml\"";
  if (!reading.look_for_files)
    return "a recipe that does not come from a file can have no base; write out the keys of the base";
  if (!fs::is_regular_file(path))
    return fmt::format("there is no file {}; a base is found relative to the recipe that names it", path.string());
  const bool again =
      is_same(path, reading.file_name) || std::any_of(reading.bases.begin(), reading.bases.end(),
                                                      [&](const std::string& file) { return is_same(path, file); });
  return again ? fmt::format("{} leads back to itself; a recipe cannot be its own base", path.string()) : "";
}

/// Lays the recipe that the key `base` names under this one, and its base under both: sections are merged key by key,
/// what else is given here counts instead. A base's [sweep] is left out. The key is taken out of the tree, and the
/// files that were read are added to `reading.bases`. Throws InputError where there is no such file, or one leads back
/// to itself.
void lay_base_under(Node& root, Reading& reading, const RecordTable& keys) {
  fs::path folder = reading.folder;
  for (auto base = root.take("base"); base;) {
    const fs::path path = (folder / base->value.text).lexically_normal();
    if (const std::string why = refusal(*base, path, reading); !why.empty())
      throw InputError({Problem{file_of(base->value.place, reading), base->value.place.line, base->value.place.column,
                                "base: " + why}});
    reading.bases.push_back(path.string());
    Node under = read_document(io::read_file(path.string()), path.string());
    each_place(under, [&](Place& place) { place.file = path.string(); });
    rename_former_keys(under, keys, reading.notices);
    under.take("sweep");
    base = under.take("base");
    lay_under(root, std::move(under));
    folder = path.parent_path();
  }
}

/// Puts "key=value" into the tree; a value that is not TOML by itself is text (container.width=350 mm). Throws
/// InputError for a key that leads nowhere.
void apply_override(Node& root, const std::string& assignment, const RecordTable& keys) {
  const auto equals = assignment.find('=');
  try {
    if (equals == std::string::npos || equals == 0)
      throw InputError("write key=value, for example seed=7 or container.width=\"350 mm\"");
    Node value = parse_value(assignment.substr(equals + 1));
    value.place = {.override_text = "--set " + assignment};
    set_value(root, assignment.substr(0, equals), std::move(value), keys);
  } catch (const InputError& error) { throw InputError(fmt::format("--set {}: {}", assignment, error.what())); }
}

// What recipes of simulations and of films have in common; declare() says their keys.

template <class R> RecordTable keys_of(R recipe, bool every_key = false) {
  return record_of([&](ParameterVisitor& visitor) { declare(visitor, recipe); }, every_key);
}

template <class R> const RecordTable& all_keys() {
  static const RecordTable all = keys_of(R(), true);
  return all;
}

template <class R> std::string changed_keys_of(const R& recipe) {
  static const RecordTable all = under_former_names(all_keys<R>());
  return write_changes(under_former_names(keys_of(recipe)), all);
}

template <class R> R read_from(const Node& root, Reading& reading) {
  R recipe;
  recipe.source_file = reading.file_name;
  read_declared(root, reading, [&](ParameterVisitor& visitor) { declare(visitor, recipe); });
  return recipe;
}

bool of_simulation(const Node& root) { return root.find("packing") || root.find("populations") || root.find("stages"); }

void refuse_other_kinds(Node& root, Reading& reading, const Recipe&) {
  if (const auto sweep = root.take("sweep"))
    add_problem(reading, sweep->place, "sweep",
                fmt::format("this recipe is a study of many runs; `arenite study plan {0}` shows them, `arenite study "
                            "run {0}` runs them",
                            reading.file_name));
}

/// A recipe of a simulation has most of its keys wrong as one of a film; that it is the wrong kind helps more than
/// their list.
void refuse_other_kinds(Node& root, Reading& reading, const FilmRecipe&) {
  if (!root.find("lockin") && of_simulation(root))
    refuse(reading.file_name,
           "is the recipe of a simulation (`arenite run`), not of a film; `arenite init film r.toml` writes one of a "
           "film");
}

template <class R> R read_text(std::string_view text, Reading reading, const std::vector<std::string>& overrides) {
  Node root = read_tree(text, reading, overrides, all_keys<R>(), std::is_same_v<R, Recipe> ? "composite" : "film");
  refuse_other_kinds(root, reading, R());
  R recipe = read_from<R>(root, reading);
  recipe.notices = reading.notices;
  return recipe;
}

Reading of_file(const std::string& file) { return {file, fs::path(file).parent_path().string(), true, {}}; }
Reading of_text(const std::string& name) { return {name, {}, false, {}}; }

/// Lines that a resolved recipe of version 0.1 did not have: keys that came later, as they stand where nothing else is
/// asked for.
constexpr std::string_view later_lines[] = {"rolling = \"none\"", "bonds = \"none\"", "cohesion = \"none\"",
                                            "shape = \"disk\""};

}  // namespace

Node read_tree(std::string_view text, Reading& reading, const std::vector<std::string>& overrides,
               const RecordTable& keys, std::string_view start_from) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    refuse(reading.file_name, "the recipe is empty; `arenite init {}` writes one to start from", start_from);
  }
  Node root = read_document(text, reading.file_name);
  rename_former_keys(root, keys, reading.notices);
  lay_base_under(root, reading, keys);
  for (const auto& assignment : overrides) {
    try {
      apply_override(root, assignment, keys);
    } catch (const InputError& error) {
      reading.problems.insert(reading.problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  return root;
}

cement::CementParameters Recipe::cement_or_none() const {
  return cement.value_or(cement::CementParameters{.kind = cement::CementParameters::Kind::none});
}

const RecordTable& recipe_keys() { return all_keys<Recipe>(); }

Recipe recipe_from(const Node& root, const std::string& file) {
  Reading reading = of_file(file);
  return read_from<Recipe>(root, reading);
}

Recipe read_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  return read_text<Recipe>(io::read_file(file), of_file(file), overrides);
}
Recipe parse_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides) {
  return read_text<Recipe>(text, of_text(file_name), overrides);
}
FilmRecipe read_film_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  return read_text<FilmRecipe>(io::read_file(file), of_file(file), overrides);
}
FilmRecipe parse_film_recipe(std::string_view text, const std::string& file_name,
                             const std::vector<std::string>& overrides) {
  return read_text<FilmRecipe>(text, of_text(file_name), overrides);
}

std::string to_toml(const Recipe& recipe) { return write_toml(keys_of(recipe)); }
std::string to_toml(const FilmRecipe& recipe) { return write_toml(keys_of(recipe)); }
std::string changed_keys(const Recipe& recipe) { return changed_keys_of(recipe); }
std::string changed_keys(const FilmRecipe& recipe) { return changed_keys_of(recipe); }
std::string to_commented_toml(const Recipe& recipe) {
  return write_commented_toml(keys_of(recipe), all_keys<Recipe>());
}
std::string to_commented_toml(const FilmRecipe& recipe) {
  return write_commented_toml(keys_of(recipe), all_keys<FilmRecipe>());
}

std::string to_toml_of_version_0_1(const Recipe& recipe) {
  const std::string text = write_toml(under_former_names(keys_of(recipe)));
  std::string then;
  io::Lines lines(text);
  for (std::string_view line; lines.next(line);)
    if (std::ranges::find(later_lines, line) == std::end(later_lines)) then.append(line).append("\n");
  return then;
}

std::string title_in(const std::string& text) {
  try {
    const Node root = read_document(text, {});
    const Entry* title = root.find("title");
    return title && title->value.kind == Node::Kind::text ? title->value.text : "";
  } catch (const InputError&) { return {}; }
}

std::string key_reference() {
  return "# The recipe\n\n"
         "A recipe is a TOML file. Quantities are texts with their unit (`\"27.35 kN/mm\"`, `\"350 mm\"`, `\"30 %\"`); "
         "units are\n"
         "products, quotients and powers of m, g, s, K, N, Pa, J, W, Hz, bar, t, min, h, deg and % with the SI "
         "prefixes, and any\n"
         "unit of the right dimension will do. A bare number where a unit is needed, an unknown key and a value out of "
         "range are\n"
         "errors, all of them reported at once with file, line and column. `arenite check RECIPE.toml` prints the "
         "recipe as\n"
         "interpreted, `arenite init composite` a commented one to start from, and `--set stages.0.bottom.force=\"60 "
         "kN\"` changes a\n"
         "key for one run (items of lists are counted from 0). A section [sweep] makes many runs of one recipe:\n"
         "[studies.md](studies.md).\n\n"
         "`base = \"../paper/recipe.toml\"`, before any section, builds a recipe on another one, found relative to it, "
         "which may have a\n"
         "base of its own. Sections are merged key by key; all other values, including lists such as `[[stages]]`, "
         "replace those of\n"
         "the base. The base's [sweep] is left out, and files named in the base are found relative to the recipe\n"
         "that builds on it.\n\n"
         "This page is generated from the declarations with which the program reads recipes: `arenite man "
         "--keys`.\n\n" +
         write_key_tables(all_keys<Recipe>());
}

bool describes_film(std::string_view text) {
  try {
    const Node root = read_document(text, {});
    return !of_simulation(root) && (root.find("lockin") || root.find("picture") || root.find("camera"));
  } catch (const InputError&) { return false; }
}

std::string film_key_reference() {
  return "# The recipe of a film\n\n"
         "The recipe that `arenite film` and `arenite camera` read in addition to the film. It is written like every "
         "recipe\n"
         "([recipe.md](recipe.md)): TOML, quantities with their units, every problem reported at once. `arenite init "
         "film` writes a\n"
         "commented one to start from. This page is generated: `arenite man --film-keys`.\n\n" +
         write_key_tables(all_keys<FilmRecipe>());
}

const std::vector<RecipeTemplate>& recipe_templates() {
  static const std::vector<RecipeTemplate> list{
      {"composite", "two materials in a rigid container, compacted by the lower wall", templates::composite},
      {"cemented", "two sizes of grains bound by a matrix, loaded in tension, with the stress of every node",
       templates::cemented},
  };
  return list;
}

FilmRecipe film_template() { return parse_film_recipe(templates::film, {}); }

std::string study_template() { return std::string(templates::study); }

}  // namespace arenite::recipe
