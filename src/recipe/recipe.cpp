#include "recipe/recipe.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/table/table.hpp"
#include "recipe/declared.hpp"
#include "recipe/doubts.hpp"
#include "recipe/templates.hpp"

namespace arenite::recipe {

namespace {

void refuse_study(Node& root, Reading& reading) {
  if (const auto sweep = root.take("sweep")) refuse_sweep(*sweep, reading);
}

Recipe with_doubts(Recipe recipe) {
  for (std::string& doubt : doubts_of(recipe)) recipe.notices.push_back(std::move(doubt));
  return recipe;
}

/// Lines that a resolved recipe of version 0.1 did not have: keys that came later, as they stand where nothing else is
/// asked for.
constexpr std::string_view later_lines[] = {"rolling = \"none\"", "bonds = \"none\"", "cohesion = \"none\"",
                                            "shape = \"disk\""};

}  // namespace

cement::CementParameters Recipe::cement_or_none() const {
  return cement.value_or(cement::CementParameters{.kind = cement::CementParameters::Kind::none});
}

const RecordTable& recipe_keys() { return all_keys<Recipe>(); }

MapSection Recipe::map_beside() const {
  MapSection opened = *map;
  opened.file = beside(opened.file).string();
  if (opened.has_label_file()) opened.labels = beside(opened.labels).string();
  return opened;
}

Recipe recipe_from(const Node& root, const std::string& file) {
  Reading reading = of_file(file);
  return read_from<Recipe>(root, reading);
}

Recipe read_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  return with_doubts(read_text<Recipe>(io::read_file(file), of_file(file), overrides, "composite", refuse_study));
}
Recipe parse_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides) {
  return with_doubts(read_text<Recipe>(text, of_text(file_name), overrides, "composite", refuse_study));
}

std::string to_toml(const Recipe& recipe) { return write_toml(keys_of(recipe)); }
std::string changed_keys(const Recipe& recipe) { return changed_keys_of(recipe); }
std::string to_commented_toml(const Recipe& recipe) {
  return write_commented_toml(keys_of(recipe), all_keys<Recipe>());
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
         "products, quotients and powers (`m^2`, `m^(1/2)`) of m, g, s, K, N, Pa, J, W, Hz, bar, t, min, h, deg and % "
         "with the SI "
         "prefixes, and any\n"
         "unit of the right dimension will do. A bare number where a unit is needed, an unknown key and a value out of "
         "range are\n"
         "errors, all of them reported at once with file, line and column. `arenite check RECIPE.toml` prints the "
         "recipe as\n"
         "interpreted, `arenite init composite` a commented one to start from, and `--set stages.0.bottom.force=\"60 "
         "kN\"` changes a\n"
         "key for one run; items of lists are counted from 0 or called by name (`stages.shear.shear_rate`, "
         "`populations.POM.count`).\n"
         "A section [sweep] makes many runs of one recipe: [studies.md](studies.md).\n\n"
         "`[variables]` gives names to numbers and quantities: with `D = \"40 mm\"` there, every number of the recipe "
         "may "
         "be an\n"
         "expression in quotes, such as `width = \"10*D\"` or `points = [[\"D/2\", \"0 mm\"], ...]`: numbers with "
         "their "
         "units, variables,\n"
         "`+ - * / ^`, brackets, `pi` and the functions sqrt, abs, min, max, sin, cos, tan, exp, log, round, floor and "
         "ceil. `--set\n"
         "variables.D=\"50 mm\"` and sweeps change them; results are named by the numbers that follow.\n\n"
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

const std::vector<RecipeTemplate>& recipe_templates() {
  static const std::vector<RecipeTemplate> list{
      {"composite", "two materials in a rigid container, compacted by the lower wall", templates::composite, true},
      {"cemented", "two sizes of grains bound by a matrix, loaded in tension, with the stress of every node",
       templates::cemented, true},
      {"biaxial", "compression at a constant side pressure: q/p, volume, critical state", templates::biaxial},
      {"shear", "a periodic cell sheared at a constant pressure: mu(I)", templates::shear},
      {"cycles", "loading and unloading many times: strain that stays, loops", templates::cycles},
      {"deposit", "grains that rain into a box; oedometer", templates::deposit},
      {"silo", "discharge through an opening: rate, Beverloo's law", templates::silo},
      {"collapse", "a column that runs out over a floor: front, deposit", templates::collapse},
      {"drum", "a rotating drum: slope of the free surface", templates::drum},
      {"rock", "bonded grains compressed until they fail: modulus, strength, cracks", templates::rock},
      {"spheres", "spheres in space, pressed and sheared in a periodic cell: q/p, dilation", templates::spheres},
  };
  return list;
}

std::string study_template() { return std::string(templates::study); }

}  // namespace arenite::recipe
