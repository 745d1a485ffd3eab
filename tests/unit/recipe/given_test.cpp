#include "recipe/given.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "recipe/recipe.hpp"
#include "workflow/stage_keys.hpp"

namespace {
using namespace arenite;
using recipe::Given, recipe::MeasureSection;

TEST(Given, ValuesAreReadOverWhatIsThereAndProblemsBearTheirLabels) {
  MeasureSection section;
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
  MeasureSection section;
  const std::vector<Given> given{{"load_axis", "load_axis", recipe::parse_value("1.5")}};
  EXPECT_THROW(recipe::read_given_into(section, given), InputError);
  recipe::read_given_into(section, given, true);
  EXPECT_EQ(section.load_axis, 1.5);
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
  EXPECT_EQ(recipe::help_of(recipe::record_at(keys, "stiffness.matrix")),
            "Young's modulus of bonds between two nodes of matrix (default 1 GPa; above 0 GPa)");
  EXPECT_THROW(recipe::record_at(keys, "nothing"), std::logic_error);
}

TEST(Given, MeasurementNamesResultsOnlyWhereItDiffersFromTheDefault) {
  recipe::Recipe plain = recipe::recipe_templates().front().make(), measured = plain;
  measured.measure = MeasureSection{.border = 4};
  EXPECT_NE(workflow::plan_of(plain).front().hash, workflow::plan_of(measured).front().hash);
  EXPECT_EQ(workflow::seed_key(plain), workflow::seed_key(measured)) << "the same samples are drawn";
}

}  // namespace
