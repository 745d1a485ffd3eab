#include "report/study/study_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::report {
namespace {

using figures::Line;

FigureCurve curve(std::string name, std::vector<double> y, std::vector<double> error = {}) {
  std::vector<double> x;
  for (std::size_t k = 0; k < y.size(); ++k) x.push_back(static_cast<double>(k + 1));
  if (error.empty()) error.assign(y.size(), statistics::unknown);
  FigureCurve made{.name = std::move(name)};
  made.points.x = x, made.points.y = std::move(y), made.points.error = std::move(error);
  return made;
}

Figure plot() {
  Figure figure;
  figure.id = "f";
  figure.y = {"z"};
  figure.x_axis.label = "eta";
  figure.y_axis.label = "z";
  return figure;
}

TEST(StudyDrawing, ReachesPastPointsWithTheirErrorsAndReferencesByATwentieth) {
  Figure figure = plot();
  figure.references.emplace_back();
  figure.references.back().y = 9;
  figure.references.back().label = "nine";
  const auto panel = drawing_of(figure, {curve("", {2, 4}, {1, 1})}, {}).panels.front();
  EXPECT_DOUBLE_EQ(*panel.y.low, 1 - 0.05 * 8);
  EXPECT_DOUBLE_EQ(*panel.y.high, 9 + 0.05 * 8);
  EXPECT_EQ(panel.y.label, "z");
  EXPECT_EQ(panel.references.front().label, "nine");
  EXPECT_EQ(panel.series.front().error, (std::vector<double>{1, 1}));
}

TEST(StudyDrawing, TellsApartWhatIsSimulatedFilmedFittedAndOfTheSource) {
  FigureCurve film = curve("film", {1, 2}), fit = curve("", {1, 2}), source = curve("T", {3, 4}),
              beside = curve("other", {5, 6});
  film.film = true, film.part = 1, fit.fit = true, source.source = true, beside.beside = true;
  const auto drawing = drawing_of(plot(), {curve("ours", {1, 2}), film, fit, source, beside}, {});
  const auto& series = drawing.panels.front().series;
  ASSERT_EQ(series.size(), 5u);
  EXPECT_EQ(series[0].mark, "");
  EXPECT_EQ(series[1].mark, "hollow");
  EXPECT_EQ(series[1].colour, series[0].colour);
  EXPECT_EQ(series[1].line, Line::dotted);
  EXPECT_EQ(series[2].line, Line::dashed);
  EXPECT_FALSE(series[2].is_read);
  EXPECT_EQ(series[3].mark, "times");
  EXPECT_EQ(series[3].line, Line::none);
  EXPECT_EQ(series[4].mark, "diamond");
  ASSERT_EQ(drawing.key.size(), 4u);  // no entry for the fit
  EXPECT_EQ(drawing.key[2].mark, "times");
}

TEST(StudyDrawing, ValuesOfAKeyHaveShadesInTheirOrder) {
  Figure figure = plot();
  figure.by = "gamma";
  std::vector<FigureCurve> curves;
  for (std::size_t k = 0; k < 3; ++k) {
    curves.push_back(curve("g", {1, 2}));
    curves.back().group = k;
  }
  const auto series = drawing_of(figure, curves, {}).panels.front().series;
  EXPECT_EQ(series[0].colour, "scale 0");
  EXPECT_EQ(series[1].colour, "scale 0.5");
  EXPECT_EQ(series[2].colour, "scale 1");
}

TEST(StudyDrawing, ADensityIsALineInItsBandBrokenWhereItIsNotKnownAndADotWhereItIsAlone) {
  Figure figure = plot();
  figure.curves = {"pdf"};
  figure.y_axis.logarithmic = true;
  figure.y_axis.low = 1e-3;
  const auto series = drawing_of(figure, {curve("", {1, 2, 0, 5, 0}, {0.5, 0.5, 0, 5, 0})}, {}).panels.front().series;
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].x, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_TRUE(std::isnan(series[0].y[2]));
  EXPECT_DOUBLE_EQ(series[0].low[0], 0.5);
  EXPECT_DOUBLE_EQ(series[0].low[3], 1e-3);  // the axis ends there
  EXPECT_DOUBLE_EQ(series[0].high[3], 10);
  EXPECT_EQ(series[1].x, (std::vector<double>{4}));
  EXPECT_TRUE(series[1].points);
}

TEST(StudyDrawing, RingsOfRosesAreRoundNumbers) {
  Figure figure = plot();
  figure.kind = FigureKind::rose;
  figure.curves = {"s"};
  figure.counts = true;
  const auto rings = [&](std::vector<double> y) {
    return drawing_of(figure, {curve("", std::move(y))}, {}).outlines->rings;
  };
  EXPECT_EQ(rings({1, 3}), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(rings({20, 45}), (std::vector<double>{20, 40}));
  EXPECT_EQ(rings({700, 1200}), (std::vector<double>{500, 1000}));
  figure.counts = false;
  EXPECT_EQ(rings({0.5, 1.2}), (std::vector<double>{0.5, 1}));
  EXPECT_TRUE(drawing_of(figure, {curve("", {1, 1})}, {}).outlines->isotropic);
}

TEST(StudyDrawing, AMapHasAPlaceForEveryPair) {
  Figure figure = plot();
  figure.kind = FigureKind::map;
  FigureCurve upper = curve("b", {3});
  upper.points.x = {2};
  const auto cells = *drawing_of(figure, {curve("a", {1, 2}), upper}, {}).cells;
  EXPECT_EQ(cells.x.names, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(cells.y.names, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(cells.values.size(), 4u);
  EXPECT_TRUE(std::isnan(cells.values[2]));
  EXPECT_EQ(cells.values[3], 3);
}

}  // namespace
}  // namespace arenite::report
