#include <gtest/gtest.h>

#include "report/study/default_figures.hpp"

namespace arenite::report {
namespace {

campaign::CollectedTable two_kinds() {
  campaign::CollectedTable t;
  t.keys = {{"cement.kind", ""}, {"contact.friction", ""}, {"seed", ""}};
  t.names = {"odd.number", "coordination.all", "solid_fraction"};
  t.meanings = {{"coordination.all", {"", "Contacts of a grain, mean of all"}},
                {"solid_fraction", {"%", "Area of grains"}}};
  for (const char* kind : {"bridges", "full"})
    for (const char* friction : {"0.1", "0.3", "10"})
      for (const char* seed : {"1", "2"})
        t.rows.push_back({std::string(kind) + friction + seed,
                          "done",
                          {kind, friction, seed},
                          1,
                          {campaign::Estimate{1}, campaign::Estimate{4, 0.1}, {}}});
  return t;
}

TEST(DefaultFigures, AreMainNumbersAgainstTheKeyWithTheMostNumbers) {
  const auto figures = default_figures(two_kinds());
  ASSERT_EQ(figures.size(), 3u);
  EXPECT_EQ(figures[0].y.front(), "solid_fraction");
  EXPECT_EQ(figures[1].y.front(), "coordination.all");
  EXPECT_EQ(figures[2].y.front(), "odd.number");  // what there is, where less is known
  EXPECT_EQ(figures[0].title, "Area of grains");
  EXPECT_EQ(figures[0].y_axis.unit, "%");
  EXPECT_EQ(figures[1].title, "Contacts of a grain");
  EXPECT_EQ(figures[1].caption, "Contacts of a grain, mean of all.");
  EXPECT_EQ(figures[2].title, "odd.number");
  for (const auto& figure : figures) {
    EXPECT_EQ(figure.x, "contact.friction");
    EXPECT_TRUE(figure.x_axis.logarithmic);
    EXPECT_EQ(figure.by, "cement.kind");
  }
}

/// Three keys, each combination of their values once.
campaign::CollectedTable three_keys(int thirds) {
  campaign::CollectedTable t;
  t.keys = {{"variables.I", "", "I"}, {"contact.friction", "", "friction"}, {"variables.P", "kPa", "P"}};
  t.names = {"solid_fraction"};
  for (const char* rate : {"0.01", "0.02", "0.03", "0.04", "0.05", "0.06", "0.07", "0.08", "0.09", "0.1"})
    for (const char* friction : {"0.1", "0.3"})
      for (int p = 0; p < thirds; ++p) {
        const std::string pressure = std::to_string(10 + p);
        t.rows.push_back({rate + pressure + friction, "done", {rate, friction, pressure}, 1, {campaign::Estimate{1}}});
      }
  return t;
}

TEST(DefaultFigures, OfThreeKeysAreOneForEachValueOfTheOneThatNeitherAxisNorCurvesShow) {
  const auto figures = default_figures(three_keys(3));
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].x, "variables.I");
  EXPECT_EQ(figures[0].by, "variables.P");
  EXPECT_EQ(figures[0].where, (Wanted{{"contact.friction", {"0.1"}}}));
  EXPECT_EQ(figures[1].where, (Wanted{{"contact.friction", {"0.3"}}}));
  EXPECT_EQ(figures[1].title, "solid_fraction, friction = 0.3");
  EXPECT_NE(figures[0].id, figures[1].id);
}

TEST(DefaultFigures, OfAKeyWithTooManyValuesForCurvesJoinNoPointsOfOthers) {
  const auto figures = default_figures(three_keys(9));
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_EQ(figures[0].by, "contact.friction");
  EXPECT_TRUE(figures[0].where.empty());
  EXPECT_FALSE(figures[0].lines);
  EXPECT_EQ(figures[0].caption, "Runs of every value of P.");
}

