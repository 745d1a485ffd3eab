#include "grains/fields/force_chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

using Chain = std::vector<std::int32_t>;
constexpr double degree = std::numbers::pi / 180;

/// Touching disks of radius 1/2, each next one turned by `turns` from x; every contact carries 1 N, as do walls at both
/// ends, which are drawn here as contacts with the left wall, turned to push along the ends.
Packing bent_chain(const std::vector<double>& turns_deg) {
  Packing p = test::empty_box(100, 100);
  Vec2 at{10, 50}, along{1, 0};
  test::add_grain(p, at, 0.5);
  p.contacts.add(0, wall_partner(left), {1, 0}, 1, 0, 0.5, 0);
  for (const double turn : turns_deg) {
    along = {std::cos(turn * degree), std::sin(turn * degree)};
    at += along;
    test::add_grain(p, at, 0.5);
    test::add_contact(p, p.grains.size() - 2, p.grains.size() - 1, 1);
  }
  p.contacts.add(static_cast<std::int32_t>(p.grains.size() - 1), wall_partner(right), -along, 1, 0, 0.5, 0);
  for (int k = 0; k < 20; ++k) {  // weakly loaded grains elsewhere lower the mean
    test::add_grain(p, {80, 10.0 + k}, 0.5);
    p.contacts.add(static_cast<std::int32_t>(p.grains.size() - 1), wall_partner(left), {1, 0}, 0.01, 0, 0.5, 0);
  }
  return p;
}

TEST(ForceChains, KnowsThePrincipalCompressionOfAGrain) {
  // Squeezed by 3 N along 30 degrees and by 1 N across: sum f r over pi r^2 = 2 F/(pi r) along each axis.
  Packing p = test::empty_box(10, 10, 0.1);
  test::add_grain(p, {5, 5}, 0.5);
  test::add_grain(p, {1, 1}, 0.5);
  const Vec2 n{std::cos(30 * degree), std::sin(30 * degree)};
  for (const double sense : {1.0, -1.0}) {
    p.contacts.add(0, wall_partner(left), sense * n, 3, 0, 0.5, 0);
    p.contacts.add(0, wall_partner(left), sense * perpendicular(n), 1, 0, 0.5, 0);
  }
  const auto grains = grain_compressions(p);
  EXPECT_NEAR(grains[0].major, 2 * 3 / (std::numbers::pi * 0.5 * 0.1), 1e-12 * 40);
  EXPECT_NEAR(std::abs(dot(grains[0].direction, n)), 1, 1e-15);
  EXPECT_TRUE(grains[0].loaded);
  EXPECT_FALSE(grains[1].loaded);
}

