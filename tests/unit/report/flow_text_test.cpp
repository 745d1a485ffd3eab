#include <gtest/gtest.h>

#include "report/result_text.hpp"

namespace arenite::report {
namespace {

TEST(FlowText, TellsWhatIsKnownWithItsErrorAndNothingElse) {
  EXPECT_TRUE(flow_text(Numbers{{"coordination", 3}}).empty());
  const Numbers n{{"discharge", {{"steady", true}, {"rate_kg_s", {{"value", 0.19712}, {"error", 0.0021}}}, {"begin_s", 0.25}}},
                  {"surface", {{"right_m", 0.8}, {"angle_deg", {{"value", 26.571}, {"error", 0.93}}}}}};
  const std::string text = flow_text(n);
  EXPECT_NE(text.find("0.1971 +- 0.0021 kg/s"), std::string::npos) << text;
  EXPECT_NE(text.find("26.57 +- 0.93 deg"), std::string::npos) << text;
  EXPECT_NE(text.find("right end"), std::string::npos);
  EXPECT_EQ(text.find("run-out"), std::string::npos);
  EXPECT_EQ(text.find("opening"), std::string::npos);
}

}  // namespace
}  // namespace arenite::report
