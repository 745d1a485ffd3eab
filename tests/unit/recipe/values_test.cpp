#include "recipe/values.hpp"

#include <gtest/gtest.h>

#include "unit/recipe/parsed.hpp"

namespace arenite::recipe {
namespace {

TEST(Values, ASideIsDrivenInOneWay) {
  const std::string two = "{ velocity = \"1 mm/s\", pressure = \"1 kPa\" }",
                    in_file = only_problem(replaced(smallest, "{ force = \"50 kN\" }", two)),
                    set = only_problem(smallest, {"stages.0.bottom=" + two});
  EXPECT_NE(in_file.find("r.toml:13:10: stages.0.bottom: is given as velocity and pressure; keep one"),
            std::string::npos)
      << in_file;
  EXPECT_NE(set.find("stages.0.bottom: is given as velocity and pressure; keep one"), std::string::npos) << set;
  only_problem(smallest, {"stages.0.bottom.force=60 kN", "stages.0.bottom.pressure=1 kPa"});
  EXPECT_EQ(parsed(smallest, {"stages.0.bottom.pressure=1 kPa"}).stages[0].side[bottom].value, 1000)
      << "what is set counts over the form of the file";
}

TEST(Values, AWholeNumberOfTooManyDigitsIsOutOfRange) {
  const auto told = problems(smallest, {"seed=99999999999999999999"});
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("seed: 99999999999999999999 is out of range; it must be from 0 to 9223372036854775807"),
            std::string::npos)
      << told[0];
  const auto text = problems("seed = \"5\"\n" + smallest);
  ASSERT_EQ(text.size(), 1u);
  EXPECT_NE(text[0].find("seed: is a text, but must be a whole number"), std::string::npos) << text[0];
  EXPECT_EQ(parsed("seed = 7.0\n" + smallest).seed, 7u);
}

}  // namespace
}  // namespace arenite::recipe
