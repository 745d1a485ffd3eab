#include "workflow/stage_keys.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/hash.hpp"
#include "io/read_file.hpp"
#include "io/run_folder.hpp"

namespace arenite::study {

namespace {

// Raised when the same recipe gives other bits: a mended law, another order of a sum.
constexpr std::int64_t packing_version = 1;
constexpr std::int64_t loading_version = 4;
constexpr std::int64_t clipped_dashpot_version = 1;  // of loadings whose dashpots cannot pull, alone
constexpr std::int64_t cement_version = 1;
constexpr std::int64_t load_version = 2;

Recipe without_what_changes_no_bit(Recipe recipe) {
  recipe.title.clear();
  recipe.source_file.clear();
  recipe.integration.threads = 1;
  recipe.integration.kernel = "auto";
  return recipe;
}

/// What a key says of laws on which it does not depend: always the same, so that a new default renames no stored result.
dem::ContactParameters no_contact() {
  dem::ContactParameters contact;
  contact.restitution = 0.1;
  contact.attractive_dashpot = true;
  contact.friction_law = dem::FrictionLaw::regularised_coulomb;
  return contact;
}

Recipe no_loading() {
  Recipe recipe;
  recipe.contact = no_contact();
  return recipe;
}

Recipe without_field(Recipe recipe) {
  recipe.cement.reset();
  recipe.raster.reset();
  recipe.loads.clear();
  return recipe;
}

}  // namespace

std::string packing_key(const Recipe& recipe) {
  Recipe part = without_field(without_what_changes_no_bit(recipe));
  part.stages.clear();
  part.contact = no_contact();
  part.integration = {};
  HashBuilder hash;
  hash.add("packing version", packing_version).add("recipe", to_toml(part));
  if (recipe.packing.method == PackingParameters::Method::file)
    hash.add("file", content_hash(io::read_file(std::filesystem::path(recipe.source_file).parent_path() / recipe.packing.file)));
  return hash.hex();
}

std::string stage_key(const Recipe& recipe, std::size_t s, const std::string& packing_hash) {
  Recipe part = without_field(without_what_changes_no_bit(recipe));
  part.stages.resize(s + 1);
  HashBuilder hash;
  hash.add("loading version", loading_version).add("packing", packing_hash).add("recipe", to_toml(part));
  if (!recipe.contact.attractive_dashpot) hash.add("clipped dashpot version", clipped_dashpot_version);
  return hash.hex();
}

std::string cement_key(const Recipe& recipe, const std::string& last_stage_hash) {
  Recipe part = no_loading();
  part.cement = recipe.cement_or_none();
  part.raster = recipe.raster_or_default();
  HashBuilder hash;
  hash.add("cement version", cement_version).add("packing", last_stage_hash).add("recipe", to_toml(part));
  return hash.hex();
}

std::string load_key(const Load& load, const std::string& cement_hash) {
  Recipe part = no_loading();
  part.loads = {load};
  HashBuilder hash;
  hash.add("load version", load_version).add("sample", cement_hash).add("recipe", to_toml(part));
  return hash.hex();
}

PlannedStage planned_stage(int place, std::string name, std::string hash, bool field) {
  std::string file = io::stage_file_name(place, name, hash), former = io::full_stage_file_name(place, name, hash);
  return {std::move(name), std::move(hash), std::move(file), field, std::move(former)};
}

std::vector<PlannedStage> plan_of(const Recipe& recipe) {
  std::vector<PlannedStage> plan;
  const auto add = [&plan](const std::string& name, std::string hash, bool field) {
    plan.push_back(planned_stage(static_cast<int>(plan.size()) + 1, name, std::move(hash), field));
  };
  const std::string packing = packing_key(recipe);
  add("packing", packing, false);
  for (std::size_t s = 0; s < recipe.stages.size(); ++s) add(recipe.stages[s].name, stage_key(recipe, s, packing), false);
  if (!recipe.has_field()) return plan;
  const std::string cement = cement_key(recipe, plan.back().hash);
  add("cement", cement, true);
  for (const Load& load : recipe.loads) add(load.name, load_key(load, cement), true);
  return plan;
}

Recipe part_of(const Recipe& recipe, std::size_t s) {
  if (s > recipe.stages.size()) {
    Recipe part = recipe;
    const std::size_t load = s - recipe.stages.size() - 1;  // 0: the cemented sample, before all loads
    part.loads.clear();
    if (load > 0) part.loads.push_back(recipe.loads[load - 1]);
    return part;
  }
  Recipe part = without_field(recipe);
  part.stages.resize(s);
  if (s == 0) {
    part.contact = {};
    part.integration = {};
  }
  return part;
}

std::string key_versions() {
  return fmt::format("{} {} {} {} {}", packing_version, loading_version, cement_version, load_version, clipped_dashpot_version);
}

}  // namespace arenite::study
