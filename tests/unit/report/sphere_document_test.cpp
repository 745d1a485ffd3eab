#include "report/sphere_document.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/figures/drawing.hpp"

namespace arenite::report {
namespace {

/// Spheres in a row that move along x from state to state.
SphereResult stage_of(int states, std::size_t spheres) {
  SphereResult stage;
  stage.name = "move";
  for (int k = 0; k < states; ++k) {
    SnapshotIn<3>& state = stage.snapshots.emplace_back();
    state.time = k;
    state.label = std::to_string(k + 1);
    state.packing.materials = {Material{.name = "glass"}};
    GrainsIn<3>& grains = state.packing.grains;
    grains.resize(spheres);
    for (std::size_t g = 0; g < spheres; ++g) {
      grains.id[g] = static_cast<std::int64_t>(g);
      grains.position[g] = {static_cast<double>(g) + 0.1 * k, 0, 0};
      grains.radius[g] = 0.5;
    }
  }
  return stage;
}

Numbers document_of(const std::vector<SphereResult>& stages) {
  Numbers document{{"spheres", Numbers::list()}};
  PageData data;
  data.spheres = stages;
  NumberBlock block;
  add_spheres(document, data, block, figures::whole_list);
  return document["spheres"];
}

TEST(SphereDocument, HasAllStatesOfASmallSampleAndWhatTheyShareOnce) {
  const Numbers stage = document_of({stage_of(3, 2)})[0];
  ASSERT_EQ(stage.at("states").size(), 3u);
  EXPECT_FALSE(stage.at("states")[0].contains("radius"));
  EXPECT_TRUE(stage.at("states")[2].contains("radius"));
  EXPECT_EQ(stage.at("note").get<std::string>().find("one in"), std::string::npos);
  SphereResult growing = stage_of(2, 2);
  growing.snapshots[0].packing.grains.radius[1] = 0.4;
  EXPECT_TRUE(document_of({growing})[0].at("states")[0].contains("radius"));
}

/// 400 000 spheres are what a page carries, whatever the states and stages that they are of.
TEST(SphereDocument, OfManySpheresHasSomeStatesTheLastAmongThemAndSaysSo) {
  const Numbers stages = document_of({stage_of(1, 130'000), stage_of(4, 130'000)});
  ASSERT_EQ(stages[0].at("states").size(), 1u);
  const Numbers& states = stages[1].at("states");
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0].at("place").get<int>(), 1);
  EXPECT_EQ(states[1].at("place").get<int>(), 3);
  EXPECT_NE(stages[1].at("note").get<std::string>().find("Of 4 stored states one in 2"), std::string::npos);
}

}  // namespace
}  // namespace arenite::report
