#include "model/phase_map.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace arenite {
namespace {

PhaseMap small_map() {
  PhaseMap map = make_phase_map(3, 2, 0.5);
  map.grain_class = {GrainClass::large};
  map.phase[map.index(1, 0)] = Phase::particle;
  map.grain[map.index(1, 0)] = 0;
  map.phase[map.index(2, 1)] = Phase::matrix;
  return map;
}

TEST(PhaseMap, SoundMapPasses) { EXPECT_NO_THROW(check(small_map())); }

TEST(PhaseMap, LabelThatNoGrainHasIsNamedWithItsNode) {
  PhaseMap map = small_map();
  map.grain[map.index(1, 0)] = 4;
  try {
    check(map);
    FAIL() << "label 4 of one grain was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("(1, 0) has grain label 4"), std::string::npos) << error.what();
  }
}

TEST(PhaseMap, LabelOnMatrixIsRefused) {
  PhaseMap map = small_map();
  map.grain[map.index(2, 1)] = 0;
  EXPECT_THROW(check(map), InputError);
}

TEST(PhaseMap, SizesAndSpacingThatDoNotFitAreRefused) {
  PhaseMap map = small_map();
  map.phase.pop_back();
  EXPECT_THROW(check(map), InputError);
  EXPECT_THROW(check(make_phase_map(0, 4, 1)), InputError);
  EXPECT_THROW(check(make_phase_map(4, 4, 0)), InputError);
}

TEST(PhaseMap, TransposedTwiceIsTheSame) {
  const PhaseMap map = small_map(), once = transposed(map), twice = transposed(once);
  EXPECT_EQ(once.phase[once.index(0, 1)], Phase::particle);
  EXPECT_EQ(twice.phase, map.phase);
  EXPECT_EQ(twice.grain, map.grain);
}

}  // namespace
}  // namespace arenite
