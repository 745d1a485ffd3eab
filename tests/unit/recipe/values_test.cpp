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

}  // namespace
}  // namespace arenite::recipe
