#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "report/field_drawing.hpp"

namespace arenite::report {
namespace {

using Json = nlohmann::json;

/// A large grain of 8 x 8 nodes in the middle of a map of 24 x 16, a small one in a corner, matrix between them up to
/// column 20.
FieldResult sample() {
  FieldResult result;
  result.map = make_phase_map(24, 16, 1e-4);
  result.map.grain_class = {GrainClass::large, GrainClass::small};
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 20; ++x) {
      const std::size_t node = result.map.index(x, y);
      const int grain = x >= 8 && x < 16 && y >= 4 && y < 12 ? 0 : x < 2 && y < 2 ? 1 : -1;
      result.map.phase[node] = grain < 0 ? Phase::matrix : Phase::particle;
      result.map.grain[node] = grain;
    }
  return result;
}

FieldResult loaded() {
  FieldResult result = sample();
  const std::size_t n = result.map.size();
  result.field = {24,
                  16,
                  1e-4,
                  std::vector<double>(n),
                  std::vector<double>(n),
                  std::vector<double>(n),
                  std::vector<double>(n),
                  std::vector<double>(n)};
  for (std::size_t k = 0; k < n; ++k)
    if (result.map.phase[k] != Phase::empty) result.field.yy[k] = result.map.grain[k] == 0 ? 3e5 : 1e5;
  return result;
}

TEST(FieldDrawing, PhasesAreRunsFromTheTopRowOnThatAddUpToAllNodes) {
  const Json j = Json::parse(to_json(phases_drawing(sample())));
  EXPECT_EQ(j["nodes"], Json::parse("[24,16]"));
  EXPECT_EQ(j["size"], Json::parse("[2.4,1.6]"));
  const auto runs = j["phases"].get<std::vector<int>>();
  EXPECT_EQ(runs[0], 1);
  EXPECT_EQ(runs[1], 20);
  EXPECT_EQ(runs[2], 0);
  EXPECT_EQ(runs[3], 4);
  std::vector<int> nodes(5, 0);
  for (std::size_t k = 0; k < runs.size(); k += 2) nodes[static_cast<std::size_t>(runs[k])] += runs[k + 1];
  EXPECT_EQ(nodes, (std::vector<int>{64, 252, 0, 4, 64}));
  const std::size_t n = runs.size();
  EXPECT_EQ((std::vector<int>(runs.end() - 6, runs.end())), (std::vector<int>{3, 2, 1, 18, 0, 4})) << n;
}

TEST(FieldDrawing, AFineMapIsThinned) {
  FieldResult fine;
  fine.map = make_phase_map(1200, 600, 1e-5);
  const Json j = Json::parse(to_json(phases_drawing(fine)));
  EXPECT_EQ(j["nodes"], Json::parse("[400,200]"));
  EXPECT_NEAR(j["size"][0].get<double>(), 12, 1e-9);
}

TEST(FieldDrawing, TheZoomShowsTheMiddleLargeGrainOverTheMeanThatStatisticsTake) {
  const Json j = Json::parse(to_json(zoom_drawing(loaded())));
  const int width = j["nodes"][0], height = j["nodes"][1];
  ASSERT_EQ(j["stress"].size(), static_cast<std::size_t>(width * height));
  EXPECT_LT(width, 16);
  const double mean = (64 * 3e5 + 96 * 1e5) / 160;  // beyond four rows at each clamp
  EXPECT_NEAR(j["stress"][static_cast<std::size_t>(height / 2 * width + width / 2)].get<double>(), 3e5 / mean, 0.006);
  EXPECT_NEAR(j["stress"][0].get<double>(), 1e5 / mean, 0.006);
  EXPECT_EQ(j["edges"].size(), 32u);  // the rim of 8 x 8 nodes
  FieldResult measured = loaded();
  measured.numbers["stress"]["sigma_yy"]["sample_mean_Pa"] = statistics::Estimate{3e5, 0};
  EXPECT_EQ(Json::parse(to_json(zoom_drawing(measured)))["stress"][0].get<double>(), 0.33);
}

TEST(FieldDrawing, TheVoidHasNoStressAndASampleWithoutAFieldIsRefused) {
  FieldResult result = loaded();
  result.map.phase[result.map.index(12, 8)] = Phase::empty;
  result.map.grain[result.map.index(12, 8)] = -1;
  const Json j = Json::parse(to_json(zoom_drawing(result)));
  int empty = 0;
  for (const auto& value : j["stress"]) empty += value.is_null();
  EXPECT_EQ(empty, 1);
  EXPECT_THROW(zoom_drawing(sample()), InputError);
}

TEST(FieldDrawing, CracksLieOnThePhasesAsThePictureHasThem) {
  FieldResult pull = loaded();
  pull.cracks = {{8.0e-4F, 4.0e-4F, 2, 1e-3}, {2.05e-3F, 1.6e-3F, 1, 2e-3}};
  const Json j = Json::parse(to_json(cracks_drawing(pull)));
  EXPECT_EQ(j["phases"], Json::parse(to_json(phases_drawing(pull)))["phases"]);
  EXPECT_EQ(j["cracks"], Json::parse(R"({"x":[8.0,20.5],"y":[12.0,0.0],"type":[2,1]})"));
  EXPECT_THROW(cracks_drawing(loaded()), InputError);
}

}  // namespace
}  // namespace arenite::report
