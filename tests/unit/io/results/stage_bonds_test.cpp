#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

/// Three grains with these bonds and cohesive pairs.
StageResult stage_with(std::vector<Bond> bonds, std::vector<CohesivePair> pairs = {}) {
  Snapshot snapshot;
  snapshot.packing.materials = {{"glass", 2500, 1e6, 0}};
  snapshot.packing.grains.resize(3);
  snapshot.packing.grains.radius = {0.01, 0.01, 0.01};
  snapshot.packing.bonds = std::move(bonds);
  snapshot.packing.cohesive = std::move(pairs);
  StageResult stage;
  stage.name = "press";
  stage.snapshots.push_back(snapshot);
  return stage;
}

const Bond whole{0, 1, 0.02, {0.6, 0.8}, 0.1, -0.2, 5, -3, 0.01, 2e-3, 0.7, BondBreak::none, 0, {}};
const Bond torn{1, 2, 0.021, {1, 0}, 0.3, 0.4, 0, 0, 0, 1e-3, 1.001, BondBreak::bending, 2.5, {0.5, 0.25}};

std::filesystem::path bonds_file(const char* name) { return std::filesystem::path(::testing::TempDir()) / name; }

void expect_same(const Bond& a, const Bond& b) {
  EXPECT_EQ(a.i, b.i);
  EXPECT_EQ(a.j, b.j);
  EXPECT_EQ(a.broken, b.broken);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.place, b.place);
  for (double Bond::*member : {&Bond::length, &Bond::angle_i, &Bond::angle_j, &Bond::fn, &Bond::ft, &Bond::moment,
                               &Bond::energy, &Bond::load, &Bond::time})
    EXPECT_EQ(a.*member, b.*member);
}

TEST(StageBonds, ComeBackAsTheyWere) {
  const auto path = bonds_file("bonds.h5");
  write_stage(path, stage_with({whole, torn}));
  const StageResult read = read_stage(path);
  ASSERT_EQ(read.snapshots[0].packing.bonds.size(), 2u);
  expect_same(read.snapshots[0].packing.bonds[0], whole);
  expect_same(read.snapshots[0].packing.bonds[1], torn);
  std::filesystem::remove(path);
}

TEST(StageBonds, OfGrainsThatAreNotThereAreRefused) {
  const auto path = bonds_file("no_grain.h5");
  for (Bond wrong : {whole, torn}) {
    wrong.j = wrong.i == 0 ? 0 : 3;
    write_stage(path, stage_with({wrong}));
    EXPECT_THROW(read_stage(path), InputError);
  }
  std::filesystem::remove(path);
}

TEST(StageBonds, LeaveNoTraceWhereThereAreNone) {
  const auto path = bonds_file("no_bonds.h5");
  write_stage(path, stage_with({}));
  EXPECT_EQ(read_file(path.string()).find("bonds"), std::string::npos);
  std::filesystem::remove(path);
}

TEST(StageCohesive, PairsComeBackAsTheyWere) {
  const auto path = bonds_file("cohesive.h5");
  const CohesivePair touching{0, 1, -1e-6, 2.5, -2.5e-6}, apart{1, 2, 3e-4, 1.5, 4e-4};
  write_stage(path, stage_with({}, {touching, apart}));
  const auto read = read_stage(path).snapshots[0].packing.cohesive;
  ASSERT_EQ(read.size(), 2u);
  for (const auto& [was, is] : {std::pair{touching, read[0]}, {apart, read[1]}}) {
    EXPECT_EQ(is.i, was.i);
    EXPECT_EQ(is.j, was.j);
    for (double CohesivePair::*member : {&CohesivePair::gap, &CohesivePair::pull, &CohesivePair::energy})
      EXPECT_EQ(is.*member, was.*member);
  }
  std::filesystem::remove(path);
}

TEST(StageCohesive, PairsOfGrainsThatAreNotThereAreRefused) {
  const auto path = bonds_file("no_grain_coheres.h5");
  for (const CohesivePair& wrong :
       {CohesivePair{0, 0, 0, 1, 0}, CohesivePair{1, 3, 0, 1, 0}, CohesivePair{-1, 1, 0, 1, 0}}) {
    write_stage(path, stage_with({}, {wrong}));
    EXPECT_THROW(read_stage(path), InputError);
  }
  std::filesystem::remove(path);
}

TEST(StageCohesive, LeavesNoTraceWhereThereIsNone) {
  const auto path = bonds_file("dry.h5");
  write_stage(path, stage_with({}, {}));
  EXPECT_EQ(read_file(path.string()).find("cohesive"), std::string::npos);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace arenite::io
