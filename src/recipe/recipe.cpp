#include "recipe/recipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "model/packing.hpp"
#include "recipe/document.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/keys.hpp"
#include "recipe/reader.hpp"

namespace arenite::recipe {
namespace {

// What recipes of simulations and of films have in common; declare() says their keys.

template <class R> RecordTable keys_of(R recipe) {
  return record_of([&](ParameterVisitor& visitor) { declare(visitor, recipe); });
}

template <class R> RecordTable all_keys() {
  R defaults;
  return record_of([&](ParameterVisitor& visitor) { declare(visitor, defaults); }, true);
}

template <class R> std::string changed_keys_of(const R& recipe) {
  static const RecordTable all = all_keys<R>();
  return write_changes(keys_of(recipe), all);
}

template <class R> R read_from(const Node& root, Reading& reading) {
  R recipe;
  recipe.source_file = reading.file_name;
  read_declared(root, reading, [&](ParameterVisitor& visitor) { declare(visitor, recipe); });
  return recipe;
}

/// `inspect` looks at the tree before its keys are read.
template <class R>
R read_text(std::string_view text, Reading reading, const std::vector<std::string>& overrides, const char* start_from, void (*inspect)(Node&, Reading&)) {
  Node root = read_tree(text, reading, overrides, start_from);
  inspect(root, reading);
  R recipe = read_from<R>(root, reading);
  recipe.notices = reading.notices;
  return recipe;
}

Reading of_file(const std::string& file) { return {file, std::filesystem::path(file).parent_path().string(), true, {}}; }

void refuse_sweep(Node& root, Reading& reading) {
  const auto sweep = std::find_if(root.entries.begin(), root.entries.end(), [](const Entry& entry) { return entry.key == "sweep"; });
  if (sweep == root.entries.end()) return;
  reading.problems.push_back({reading.file_name, sweep->place.line, sweep->place.column,
                              fmt::format("sweep: this recipe is a study of many runs; `arenite study plan {0}` shows them, "
                                          "`arenite study run {0}` runs them",
                                          reading.file_name)});
  root.entries.erase(sweep);
}

bool of_simulation(const Node& root) { return root.find("packing") || root.find("populations") || root.find("stages"); }

/// A recipe of a simulation has most of its keys wrong as one of a film; that it is the wrong kind helps more than their list.
void refuse_simulations(Node& root, Reading& reading) {
  if (!root.find("lockin") && of_simulation(root))
    refuse(reading.file_name, "is a recipe of a simulation (`arenite run`), not of a film; `arenite init film r.toml` writes one of a film");
}

}  // namespace

cement::CementParameters Recipe::cement_or_none() const { return cement.value_or(cement::CementParameters{.kind = cement::CementParameters::Kind::none}); }

Recipe recipe_from(const Node& root, const std::string& file) {
  Reading reading = of_file(file);
  return read_from<Recipe>(root, reading);
}

Recipe read_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  return read_text<Recipe>(io::read_file(file), of_file(file), overrides, "composite", refuse_sweep);
}

Recipe parse_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides) {
  return read_text<Recipe>(text, {file_name, {}, false, {}}, overrides, "composite", refuse_sweep);
}

std::string to_toml(const Recipe& recipe) { return write_toml(keys_of(recipe)); }
std::string changed_keys(const Recipe& recipe) { return changed_keys_of(recipe); }
std::string to_commented_toml(const Recipe& recipe) { return write_commented_toml(keys_of(recipe), all_keys<Recipe>()); }

std::string title_in(const std::string& text) {
  try {
    const Node root = read_document(text, {});
    const Entry* title = root.find("title");
    return title && title->value.kind == Node::Kind::text ? title->value.text : "";
  } catch (const InputError&) { return {}; }
}

std::string key_reference() {
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
         write_key_tables(all_keys<Recipe>());
}

bool describes_film(std::string_view text) {
  try {
    const Node root = read_document(text, {});
    return !of_simulation(root) && (root.find("lockin") || root.find("picture") || root.find("camera"));
  } catch (const InputError&) { return false; }
}

std::vector<double> emissivities(const FilmRecipe& recipe) {
  return mapped(recipe.materials, [&](const FilmMaterial& m) { return m.emissivity.value_or(recipe.temperature.emissivity.value_or(0.9)); });
}

bool has_references(const FilmRecipe& recipe) {
  const CorrectionSection& c = recipe.correction;
  return recipe.temperature.from != TemperatureSection::From::references ||
         (!c.cold.empty() && !c.warm.empty() && c.cold_temperature > 0 && c.warm_temperature > c.cold_temperature);
}

FilmRecipe read_film_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  return read_text<FilmRecipe>(io::read_file(file), of_file(file), overrides, "film", refuse_simulations);
}

FilmRecipe parse_film_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides) {
  return read_text<FilmRecipe>(text, {file_name, {}, false, {}}, overrides, "film", refuse_simulations);
}