TEST(ForceChains, FindsTheLoadedColumnOfALattice) {
  // 5 x 5 touching disks between floor and ceiling; the middle column carries 10 N, the others 1 N, rows 0.5 N.
  Packing p = test::empty_box(5, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 5; ++x) test::add_grain(p, {x + 0.5, y + 0.5}, 0.5);
  for (std::size_t g = 0; g < 25; ++g) {
    const double load = g % 5 == 2 ? 10 : 1;
    if (g % 5 < 4) test::add_contact(p, g, g + 1, 0.5);
    if (g < 20) test::add_contact(p, g, g + 5, load);
    else test::add_wall_contact(p, g, top, load);
    if (g < 5) test::add_wall_contact(p, g, bottom, load);
  }
  const ForceChains f = find_force_chains(p);
  EXPECT_EQ(f.chains, std::vector<Chain>{(Chain{2, 7, 12, 17, 22})});
  EXPECT_EQ(f.ring, std::vector<std::uint8_t>{0});
  EXPECT_EQ(f.histogram, (std::vector<std::size_t>{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(f.highly_loaded, 5u);
  EXPECT_DOUBLE_EQ(f.mean_length, 5);
  EXPECT_DOUBLE_EQ(f.grain_share, 0.2);
  EXPECT_NEAR(f.mean_stress, 2 * 2.8 / (std::numbers::pi * 0.5), 1e-12);
  EXPECT_TRUE(find_force_chains(p, {1, 45 * degree, 6}).chains.empty());
  EXPECT_TRUE(find_force_chains(p, {3.6, 45 * degree, 3}).chains.empty());  // 10 N are 3.57 times the mean
}

TEST(ForceChains, CloseAroundAPeriodicCell) {
  Packing p = test::square_lattice(6);
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    p.contacts.fn[c] = std::abs(p.contacts.normal[c].y) < 0.5 ? 0.5 : p.contacts.i[c] % 2 == 0 ? 3 : 1;
  const ForceChains f = find_force_chains(p);
  EXPECT_EQ(f.chains.size(), 3u);
  EXPECT_EQ(f.ring, (std::vector<std::uint8_t>{1, 1, 1}));
  EXPECT_EQ(f.histogram.at(6), 3u);
}

TEST(ForceChains, BreakWhereTheyBendByMoreThanTwiceTheAngle) {
  // At a bend by 60 degrees the direction of greatest compression halves it: 30 degrees off either branch.
  const Packing p = bent_chain({0, 0, 0, 60, 60, 60});
  const auto whole = find_force_chains(p, {1, 31 * degree, 3}), parts = find_force_chains(p, {1, 29 * degree, 2});
  EXPECT_EQ(whole.chains, std::vector<Chain>{(Chain{0, 1, 2, 3, 4, 5, 6})});
  EXPECT_EQ(parts.chains, (std::vector<Chain>{{0, 1, 2}, {4, 5, 6}}));  // the grain at the bend belongs to neither
}

TEST(ForceChains, GoStraightOnAtAFork) {
  // A chain along x that forks at 35 degrees. The direction of greatest compression at the fork, from 1 N on either
  // side along x and 0.8 N at 35 degrees, is 9 degrees off x: within the angle of both branches, but nearer to the
  // straight one.
  Packing p = bent_chain({0, 0, 0, 0, 0, 0});
  Vec2 at = p.grains.position[3];
  std::size_t last = 3;
  for (int k = 0; k < 3; ++k) {
    at += Vec2{std::cos(35 * degree), std::sin(35 * degree)};
    test::add_grain(p, at, 0.5);
    test::add_contact(p, last, p.grains.size() - 1, 0.8);
    last = p.grains.size() - 1;
  }
  p.contacts.add(static_cast<std::int32_t>(last), wall_partner(top), {-std::cos(35 * degree), -std::sin(35 * degree)},
                 0.8, 0, 0.5, 0);
  const ForceChains f = find_force_chains(p, {1, 45 * degree, 3});
  ASSERT_EQ(f.chains.size(), 2u);
  EXPECT_EQ(f.chains[0], (Chain{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(f.chains[1], (Chain{27, 28, 29}));
}

/// The contacts in reverse, every other one seen from its other grain.
Packing told_otherwise(const Packing& p) {
  Packing q = p;
  q.contacts = {};
  for (std::size_t k = p.contacts.size(); k-- > 0;) {
    const Contacts& c = p.contacts;
    if (k % 2 || c.is_wall(k)) q.contacts.add(c.i[k], c.j[k], c.normal[k], c.fn[k], c.ft[k], c.arm_i[k], c.arm_j[k]);
    else q.contacts.add(c.j[k], c.i[k], -c.normal[k], c.fn[k], c.ft[k], c.arm_j[k], c.arm_i[k]);
  }
  return q;
}

TEST(ForceChains, OfAnyNetworkShareNoGrainAndKeepTheirRule) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Packing p = test::random_network(seed, 150);
    const auto grains = grain_compressions(p);
    const ForceChains f = find_force_chains(p);
    EXPECT_EQ(f.chains, find_force_chains(told_otherwise(p)).chains);
    std::set<std::int32_t> seen;
    std::size_t members = 0;
    for (const Chain& chain : f.chains) {
      EXPECT_GE(chain.size(), 3u);
      members += chain.size();
      seen.insert(chain.begin(), chain.end());
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const auto a = static_cast<std::size_t>(chain[k]), b = static_cast<std::size_t>(chain[k + 1]);
        const Vec2 branch = p.grains.position[b] - p.grains.position[a];
        EXPECT_LT(norm(branch), p.grains.radius[a] + p.grains.radius[b]);
        for (const std::size_t g : {a, b}) {
          EXPECT_GT(grains[g].major, f.mean_stress);
          EXPECT_GE(std::abs(dot(grains[g].direction, branch)) / norm(branch), std::cos(45 * degree) - 1e-12);
        }
      }
    }
    EXPECT_EQ(seen.size(), members);
    found += f.chains.size();
  }
  EXPECT_GT(found, 30u);
}

TEST(ForceChains, RefusesAnAngleThatIsNone) {
  EXPECT_THROW(find_force_chains(test::square_lattice(4), {1, 90, 3}), InputError);
  EXPECT_THROW(find_force_chains(test::square_lattice(4), {1, 0, 3}), InputError);
  EXPECT_TRUE(std::isnan(find_force_chains(test::empty_box(1, 1)).mean_length));
}

TEST(StrongClusters, OfALatticeAreItsLoadedColumns) {
  Packing p = test::square_lattice(6);
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    p.contacts.fn[c] = std::abs(p.contacts.normal[c].y) > 0.5 && p.contacts.i[c] % 6 == 1 ? 3 : 0.5;
  const StrongClusters s = strong_clusters(p);
  EXPECT_EQ(s.grains, std::vector<std::size_t>{6});
  EXPECT_EQ(s.contacts_of, std::vector<std::size_t>{6});
  EXPECT_EQ(s.contacts, 6u);
  EXPECT_DOUBLE_EQ(s.share, 6.0 / 72);
  EXPECT_NEAR(s.threshold, (6 * 3 + 66 * 0.5) / 72, 1e-15);
  EXPECT_EQ(s.of[7], 0);
  EXPECT_EQ(s.of[8], -1);
  EXPECT_EQ(strong_clusters(p, 10).contacts, 0u);
  EXPECT_EQ(strong_clusters(p, 0.1).grains, std::vector<std::size_t>{36});
  EXPECT_TRUE(std::isnan(strong_clusters(test::empty_box(1, 1)).share));
}

TEST(StrongClusters, ComeLargestFirstAndHoldEveryStrongContact) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Packing p = test::random_network(seed, 120);
    const StrongClusters s = strong_clusters(p);
    EXPECT_TRUE(std::is_sorted(s.grains.rbegin(), s.grains.rend()));
    std::size_t contacts = 0;
    for (const std::size_t n : s.contacts_of) contacts += n;
    EXPECT_EQ(contacts, s.contacts);
    for (std::size_t k = 0; k < s.grains.size(); ++k) {
      EXPECT_EQ(static_cast<std::size_t>(std::count(s.of.begin(), s.of.end(), static_cast<std::int32_t>(k))),
                s.grains[k]);
      EXPECT_GE(s.contacts_of[k] + 1, s.grains[k]);  // a tree at least
    }
    for (std::size_t c = 0; c < p.contacts.size(); ++c)
      if (!p.contacts.is_wall(c) && p.contacts.fn[c] > s.threshold) {
        EXPECT_EQ(s.of[static_cast<std::size_t>(p.contacts.i[c])], s.of[static_cast<std::size_t>(p.contacts.j[c])]);
      }
  }
}

}  // namespace
}  // namespace arenite::fields
