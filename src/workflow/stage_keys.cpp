#include "workflow/stage_keys.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "core/thread_count.hpp"
#include "io/disk/file.hpp"
#include "io/disk/store_file.hpp"
#include "io/film/film.hpp"
#include "io/volume/spheres.hpp"
#include "io/volume/volume.hpp"
#include "recipe/film_recipe.hpp"
#include "workflow/load_voxels.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

namespace {

// Raised when the same recipe gives other bits: a corrected law, another order of a sum, another default of a key.
constexpr std::int64_t packing_version = 1;
constexpr std::int64_t loading_version = 4;
constexpr std::int64_t clipped_dashpot_version = 1;   // of loadings whose dashpots cannot pull, alone
constexpr std::int64_t driven_loading_version = 1;    // of loadings that shear, or press while something drives, alone
constexpr std::int64_t drifting_loading_version = 1;  // of loadings between two membranes that slide, alone
constexpr std::int64_t cement_version = 1;
constexpr std::int64_t map_version = 1;
constexpr std::int64_t load_version = 2;
constexpr std::int64_t closing_version = 1;  // of loads to failure whose cracks close, alone

recipe::Recipe without_what_changes_no_bit(recipe::Recipe recipe) {
  recipe.title.clear();
  recipe.source_file.clear();
  recipe.integration.threads = Threads{}.threads;
  recipe.integration.kernel = "auto";
  return recipe;
}

recipe::Recipe without_field(recipe::Recipe recipe) {
  recipe.cement.reset();
  recipe.grid.reset();
  recipe.loads.clear();
  return recipe;
}

/// Counts up whenever the same film and recipe give other numbers.
constexpr std::int64_t film_version = 5;
constexpr std::int64_t virtual_film_version = 1;  // of films that are rendered from a run

/// The bytes of a file that need not fit into memory.
std::vector<std::string> hashes_of(const fs::path& path) {
  std::vector<std::string> hashes;
  std::ifstream file(path, std::ios::binary);
  std::string part(std::size_t{8} << 20, '\0');
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
    hashes.push_back(content_hash(std::string_view(part).substr(0, static_cast<std::size_t>(file.gcount()))));
  return hashes;
}

void add_file(HashBuilder& hash, const fs::path& path, KnownFilms& known) {
  const auto [at, is_new] = known.try_emplace(path.string());
  if (is_new) at->second = hashes_of(path);
  for (const std::string& part : at->second) hash.add("part", part);
}

/// A map or its labels; of a volume also what lies beside the file.
void add_map_file(HashBuilder& hash, const char* name, const std::string& file, const std::string& dataset,
                  bool is_volume) {
  if (!is_volume || !io::are_slices(file)) hash.add(name, content_hash(io::read_file(file)));
  if (!is_volume) return;
  // A side of voxels that is not stated well is refused, if at all, by what reads them.
  const std::string elsewhere = io::hash_of_voxels_elsewhere(file, {.dataset = dataset, .dx_given = true});
  if (!elsewhere.empty()) hash.add("voxels", elsewhere);
}

template <class T> std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

void add_frames(HashBuilder& hash, FilmSource& source) {
  const std::int64_t frames = source.info().frames;
  constexpr std::int64_t together = 32;
  FrameBlock block;
  for (std::int64_t k = 0; k < frames; k += together) {
    source.read(k, static_cast<std::size_t>(std::min(together, frames - k)), block);
    hash.add("levels", content_hash(bytes_of(block.level)));
    hash.add("values", content_hash(bytes_of(block.value)));
  }
}

/// What a film says about itself may stand beside its frames, in another file.
void add_info(HashBuilder& hash, const FilmInfo& info) {
  hash.add("width", std::int64_t{info.width}).add("height", std::int64_t{info.height}).add("frames", info.frames);
  hash.add("frame_rate", info.frame_rate).add("integration", info.integration).add("bits", std::int64_t{info.bits});
  hash.add("floating", std::int64_t{info.floating}).add("quantity", static_cast<std::int64_t>(info.quantity));
  hash.add("emissivity", info.emissivity).add("ambient", info.ambient);
  hash.add("band_low", info.band_low).add("band_high", info.band_high);
  hash.add("time", content_hash(bytes_of(info.time)));
}

void add_film(HashBuilder& hash, const char* name, const fs::path& path, FilmSource& source, KnownFilms& known) {
  hash.add("film", name);
  add_info(hash, source.info());
  // A raw film may be named by the file that describes its frames.
  if (fs::is_regular_file(path) && source.info().format != "raw") add_file(hash, path, known);
  else add_frames(hash, source);
}

/// What the packing depends on: no law, no loading.
recipe::Recipe packing_part(const recipe::Recipe& recipe) {
  recipe::Recipe part = without_field(without_what_changes_no_bit(recipe));
  part.stages.clear();
  part.contact = {};
  part.integration = {};
  return part;
}

std::string packing_key(const recipe::Recipe& recipe, const std::string& part) {
  HashBuilder hash;
  hash.add("packing version", packing_version).add("recipe", part);
  if (recipe.packing.method == recipe::PackingParameters::Method::file)
    hash.add("file", content_hash(io::read_file(recipe.beside(recipe.packing.file))));
  return hash.hex();
}

/// Its walls are those of a driven sample (dem/walls.hpp), or its anisotropies have the signs of shear.
bool presses_while_driven_or_shears(const dem::Stage& stage) {
  const auto closes = [](const dem::SideDrive& side) { return side.kind == dem::SideDrive::Kind::velocity; };
  const bool driven = std::ranges::any_of(stage.side, closes) || stage.strain_cycles || !stage.programmes.empty() ||
                      dem::moves_boundaries(stage);
  return stage.shear_rate != 0 || stage.slide != ByAnySide<double>{} ||
         (driven && std::ranges::any_of(stage.side, &dem::SideDrive::presses));
}

/// Of all that stage `s` (0-based) depends on: the packing, laws, integration, the stages up to it. What changes no bit
/// (title, number of threads, kernel, later stages) is not in it.
std::string stage_key(const recipe::Recipe& recipe, std::size_t s, const std::string& packing_hash) {
  recipe::Recipe part = without_field(without_what_changes_no_bit(recipe));
  part.stages.resize(s + 1);
  HashBuilder hash;
  hash.add("loading version", loading_version).add("packing", packing_hash).add("recipe", changed_keys(part));
  if (!recipe.contact.attractive_dashpot) hash.add("clipped dashpot version", clipped_dashpot_version);
  if (std::ranges::any_of(part.stages, presses_while_driven_or_shears))
    hash.add("driven loading version", driven_loading_version);
  if (std::ranges::any_of(part.stages, dem::presses_by_two_membranes))
    hash.add("drifting loading version", drifting_loading_version);
  return hash.hex();
}

/// Of all that the cemented sample depends on: the last stage, the cement and the grid.
std::string cement_key(const recipe::Recipe& recipe, const std::string& last_stage_hash) {
  recipe::Recipe part;
  part.dimension = recipe.dimension;
  part.cement = recipe.cement_or_none();
  part.grid = recipe.grid_or_default();
  HashBuilder hash;
  hash.add("cement version", cement_version).add("packing", last_stage_hash).add("recipe", changed_keys(part));
  return hash.hex();
}

}  // namespace

