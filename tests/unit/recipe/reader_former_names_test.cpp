#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recipe/doubts.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {
namespace {

std::string recipe_with(const std::string& container, const std::string& snapshots, const std::string& equilibrium,
                        const std::string& masses) {
  return "[" + container +
         "]\nwidth = \"350 mm\"\nthickness = \"60 mm\"\n[materials.POM]\ndensity = \"1410 kg/m^3\"\nstiffness = \"27 "
         "kN/mm\"\n"
         "[[populations]]\nmaterial = \"POM\"\ncount = 10\ndiameter = \"16 mm\"\n[[stages]]\nname = \"load\"\n" +
         snapshots + " = 3\n" + masses + "\n" + equilibrium + " = { unbalanced = 1e-3 }\n";
}
const std::string then = recipe_with("frame", "frames", "rest", "masses = \"even\""),
                  now = recipe_with("container", "snapshots", "equilibrium", "mass_scaling = \"uniform\"");

TEST(FormerNames, AreReadWithANotice) {
  const Recipe former = parse_recipe(then, "r.toml"), current = parse_recipe(now, "r.toml");
  EXPECT_EQ(to_toml(former), to_toml(current));
  EXPECT_EQ(current.notices, doubts_of(current));
  ASSERT_EQ(former.notices.size(), 5 + doubts_of(former).size());
  EXPECT_EQ(former.notices[0], "frame is now called container; the former name is still read");
  EXPECT_EQ(former.notices[3],
            "stages.*.mass_scaling = \"even\" is now called \"uniform\"; the former name is still read");
}

TEST(FormerNames, AreReadOnTheCommandLineOverBoth) {
  for (const std::string& text : {then, now})
    for (const std::string set : {"frame.width=\"400 mm\"", "container.width=\"400 mm\""})
      EXPECT_EQ(parse_recipe(text, "r.toml", {set}).container.width, 0.4);
  for (const std::string set : {"stages.0.masses=own", "stages.0.mass_scaling=own", "stages.0.mass_scaling=none"})
    EXPECT_EQ(parse_recipe(now, "r.toml", {set}).stages[0].mass_scaling, dem::MassScaling::none) << set;
}

TEST(FormerNames, BesideTheNamesOfNowAreUnknown) {
  try {
    parse_recipe(now + "masses = \"own\"\n", "r.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("r.toml:", 0), 0u);
    EXPECT_NE(std::string(error.what()).find("masses: unknown key"), std::string::npos) << error.what();
  }
}

TEST(FormerNames, AreThoseThatResultsAreNamedBy) {
  const std::string changes = changed_keys(parse_recipe(now, "r.toml"));
  EXPECT_NE(changes.find("frame.width = \"350 mm\"\n"), std::string::npos) << changes;
  EXPECT_NE(changes.find("stages.0.rest.unbalanced = 0.001\n"), std::string::npos) << changes;
  EXPECT_NE(changes.find("stages.0.masses = \"even\"\n"), std::string::npos) << changes;
}

TEST(FormerNames, OfAPackingAreThoseThatVersion01Wrote) {
  const std::string text = to_toml_of_version_0_1(parse_recipe(now, "r.toml"));
  EXPECT_NE(text.find("\n[frame]\n"), std::string::npos) << text;
  for (const char* later : {"shape", "rolling", "bonds", "cohesion"})
    EXPECT_EQ(text.find(later), std::string::npos) << text;
}

}  // namespace
}  // namespace arenite::recipe
