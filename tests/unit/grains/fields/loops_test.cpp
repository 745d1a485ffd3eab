#include "grains/fields/loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

/// Share of loops with from so many to so many contacts.
double share_of(const Loops& loops, std::size_t least, std::size_t most) {
  const auto among = [&](std::int32_t edges) {
    return static_cast<std::size_t>(edges) >= least && static_cast<std::size_t>(edges) <= most;
  };
  return static_cast<double>(std::count_if(loops.edges.begin(), loops.edges.end(), among)) /
         static_cast<double>(loops.edges.size());
}

double total_area(const Loops& loops) { return std::accumulate(loops.area.begin(), loops.area.end(), 0.0); }

/// Contacts for which `keep(c)` holds.
template <class Keep> Packing with_contacts(Packing p, Keep keep) {
  const Contacts old = std::move(p.contacts);
  p.contacts = {};
  for (std::size_t c = 0; c < old.size(); ++c)
    if (keep(old, c))
      p.contacts.add(old.i[c], old.j[c], old.normal[c], old.fn[c], old.ft[c], old.arm_i[c], old.arm_j[c]);
  return p;
}

/// The lattice cut along its cell: only contacts inside it are left.
Packing cut_open(Packing p) {
  p.domain.periodic[0] = p.domain.periodic[1] = false;
  const Grains grains = p.grains;
  return with_contacts(std::move(p), [&](const Contacts& c, std::size_t k) {
    return norm(grains.position[static_cast<std::size_t>(c.i[k])] - grains.position[static_cast<std::size_t>(c.j[k])]) <
           1.5;
  });
}

TEST(Loops, OfAPeriodicLatticeAreItsMeshes) {
  const Loops squares = find_loops(test::square_lattice(6)), triangles = find_loops(test::triangular_lattice(6));
  EXPECT_EQ(squares.edges, std::vector<std::int32_t>(36, 4));
  EXPECT_EQ(squares.contacts - squares.grains, squares.edges.size());  // F = E - V on the torus
  EXPECT_EQ(squares.outlines, 0u);
  EXPECT_NEAR(total_area(squares), 36, 1e-12);  // rounding of 144 terms of size 1
  EXPECT_DOUBLE_EQ(squares.mean_edges, 4);
  EXPECT_EQ(triangles.edges, std::vector<std::int32_t>(72, 3));
  EXPECT_NEAR(total_area(triangles), 36 * std::sqrt(3.0) / 2, 1e-12);
  EXPECT_DOUBLE_EQ(share_of(triangles, 3, 3), 1);
  EXPECT_DOUBLE_EQ(share_of(triangles, 4, triangles.histogram.size()), 0);
}

TEST(Loops, GrowWhereAGrainIsMissing) {
  // Without one grain and its six contacts, six triangles become one loop of six.
  const Packing p = with_contacts(test::triangular_lattice(6),
                                  [](const Contacts& c, std::size_t k) { return c.i[k] != 14 && c.j[k] != 14; });
  const Loops loops = find_loops(p);
  EXPECT_EQ(loops.rattlers, 1u);
  EXPECT_EQ(loops.histogram, (std::vector<std::size_t>{0, 0, 0, 66, 0, 0, 1}));
  EXPECT_EQ(loops.edges.size(), loops.contacts - loops.grains);
  EXPECT_DOUBLE_EQ(share_of(loops, 3, 3), 66.0 / 67);
  EXPECT_DOUBLE_EQ(share_of(loops, 5, loops.histogram.size()), 1.0 / 67);
  EXPECT_DOUBLE_EQ(loops.mean_edges, 204.0 / 67);
  EXPECT_NEAR(total_area(loops), 36 * std::sqrt(3.0) / 2, 1e-12);
}

TEST(Loops, OfALatticeCutOpenHaveAnOutline) {
  const Loops loops = find_loops(cut_open(test::square_lattice(6)));
  EXPECT_EQ(loops.edges.size(), 25u);
  EXPECT_EQ(loops.outlines, 1u);
  EXPECT_EQ(loops.parts, 1u);
  EXPECT_EQ(loops.edges.size(), loops.contacts - loops.grains + loops.parts);
}

