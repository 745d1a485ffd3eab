#include "study/recipe.hpp"

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "io/read_file.hpp"
#include "study/recipe_keys.hpp"
#include "study/recipe_reader.hpp"

namespace arenite::study {
namespace {

Recipe read_from(std::string_view text, Reading& reading, const std::vector<std::string>& overrides) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError(reading.file_name, 0, "the recipe is empty; `arenite init composite` writes one to start from");
  }
  Node root = read_document(text, reading.file_name);
  for (const auto& assignment : overrides) {
    try {
      apply_override(root, assignment);
    } catch (const InputError& error) {
      reading.problems.insert(reading.problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  Recipe recipe;
  recipe.source_file = reading.file_name;
  RecipeReader reader(root, "", reading);
  declare(reader, recipe);
  reader.refuse_unknown_keys();
  if (reading.problems.empty()) return recipe;
  std::stable_sort(reading.problems.begin(), reading.problems.end(), [](const Problem& a, const Problem& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  });
  throw InputError(std::move(reading.problems));
}

}  // namespace

CementSection Recipe::cement_or_none() const {
  CementSection none;
  none.law.kind = cement::CementParameters::Kind::none;
  return cement.value_or(none);
}

Recipe read_recipe(const std::string& file, const std::vector<std::string>& overrides) {
  Reading reading{file, std::filesystem::path(file).parent_path().string(), true, {}};
  return read_from(io::read_file(file), reading, overrides);
}

Recipe parse_recipe(std::string_view text, const std::string& file_name, const std::vector<std::string>& overrides) {
  Reading reading{file_name, {}, false, {}};
  return read_from(text, reading, overrides);
}

}  // namespace arenite::study
