#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

StageResult stage_with_cohesive(std::vector<CohesivePair> pairs) {
  Frame frame;
  frame.packing.materials = {{"glass", 2500, 1e6, 0}};
  frame.packing.grains.resize(3);
  frame.packing.grains.radius = {0.01, 0.01, 0.01};
  frame.packing.cohesive = std::move(pairs);
  StageResult stage;
  stage.name = "wet";
  stage.frames.push_back(frame);
  return stage;
}

std::filesystem::path cohesive_file(const char* name) { return std::filesystem::path(::testing::TempDir()) / name; }

TEST(StageCohesive, PairsComeBackAsTheyWere) {
  const auto path = cohesive_file("cohesive.h5");
  const CohesivePair touching{0, 1, -1e-6, 2.5, -2.5e-6}, apart{1, 2, 3e-4, 1.5, 4e-4};
  write_stage(path, stage_with_cohesive({touching, apart}));
  const auto read = read_stage(path).frames[0].packing.cohesive;
  ASSERT_EQ(read.size(), 2u);
  for (const auto& [was, is] : {std::pair{touching, read[0]}, {apart, read[1]}}) {
    EXPECT_EQ(is.i, was.i);
    EXPECT_EQ(is.j, was.j);
    for (double CohesivePair::*member : {&CohesivePair::gap, &CohesivePair::pull, &CohesivePair::energy}) EXPECT_EQ(is.*member, was.*member);
  }
  std::filesystem::remove(path);
}

TEST(StageCohesive, PairsOfGrainsThatAreNotThereAreRefused) {
  const auto path = cohesive_file("no_grain_coheres.h5");
  for (const CohesivePair& wrong : {CohesivePair{0, 0, 0, 1, 0}, CohesivePair{1, 3, 0, 1, 0}, CohesivePair{-1, 1, 0, 1, 0}}) {
    write_stage(path, stage_with_cohesive({wrong}));
    EXPECT_THROW(read_stage(path), InputError);
  }
  std::filesystem::remove(path);
}

TEST(StageCohesive, LeavesNoTraceWhereThereIsNone) {
  const auto path = cohesive_file("dry.h5");
  write_stage(path, stage_with_cohesive({}));
  EXPECT_EQ(read_file(path.string()).find("cohesive"), std::string::npos);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace arenite::io