std::string to_toml(const FilmRecipe& recipe) { return write_toml(keys_of(recipe)); }
std::string changed_keys(const FilmRecipe& recipe) { return changed_keys_of(recipe); }
std::string to_commented_toml(const FilmRecipe& recipe) { return write_commented_toml(keys_of(recipe), all_keys<FilmRecipe>()); }

std::string film_key_reference() {
  return "# The recipe of a film\n\n"
         "What `arenite film` and `arenite camera` are given beside the film itself. It is written as every recipe\n"
         "([recipe.md](recipe.md)): TOML, quantities with their units, every problem reported at once. `arenite init film` writes a\n"
         "commented one to start from. This page is generated: `arenite man --film-keys`.\n\n" +
         write_key_tables(all_keys<FilmRecipe>());
}

// What `arenite init` writes.

namespace {

Stage loading(std::string name, int side, double force, std::int64_t increments, bool gravity) {
  Stage stage;
  stage.name = std::move(name);
  stage.gravity = gravity;
  stage.side[static_cast<std::size_t>(side)] = {SideDrive::Kind::force, force};
  stage.increments = increments;
  return stage;
}

/// Pressed from all sides, with masses that make the steps few.
Stage pressed(std::string name, double pressure) {
  Stage stage;
  stage.name = std::move(name);
  stage.side.fill({SideDrive::Kind::pressure, pressure});
  stage.mass_scaling = dem::MassScaling::uniform;
  return stage;
}

/// Sample #8 of the thesis (T Tables 2.1, 2.2, 3.2): 100 N on the upper wall, then gravity and 50 kN on the lower one.
Recipe composite() {
  Recipe recipe;
  recipe.title = "Composite of POM and HDPE cylinders, sample 8 of the thesis";
  recipe.seed = 8;
  recipe.container.width = 0.35;
  recipe.container.thickness = 0.06;
  recipe.materials = {{"HDPE", 950, 6.43e6, 0.0258e-6}, {"POM", 1410, 27.35e6, 0.0150e-6}};
  recipe.populations = {{"POM", 334, {}, {}, {}}, {"HDPE", 371, {}, {}, {}}};
  recipe.populations[0].size = packing::FixedSize{0.0164};
  recipe.populations[1].size = packing::FixedSize{0.0105};
  recipe.contact.friction_law = dem::CundallStrack{};
  recipe.contact.restitution = 0.5;
  recipe.integration.track_energy = true;
  recipe.stages = {loading("prepare", top, 100, 1, false), loading("load", bottom, 50'000, 10, true)};
  return recipe;
}

/// One sample of the paper (P II): gamma = 2.5, theta = 1.4, eta = 0.4, pressed to k_n/P = 10^4, then pulled.
Recipe cemented() {
  Recipe recipe;
  recipe.title = "Cemented disks of two sizes, pulled";
  recipe.packing.method = PackingParameters::Method::poisson;
  recipe.bidisperse.emplace();
  recipe.bidisperse->law.large_radius = 1e-3;
  recipe.container.thickness = 0.01;
  recipe.materials = {{"large", 2500, 1e6, 0}, {"small", 2500, 1e6, 0}};
  recipe.contact.friction_law = dem::CundallStrack{};
  recipe.contact.friction = 0.3;
  recipe.contact.restitution = 0.7;
  recipe.stages = {pressed("compact", 1e4), pressed("rest", 1e4)};
  recipe.stages[0].inertial_number = 1;
  recipe.stages[0].equilibrium.unbalanced = 0.01;
  recipe.stages[0].equilibrium.kinetic = 0.05;
  recipe.stages[1].critical_drag = 0.2;
  recipe.stages[1].equilibrium.kinetic = 1e-5;
  recipe.cement.emplace();
  recipe.grid.emplace();
  Load tension;
  tension.name = "tension";
  recipe.loads = {tension};
  return recipe;
}

}  // namespace

const std::vector<RecipeTemplate>& recipe_templates() {
  static const std::vector<RecipeTemplate> list{
      {"composite", "two materials in a rigid frame, compacted by the lower wall", composite},
      {"cemented", "two sizes of grains bound by a matrix, pulled, with the stress in every node", cemented},
  };
  return list;
}

std::string study_template() {
  return R"(title = "Coordination against friction"
seed = 1

[container]                               # rigid, square; its height follows from the grains
width = "120 mm"
thickness = "60 mm"

[materials.POM]
density = "1410 kg/m^3"
stiffness = "27.35 kN/mm"

[[populations]]
material = "POM"
count = 60
size = { law = "uniform", min = "10 mm", max = "16 mm" }

[contact]
friction_law = "cundall_strack"
friction = 0.3
restitution = 0.5

[[stages]]                                # each run: 100 N on the upper wall, then 10 kN on the lower one
name = "prepare"
top = { force = "100 N" }

[[stages]]
name = "load"
bottom = { force = "10 kN" }

[sweep]                                   # what makes it a study: all of the below with all of the below
replicates = 2                            # seeds 1 and 2 for every combination

[sweep.grid]                              # keys of the recipe with the values that they take
"contact.friction" = [0.1, 0.3, 0.5]
)";
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
