#include "report/stage_doubts.hpp"

#include <gtest/gtest.h>

#include "model/result.hpp"

namespace arenite::report {
namespace {

TEST(StageDoubts, AreOfADischargeWhoseFillingIsLowBesideTheOpening) {
  StageResult silo;
  silo.texture["surface"]["height_before_m"] = 0.108;
  EXPECT_TRUE(doubts_about(silo.texture).empty()) << "no opening is known";
  silo.texture["discharge"]["opening_m"] = 0.04;
  EXPECT_TRUE(doubts_about(silo.texture).empty());
  silo.texture["discharge"]["opening_m"] = 0.075;
  const auto doubts = doubts_about(silo.texture);
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_TRUE(doubts[0].starts_with("the filling was 1.4 openings high")) << doubts[0];
}

}  // namespace
}  // namespace arenite::report
