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
  const std::string recipe = test::small_packing_recipe + "[[stages]]\nname = \"load\"\nslide = { top = \"1 mm/s\" }\n";
  EXPECT_EQ(value_of(recipe, "stages.0.name"), "load");
  EXPECT_EQ(value_of(recipe, "stages.0.slide.top"), "1 mm/s");
  EXPECT_NE(value_of(recipe, "contact.friction"), "none") << "a default";
}

TEST(Settings, OfAnotherVersionAreWhatIsWritten) {
  EXPECT_EQ(value_of("[unheard]\nof = [1, 2.5, true]\n", "unheard.of.1"), "2.5");
  EXPECT_EQ(value_of("[unheard]\nof = [1, 2.5, true]\n", "unheard.of.2"), "true");
  EXPECT_TRUE(settings_of("no TOML").empty());
  EXPECT_TRUE(settings_of("").empty());
}

}  // namespace
}  // namespace arenite::recipe
