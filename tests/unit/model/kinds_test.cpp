#include "model/kinds.hpp"

#include <gtest/gtest.h>

namespace arenite {
namespace {

TEST(Kinds, AreThoseOfPhasesAndOfClasses) {
  PhaseMap map = make_phase_map(5, 1, 1e-3);
  map.phase = {Phase::empty, Phase::matrix, Phase::particle, Phase::particle, Phase::particle};
  map.grain = {-1, -1, 0, 1, 2};
  map.grain_class = {GrainClass::large, GrainClass::none, GrainClass::small};
  using enum NodeKind;
  EXPECT_EQ(kinds_of(map), (std::vector{empty, matrix, large, grain, small}));
  map.grain_class.clear();  // of a picture whose grains nobody numbered
  EXPECT_EQ(kind_of(map, 2), grain);
}

TEST(Kinds, HaveNamesByTheirNumbers) {
  EXPECT_EQ(node_kinds[static_cast<std::size_t>(NodeKind::large)].id, "large");
  EXPECT_EQ(node_kinds[static_cast<std::size_t>(kind_of(GrainClass::small))].many, "small grains");
  EXPECT_EQ(bond_breaks[static_cast<std::size_t>(BondBreak::shear)], "shear");
}

}  // namespace
}  // namespace arenite