TEST(DefaultFigures, AreNoneWhereNothingIsSweptButTheSeedOrWords) {
  auto t = two_kinds();
  t.keys = {{"seed", ""}};
  for (auto& row : t.rows) row.values = {"1"};
  EXPECT_TRUE(default_figures(t).empty());
  t.keys = {{"cement.kind", ""}};
  for (auto& row : t.rows) row.values = {row.run.substr(0, 4)};
  EXPECT_TRUE(default_figures(t).empty());
}

TEST(DefaultFigures, KeysThatVaryTogetherAreOneAxis) {
  auto t = two_kinds();
  t.keys = {{"variables.D", "mm", "D"}, {"contact.friction", "", "friction"}, {"variables.W", "mm", "W"}};
  const char *widths[] = {"30", "40", "60"}, *outer[] = {"150", "200", "300"};
  for (std::size_t k = 0; k < t.rows.size(); ++k)
    t.rows[k].values = {widths[k % 3], k % 2 == 0 ? "0.1" : "0.5", outer[k % 3]};
  const Figure first = default_figures(t).front();
  EXPECT_EQ(first.x, "variables.D");
  EXPECT_EQ(first.x_axis.label, "D");
  EXPECT_EQ(first.x_axis.unit, "mm");
  EXPECT_EQ(first.by, "contact.friction");
  EXPECT_TRUE(first.caption.ends_with("With D goes W.")) << first.caption;
  t.rows.back().values[2] = "150";
  EXPECT_NE(default_figures(t).front().by, "contact.friction") << "W now differs where D does not";
}

TEST(DefaultFigures, BeginWithWhatOneAsksOfTheTestAndHoldNumbersOfOneSymbolTogether) {
  auto t = two_kinds();
  t.names = {"peak.q_over_p", "uniaxial.strength_Pa", "critical_state.q_over_p"};
  t.meanings = {{"uniaxial.strength_Pa", {"Pa", "Strength"}}};
  for (auto& row : t.rows) row.numbers[1] = {2e6};
  auto first = figures::headlines_of(fields::TestKind::biaxial);
  first.push_back({"strength", "\u03c3", "uniaxial.strength_Pa"});
  const auto figures = default_figures(t, first);
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].y, (std::vector<std::string>{"critical_state.q_over_p", "peak.q_over_p"}));
  EXPECT_EQ(figures[0].names, (std::vector<std::string>{"critical state", "peak"}));
  EXPECT_EQ(figures[0].y_axis.label, "q/p");
  EXPECT_EQ(figures[1].y_axis.unit, "MPa");
  EXPECT_EQ(figures[1].y_axis.factor, 1e6);
  EXPECT_EQ(runs_table(t, first, {})["names"], Numbers({"Critical state q/p", "Peak q/p", "Strength \u03c3, Pa"}));
}

TEST(DefaultFigures, LettersWithAnIndexAreLabelsWithOne) {
  campaign::CollectedTable table;
  table.meanings = {{"S_m", {"", "Saturation S_m, matrix over pores"}}, {"z_all", {"m", "Mean way of all"}}};
  EXPECT_EQ(label_of(table, "S_m"), "Saturation S_{m}");
  EXPECT_EQ(label_of(table, "z_all"), "Mean way of all, m");
}

TEST(DefaultFigures, TheTableHasEveryRunWithItsNumbersAndItsPage) {
  const Numbers runs =
      runs_table(two_kinds(), {}, [](const std::string& run) { return "runs/" + run + "/report.html"; });
  ASSERT_EQ(runs["rows"].size(), 12u);
  EXPECT_EQ(runs["names"], Numbers({"Area of grains, %", "Contacts of a grain", "odd.number"}));
  const Numbers& first = runs["rows"][0];
  EXPECT_EQ(first["link"].get<std::string>(), "runs/bridges0.11/report.html");
  EXPECT_EQ(first["values"][1].get<std::string>(), "0.1");
  EXPECT_FALSE(first["numbers"][0].is_known());  // no solid fraction
  EXPECT_EQ(first["numbers"][1][0].get<double>(), 4);
  EXPECT_EQ(first["numbers"][1][1].get<double>(), 0.1);
}

}  // namespace
}  // namespace arenite::report
