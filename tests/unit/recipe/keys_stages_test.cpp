#include "recipe/keys/stages.hpp"

#include <gtest/gtest.h>

#include "unit/recipe/parsed.hpp"

namespace arenite::recipe {
namespace {

TEST(KeysOfStages, AStageOfMoreStepsThanCanBeCountedIsRefused) {
  const std::string timed = replaced(smallest, "bottom = ", "duration = \"150 ms\"\nbottom = ");
  EXPECT_TRUE(problems(timed, {"integration.time_step=1 ns"}).empty());
  const std::string short_steps = only_problem(timed, {"integration.time_step=1e-20 s"}),
                    long_stage = only_problem(timed, {"stages.load.duration=1e50 s"});
  EXPECT_NE(short_steps.find("r.toml:13:12: stages.0.duration: 0.15 s are 1.5e+19 steps of 1e-20 s"), std::string::npos)
      << short_steps;
  EXPECT_NE(long_stage.find("out of range; it must be above 0 s, up to"), std::string::npos) << long_stage;
  const std::string cycled = replaced(
      smallest, "bottom = { force = \"50 kN\" }",
      "strain_cycles = { of = \"top\", max = 0.01, rate = \"1e-9 1/s\", count = 1000000 }\nbottom = \"fixed\"");
  EXPECT_TRUE(problems(cycled).empty());
  only_problem(cycled, {"integration.time_step=1 us"});
}

TEST(KeysOfStages, CyclesTurnToAnySideThatTheSampleHas) {
  const std::string in_space = replaced(replaced("dimension = 3\n" + smallest, "thickness", "depth"), "bottom = {",
                                        "front = { force = \"1 kN\" }\nbottom = {");
  const std::string by_force = "cycles = { side = \"front\", min = \"1 kN\", max = \"2 kN\", count = 3 }\n",
                    by_strain = "strain_cycles = { of = \"back\", max = 0.01, rate = \"1 1/s\", count = 3 }\n";
  for (const std::string& cycles : {by_force, by_strain}) {
    const std::string with = "bottom = {", now = cycles + with;
    EXPECT_TRUE(problems(replaced(in_space, with, now)).empty()) << only_problem(replaced(in_space, with, now));
    EXPECT_NE(only_problem(replaced(smallest, with, now)).find("side is of samples in space"), std::string::npos);
  }
}

}  // namespace
}  // namespace arenite::recipe
