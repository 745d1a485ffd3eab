#include "report/page_document.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/page_sample.hpp"

using namespace arenite;
using Json = nlohmann::json;

TEST(PageDocument, HoldsEverySnapshotWithItsTexture) {
  const test::PageSample sample(60);
  const Json document = Json::parse(report::page_document(sample.data).json);
  ASSERT_EQ(document["snapshots"].size(), 5u);
  for (const Json& snapshot : document["snapshots"]) {
    EXPECT_EQ(snapshot["x"]["n"], 60);
    EXPECT_TRUE(snapshot["texture"]["coordination"].contains("all"));
    EXPECT_FALSE(snapshot["texture"].contains("by_grain"));
  }
}

TEST(PageDocument, LeavesOutSnapshotsWithAnotherNumberOfGrains) {
  test::PageSample sample(60);
  sample.stage.snapshots[1].packing.grains.resize(59);
  sample.stage.snapshots[1].packing.contacts = {};
  const Json document = Json::parse(report::page_document(sample.data).json);
  EXPECT_EQ(document["snapshots"].size(), 4u);
}

TEST(PageDocument, NumbersWallsAfterTheGrains) {
  const test::PageSample sample(60);
  const Packing& last = sample.stage.snapshots.back().packing;
  ASSERT_GT(std::count_if(last.contacts.j.begin(), last.contacts.j.end(), [](int j) { return j < 0; }), 0);
  const Json document = Json::parse(report::page_document(sample.data).json);
  EXPECT_EQ(document["snapshots"][4]["contacts"]["j"]["n"], last.contacts.size());
  EXPECT_EQ(document["snapshots"][4]["domain"]["walls"][2]["force"], last.domain.wall[bottom].force);
}

TEST(PageDocument, HasTheBoundariesOfEachStateThatHasThem) {
  test::PageSample sample(60);
  Boundary drum;
  drum.name = "drum";
  drum.points = {{0, 0}, {1, 0}, {0, 1}};
  drum.closed = true;
  drum.spin = 2;
  drum.force = {1, -3};
  drum.torque = 0.5;
  Packing& last = sample.stage.snapshots.back().packing;
  last.domain.boundaries = {drum};
  last.contacts.add(0, boundary_partner(5), {0, 1}, 1, 0, 0.005, 0);
  const Json document = Json::parse(report::page_document(sample.data).json);
  EXPECT_FALSE(document["snapshots"][0]["domain"].contains("boundaries"));
  const Json& stored = document["snapshots"][4]["domain"]["boundaries"][0];
  EXPECT_EQ(stored["name"], "drum");
  EXPECT_EQ(stored["x"]["n"], 3);
  EXPECT_EQ(stored["force"][1], -3);
}

TEST(PageDocument, KeepsAboutAThousandRowsOfALongHistoryAndItsLast) {
  test::PageSample sample(60);
  for (auto& column : sample.stage.history.columns) {
    column.values.assign(4096, 1.0);
    if (column.name == "time")
      for (std::size_t k = 0; k < column.values.size(); ++k) column.values[k] = static_cast<double>(k);
  }
  const Json document = Json::parse(report::page_document(sample.data).json);
  const Json& line = document["stages"][0]["figures"]["wall-forces"][0]["panels"][0]["series"][0];
  EXPECT_LE(line["x"]["n"], 1001);
  EXPECT_GE(line["x"]["n"], 500);
  EXPECT_EQ(line["y"]["n"], line["x"]["n"]);
}

TEST(PageDocument, SaysUnitsAndMeaningsAsTheyAreDeclared) {
  test::PageSample sample(60);
  sample.stage.texture["new_number_m"] = statistics::described(2.5, "m", "That no page knows of");
  const Json document = Json::parse(report::page_document(sample.data).json);
  const Json& last = document["snapshots"].back();
  EXPECT_EQ(last["x"]["unit"], "m");
  EXPECT_EQ(last["angle"]["unit"], "rad");
  EXPECT_EQ(last["contacts"]["fn"]["unit"], "N");
  EXPECT_EQ(document["stages"][0]["figures"]["wall-forces"][0]["panels"][0]["x"]["unit"], "s");
  EXPECT_EQ(document["meanings"]["force.mean_N"][0], "N");
  EXPECT_EQ(last["texture"]["new_number_m"], 2.5);
  EXPECT_EQ(document["meanings"]["new_number_m"], Json({"m", "That no page knows of"}));
}

TEST(PageDocument, OfAnEmptyRunHasNoSnapshots) {
  EXPECT_TRUE(Json::parse(report::page_document({.title = "nothing"}).json)["snapshots"].empty());
}
