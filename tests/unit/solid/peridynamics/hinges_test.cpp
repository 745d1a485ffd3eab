#include <gtest/gtest.h>

#include <set>

#include "core/random.hpp"
#include "solid/peridynamics/hinges.hpp"
#include "support/homogeneous_sample.hpp"

namespace arenite::peridynamics {
namespace {

/// Nodes reached from the bottom row (clamped as one) when node `without` is taken away; the upper clamp joins its
/// nodes.
std::size_t reached(const Bonds& bonds, std::ptrdiff_t without, bool& top) {
  const Grid& g = bonds.grid;
  std::set<std::ptrdiff_t> joined;  // nodes with any bond
  for (int y = 0; y < g.height; ++y)
    for (int x = 0; x < g.width; ++x)
      for (int d = 0; d < bonds_per_node; ++d)
        if (const auto i = g.index(x, y); bonds.type(i, d)) joined.insert({i, i + bonds.step(d)});
  std::set<std::ptrdiff_t> seen;
  std::vector<std::ptrdiff_t> front;
  const auto add = [&](std::ptrdiff_t i) {
    if (i != without && seen.insert(i).second) front.push_back(i);
  };
  for (int x = 0; x < g.width; ++x)
    if (bonds.words[g.index(x, 0)]) add(g.index(x, 0));
  top = false;
  while (!front.empty()) {
    const auto i = front.back();
    front.pop_back();
    for (int d = 0; d < bonds_per_node; ++d) {
      if (bonds.type(i, d)) add(i + bonds.step(d));
      if (bonds.type(i - bonds.step(d), d)) add(i - bonds.step(d));
    }
    if (top || i < g.row(g.height - 1)) continue;
    top = true;
    for (int x = 0; x < g.width; ++x)
      if (joined.contains(g.index(x, g.height - 1))) add(g.index(x, g.height - 1));
  }
  return seen.size();
}

TEST(Hinges, SolidPlateHasNone) { EXPECT_TRUE(find_hinges(make_bonds(test::homogeneous_sample(20, 20), {})).empty()); }

TEST(Hinges, EveryHingeCutsOffWhatItSaysAndNoOtherNodeCutsAnything) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    PhaseMap map = make_phase_map(14, 22, 1);
    RandomStream random(seed, Purpose::test);
    for (std::size_t i = 0; i < map.size(); ++i)
      if (random.uniform() < 0.16) map.phase[i] = Phase::matrix;
    for (int x = 0; x < 14; ++x) map.phase[map.index(x, 0)] = Phase::matrix;  // one clamp, one part
    const Bonds bonds = make_bonds(map, {});
    const auto hinges = find_hinges(bonds);
    bool top_whole = false;
    const std::size_t whole = reached(bonds, -1, top_whole);
    for (int y = 1; y < map.height - 1; ++y)
      for (int x = 0; x < map.width; ++x) {
        const auto i = bonds.grid.index(x, y);
        if (map.phase[map.index(x, y)] == Phase::empty) continue;
        bool top = false;
        const std::size_t left = reached(bonds, i, top);
        std::size_t said = 0;
        bool carries = false;
        for (const Hinge& h : hinges)
          if (h.x == x && h.y == y) said = h.nodes, carries = h.carries;
        if (left == whole) {  // not tied to the bottom at all
          EXPECT_EQ(said, 0u);
        } else {
          EXPECT_EQ(whole - left - 1, said) << "seed " << seed << " node " << x << " " << y;
          EXPECT_EQ(carries, top_whole && !top) << "seed " << seed << " node " << x << " " << y;
        }
      }
  }
}

}  // namespace
}  // namespace arenite::peridynamics
