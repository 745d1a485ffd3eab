#include "report/figures/field_figures.hpp"
#include "report/figures/failure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace arenite;
using namespace arenite::report::figures;

namespace {

const Row<FieldData>& densities_row() {
  return *std::ranges::find(field_figures(), "stress-pdf", [](const auto& row) { return row.head.id; });
}

/// The area below a line.
double area(const Series& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.x.size(); ++k)
    sum += 0.5 * (line.y[k] + line.y[k - 1]) * (line.x[k] - line.x[k - 1]);
  return sum;
}

}  // namespace

TEST(FieldFigures, FitsHoldWhatWasCounted) {
  const Numbers set{
      {"count", 100},
      {"pdf", {{"x", {-9, 1, 11}}, {"y", {0.1, 0.4, 0.1}}}},
      {"own_pdf", {{"x", {-9, 1, 11}}, {"y", {0.1, 0.4, 0.1}}}},
      {"tail", {{"count", 20}, {"slope", {{"value", 2.0}}}, {"low", 1.0}, {"high", 3.0}}},
      {"q_gaussian", {{"q", {{"value", 1.0}}}, {"beta", {{"value", 0.5}}}, {"centre", {{"value", 1.0}}}}}};
  const Numbers densities{{"sigma_yy", {{"normalised_by", "mean"}, {"sets", {{"all", set}}}}}};
  const FieldResult none;
  const Drawings drawings = densities_row().draw({none, densities});
  ASSERT_EQ(drawings.size(), 2u);
  ASSERT_EQ(drawings[1].chosen.back().second, "own");
  const Series &gaussian = drawings[1].panels[0].series.back(), &tail = drawings[1].panels[1].series.back();
  EXPECT_NEAR(*std::ranges::max_element(gaussian.y), 1 / std::sqrt(2 * std::numbers::pi), 1e-3);
  EXPECT_NEAR(area(gaussian), 1, 1e-3);
  EXPECT_EQ(tail.x, (std::vector<double>{1, 3}));  // straight on a logarithmic axis
  const double foot = 0.2 * 2 / (std::exp(-2.0) - std::exp(-6.0));
  EXPECT_NEAR(tail.y[0], foot * std::exp(-2.0), 1e-12);
  EXPECT_NEAR(tail.y[1], foot * std::exp(-6.0), 1e-12);
  EXPECT_TRUE(drawings[1].panels[1].y.logarithmic);
}

TEST(FieldFigures, AStressWithoutMeanIsOverItsRootMeanSquare) {
  const Numbers set{{"pdf", {{"x", {-1, 0, 1}}, {"y", {0.1, 0.5, 0.1}}}}};
  const Numbers densities{{"sigma_xy", {{"normalised_by", "root mean square"}, {"sets", {{"all", set}}}}}};
  const FieldResult none;
  const Drawings drawings = densities_row().draw({none, densities});
  ASSERT_EQ(drawings.size(), 1u);  // no set has a mean of its own
  EXPECT_NE(drawings[0].panels[0].x.label.find("r.m.s."), std::string::npos);
}

TEST(FieldFigures, CavitiesAreThoseThatAreStored) {
  FieldResult result;
  result.numbers = {
      {"pores",
       {{"count", 7},
        {"pdf", {{"edge", {1, 4, 16, 64, 256}}, {"density", {2, 0, 1, 0.5}}, {"error", {1, 0, 1, 0.2}}}}}},
      {"voids", {{"count", 0}}}};
  const auto& row = *std::ranges::find(field_figures(), "cavities", [](const auto& r) { return r.head.id; });
  const Drawings drawings = row.draw({result, Numbers::tree()});
  ASSERT_EQ(drawings.size(), 1u);
  EXPECT_EQ(drawings[0].panels[0].series[0].x, (std::vector<double>{2, 32, 128}));
  EXPECT_EQ(drawings[0].panels[0].series[0].y, (std::vector<double>{2, 1, 0.5}));
  EXPECT_EQ(drawings[0].key[0].name, "pores 7");
  result.numbers = {{"pores", {{"count", 0}}}};
  EXPECT_TRUE(row.draw({result, Numbers::tree()}).empty());
}

TEST(FieldFigures, BrokenBondsAreCountedByTypeUpToEachStep) {
  FieldResult result;
  result.curve.columns = {{"strain", "", {1e-3, 2e-3, 3e-3}}, {"broken", "", {0, 2, 5}}};
  for (const std::uint8_t type : {1, 1, 2, 3, 1}) result.cracks.push_back({0, 0, type, 0});
  const Drawing drawing = broken_bonds({result, Numbers::tree()}).front();
  const auto& lines = drawing.panels[0].series;
  EXPECT_EQ(drawing.key[0].name, "matrix");
  EXPECT_EQ(lines[0].y, (std::vector<double>{0, 2, 3}));
  EXPECT_EQ(lines[1].y, (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(lines[2].y, (std::vector<double>{0, 0, 1}));
}
