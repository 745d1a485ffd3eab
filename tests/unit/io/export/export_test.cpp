#include "io/export/export.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/sample_results.hpp"

namespace {
using namespace arenite;

Packing sheared_pair() {
  Packing packing;
  packing.materials = {{"A", 1, 1, 0}, {"B", 1, 1, 0}, {"C", 1, 1, 0}};
  auto& d = packing.domain;
  d.periodic[0] = d.periodic[1] = true;
  for (auto& wall : d.wall) wall.present = false;
  d.wall[right].position = 10;
  d.wall[top].position = 8;
  d.tilt = 3;
  packing.grains.resize(2);
  packing.grains.position = {{1, 0.5}, {4.5, 7.5}};
  packing.grains.radius = {0.6, 0.6};
  return packing;
}

TEST(ExportSnapshot, AContactAcrossATiltedPeriodicSideEndsAtTheNearImage) {
  Packing packing = sheared_pair();
  packing.contacts.add(0, 1, {0, 1}, 1, 0, 0.5, 0.5);
  const Vec2 end = io::far_end(packing, 0);
  EXPECT_DOUBLE_EQ(end.x, 1.5);   // 4.5 less the tilt
  EXPECT_DOUBLE_EQ(end.y, -0.5);  // one cell below
}

TEST(ExportSnapshot, ContactTypesNumberThePairsOfMaterialsWhateverTheirOrder) {
  Packing packing = sheared_pair();
  packing.grains.resize(3);
  packing.grains.material = {0, 1, 2};
  for (std::int32_t a = 0; a < 3; ++a)
    for (std::int32_t b = 0; b < 3; ++b) packing.contacts.add(a, b, {1, 0}, 1, 0, 1, 1);
  packing.contacts.add(0, wall_partner(top), {0, -1}, 1, 0, 1, 0);
  std::vector<int> types;
  for (std::size_t c = 0; c < packing.contacts.size(); ++c) types.push_back(io::contact_type(packing, c));
  EXPECT_EQ(types, (std::vector<int>{0, 1, 2, 1, 3, 4, 2, 4, 5, -1}));
}

TEST(ExportSnapshot, LammpsBoundsOfATiltedCellEncloseIt) {
  Snapshot snapshot;
  snapshot.packing = sheared_pair();
  const auto dump = io::exports::lammps.of_snapshot({0, "shear", &snapshot, {}}).front().bytes;
  EXPECT_NE(dump.find("ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 13 3\n0 8 0\n"), std::string::npos) << dump;
  const auto xyz = io::exports::extxyz.of_snapshot({0, "shear", &snapshot, {}}).front().bytes;
  EXPECT_NE(xyz.find("Lattice=\"10 0 0 3 8 0 0 0 1\""), std::string::npos) << xyz;
  EXPECT_NE(xyz.find("pbc=\"T T F\""), std::string::npos) << xyz;
}

TEST(ExportSnapshot, EveryFormatTakesASampleWithoutContactsOrGrains) {
  Snapshot snapshot;
  snapshot.packing.materials = {{"A", 1, 1, 0}};
  for (const auto* known : io::exports::all) {
    const io::ExportFormat& format = *known;
    if (!format.of_loading && !format.of_snapshot) continue;  // of fields only
    std::set<std::string> names;
    io::ExportSnapshot one{0, "", &snapshot, {}};
    if (format.wants_grid) one.grid = {{0, 0}, {1, 1}, {1, 1}, {}, {{0, 0}}, {0, 0, 0, 0, 0, 0}};
    for (const auto& file : format.of_loading ? format.of_loading({one}, {}) : format.of_snapshot(one)) {
      EXPECT_FALSE(file.bytes.empty()) << file.name;
      names.insert(file.name);
    }
    EXPECT_GE(names.size(), 1u) << format.name;
  }
}

TEST(ExportSnapshot, FieldsAreAnImageOfTheBoxWithVectorsAndTensors) {
  io::ExportSnapshot one;
  one.number = 7;
  EXPECT_TRUE(io::exports::fields.of_snapshot(one).empty());
  one.grid = {{1, 2},           {0.5, 0.25},
              {2, 1},           {{"density", "kg/m^3", {3, 4}}},
              {{1, 0}, {2, 0}}, {-1, -2, 0, 0.5, 0, 0, -1, -2, 0, 0.5, 0, 0}};
  const auto files = io::exports::fields.of_snapshot(one);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].name, "fields_0007.vti");
  for (const char* part : {"WholeExtent=\"0 1 0 0 0 0\" Origin=\"1.25 2.125 0\" Spacing=\"0.5 0.25 0.5\"",
                           "Name=\"density\" NumberOfComponents=\"1\"", "Name=\"velocity\" NumberOfComponents=\"3\"",
                           "Name=\"stress\" NumberOfComponents=\"6\""})
    EXPECT_NE(files[0].bytes.find(part), std::string::npos) << part;
  EXPECT_NE(
      io::exports::fields.index({0, 0.5}).front().bytes.find("timestep=\"0.5\" part=\"0\" file=\"fields_0001.vti\""),
      std::string::npos);
}

TEST(ExportSnapshot, FieldsOfSpheresAreAnImageOfLayers) {
  io::ExportSpheres one;
  EXPECT_TRUE(io::exports::fields.of_spheres(one).empty());
  one.grid = {{1, 2, 3}, {0.5, 0.25, 2}, {1, 2, 1}, {}, {{1, 0, 0}, {2, 0, 0}}, std::vector<double>(12, 1.0)};
  const auto files = io::exports::fields.of_spheres(one);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_NE(files[0].bytes.find("WholeExtent=\"0 0 0 1 0 0\" Origin=\"1.25 2.125 4\" Spacing=\"0.5 0.25 2\""),
            std::string::npos)
      << files[0].bytes.substr(0, 400);
}

TEST(ExportSnapshot, UnknownNumbersAreEmptyCellsAndNamesWithCommasAreQuotedInTables) {
  Snapshot snapshot;
  snapshot.packing = test::row_of_grains(2);
  snapshot.packing.materials[0].name = "POM, \"black\"";
  const auto files = io::exports::csv.of_snapshot({3, "load", &snapshot, {{"sigma_norm", "1", {0.5, std::nan("")}}}});
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].name, "grains_0003.csv");
  EXPECT_TRUE(files[0].bytes.starts_with(
      "id,x [m],y [m],radius [m],material,zone,angle [rad],vx [m/s],vy [m/s],omega [rad/s],sigma_norm\n"))
      << files[0].bytes;
  EXPECT_TRUE(files[1].bytes.starts_with(
      "i,j,fn [N],ft [N],nx,ny,type,strong,glued,arm_i [m],arm_j [m],overlap [m],sliding_velocity [m/s]\n"))
      << files[1].bytes;
  EXPECT_NE(files[0].bytes.find("100,0,0.01,0.0101,\"POM, \"\"black\"\"\",1,0,0,-0,0,0.5\n"), std::string::npos)
      << files[0].bytes;
  EXPECT_NE(files[0].bytes.find(",0.003,\n"), std::string::npos) << files[0].bytes;
  EXPECT_NE(files[1].bytes.find("100,bottom,5,-0.25,0,-1,-1,"), std::string::npos) << files[1].bytes;
}

}  // namespace