bool has_sample_apart(const recipe::Recipe& recipe) {
  return recipe.map ? !is_in_space(recipe.map_beside()) : recipe.dimension == 2;
}

std::string seed_key(const recipe::Recipe& recipe) {
  recipe::Recipe part = packing_part(recipe);
  // The laws are none of its business, but version 0.1 wrote its defaults of then.
  part.contact.restitution = 0.1;
  part.contact.attractive_dashpot = true;
  part.contact.friction_law = dem::RegularisedCoulomb{};
  part.measure.reset();
  return packing_key(recipe, to_toml_of_version_0_1(part));
}

std::string stage_key(const recipe::Recipe& recipe, std::size_t place, const std::vector<std::uint8_t>& start) {
  return stage_key(recipe, place - 1, content_hash(bytes_of(start)));
}

std::string load_key(const recipe::Load& load, const std::string& cement_hash) {
  recipe::Recipe part;
  part.loads = {load};
  HashBuilder hash;
  hash.add("load version", load_version).add("sample", cement_hash).add("recipe", changed_keys(part));
  if (load.failure && !load.cracks_stay_open) hash.add("closing version", closing_version);
  return hash.hex();
}

std::string map_keys(const recipe::MapSection& map) {
  recipe::Recipe part;
  part.map = map;
  part.map->file.clear();
  if (map.has_label_file()) part.map->labels = "a file";
  return changed_keys(part);
}

