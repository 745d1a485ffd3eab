#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

// What fuzzing found, and its seeds: each is understood, and then reads back the same, or is refused with a sentence.
TEST(RecipeCorpus, EveryInputIsUnderstoodOrRefused) {
  int understood = 0, refused = 0;
  for (const auto& file : std::filesystem::directory_iterator(ARENITE_SOURCE_DIR "/tests/fuzz/corpus/recipe")) {
    SCOPED_TRACE(file.path().filename().string());
    try {
      const Recipe recipe = parse_recipe(io::read_file(file.path()), "corpus.toml");
      EXPECT_EQ(parse_recipe(to_toml(recipe), "corpus.toml"), recipe);
      ++understood;
    } catch (const InputError& error) {
      ASSERT_FALSE(error.problems().empty());
      EXPECT_FALSE(error.problems().front().message.empty());
      ++refused;
    }
  }
  EXPECT_GE(understood, 3);
  EXPECT_GE(refused, 4);
}

}  // namespace
}  // namespace arenite::recipe
