#include <gtest/gtest.h>

#include "report/default_figures.hpp"

namespace arenite::report {
namespace {

campaign::CollectedTable table() {
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
  const auto figures = default_figures(table());
  ASSERT_EQ(figures.size(), 3u);
  EXPECT_EQ(figures[0].y.front(), "solid_fraction");
  EXPECT_EQ(figures[1].y.front(), "coordination.all");
  EXPECT_EQ(figures[2].y.front(), "odd.number");  // what there is, where less is known
  EXPECT_EQ(figures[0].title, "Area of grains, %");
  EXPECT_EQ(figures[1].title, "Contacts of a grain");
  EXPECT_EQ(figures[1].caption, "Contacts of a grain, mean of all.");
  EXPECT_EQ(figures[2].title, "odd.number");
  for (const auto& figure : figures) {
    EXPECT_EQ(figure.x, "contact.friction");
    EXPECT_TRUE(figure.x_axis.logarithmic);
    EXPECT_EQ(figure.by, "cement.kind");
  }
}

TEST(DefaultFigures, AreNoneWhereNothingIsSweptButTheSeedOrWords) {
  auto t = table();
  t.keys = {{"seed", ""}};
  for (auto& row : t.rows) row.values = {"1"};
  EXPECT_TRUE(default_figures(t).empty());
  t.keys = {{"cement.kind", ""}};
  for (auto& row : t.rows) row.values = {row.run.substr(0, 4)};
  EXPECT_TRUE(default_figures(t).empty());
}

TEST(DefaultFigures, LettersWithAnIndexAreLabelsWithOne) {
  campaign::CollectedTable table;
  table.meanings = {{"S_m", {"", "Saturation S_m, matrix over pores"}}, {"z_all", {"m", "Mean way of all"}}};
  EXPECT_EQ(label_of(table, "S_m"), "Saturation S_{m}");
  EXPECT_EQ(label_of(table, "z_all"), "Mean way of all, m");
}

TEST(DefaultFigures, TheTableHasEveryRunWithItsNumbersAndItsPage) {
  const Numbers runs = runs_table(table(), [](const std::string& run) { return "runs/" + run + "/report.html"; });
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
