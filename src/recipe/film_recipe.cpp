#include "recipe/film_recipe.hpp"

#include <algorithm>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "io/disk/file.hpp"
#include "recipe/declared.hpp"
#include "recipe/templates.hpp"
#include "thermal/radiometry/band.hpp"

namespace arenite::recipe {
namespace {

bool of_simulation(const Node& root) { return root.find("packing") || root.find("populations") || root.find("stages"); }

/// A recipe of a simulation has most of its keys wrong as one of a film; that it is the wrong kind helps more than
/// their list. A study is none either.
void refuse_others(Node& root, Reading& reading) {
  if (!root.find("lockin") && of_simulation(root))
    refuse(reading.file_name,
           "is the recipe of a simulation (`arenite run`), not of a film; `arenite init film r.toml` writes one of a "
           "film");
  if (const auto sweep = root.take("sweep")) refuse_sweep(*sweep, reading);
}

}  // namespace

FilmRecipe read_film_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  return read_text<FilmRecipe>(io::read_file(file), of_file(file), overrides, "film", refuse_others);
}

FilmRecipe parse_film_recipe(std::string_view text, const std::string& file_name,
                             const std::vector<std::string>& overrides) {
  return read_text<FilmRecipe>(text, of_text(file_name), overrides, "film", refuse_others);
}

FilmRecipe film_recipe_from(const Node& root, const std::string& file) {
  Reading reading = of_file(file);
  return read_from<FilmRecipe>(root, reading);
}

const RecordTable& film_keys() { return all_keys<FilmRecipe>(); }

std::filesystem::path FilmRecipe::film_named() const {
  if (film && !film->file.empty()) return beside(film->file);
  refuse(source_file, "names no film; give it as [film] file = \"film.ptw\", found beside the recipe");
}

std::string to_toml(const FilmRecipe& recipe) { return write_toml(keys_of(recipe)); }

std::string changed_keys(const FilmRecipe& recipe) { return changed_keys_of(recipe); }

std::string to_commented_toml(const FilmRecipe& recipe) {
  return write_commented_toml(keys_of(recipe), all_keys<FilmRecipe>());
}

bool describes_film(std::string_view text) {
  try {
    return describes_film(read_document(text, {}));
  } catch (const InputError&) { return false; }
}

bool describes_film(const Node& root) {
  return !of_simulation(root) && (root.find("lockin") || root.find("picture") || root.find("camera"));
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

FilmRecipe film_template() { return parse_film_recipe(templates::film, {}); }

thermography::LockinOptions LockinSection::options() const {
  thermography::LockinOptions o;
  o.frequency = frequency;
  o.drift_order = static_cast<int>(drift);
  o.harmonics = static_cast<int>(harmonics);
  o.reference_phase = phase;
  return o;
}

thermography::LockinOptions LockinAlone::options() const {
  thermography::LockinOptions o = LockinSection::options();
  o.refine = refine;
  o.convention = convention;
  return o;
}

thermography::StepOptions StepSection::options() const {
  thermography::StepOptions o;
  o.time = time;
  o.rise = rise;
  o.window = window;
  o.drift_order = static_cast<int>(drift);
  return o;
}

std::vector<double> emissivities(const FilmRecipe& recipe) {
  return mapped(recipe.materials, [&](const FilmMaterial& m) {
    return m.emissivity.value_or(recipe.temperature.emissivity.value_or(radiometry::usual_emissivity));
  });
}

bool has_references(const FilmRecipe& recipe) {
  const CorrectionSection& c = recipe.correction;
  return recipe.temperature.from != TemperatureSection::From::references ||
         (!c.cold.empty() && !c.warm.empty() && c.cold_temperature > 0 && c.warm_temperature > c.cold_temperature);
}

}  // namespace arenite::recipe
