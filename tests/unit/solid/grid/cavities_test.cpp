#include "solid/grid/cavities.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "model/packing.hpp"

namespace arenite::grid {
namespace {

/// Rows from the top: "o" particle, "x" matrix, "." nothing.
PhaseMap map_of(const std::vector<std::string>& rows) {
  PhaseMap map = make_phase_map(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1);
  map.grain_class = {GrainClass::none};
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const char c = rows[map.height - 1 - y][x];
      map.phase[map.index(x, y)] = c == 'o' ? Phase::particle : c == 'x' ? Phase::matrix : Phase::empty;
      map.grain[map.index(x, y)] = c == 'o' ? 0 : -1;
    }
  return map;
}

PhaseMap random_map(int width, int height) {
  PhaseMap map = make_phase_map(width, height, 1);
  map.grain_class = {GrainClass::none};
  for (std::size_t k = 0; k < map.size(); ++k) {
    map.phase[k] = *rc::gen::element(Phase::empty, Phase::empty, Phase::matrix, Phase::particle);
    if (map.phase[k] == Phase::particle) map.grain[k] = 0;
  }
  return map;
}

/// The same rules by spreading every label to its neighbours until nothing changes.
Cavities by_brute_force(const PhaseMap& map, Cavity kind, const CavityRules& rules) {
  std::vector<std::int32_t> label(map.size(), -1);
  for (std::size_t k = 0; k < map.size(); ++k)
    if (kind == Cavity::pore ? map.phase[k] != Phase::particle : map.phase[k] == Phase::empty)
      label[k] = static_cast<std::int32_t>(k);
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const int u = x + dx, v = y + dy;
            if ((dx != 0 && dy != 0 && !rules.eight_connected) || u < 0 || v < 0 || u >= map.width || v >= map.height)
              continue;
            auto &a = label[map.index(x, y)], &b = label[map.index(u, v)];
            if (a < 0 || b < 0 || b >= a) continue;
            a = b;
            changed = true;
          }
  }
  Cavities cavities;
  cavities.rules = rules;
  cavities.label.assign(map.size(), -1);
  for (std::size_t first = 0; first < map.size(); ++first) {
    if (label[first] != static_cast<std::int32_t>(first)) continue;
    std::vector<std::size_t> members;
    bool border = false;
    for (std::size_t k = first; k < map.size(); ++k) {
      if (label[k] != static_cast<std::int32_t>(first)) continue;
      members.push_back(k);
      const int x = static_cast<int>(k) % map.width, y = static_cast<int>(k) / map.width;
      border = border || x == 0 || y == 0 || x == map.width - 1 || y == map.height - 1;
    }
    if (border && rules.leave_out_border) {
      ++cavities.cut;
    } else if (static_cast<int>(members.size()) < rules.fewest_nodes) {
      ++cavities.specks;
    } else {
      for (const auto k : members) cavities.label[k] = static_cast<std::int32_t>(cavities.nodes.size());
      cavities.nodes.push_back(static_cast<std::int64_t>(members.size()));
    }
  }
  return cavities;
}

RC_GTEST_PROP(Cavities, AreThoseThatBruteForceFinds, ()) {
  const PhaseMap map = random_map(*rc::gen::inRange(1, 24), *rc::gen::inRange(1, 24));
  CavityRules rules;
  rules.eight_connected = *rc::gen::arbitrary<bool>();
  rules.leave_out_border = *rc::gen::arbitrary<bool>();
  rules.fewest_nodes = *rc::gen::inRange(0, 6);
  const Cavity kind = *rc::gen::element(Cavity::pore, Cavity::void_);
  const Cavities found = find_cavities(map, kind, rules), expected = by_brute_force(map, kind, rules);
  RC_ASSERT(found.label == expected.label);
  RC_ASSERT(found.nodes == expected.nodes);
  RC_ASSERT(found.specks == expected.specks);
  RC_ASSERT(found.cut == expected.cut);
}

TEST(Cavities, OfASmallMapAreTheOnesSeen) {
  const PhaseMap map = map_of({"oooooooo", "o..oxx.o", "o..ox..o", "o.ooooo.", "oooooooo"});
  const Cavities voids = find_cavities(map, Cavity::void_), pores = find_cavities(map, Cavity::pore);
  EXPECT_EQ(voids.nodes, (std::vector<std::int64_t>{5}));
  EXPECT_EQ(voids.specks, 1u);
  EXPECT_EQ(voids.cut, 1u);
  EXPECT_EQ(pores.nodes, (std::vector<std::int64_t>{5, 6}));
  CavityRules touching;
  touching.eight_connected = true;
  EXPECT_EQ(find_cavities(map, Cavity::pore, touching).cut, 1u);  // the corner joins the right one to the border
}

TEST(Cavities, NeedALeastSize) {
  CavityRules rules;
  rules.fewest_nodes = -1;
  EXPECT_THROW(find_cavities(map_of({"."}), Cavity::pore, rules), InputError);
}

TEST(Percolation, NamesWhatRunsThrough) {
  const Percolation crack = find_percolation(map_of({"oooo", "....", "oxxo"}));
  EXPECT_FALSE(crack.solid_bottom_top);
  EXPECT_TRUE(crack.solid_left_right);
  EXPECT_TRUE(crack.void_left_right);
  EXPECT_FALSE(crack.void_bottom_top);
  const Percolation diagonal = find_percolation(map_of({"..o", ".o.", "o.."}));
  EXPECT_TRUE(diagonal.solid_bottom_top);
  EXPECT_FALSE(diagonal.void_left_right);
  EXPECT_TRUE(find_percolation(map_of({"..o", ".o.", "o.."}), true).void_left_right);
  EXPECT_FALSE(find_percolation(map_of({"..o", ".o.", "o.."}), true).solid_bottom_top);
}

RC_GTEST_PROP(Percolation, EitherAVoidCrossesOrSolidConnects, ()) {
  const PhaseMap map = random_map(*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12));
  for (const bool eight : {false, true}) {
    const Percolation p = find_percolation(map, eight);
    RC_ASSERT(p.solid_bottom_top != p.void_left_right);
    RC_ASSERT(p.solid_left_right != p.void_bottom_top);
  }
}

}  // namespace
}  // namespace arenite::grid
