// Rough walls in space: the spheres nearest to them go with them and do not turn, the force on these is the wall's, and
// the account of energy closes.
#include "balance.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/save.hpp"
#include "spheres.hpp"

namespace arenite::verification {
namespace {

constexpr ByAnySide<bool> floor_and_lid{false, false, true, true, false, false};

/// A layer of spheres between a floor and a lid that presses, periodic along both.
struct Layer : Spheres {
  SampleIn<3> s;
  WallDrivesIn<3> drives{};

  Layer() : Spheres(1e6) {
    const auto share = [](int k, double by) { return std::fmod(k * by, 1.0) - 0.5; };
    for (int k = 0; k < 125; ++k)
      add(0.0094 + 0.0008 * share(k, 0.37), 0.02 * Vec3{k % 5 + 0.5, k / 5 % 5 + 0.5, k / 25 + 0.5},
          0.1 * Vec3{share(k, 0.7548), share(k, 0.5698), share(k, 0.4302)});
    start.domain.periodic = {true, false, true};
    contact.friction_law = CundallStrack{};
    contact.friction = 0.4;
    contact.restitution = 0.3;
    integration.track_energy = true;
    integration.safety = 0.02;
    s = sample();
    drives[top] = {DriveKind::force, 100, {}};
    set_drives(s, drives);
    go_on(0.3);
    set_rough(s, floor_and_lid);
  }
  void go_on(double time) { advance(s, ThreadPool(), std::lround(time / s.dt)); }
  void slide(Vec3 way) {
    drives[top].slide = way;
    set_drives(s, drives);
  }
};

TEST(SphereRoughWalls, CarryTheSpheresNearThem) {
  Layer c;
  const PackingIn<3> before = packing_of(c.s);
  const Vec3 slide{0.3, 0, -0.2};
  c.slide(slide);
  const double begin = time_of(c.s);
  c.go_on(0.2);
  const PackingIn<3> now = packing_of(c.s);
  const double lid = before.domain.wall[top].position;
  const Vec3 way = (time_of(c.s) - begin) * slide + Vec3{0, now.domain.wall[top].position - lid, 0};
  int low = 0, high = 0;
  for (std::size_t k = 0; k < now.grains.size(); ++k) {
    const double y = before.grains.position[k].y, r = before.grains.radius[k];
    const bool is_low = y < 1.5 * r, is_high = lid - y < 1.5 * r;
    if (!is_low && !is_high) continue;
    ++(is_low ? low : high);
    const Vec3 moved = now.grains.position[k] - before.grains.position[k] - (is_low ? Vec3{} : way);
    EXPECT_LT(norm(now.domain.nearest_image(moved)), 1e-9);
    const Vec3 velocity = is_low ? Vec3{} : slide + Vec3{0, now.domain.wall[top].velocity, 0};
    EXPECT_LT(norm(along(top, now.grains.velocity[k] - velocity)), 1e-12);
    // Up to half a step, which the velocity of a wall under a force is ahead of its place.
    EXPECT_NEAR(now.grains.velocity[k].y, velocity.y, std::abs(c.s.wall[top].acceleration) * c.s.dt);
    EXPECT_EQ(now.grains.angle[k], before.grains.angle[k]);
    EXPECT_EQ(now.grains.omega[k], Vec3{});
  }
  EXPECT_GT(low, 10);
  EXPECT_GT(high, 10);
}

/// Grains between rough walls resist along the way, and by more than half of what a smooth lid could carry at most.
TEST(SphereRoughWalls, ResistASlideAndCloseTheAccountOfEnergy) {
  Layer c;
  c.slide({0.3, 0, -0.4});
  c.go_on(0.1);
  const Energies before = energies_of(c.s);
  Vec3 shear;
  double normal = 0;
  for (int look = 0; look < 100; ++look) {
    c.go_on(0.003);
    shear += c.s.domain.wall[top].shear_force;
    normal += c.s.domain.wall[top].force;
  }
  const Energies after = energies_of(c.s);
  EXPECT_LT(std::abs(imbalance(before, after)), 2e-3 * (after.work_walls - before.work_walls));
  EXPECT_LT(dot(shear, Vec3{0.6, 0, -0.8}), -0.2 * normal);
  EXPECT_LT(std::abs(dot(shear, Vec3{0.8, 0, 0.6})), 0.1 * normal);
  EXPECT_EQ(shear.y, 0);
}

TEST(SphereRoughWalls, GoOnFromAStoredStateToTheLastBit) {
  Layer one;
  one.slide({0.3, 0, 0.1});
  one.go_on(0.05);
  SampleIn<3> again = one.sample();
  restore_sample(again, save_sample(one.s));
  const ThreadPool two(2);
  advance(one.s, ThreadPool(), 500);
  advance(again, two, 500);
  EXPECT_EQ(state_hash(again), state_hash(one.s));
}

TEST(SphereRoughWalls, ThatAreSmoothAgainLetGo) {
  Layer c;
  EXPECT_GE(holding_side(c.s, 0), 0) << "the first sphere lies on the floor";
  set_rough(c.s, {});
  for (std::int32_t k = 0; k < 125; ++k) EXPECT_LT(holding_side(c.s, k), 0);
}

}  // namespace
}  // namespace arenite::verification
