#include "grains/fields/laboratory/tested_stage.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/error.hpp"

namespace arenite::fields {
namespace {

template <class Stage> void expect_found_by_history() {
  Stage packing, test;
  packing.snapshots.emplace_back();
  test.name = "test";
  test.snapshots.emplace_back();
  test.history.columns.push_back({"time", "s", {0, 1}});
  using Stages = std::vector<const Stage*>;
  EXPECT_EQ(stage_with_history(Stages{&packing, &test, &packing}, {}), 1u);
  EXPECT_EQ(stage_with_history(Stages{&packing, &test, &packing}, "test"), 1u);
  EXPECT_THROW(stage_with_history(Stages{&packing, &test}, "other"), InputError);
  EXPECT_THROW(stage_with_history(Stages{&packing}, {}), InputError);
}

TEST(TestedStage, IsFoundByItsHistory) {
  expect_found_by_history<StageResult>();
  expect_found_by_history<SphereResult>();
}

}  // namespace
}  // namespace arenite::fields
