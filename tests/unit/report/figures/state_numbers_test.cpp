#include "report/figures/state_numbers.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/page_document.hpp"
#include "support/page_sample.hpp"

using namespace arenite;
using report::figures::state_numbers;

namespace {

/// A stage whose results hold a wider error of the coordination number than its last state alone shows, and a number
/// of the stage.
test::PageSample& stored(test::PageSample& sample) {
  sample.stage.texture = {{"coordination", {{"all", {{"value", 3.5}, {"error", 0.75}}}}},
                          {"flow", {{"value", 2.0}, {"error", 0.1}}}};
  return sample;
}

double error_of(const Numbers& numbers) { return numbers["coordination"]["all"]["error"].get<double>(); }

}  // namespace

TEST(StateNumbers, TheLastStateHasTheErrorsThatItsStageIsStoredWith) {
  test::PageSample sample(60);
  const StageResult& stage = stored(sample).stage;
  for (const bool curves : {true, false}) {
    const Numbers last = state_numbers(stage, stage.snapshots.back(), curves);
    EXPECT_EQ(error_of(last), 0.75);
    EXPECT_EQ(last["flow"]["value"].get<double>(), 2);
    EXPECT_TRUE(last.contains("solid_fraction"));
    const Numbers before = state_numbers(stage, stage.snapshots[3], curves);
    EXPECT_LT(error_of(before), 0.7);
    EXPECT_FALSE(before.contains("flow"));
  }
}

TEST(StateNumbers, ThePageShowsThem) {
  test::PageSample sample(60);
  const StageResult& stage = stored(sample).stage;
  const auto shown = nlohmann::json::parse(report::page_document(sample.data).json)["snapshots"];
  EXPECT_EQ(shown[4]["texture"]["coordination"]["all"]["error"], 0.75);
  EXPECT_NEAR(shown[3]["texture"]["coordination"]["all"]["error"].get<double>(),
              error_of(state_numbers(stage, stage.snapshots[3])), 1e-4);
}
