#include "recipe/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/small_study.hpp"

namespace arenite::recipe {
namespace {

std::string value_of(const std::string& recipe, const std::string& key) {
  for (const auto& [name, value] : settings_of(recipe))
    if (name == key) return value;
  return "none";
}

TEST(Settings, AreTheKeysOfARecipeWithItsDefaults) {
  EXPECT_EQ(value_of(test::small_cemented_recipe, "stages.0.name"), "prepare");
  EXPECT_EQ(value_of(test::small_cemented_recipe, "stages.0.top.force"), "0.1 kN");
  EXPECT_NE(value_of(test::small_cemented_recipe, "contact.friction"), "none") << "a default";
}

TEST(Settings, OfAnotherVersionAreWhatIsWritten) {
  EXPECT_EQ(value_of("[unheard]\nof = [1, 2.5, true]\n", "unheard.of.1"), "2.5");
  EXPECT_EQ(value_of("[unheard]\nof = [1, 2.5, true]\n", "unheard.of.2"), "true");
  EXPECT_TRUE(settings_of("no TOML").empty());
  EXPECT_TRUE(settings_of("").empty());
}

}  // namespace
}  // namespace arenite::recipe
