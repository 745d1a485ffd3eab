#include "workflow/run_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "workflow/field_stages.hpp"
#include "workflow/final_state.hpp"
#include "workflow/named_result.hpp"
#include "recipe/recipe.hpp"

namespace arenite::study {
namespace {

namespace fs = std::filesystem;

const Load& load_of(const Recipe& recipe, const fs::path& run, const std::string& name) {
  const auto at = std::find_if(recipe.loads.begin(), recipe.loads.end(), [&](const Load& load) { return name == "*" || load.name == name; });
  if (at == recipe.loads.end()) throw InputError(run.string(), 0, fmt::format("there is no load \"{}\" of this run; name one of its recipe", name));
  return *at;
}

/// What a file would hold: single precision.
FieldResult as_stored(FieldResult result) {
  StressField& f = result.field;
  for (auto* values : {&f.ux, &f.uy, &f.xx, &f.yy, &f.xy})
    for (double& value : *values) value = static_cast<double>(static_cast<float>(value));
  return result;
}

}  // namespace

FieldResult field_of(const fs::path& run, const std::string& load) {
  const Recipe recipe = read_recipe((run / "recipe.toml").string());
  const Load* wanted = load.empty() ? nullptr : &load_of(recipe, run, load);
  if (auto field = load_named(run, wanted ? wanted->name : "cement")) return std::move(*field);
  FieldResult sample = make_cemented_sample(recipe, final_state(run).packing);
  if (!wanted) return sample;
  return as_stored(apply_load(*wanted, sample, [](const auto&) { return true; }).value());
}

}  // namespace arenite::study
