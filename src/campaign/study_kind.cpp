#include "campaign/study_kind.hpp"

#include <algorithm>
#include <set>

#include "core/mapped.hpp"
#include "io/disk/file.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::campaign {

namespace fs = std::filesystem;

namespace {

using recipe::Recipe;

constexpr std::size_t fewest_runs = 3, fewest_frictions = 3;  // that a law is seen by

std::vector<fs::path> runs_of(const fs::path& study) {
  std::error_code error;
  std::vector<fs::path> runs;
  const fs::path folder = (fs::is_directory(study, error) ? study : study.parent_path()) / "runs";
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (fs::exists(entry.path() / "recipe.toml", error)) runs.push_back(entry.path());
  std::ranges::sort(runs);
  return runs;
}

std::string flow_of(const std::vector<Recipe>& recipes) {
  const auto all = [&](const auto& holds) {
    return std::ranges::all_of(recipes, [&](const Recipe& recipe) { return holds(recipe.stages.back()); });
  };
  const bool weighs = all([](const dem::Stage& stage) { return stage.gravity; });
  if (weighs && all([](const dem::Stage& stage) { return stage.count_below.has_value(); })) return "beverloo";
  if (weighs && all([](const dem::Stage& stage) { return stage.open[left] || stage.open[right]; })) return "runout";
  if (weighs && all([](const dem::Stage& stage) { return moves_side(stage, bottom); })) return "janssen";
  std::set<double> frictions;
  for (const Recipe& recipe : recipes) frictions.insert(recipe.contact.friction);
  const bool sheared = all([](const dem::Stage& stage) { return stage.shear_rate != 0; });
  return sheared && frictions.size() >= fewest_frictions ? "critical-state" : "";
}

}  // namespace

std::vector<std::string> StudyKind::figures() const {
  std::vector<std::string> ids;
  if (!flow.empty()) ids.push_back(flow);
  if (!driven.empty() && (flow.empty() || flow == "critical-state")) ids.emplace_back("rheology");
  return ids;
}

StudyKind kind_of_study(const fs::path& study) {
  const auto runs = runs_of(study);
  std::vector<Recipe> recipes;
  for (const fs::path& run : runs) {
    const std::string file = (run / "recipe.toml").string(), text = io::read_file(file);
    if (recipe::describes_film(text)) return {};
    recipes.push_back(recipe::parse_recipe(text, file));
  }
  const auto loads = [](const Recipe& recipe) { return !recipe.stages.empty(); };
  if (!std::ranges::all_of(recipes, loads)) return {};
  StudyKind kind;
  if (runs.size() > 1 &&
      std::ranges::all_of(recipes, [](const Recipe& recipe) { return strains_at_a_rate(recipe.stages.back()); }))
    kind.driven = runs;
  if (runs.size() >= fewest_runs) kind.flow = flow_of(recipes);
  return kind;
}

}  // namespace arenite::campaign
