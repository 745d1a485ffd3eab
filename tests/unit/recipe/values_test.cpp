#include "recipe/values.hpp"

#include <gtest/gtest.h>

#include "unit/recipe/parsed.hpp"

namespace arenite::recipe {
namespace {

TEST(Values, ASideIsDrivenInOneWay) {
  const auto in_file =
      problems(replaced(smallest, "{ force = \"50 kN\" }", "{ velocity = \"1 mm/s\", pressure = \"1 kPa\" }"));
  ASSERT_EQ(in_file.size(), 1u);
  EXPECT_NE(in_file[0].find("r.toml:13:10: stages.0.bottom: is given as velocity and pressure; keep one"),
            std::string::npos)
      << in_file[0];
  const auto set = problems(smallest, {"stages.0.bottom={ velocity = \"1 mm/s\", pressure = \"1 kPa\" }"});
  ASSERT_EQ(set.size(), 1u);
  EXPECT_NE(set[0].find("stages.0.bottom: is given as velocity and pressure; keep one"), std::string::npos) << set[0];
  EXPECT_EQ(problems(smallest, {"stages.0.bottom.force=60 kN", "stages.0.bottom.pressure=1 kPa"}).size(), 1u);
  EXPECT_EQ(parsed(smallest, {"stages.0.bottom.pressure=1 kPa"}).stages[0].side[bottom].value, 1000)
      << "what is set counts over the form of the file";
}

}  // namespace
}  // namespace arenite::recipe
