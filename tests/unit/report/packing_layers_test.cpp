
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geometry/rectangle.hpp"
#include "report/page_document.hpp"
#include "support/page_sample.hpp"

using namespace arenite;
using Json = nlohmann::json;

namespace {

TEST(PackingLayers, APageHasFieldsOfItsStatesAndMotionWhereGrainsMove) {
  test::PageSample sample(60);
  for (Vec2& v : sample.stage.snapshots[0].packing.grains.velocity) v.x = 0;
  const Json document = Json::parse(report::page_document(sample.data).json);
  for (const Json& snapshot : document["snapshots"]) {
    const Json& fields = snapshot["fields"];
    EXPECT_EQ(fields["solid_fraction"]["n"].get<int>(), fields["columns"].get<int>() * fields["rows"].get<int>());
    EXPECT_EQ(snapshot["deviator"]["n"], 60);
  }
  EXPECT_FALSE(document["snapshots"][0].contains("vx"));
  EXPECT_FALSE(document["snapshots"][0]["fields"].contains("vx"));
  EXPECT_TRUE(document["snapshots"][1].contains("vx"));
  EXPECT_TRUE(document["snapshots"][1]["fields"].contains("kinetic"));
}

TEST(PackingLayers, StatesTellHowFarGrainsWentAndTurnedSinceTheFirstOfTheirStage) {
  test::PageSample sample(60);
  sample.stage.snapshots.back().packing.grains.angle.assign(60, 0.5);
  const auto snapshots_of = [&] { return Json::parse(report::page_document(sample.data).json)["snapshots"]; };
  const Json all = snapshots_of();
  EXPECT_FALSE(all[0].contains("displacement"));
  EXPECT_EQ(all[1]["displacement"]["n"], 60);
  EXPECT_EQ(all[1]["displacement"]["unit"], "m");
  EXPECT_FALSE(all[1].contains("rotation"));
  EXPECT_EQ(all[4]["rotation"]["n"], 60);
  EXPECT_EQ(all[4]["rotation"]["unit"], "rad");
  sample.stage.snapshots.erase(sample.stage.snapshots.begin(), sample.stage.snapshots.end() - 1);
  EXPECT_FALSE(snapshots_of()[0].contains("rotation")) << "nothing is before the only state";
}

/// Too many to measure all states; those added are beside the container, each alone, and take no time in its fields.
Grains with_many_more(Grains grains) {
  const std::size_t few = grains.size();
  grains.resize(10'001);
  for (std::size_t i = few; i < grains.size(); ++i) grains.position[i] = {1 + 0.1 * static_cast<double>(i), 1};
  return grains;
}

TEST(PackingLayers, ALongLoadingHasFieldsOfSomeStatesAndOfTheLast) {
  test::PageSample sample(60);
  const workflow::KnownStatistics known{.stages = {texture::measure(sample.stage.snapshots.back().packing)}};
  Snapshot one = sample.stage.snapshots.back();
  one.packing.grains = with_many_more(one.packing.grains);  // only the last state's texture, which is known here
  sample.stage.snapshots.assign(60, one);
  sample.data.measured = &known;
  const Json snapshots = Json::parse(report::page_document(sample.data).json)["snapshots"];
  std::size_t with = 0;
  for (const Json& snapshot : snapshots) with += snapshot.contains("fields") ? 1 : 0;
  EXPECT_LT(with, 30u);
  EXPECT_GT(with, 10u);
  EXPECT_TRUE(snapshots.back().contains("fields"));
}

TEST(PackingLayers, EveryStateHasItsForceScaleAndStressesOverTheirMean) {
  test::PageSample sample(60);
  const Json measured = Json::parse(report::page_document(sample.data).json)["snapshots"][1];
  EXPECT_NEAR(measured["force_scale"]["mean"], measured["texture"]["force"]["mean_N"]["value"],
              1e-5 * measured["force_scale"]["mean"].get<double>());
  EXPECT_NEAR(measured["force_scale"]["tension"], -1e-3 * measured["force_scale"]["mean"].get<double>(), 1e-12);
  EXPECT_EQ(measured["sigma_norm"]["n"], 60);
  Snapshot large = sample.stage.snapshots[1];
  large.packing.grains = with_many_more(large.packing.grains);
  large.packing.grains.radius.assign(large.packing.grains.size(), 1e-3);
  sample.stage.snapshots.assign(2, large);
  const Json bare = Json::parse(report::page_document(sample.data).json)["snapshots"][0];
  EXPECT_FALSE(bare.contains("texture"));
  EXPECT_EQ(bare["sigma_norm"]["n"], 10'001);
  EXPECT_GT(bare["force_scale"]["mean"], 0);
}

TEST(PackingLayers, SizeCurvesAreThereWhereALawWasAskedFor) {
  const test::PageSample sample(60);
  const Json asked = Json::parse(report::page_document(sample.data).json);
  const Json& lines = asked["run"]["size-curve"][0]["panels"][0]["series"];
  EXPECT_EQ(lines[1]["name"], "asked");
  EXPECT_GE(lines[1]["x"].is_array() ? lines[1]["x"].size() : lines[1]["x"]["n"].get<std::size_t>(), 3u);
  test::PageSample without(60);
  without.stage.asked.diameter.clear();
  EXPECT_FALSE(Json::parse(report::page_document(without.data).json)["run"].contains("size-curve"));
}

TEST(PackingLayers, TheExtentIsThatOfTheGrainsWithBoundariesAndNearSides) {
  test::PageSample sample(60);
  Packing& packing = sample.stage.snapshots.back().packing;
  const auto grains = geometry::bounds(packing.grains.position, packing.grains.radius);
  const auto extent = [&] {
    return Json::parse(report::page_document(sample.data).json)["snapshots"]
        .back()["extent"]
        .get<std::vector<double>>();
  };
  const double right_before = packing.domain.wall[right].position;
  EXPECT_NEAR(extent()[1], right_before, 1e-5);
  packing.domain.wall[right].position = grains.x_max + 10 * grains.width();
  EXPECT_NEAR(extent()[1], grains.x_max, 1e-5);
  const double high = grains.y_max + 3 * grains.height();
  packing.domain.boundaries.resize(1);
  packing.domain.boundaries[0].points = {{grains.x_min, 0}, {grains.x_min, high}};
  EXPECT_NEAR(extent()[3], grains.y_max + 0.25 * grains.height(), 1e-5);
  packing.domain.boundaries[0].points.push_back({grains.x_max, high});
  packing.domain.boundaries[0].closed = true;
  EXPECT_NEAR(extent()[3], high, 1e-5);
}

}  // namespace
