#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/given.hpp"
#include "recipe/recipe.hpp"
#include "workflow/identify/identify_keys.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::recipe {
namespace {

std::string with_material(const std::string& constants, const std::string& rest = "") {
  return R"([container]
width = "100 mm"
height = "100 mm"
thickness = "10 mm"
[[populations]]
material = "glass"
count = 10
diameter = "5 mm"
[[stages]]
name = "load"
gravity = true
[materials.glass]
density = "2500 kg/m^3"
)" + constants +
         rest;
}
const std::string both = "youngs_modulus = \"70 GPa\"\npoisson = 0.22\n",
                  mindlin = "[contact]\nnormal = \"hertz_mindlin\"\n";

std::string refusal(const std::string& text) {
  try {
    parse_recipe(text, "r.toml");
    return "none";
  } catch (const InputError& error) {
    return error.problems().size() == 1 ? error.what() : "several: " + std::string(error.what());
  }
}

TEST(Materials, TakeModuliForAStiffness) {
  const Recipe recipe = parse_recipe(with_material(both, mindlin), "r.toml");
  const Material& glass = recipe.materials.at(0);
  EXPECT_EQ(glass.youngs_modulus, 70e9);
  EXPECT_EQ(glass.poisson, 0.22);
  EXPECT_EQ(glass.stiffness, 0);
  EXPECT_EQ(parse_recipe(to_toml(recipe), "r.toml"), recipe);
  EXPECT_EQ(refusal(with_material(both + "stiffness = \"1 kN/mm\"\n")), "none");
}

TEST(Materials, SayWhatTheNormalLawNeeds) {
  const std::string stiffness = "stiffness = \"1 kN/mm\"\n";
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find("several") != 0 && text.find(part) != std::string::npos;
  };
  const std::string needs =
      "normal = \"hertz_mindlin\" needs E and nu; write youngs_modulus and poisson in [materials.glass]";
  for (const std::string& lacking :
       {stiffness, stiffness + "poisson = 0.2\n", stiffness + "youngs_modulus = \"1 GPa\"\n"})
    EXPECT_TRUE(has(refusal(with_material(lacking, mindlin)), needs)) << refusal(with_material(lacking, mindlin));
  EXPECT_TRUE(has(refusal(with_material(both)), "needs a stiffness; write it in [materials.glass]"))
      << refusal(with_material(both));
  EXPECT_TRUE(has(refusal(with_material("")), "materials.glass.stiffness: is missing")) << refusal(with_material(""));
  EXPECT_TRUE(has(refusal(with_material("youngs_modulus = \"70 GPa\"\npoisson = 0.6\n" + stiffness)),
                  "poisson: 0.6 is out of range"));
}

}  // namespace
TEST(Given, ValuesAreReadOverWhatIsThereAndProblemsBearTheirLabels) {
  Measuring section;
  section.seed = 7;
  recipe::read_given_into(section, {{"--border", "border", recipe::parse_value("1.5")}});
  EXPECT_EQ(section.border, 1.5);
  EXPECT_EQ(section.seed, 7u);
  try {
    recipe::read_given_into(section, {{"--border", "border", recipe::parse_value("-1")}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--border: -1 is out of range; it must be from 0 to 1000");
  }
}

TEST(Given, NumbersWithoutUnitAreInSiOnlyWhereThatIsAsked) {
  Measuring section;
  const std::vector<recipe::Given> given{{"load_axis", "load_axis", recipe::parse_value("1.5")}};
  EXPECT_THROW(recipe::read_given_into(section, given), InputError);
  recipe::read_given_into(section, given, true);
  EXPECT_EQ(section.load_axis, 1.5);
}

TEST(Given, AMeasuredValueIsANumberPerhapsWithItsError) {
  const auto read = [](const std::string& stiffness) {
    const auto keys = recipe::every_key<workflow::AdhesionRequest>();
    workflow::AdhesionRequest request;
    recipe::read_given_into(request,
                            {{"--k", "stiffness", recipe::value_of(recipe::record_at(keys, "stiffness"), stiffness)}});
    return *request.stiffness;
  };
  EXPECT_DOUBLE_EQ(read("27.35 kN/mm").value, 27.35e6);
  EXPECT_EQ(read("27.35 kN/mm").error, 0);
  EXPECT_DOUBLE_EQ(read("27.35 +- 0.40 kN/mm").value, 27.35e6);
  EXPECT_DOUBLE_EQ(read("27.35 +- 0.40 kN/mm").error, 0.40e6);
  for (const char* wrong : {"-1 kN/mm", "0 kN/mm", "27.35 mm", "27.35 +- -1 kN/mm", "1 kN/mm,2 kN/mm,3 kN/mm", "27"})
    EXPECT_THROW(read(wrong), InputError) << wrong;
}

TEST(Given, KeysWithoutEffectAreToldAndLeftAside) {
  recipe::Load load;
  const auto told = recipe::read_given_into(load, {{"--max-strain", "max_strain", recipe::parse_value("0.5")}});
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0], "--max-strain: only has an effect with failure = true; it is left aside");
  EXPECT_EQ(load, recipe::Load{});
}

TEST(Given, HelpHasSentenceDefaultAndRange) {
  const auto keys = recipe::every_key<recipe::Load>();
  EXPECT_EQ(recipe::help_of(recipe::record_at(keys, "strain")),
            "Nominal strain: displacement of the top row over the height (default 0.0001; above 0, up to 0.5)");
  EXPECT_EQ(
      recipe::help_of(recipe::record_at(keys, "stiffness.matrix")),
      "Young's modulus of the matrix: of bonds between two of its nodes, or its elements (default 1 GPa; above 0 GPa)");
  EXPECT_THROW(recipe::record_at(keys, "nothing"), std::logic_error);
}

TEST(Given, MeasurementNamesResultsOnlyWhereItDiffersFromTheDefault) {
  recipe::Recipe plain = recipe::recipe_templates().front().make(), measured = plain;
  measured.measure.emplace().border = 4;
  EXPECT_NE(workflow::plan_of(plain).front().hash, workflow::plan_of(measured).front().hash);
  EXPECT_EQ(workflow::seed_key(plain), workflow::seed_key(measured)) << "the same samples are drawn";
  measured.measure = Measuring{};
  EXPECT_EQ(workflow::plan_of(plain), workflow::plan_of(measured));
}

TEST(Given, ASectionThatHoldsItsDefaultsIsAsNone) {
  const std::string text(recipe_templates().front().text);
  const Recipe plain = parse_recipe(text, "r.toml");
  for (const char* section : {"[measure]\n", "[measure]\nborder = 2.5\nseed = 1\n"}) {
    const Recipe with = parse_recipe(text + section, "r.toml");
    EXPECT_EQ(with, plain) << section;
    EXPECT_EQ(workflow::plan_of(with), workflow::plan_of(plain)) << section;
  }
  EXPECT_EQ(changed_keys(parse_recipe(text + "[measure]\nborder = 2\n", "r.toml")),
            changed_keys(plain) + "[measure]\nmeasure.border = 2\n")
      << "the names that results of such recipes have had";
  const std::string film = to_toml(film_template());
  const auto film_keys = [](const std::string& of) { return changed_keys(parse_film_recipe(of, "film.toml")); };
  EXPECT_EQ(film_keys(film + "[film]\n"), film_keys(film));
  EXPECT_NE(film_keys(film + "[film]\nframe_rate = \"50 Hz\"\n"), film_keys(film));
}

}  // namespace arenite::recipe
