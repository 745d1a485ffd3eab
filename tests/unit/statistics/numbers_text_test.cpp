#include <gtest/gtest.h>

#include "statistics/numbers.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite {
namespace {

using statistics::described;

TEST(NumbersText, TellsWhatIsKnownWithItsErrorUnitAndMeaningAndNothingElse) {
  const Numbers n{
      {"discharge",
       {{"steady", true},
        {"rate_kg_s", described({{"value", 0.19712}, {"error", 0.0021}}, "kg/s", "Rate of discharge")},
        {"begin_s", nullptr}}},
      {"surface",
       {{"right_m", 0.8}, {"angle_deg", described({{"value", 26.571}, {"error", 0.93}}, "deg", "Angle of repose")}}},
      {"curve", {1, 2, 3, 4, 5}}};
  const std::string text = to_text(n);
  EXPECT_NE(text.find("0.1971 +- 0.0021 kg/s   Rate of discharge\n"), std::string::npos) << text;
  EXPECT_NE(text.find("26.57 +- 0.93 deg"), std::string::npos) << text;
  EXPECT_NE(text.find("surface.right_m "), std::string::npos) << text;
  for (const char* absent : {"begin", "curve"}) EXPECT_EQ(text.find(absent), std::string::npos) << text;
  EXPECT_EQ(to_text(n, {"discharge right_m"}).find("  surface.angle_deg "), 0u);
}

TEST(NumbersText, WritesStressesInTheUnitThatSuitsThemAndTensorsByRows) {
  const Numbers n{
      {"stress", described(statistics::TensorEstimate{{-80610, 1230, 1240, -84250}, {110, 120, 130, 140}}, "Pa", "")}};
  EXPECT_EQ(to_text(n),
            "  stress                           -80.61 +- 0.11, 1.23 +- 0.12; 1.24 +- 0.13, -84.25 +- 0.14 kPa\n");
}

TEST(NumbersText, LeavesOutASetThatIsAllOfItsWhole) {
  const Numbers n{{"force", {{"count", 7}, {"by_type", {{"POM-POM", {{"count", 7}}}, {"POM-HDPE", {{"count", 3}}}}}}},
                  {"notes", {"Seven."}}};
  EXPECT_EQ(to_text(n), "  force.count                      7\n  force.by_type.POM-HDPE.count     3\n  note: Seven.\n");
}

TEST(NumbersText, LeavesOutNamesWithAnEndingButNotTheEndingAlone) {
  const Numbers n{{"POM strong", 1}, {"strong", 2}};
  EXPECT_EQ(to_text(n, {"", "strong weak"}), "  strong                           2\n");
}

TEST(NumbersText, RowsAreThoseOfTheNamesInTheirOrder) {
  const Numbers n{{"z", 4}, {"sets", {{"large", {{"mean", 1.5}}}, {"small", {{"mean", 0.5}}}}}};
  EXPECT_EQ(rows_of(n, "sets.*.mean none z"),
            "  sets.large.mean                  1.5\n  sets.small.mean                  0.5\n  z                       "
            "         4\n");
}

}  // namespace
}  // namespace arenite
