#include "report/figures/grains/grain_scatter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grains/fields/stage_numbers.hpp"
#include "grains/texture/texture.hpp"
#include "report/figures/grains/grain_values.hpp"
#include "support/page_sample.hpp"

using namespace arenite;
using namespace arenite::report::figures;

namespace {

using Known = std::map<std::string, std::vector<double>, std::less<>>;

Scatter scatter_of(const Known& known) {
  const Drawings drawings = grain_scatter([&](std::string_view name) {
    const auto at = known.find(name);
    return at == known.end() ? std::vector<double>{} : at->second;
  });
  return drawings.empty() ? Scatter{} : *drawings.front().scatter;
}

const GrainAxis& axis_of(const Scatter& scatter, const std::string& quantity) {
  return *std::ranges::find(scatter.axes, quantity, &GrainAxis::quantity);
}

}  // namespace

TEST(GrainScatter, BeginsWithTheStressOverTheSizeWhereGrainsDifferInThem) {
  const Known all{{"size", {1e-3, 2e-3}}, {"coordination", {3, 4}}, {"x", {0, 1}},
                  {"y", {0, 1}},          {"pressure", {1, 2}},     {"stress", {0.5, 1.5}}};
  EXPECT_EQ(scatter_of(all).across, "size");
  EXPECT_EQ(scatter_of(all).up, "stress");
  Known alike = all;
  alike["size"] = {1e-3, 1e-3};
  alike.erase("stress");
  EXPECT_EQ(scatter_of(alike).across, "coordination");
  EXPECT_EQ(scatter_of(alike).up, "pressure");
  EXPECT_TRUE(scatter_of({{"size", {1e-3}}}).axes.empty()) << "one grain alone";
}

TEST(GrainScatter, UnitsSuitAllButAHundredthOfTheGrains) {
  std::vector<double> pressure(1000, 2e3), few(1000, 2e3);
  few[7] = 5e7;
  pressure[7] = pressure[8] = -3e3;
  const Scatter scatter = scatter_of({{"pressure", few}, {"deviator", pressure}});
  EXPECT_EQ(axis_of(scatter, "pressure").axis.unit, "kPa");
  EXPECT_EQ(axis_of(scatter, "pressure").factor, 1e3);
  EXPECT_EQ(scatter.every, 1U);
  EXPECT_EQ(scatter_of({{"size", std::vector<double>(12'001, 1.0)}}).every, 3U);
}

TEST(GrainScatter, OfAStageHasTheStressThatItsTextureMeasures) {
  const test::PageSample sample(60);
  const StageResult& stage = sample.stage;
  const std::vector<double> stress = grain_values(stage, stage.snapshots.back(), "stress");
  EXPECT_EQ(stress,
            texture::grain_rows(stage.snapshots.back().packing, fields::texture_options(stage)).per_grain.sigma_norm);
  EXPECT_TRUE(grain_values(stage, stage.snapshots.back(), "z").empty());
  const std::vector<double> first = grain_values(stage, stage.snapshots.front(), "displacement");
  EXPECT_EQ(first, std::vector<double>(first.size(), 0.0));
}