std::string told_map_keys(const recipe::MapSection& map) {
  constexpr std::string_view before = "map.";
  std::vector<std::string> told;
  std::istringstream lines(map_keys(map));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(before) && line != "map.file = \"\"") told.push_back(line.substr(before.size()));
  return list_of(told, ", ");
}

std::string map_key(const recipe::MapSection& map) {
  const bool is_volume = is_in_space(map) && !io::is_sphere_table(map.file);
  HashBuilder hash;
  hash.add("map version", map_version);
  add_map_file(hash, "map", map.file, map.dataset, is_volume);
  hash.add("recipe", map_keys(map));
  if (map.has_label_file()) add_map_file(hash, "labels", map.labels, map.label_dataset, is_volume);
  return hash.hex();
}

PlannedStage planned_stage(int place, std::string name, std::string hash, bool field) {
  return {name, hash, io::stage_file_name(place, name, hash), field};
}

std::vector<PlannedStage> plan_of(const recipe::Recipe& recipe) {
  std::vector<PlannedStage> plan;
  const auto add = [&plan](const std::string& name, const std::string& hash, bool field) {
    plan.push_back(planned_stage(static_cast<int>(plan.size()) + 1, name, hash, field));
  };
  if (recipe.map) {
    const std::string sample = map_key(recipe.map_beside());
    if (has_sample_apart(recipe)) add("map", sample, true);
    for (const recipe::Load& load : recipe.loads) add(load.name, load_key(load, sample), true);
    return plan;
  }
  add("packing", packing_key(recipe, changed_keys(packing_part(recipe))), false);
  for (std::size_t s = 0; s < recipe.stages.size(); ++s)
    add(recipe.stages[s].name, stage_key(recipe, s, plan.front().hash), false);
  if (!recipe.has_field()) return plan;
  const std::string sample = cement_key(recipe, plan.back().hash);
  if (has_sample_apart(recipe)) add("cement", sample, true);
  for (const recipe::Load& load : recipe.loads) add(load.name, load_key(load, sample), true);
  return plan;
}

recipe::Recipe part_of(const recipe::Recipe& recipe, std::size_t s) {
  if (recipe.map || s > recipe.stages.size()) {
    recipe::Recipe part = recipe;
    // 0: the sample, before all loads.
    const std::size_t load = (recipe.map ? s : s - recipe.stages.size() - 1) + (has_sample_apart(recipe) ? 0 : 1);
    part.loads.clear();
    if (load > 0) part.loads.push_back(recipe.loads[load - 1]);
    return part;
  }
  recipe::Recipe part = without_field(recipe);
  part.stages.resize(s);
  if (s == 0) {
    part.contact = {};
    part.integration = {};
  }
  return part;
}

std::string key_versions() {
  return fmt::format("changed keys {} {} {} {} {} {} {}", packing_version, loading_version, cement_version,
                     load_version, clipped_dashpot_version, closing_version, driven_loading_version);
}

std::string film_key(const fs::path& film, FilmSource& source, const recipe::FilmRecipe& recipe, KnownFilms& known) {
  recipe::FilmRecipe asked = recipe;  // where the film lies changes nothing
  if (asked.film) asked.film->file.clear();
  HashBuilder hash;
  hash.add("film version", film_version).add("recipe", changed_keys(asked));
  add_film(hash, "film", film, source, known);
  const auto add_reference = [&](const char* name, const std::string& file) {
    if (!file.empty())
      add_film(hash, name, recipe.beside(file), *io::open_film(recipe.beside(file), recipe.choice()), known);
  };
  const auto add = [&](const char* name, const std::string& file) {
    if (!file.empty()) hash.add(name, content_hash(io::read_file(recipe.beside(file))));
  };
  add_reference("cold", recipe.correction.cold);
  add_reference("warm", recipe.correction.warm);
  add("curve", recipe.temperature.curve);
  add("grains", recipe.picture.grains);
  add("optical", recipe.picture.optical);
  if (recipe.simulation) add("twin", recipe.simulation->recipe);  // as results have been named by since version 0.1
  return hash.hex();
}

std::string virtual_film_key(const recipe::FilmRecipe& camera, const std::string& low, const std::string& high) {
  HashBuilder hash;
  hash.add("virtual film version", virtual_film_version).add("film version", film_version);
  return hash.add("recipe", changed_keys(camera)).add("low", low).add("high", high).hex();
}

}  // namespace arenite::workflow
