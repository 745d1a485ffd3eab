#include "report/sphere_document.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "grains/texture/grain_quantities.hpp"
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
    for (int side = 0; side < sides_in<3>; ++side) state.packing.domain.wall[side].position = side % 2 == 0 ? -1 : 10;
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

TEST(SphereDocument, TheLastStateSaysWhatItsQuantitiesAreCalledAndTheirMeans) {
  constexpr double force = 6, radius = 0.5;
  SphereResult stage = stage_of(2, 3);
  stage.texture = Numbers{{"force", Numbers{{"mean_N", force}}}};
  PackingIn<3>& last = stage.snapshots.back().packing;
  last.contacts.add(0, 1, {-1, 0, 0}, force, {}, radius, radius);
  last.contacts.add(2, wall_partner(right), {-1, 0, 0}, force, {}, radius, 0);
  last.grains.velocity[1] = {0, 3, 4};
  const Numbers states = document_of({stage})[0].at("states");
  EXPECT_FALSE(states[0].contains("quantities"));
  const Numbers& quantities = states[1].at("quantities");
  ASSERT_EQ(quantities.size(), 4u);
  for (const char* name : {"pressure", "stress", "coordination", "speed"}) {
    EXPECT_EQ(states[1].at(name).at("n").get<int>(), 3) << name;
    const texture::GrainQuantity& quantity = texture::grain_quantity(name);
    EXPECT_EQ(quantities.at(name).at("label").get<std::string>(), quantity.label);
    EXPECT_EQ(quantities.at(name).at("symbol").get<std::string>(), quantity.symbol);
    EXPECT_EQ(quantities.at(name).at("unit").get<std::string>(), quantity.unit);
    EXPECT_EQ(quantities.at(name).contains("magnitude"), quantity.is_magnitude) << name;
  }
  const double volume = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
  EXPECT_NEAR(quantities.at("pressure").at("mean").get<double>(), force * radius / (3 * volume), 1e-12);
  EXPECT_NEAR(quantities.at("stress").at("mean").get<double>(), 1, 1e-12);
  EXPECT_NEAR(quantities.at("coordination").at("mean").get<double>(), 1, 1e-12);
  EXPECT_NEAR(quantities.at("speed").at("mean").get<double>(), 5.0 / 3, 1e-12);
}

TEST(SphereDocument, OfSpheresThatNothingPressesOnlyTheSpeedIsThere) {
  const Numbers states = document_of({stage_of(1, 2)})[0].at("states");
  EXPECT_EQ(states[0].at("quantities").size(), 1u);
  EXPECT_TRUE(states[0].at("quantities").contains("speed"));
}

TEST(SphereDocument, TablesHaveThePlacesAndSizesBesideTheQuantities) {
  const Numbers stage = document_of({stage_of(1, 2)})[0];
  std::vector<std::string> names;
  for (const auto& [name, words] : stage.at("quantities").items()) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"x", "y", "z", "size", "speed"}));
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

int cells_of(const Numbers& state) {
  int cells = 1;
  for (const Numbers& along : state.at("fields").at("cells")) cells *= along.get<int>();
  return cells;
}

TEST(SphereDocument, StatesHaveFieldsOnEquallyManyCellsOfTheirContainers) {
  SphereResult stage = stage_of(2, 2);
  stage.snapshots[0].packing.domain.wall[right].position = 16;
  stage.snapshots[1].packing.materials[0].density = 2500;
  stage.snapshots[1].packing.grains.velocity[1] = {1, 0, 0};
  const Numbers shown = document_of({stage})[0];
  EXPECT_EQ(shown.at("layers").at("shear")[2].get<std::string>(), "Pa");
  for (const Numbers& state : shown.at("states")) {
    const Numbers& fields = state.at("fields");
    EXPECT_EQ(cells_of(state), 22 * 22 * 22);  // 11 m, by radii of half a metre
    EXPECT_EQ(fields.at("layers").at("density").at("residual").at("n").get<int>(), cells_of(state));
    EXPECT_EQ(fields.at("reached").at("n").get<int>(), cells_of(state)) << "far from the spheres there is nothing";
    EXPECT_EQ(fields.at("width").get<double>(), 1);
  }
  EXPECT_EQ(shown.at("states")[0].at("fields").at("high")[0].get<double>(), 16);
  EXPECT_FALSE(shown.at("states")[0].at("fields").at("layers").contains("vx"));
  EXPECT_TRUE(shown.at("states")[1].at("fields").at("layers").contains("vx"));
}

TEST(SphereDocument, OfManyCellsSomeStatesHaveFieldsTheLastAmongThem) {
  const Numbers states = document_of({stage_of(12, 2)})[0].at("states");  // 12 times 22^3: three times what a page has
  ASSERT_EQ(states.size(), 12u);
  for (std::size_t k = 0; k < states.size(); ++k) EXPECT_EQ(states[k].contains("fields"), k % 3 == 2) << k;
  SphereResult without = stage_of(2, 2);
  for (auto& state : without.snapshots) state.packing.domain.wall[top].position = -1;
  const Numbers flat = document_of({without})[0];
  EXPECT_FALSE(flat.contains("layers"));
  EXPECT_FALSE(flat.at("states")[1].contains("fields")) << "without a container there are none";
}

}  // namespace
}  // namespace arenite::report