TEST(Loops, OfAStripAroundTheCellHaveTwoOutlines) {
  // Two rows of a lattice, and whatever grains of the rows above and below: an outline that rises and falls encloses no
  // loop, be the area between it and the line from its start to its end what it may. A ring has V - E + L = 0.
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, Purpose::test);
    std::vector<std::uint8_t> there(36, 0);
    for (std::size_t g = 0; g < 36; ++g) there[g] = g < 12 || ((g < 18 || g >= 30) && random.uniform() < 0.7);
    Packing p = test::square_lattice(6);
    if (seed % 2) {  // walks then begin at the high places of an outline
      for (auto* a : {&p.contacts.i, &p.contacts.j}) std::reverse(a->begin(), a->end());
      std::ranges::reverse(p.contacts.normal);
    }
    const Loops loops = find_loops(with_contacts(std::move(p), [&](const Contacts& c, std::size_t k) {
      return there[static_cast<std::size_t>(c.i[k])] && there[static_cast<std::size_t>(c.j[k])];
    }));
    EXPECT_EQ(loops.outlines, 2u);
    EXPECT_EQ(loops.edges.size(), loops.contacts - loops.grains);
    EXPECT_EQ(loops.edges.size(), loops.histogram.at(4));
  }
}

TEST(Loops, LeaveOutWhatDanglesAndPassABridgeOnBothSides) {
  // Two triangles joined by one contact, and a tail of two grains.
  Packing p = test::empty_box(20, 20);
  for (const Vec2 c :
       {Vec2{1, 1}, Vec2{2, 0.5}, Vec2{2, 1.5}, Vec2{3, 1.5}, Vec2{4, 1}, Vec2{4, 2}, Vec2{5, 2}, Vec2{6, 2}})
    test::add_grain(p, c, 0.6);
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 3}, {5, 6}, {6, 7}})
    test::add_contact(p, static_cast<std::size_t>(i), static_cast<std::size_t>(j), 1);
  Loops loops = find_loops(p);
  EXPECT_EQ(loops.edges, (std::vector<std::int32_t>{3, 3}));
  EXPECT_EQ(loops.rattlers, 2u);
  EXPECT_EQ(loops.contacts, 7u);
  EXPECT_EQ(loops.outlines, 1u);
  EXPECT_NEAR(total_area(loops), 1, 1e-15);
  p.contacts.fn[3] = 0;  // the bridge bears nothing: two parts
  loops = find_loops(p);
  EXPECT_EQ(loops.parts, 2u);
  EXPECT_EQ(loops.edges.size(), loops.contacts - loops.grains + loops.parts);
  EXPECT_EQ(find_loops(p, false).parts, 1u);
  EXPECT_TRUE(std::isnan(find_loops(test::empty_box(1, 1)).mean_edges));
}

TEST(Loops, OfAnyPlaneNetworkObeyEuler) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, Purpose::test);
    const double kept = random.uniform(0.3, 1);
    const Packing p = with_contacts(cut_open(test::triangular_lattice(12)),
                                    [&](const Contacts&, std::size_t) { return random.uniform() < kept; });
    const Loops loops = find_loops(p);
    EXPECT_EQ(loops.edges.size() + loops.grains, loops.contacts + loops.parts);
    EXPECT_EQ(loops.outlines, loops.parts);
    EXPECT_EQ(loops.grains + loops.rattlers, p.grains.size());
  }
}

TEST(Loops, OfAnyPeriodicNetworkObeyEulerAndFillTheCell) {
  // Cells sheared by whole grains hold the same lattice: contacts over the top edge lead to grains further along.
  int checked = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(seed, Purpose::test);
    Packing p = test::square_lattice(8);
    p.domain.tilt = static_cast<double>(random.below(20)) - 10;
    p.contacts = {};
    for (std::size_t g = 0; g < 64; ++g) {
      const auto row = static_cast<int>(g) / 8, column = static_cast<int>(g) % 8;
      const int across = row == 7 ? static_cast<int>(p.domain.tilt) : 0;
      if (random.uniform() < 0.85) test::add_contact(p, g, static_cast<std::size_t>(row * 8 + (column + 1) % 8), 1);
      if (random.uniform() < 0.85)
        test::add_contact(p, g, static_cast<std::size_t>((row + 1) % 8 * 8 + (column - across + 16) % 8), 1);
    }
    const Loops loops = find_loops(p);
    if (loops.parts != 1 || loops.outlines != 0) continue;
    ++checked;
    EXPECT_EQ(loops.edges.size(), loops.contacts - loops.grains) << p.domain.tilt;
    EXPECT_NEAR(total_area(loops), 64, 1e-11);
  }
  EXPECT_GT(checked, 30);
}

}  // namespace
}  // namespace arenite::fields
