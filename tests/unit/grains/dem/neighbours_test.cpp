#include "grains/dem/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "grains/dem/engine.hpp"
#include "grains/dem/setup.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

/// Every pair of the caller's grains nearer than the sum of their radii and `gap`, by trying all images of all pairs.
std::set<std::uint64_t> near_pairs(const Packing& p, double gap) {
  std::set<std::uint64_t> found;
  const Grains& g = p.grains;
  const int ax = p.domain.periodic[0] ? 1 : 0, ay = p.domain.periodic[1] ? 1 : 0;
  for (std::size_t a = 0; a < g.size(); ++a)
    for (std::size_t b = a + 1; b < g.size(); ++b)
      for (int iy = -2 * ay; iy <= 2 * ay; ++iy)
        for (int ix = -2 * ax; ix <= 2 * ax; ++ix) {
          const Vec2 d{g.position[a].x - g.position[b].x + ix * p.domain.width() + iy * p.domain.tilt,
                       g.position[a].y - g.position[b].y + iy * p.domain.height()};
          if (norm(d) < g.radius[a] + g.radius[b] + gap)
            found.insert(pair_key(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)));
        }
  return found;
}

std::set<std::uint64_t> listed_pairs(const Sample& s) {
  std::set<std::uint64_t> found;
  for (std::size_t p = 0; p < s.list.pairs; ++p) EXPECT_TRUE(found.insert(slot_key(s, p)).second) << "listed twice";
  return found;
}

struct Cell {
  std::array<bool, 2> periodic;
  double tilt;
};

class Neighbours : public ::testing::TestWithParam<Cell> {};

TEST_P(Neighbours, AreThoseOfBruteForce) {
  const Cell cell = GetParam();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Packing p = testing::crowd(9, 7, seed, 0.012);
    p.domain.periodic = cell.periodic;
    p.domain.tilt = cell.tilt * p.domain.width();
    const Sample s = make_sample(p, {}, {}, find_kernel<2>("auto"));
    EXPECT_EQ(listed_pairs(s), near_pairs(p, s.skin));
  }
}

TEST_P(Neighbours, StayCompleteWhileGrainsAndWallsMove) {
  const Cell cell = GetParam();
  Packing p = testing::crowd(9, 7, 4, 0.0125);
  p.domain.periodic = cell.periodic;
  p.domain.tilt = cell.tilt * p.domain.width();
  RandomStream random(8, Purpose::test);
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    p.grains.velocity[k] = {random.uniform(-3, 3), random.uniform(-3, 3)};
  }
  ContactParameters contact;
  contact.restitution = 0.9;
  Engine engine(p, contact, {});
  WallDrives drives;
  drives[right] = {WallDrive::Kind::velocity, -1.5};
  drives[top] = {WallDrive::Kind::velocity, -1.0};
  set_drives(engine, drives);
  for (int n = 0; n < 60; ++n) {
    engine.advance(97);
    const Packing now = packing_of(engine);
    std::set<std::uint64_t> touching;
    for (std::size_t c = 0; c < now.contacts.size(); ++c)
      if (!now.contacts.is_wall(c)) touching.insert(pair_key(now.contacts.i[c], now.contacts.j[c]));
    ASSERT_EQ(touching, near_pairs(now, 0)) << "after " << engine.step << " steps";
    ASSERT_TRUE(std::is_sorted(now.contacts.i.begin(), now.contacts.i.end()));
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, Neighbours,
                         ::testing::Values(Cell{{false, false}, 0}, Cell{{true, false}, 0}, Cell{{false, true}, 0},
                                           Cell{{true, true}, 0}, Cell{{true, true}, 0.3}, Cell{{true, true}, -0.45}));

/// 64 spheres that fly about between six walls with up to so many m/s along each axis.
EngineIn<3> flying(double speed) {
  PackingIn<3> p;
  p.materials = {{"pom", 1410, 1e5, 0}};
  for (const int side : {right, top, front}) p.domain.wall[side].position = 0.1;
  p.grains.resize(64);
  RandomStream random(5, Purpose::test);
  for (int k = 0; k < 64; ++k) {
    p.grains.position[k] = 0.025 * Vec3{k % 4 + 0.5, k / 4 % 4 + 0.5, k / 16 + 0.5};
    p.grains.radius[k] = 0.01;
    p.grains.velocity[k] =
        speed * Vec3{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
  }
  ContactParameters contact;
  contact.restitution = 1;
  return {p, contact, {}};
}

TEST(NeighboursOfSpheres, AreListedFartherWhereTheyMoveFast) {
  EngineIn<3> slow = flying(0.01), fast = flying(4);
  for (EngineIn<3>* engine : {&slow, &fast}) {
    for (int n = 0; n < 60; ++n) {
      engine->advance(97);
      const PackingIn<3> now = packing_of(*engine);
      std::size_t touching = 0;
      for (std::size_t a = 0; a < 64; ++a)
        for (std::size_t b = a + 1; b < 64; ++b)
          if (norm(now.grains.position[a] - now.grains.position[b]) < 0.02) ++touching;
      const auto between = std::ranges::count_if(now.contacts.j, [](std::int32_t j) { return j >= 0; });
      ASSERT_EQ(static_cast<std::size_t>(between), touching) << "after " << engine->step << " steps";
    }
    EXPECT_GT(engine->builds, 3);
  }
  EXPECT_LT(slow.skin, 0.05 * 0.01);
  EXPECT_GT(fast.skin, 0.1 * 0.01);
}

TEST(PeriodicCell, TooNarrowForItsGrainsIsRefused) {
  Packing p = testing::empty_container(0.02, 0.2);
  testing::add_grain(p, 0.01, 0.1, 0.006);
  p.domain.periodic[0] = true;
  EXPECT_ANY_THROW(Engine(p, {}, {}));
}

}  // namespace
}  // namespace arenite::dem
