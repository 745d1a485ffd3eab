#include "campaign/key_words.hpp"

#include <gtest/gtest.h>

namespace arenite::campaign {
namespace {

TEST(KeyWords, NameItemsOfListsByTheirNamesAndLeaveOutWhatSaysNothing) {
  const recipe::Node recipe = recipe::read_document(R"([variables]
D = "3 mm"
[materials.sand]
[[populations]]
material = "sand"
[[stages]]
name = "fill"
[[stages]]
name = "shear"
[[loads]]
)",
                                                    "recipe.toml");
  EXPECT_EQ(words_of_key(recipe, "variables.D"), "D");
  EXPECT_EQ(words_of_key(recipe, "stages.1.duration"), "duration of shear");
  EXPECT_EQ(words_of_key(recipe, "stages.shear.top.velocity"), "top velocity of shear");
  EXPECT_EQ(words_of_key(recipe, "populations.0.count"), "count of sand");
  EXPECT_EQ(words_of_key(recipe, "materials.sand.stiffness"), "stiffness of sand");
  EXPECT_EQ(words_of_key(recipe, "loads.0.max_strain"), "max strain of loads 1");
  EXPECT_EQ(words_of_key(recipe, "cement.width"), "cement width");
  EXPECT_EQ(words_of_key(recipe, "contact.tangential_stiffness_ratio"), "contact tangential stiffness ratio");
}

}  // namespace
}  // namespace arenite::campaign
