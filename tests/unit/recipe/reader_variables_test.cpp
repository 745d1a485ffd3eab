#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "recipe/recipe.hpp"
#include "unit/recipe/smallest_recipe.hpp"

namespace arenite::recipe {
namespace {

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

const std::string written =
    "[variables]\nD = \"16.4 mm\"\nn = 5\nW = \"2*n*D + 186 mm\"\n" +
    with(with(with(smallest, "\"350 mm\"", "\"W\""), "\"16.4 mm\"", "\"D\""), "count = 10", "count = \"2*n\"");

std::string refusal_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_recipe(text, "r.toml", overrides);
    return "";
  } catch (const InputError& error) { return error.what(); }
}

TEST(Variables, StandForTheirNumbers) {
  const Recipe plain = parse_recipe(smallest, "r.toml"), named = parse_recipe(written, "r.toml");
  EXPECT_DOUBLE_EQ(named.container.width, 0.35);
  EXPECT_EQ(named.populations, plain.populations);
  EXPECT_EQ(to_toml(named).find("variables"), std::string::npos);
  EXPECT_EQ(parse_recipe(to_toml(named), "r.toml"), named);
}

TEST(Variables, AreChangedFromOutside) {
  const Recipe changed = parse_recipe(written, "r.toml", {"variables.n=7", "contact.friction=\"n/10\""});
  EXPECT_DOUBLE_EQ(changed.container.width, 14 * 0.0164 + 0.186);
  EXPECT_EQ(changed.populations[0].count, 14);
  EXPECT_DOUBLE_EQ(changed.contact.friction, 0.7);
}

TEST(Variables, MayBeDefinedInAnyOrder) {
  const std::string text = with(written, "D = \"16.4 mm\"\n", "") + "[variables.more]\n";
  EXPECT_NE(refusal_of(text), "");
  EXPECT_DOUBLE_EQ(parse_recipe(with(written, "D = \"16.4 mm\"\nn = 5\nW = \"2*n*D + 186 mm\"\n",
                                     "W = \"2*n*D + 186 mm\"\nn = 5\nD = \"16.4 mm\"\n"),
                                "r.toml")
                       .container.width,
                   0.35);
}

TEST(Variables, WhatIsWrongWithThemIsSaidWhereItStands) {
  EXPECT_NE(refusal_of(with(written, "D = \"16.4 mm\"", "D = \"16.4 mn\"")).find("r.toml:2"), std::string::npos);
  EXPECT_NE(refusal_of(with(written, "\"W\"", "\"Volume\"")).find("there are: D, n, W"), std::string::npos);
  EXPECT_NE(refusal_of(with(written, "\"W\"", "\"2*n\"")).find("a length is needed"), std::string::npos);
  EXPECT_NE(refusal_of(with(written, "n = 5", "n = \"W/D\"")).find("no variable"), std::string::npos);
  EXPECT_NE(refusal_of(with(written, "n = 5", "mm = 5")).find("cannot be the name"), std::string::npos);
  EXPECT_NE(refusal_of(with(written, "\"2*n\"", "\"n/2\"")).find("not a whole number"), std::string::npos);
}

TEST(Variables, AreNoTexts) {
  const Recipe named = parse_recipe("title = \"D\"\n" + written, "r.toml");
  EXPECT_EQ(named.title, "D");
}

TEST(Names, LeadToItemsLikeNumbers) {
  const Recipe by_name =
      parse_recipe(smallest, "r.toml", {"stages.load.bottom={force=\"60 kN\"}", "populations.POM.count=12"});
  EXPECT_EQ(by_name, parse_recipe(smallest, "r.toml", {"stages.0.bottom={force=\"60 kN\"}", "populations.0.count=12"}));
  EXPECT_NE(refusal_of(smallest, {"stages.laod.gravity=true"}).find("nor the name of one: load"), std::string::npos);
  const std::string twice = smallest + "[[stages]]\nname = \"load\"\n";
  EXPECT_NE(refusal_of(twice, {"stages.load.gravity=true"}).find("2 items are called"), std::string::npos);
}

TEST(Choices, OneMisspeltWordIsOneProblem) {
  const std::string text =
      with(smallest, "diameter = \"16.4 mm\"", "size = { law = \"unifrom\", min = \"1 mm\", max = \"2 mm\" }");
  try {
    parse_recipe(text, "r.toml");
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 1u) << error.what();
    EXPECT_NE(error.problems()[0].message.find("did you mean \"uniform\"?"), std::string::npos);
  }
}

TEST(Rotations, AreGivenInTurns) {
  EXPECT_NE(refusal_of(smallest, {"stages.0.drag=5 rpm"}).find("a unit of rotation"), std::string::npos);
}

}  // namespace
}  // namespace arenite::recipe
