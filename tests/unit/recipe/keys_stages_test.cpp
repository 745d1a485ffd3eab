#include "recipe/keys/stages.hpp"

#include <gtest/gtest.h>

#include "unit/recipe/parsed.hpp"

namespace arenite::recipe {
namespace {

TEST(KeysOfStages, AStageOfMoreStepsThanCanBeCountedIsRefused) {
  const std::string timed = replaced(smallest, "bottom = ", "duration = \"150 ms\"\nbottom = ");
  EXPECT_TRUE(problems(timed, {"integration.time_step=1 ns"}).empty());
  const auto short_steps = problems(timed, {"integration.time_step=1e-20 s"});
  ASSERT_EQ(short_steps.size(), 1u);
  EXPECT_NE(short_steps[0].find("r.toml:13:12: stages.0.duration: 0.15 s are 1.5e+19 steps of 1e-20 s"),
            std::string::npos)
      << short_steps[0];
  const auto long_stage = problems(timed, {"stages.load.duration=1e50 s"});
  ASSERT_EQ(long_stage.size(), 1u);
  EXPECT_NE(long_stage[0].find("out of range; it must be above 0 s, up to"), std::string::npos) << long_stage[0];
  const std::string cycled = replaced(
      smallest, "bottom = { force = \"50 kN\" }",
      "strain_cycles = { of = \"top\", max = 0.01, rate = \"1e-9 1/s\", count = 1000000 }\nbottom = \"fixed\"");
  EXPECT_TRUE(problems(cycled).empty());
  EXPECT_EQ(problems(cycled, {"integration.time_step=1 us"}).size(), 1u);
}

}  // namespace
}  // namespace arenite::recipe
