#include "report/figures/over_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace arenite::report::figures {
namespace {

/// Stages that discharge by the law of Beverloo, with an error of a hundredth.
template <class Stage> std::vector<Stage> discharging(double factor, double lost, double exponent) {
  std::vector<Stage> stages;
  for (const double opening : {0.02, 0.03, 0.04, 0.055}) {
    const double rate = factor * std::pow(opening - lost, exponent);
    Stage stage;
    stage.texture = {{"discharge", {{"opening_m", opening}, {"rate_kg_s", {{"value", rate}, {"error", 0.01 * rate}}}}}};
    stages.push_back(stage);
  }
  return stages;
}

void expect_a_line(const std::vector<fields::AnyTest>& tests, int halves) {
  const Drawings drawings = figure_over_runs("beverloo").draw(tests);
  const std::vector<Series>& series = drawings.at(0).panels.at(0).series;
  ASSERT_EQ(series.size(), 2u);
  const std::string exponent = std::to_string(halves) + "/2";
  EXPECT_NE(series[1].name.find(exponent), std::string::npos);
  const double slope = (series[1].y.back() - series[1].y.front()) / (series[1].x.back() - series[1].x.front());
  for (std::size_t k = 0; k < series[0].x.size(); ++k) {
    EXPECT_NEAR(series[0].y[k], slope * (series[0].x[k] - 5), 1e-3 * series[0].y[k]);
    EXPECT_NEAR(series[0].error[k], 0.02 / halves * series[0].y[k], 1e-9);
  }
}

TEST(FiguresOverRuns, BeverloosLawHasTheExponentOfItsDimension) {
  const auto disks = discharging<StageResult>(33, 0.005, 1.5);
  std::vector<fields::AnyTest> tests;
  for (const StageResult& stage : disks) tests.emplace_back(fields::Test{stage});
  expect_a_line(tests, 3);
  const auto spheres = discharging<SphereResult>(900, 0.005, 2.5);
  tests.clear();
  for (const SphereResult& stage : spheres) tests.emplace_back(&stage);
  expect_a_line(tests, 5);
}

}  // namespace
}  // namespace arenite::report::figures
