#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "recipe/recipe.hpp"

/// Any bytes are a recipe or an InputError with a sentence; and what was understood is written so that it reads back as
/// the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace arenite;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  recipe::Recipe recipe;
  try {
    recipe = recipe::parse_recipe(text, "fuzz.toml");
  } catch (const InputError& error) {
    if (error.problems().empty() || std::string(error.what()).empty()) std::abort();
    return 0;
  }
  const std::string resolved = recipe::to_toml(recipe);
  if (!(recipe::parse_recipe(resolved, "fuzz.toml") == recipe)) std::abort();
  if (!(recipe::parse_recipe(recipe::to_commented_toml(recipe), "fuzz.toml") == recipe)) std::abort();
  return 0;
}
