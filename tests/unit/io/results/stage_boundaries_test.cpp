#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

StageResult stage_with_boundaries(std::vector<Boundary> boundaries, std::int32_t partner) {
  Snapshot snapshot;
  Packing& p = snapshot.packing;
  p.materials = {{"glass", 2500, 1e6, 0}};
  p.grains.resize(1);
  p.grains.radius[0] = 0.01;
  p.domain.boundaries = std::move(boundaries);
  p.contacts.add(0, partner, {0, 1}, 1, 0, 0.01, 0);
  StageResult stage;
  stage.name = "turn";
  stage.snapshots.push_back(snapshot);
  return stage;
}

const std::vector<Boundary> two{{{false}, "gate", {{0, 0}, {1, 0.5}}, false, {0.1, 0}, 0, {0.5, 0.25}, {}, 0},
                                {{true}, "drum", {{0, 0}, {1, 0}, {0, 1}}, true, {}, -2, {0.25, 0.25}, {1, -3}, 0.5}};

std::filesystem::path boundaries_file(const char* name) { return std::filesystem::path(::testing::TempDir()) / name; }

TEST(StageBoundaries, ComeBackAsTheyWere) {
  const auto path = boundaries_file("boundaries.h5");
  write_stage(path, stage_with_boundaries(two, boundary_partner(9)));
  const StageResult read = read_stage(path);
  EXPECT_EQ(read.snapshots[0].packing.domain.boundaries, two);
  EXPECT_EQ(read.snapshots[0].packing.domain.boundary_of(read.snapshots[0].packing.contacts.element(0)), 1);
  std::filesystem::remove(path);
}

SphereResult stage_with_faces(std::vector<std::int32_t> corners, std::int32_t partner) {
  SphereResult stage;
  stage.name = "sink";
  PackingIn<3>& p = stage.snapshots.emplace_back().packing;
  p.materials = {{"glass", 2500, 1e6, 0}};
  p.grains.resize(1);
  p.grains.radius[0] = 0.01;
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.domain.boundaries = {{{corners}, "wedge", points, false, {0, -1, 0}, {0, 0, 2}, {0.5, 0, 0}, {1, 2, 3}, {4, 5, 6}}};
  p.contacts.add(0, partner, {0, 1, 0}, 1, {}, 0.01, 0);
  return stage;
}

TEST(StageBoundaries, OfFacesComeBackAsTheyWere) {
  const auto path = boundaries_file("faces.h5");
  const SphereResult written = stage_with_faces({3, 3}, boundary_partner<3>(1));
  write_stage(path, written);
  const SphereResult read = read_stage<3>(path);
  EXPECT_EQ(read.snapshots[0].packing.domain.boundaries, written.snapshots[0].packing.domain.boundaries);
  EXPECT_TRUE(read.snapshots[0].packing.contacts.is_boundary(0));
  write_stage(path, stage_with_faces({3, 3}, boundary_partner<3>(2)));
  EXPECT_THROW(read_stage<3>(path), InputError);
  write_stage(path, stage_with_faces({3, 4}, boundary_partner<3>(0)));
  EXPECT_THROW(read_stage<3>(path), InputError);
  std::filesystem::remove(path);
}

TEST(StageBoundaries, AContactWithAnElementThatIsNotThereIsRefused) {
  const auto path = boundaries_file("no_element.h5");
  write_stage(path, stage_with_boundaries(two, boundary_partner(10)));
  EXPECT_THROW(read_stage(path), InputError);
  write_stage(path, stage_with_boundaries({}, boundary_partner(0)));
  EXPECT_THROW(read_stage(path), InputError);
  std::filesystem::remove(path);
}

TEST(StageBoundaries, LeaveNoTraceWhereThereAreNone) {
  const auto path = boundaries_file("none.h5");
  write_stage(path, stage_with_boundaries({}, wall_partner(bottom)));
  EXPECT_EQ(read_file(path.string()).find("boundaries"), std::string::npos);
  EXPECT_TRUE(read_stage(path).snapshots[0].packing.domain.boundaries.empty());
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace arenite::io
