#include <gtest/gtest.h>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::StiffnessRule;
using dem::WallStiffness;

constexpr double h = 1e-5;

double pair_force(std::int32_t a, std::int32_t b, StiffnessRule rule) {
  Packing p = box(1, 1);
  add(p, {{0.5, 0.5}, 8.2e-3, a});
  add(p, {{0.5, 0.5 + 8.2e-3 + 5.25e-3 - h}, 5.25e-3, b});
  dem::ContactParameters law = elastic();
  law.stiffness_rule = rule;
  return packing_of(Engine(p, law, with_step(1e-8))).contacts.fn.at(0);
}

double wall_force(std::int32_t material, WallStiffness rule, bool both_present = true) {
  Packing p = box(1, 1);
  add(p, {{5e-3 - h, 0.5}, 5e-3, material});
  if (both_present) add(p, {{0.5, 0.5}, 5e-3, pom});
  dem::ContactParameters law = elastic();
  law.wall_stiffness = rule;
  return packing_of(Engine(p, law, with_step(1e-8))).contacts.fn.at(0);
}

TEST(Stiffness, ThesisRuleGivesLikePairsTheirOwnAndPomOnHdpe5210PerMillimetre) {
  EXPECT_NEAR(pair_force(pom, pom, StiffnessRule::thesis), k_pom * h, 1e-9 * k_pom * h);
  EXPECT_NEAR(pair_force(hdpe, hdpe, StiffnessRule::thesis), k_hdpe * h, 1e-9 * k_hdpe * h);
  EXPECT_NEAR(pair_force(pom, hdpe, StiffnessRule::thesis), reduced(k_pom, k_hdpe) * h, 1e-9 * k_hdpe * h);
  EXPECT_NEAR(pair_force(hdpe, pom, StiffnessRule::thesis) / h, 5.21e6, 0.005e6);
}

TEST(Stiffness, SeriesRuleIsTwoSpringsOfTwiceTheStiffnessInARow) {
  EXPECT_NEAR(pair_force(pom, pom, StiffnessRule::series), k_pom * h, 1e-9 * k_pom * h);
  EXPECT_NEAR(pair_force(pom, hdpe, StiffnessRule::series) / h, 10.41e6, 0.005e6);
}

TEST(Stiffness, WallsTakeTheStiffestMaterialOrTheGrainsOwn) {
  EXPECT_NEAR(wall_force(hdpe, WallStiffness::stiffest), k_pom * h, 1e-9 * k_pom * h);
  EXPECT_NEAR(wall_force(pom, WallStiffness::stiffest), k_pom * h, 1e-9 * k_pom * h);
  EXPECT_NEAR(wall_force(hdpe, WallStiffness::grain), k_hdpe * h, 1e-9 * k_pom * h);
  EXPECT_NEAR(wall_force(pom, WallStiffness::grain), k_pom * h, 1e-9 * k_pom * h);
}

TEST(Stiffness, DampingFollowsFromTheRestitutionOfEachPair) {
  // Force at no overlap but at speed v: alpha v with alpha = 2 zeta sqrt(k m_eff).
  const double speed = 0.1, e = 0.3, tiny = 1e-12;
  for (const std::int32_t b : {pom, hdpe}) {
    Packing p = box(1, 1);
    add(p, {{0.5, 0.5}, 8.2e-3, pom, {speed, 0}});
    add(p, {{0.5 + 8.2e-3 + 5.25e-3 - tiny, 0.5}, 5.25e-3, b});
    const double k = b == pom ? k_pom : reduced(k_pom, k_hdpe);
    const double alpha = 2 * damping_ratio(e) * std::sqrt(k * reduced(mass(p, 0), mass(p, 1)));
    const Contacts c = packing_of(Engine(p, frictionless(e), with_step(1e-8))).contacts;
    EXPECT_NEAR(c.fn.at(0) - k * c.overlap.at(0), alpha * speed, 1e-10 * alpha * speed);
  }
}

TEST(Stiffness, FrictionOfAWallTurnsADiskByTheArmToThePlane) {
  // Whatever the friction force f: m dv = f dt and I d omega = -arm f dt (right wall: t points down).
  const double r = 8.2e-3, deep = 0.1 * r;
  for (const bool full : {false, true}) {
    Packing p = box(1, 1);
    add(p, {{1 - r + deep, 0.5}, r, pom, {0, 0.3}});
    dem::ContactParameters law;
    law.friction_law = dem::RegularisedCoulomb{};
    law.arms = full ? dem::Arms::full_radius : dem::Arms::contact_point;
    const double dt = contact_time(mass(p, 0), k_pom) / 1e5;
    Engine engine(p, law, with_step(dt));
    engine.advance(10);
    const Packing now = packing_of(engine);
    const double slowed = mass(p, 0) * (now.grains.velocity[0].y - 0.3),
                 turned = disk_inertia(p, 0) * now.grains.omega[0];
    ASSERT_LT(slowed, 0);
    EXPECT_NEAR(std::abs(turned / slowed), full ? r : r - deep, 1e-5 * r);
  }
}

TEST(Stiffness, ADiskRollsOnAWallAboutThePointOnThePlane) {
  const double r = 8.2e-3, deep = 0.1 * r, spin = 20;
  for (const bool full : {false, true}) {
    const double arm = full ? r : r - deep;
    const auto force = [&](double speed) {
      Packing p = box(1, 1);
      add(p, {{1 - r + deep, 0.5}, r, pom, {0, speed}, spin});
      dem::ContactParameters law;
      law.friction_law = dem::RegularisedCoulomb{};
      law.arms = full ? dem::Arms::full_radius : dem::Arms::contact_point;
      law.friction = 100;  // far from the cap
      return std::abs(packing_of(Engine(p, law, with_step(1e-8))).contacts.ft.at(0));
    };
    EXPECT_LT(force(-spin * arm), 1e-9 * force(-spin * (arm - 0.01 * r)));
  }
}

TEST(Stiffness, ContactPointHalvesTheOverlapAndLiesOnTheWall) {
  Packing p = box(1, 1);
  add(p, {{8.2e-3 - h, 0.5}, 8.2e-3});
  add(p, {{8.2e-3 - h + 8.2e-3 + 5.25e-3 - 3 * h, 0.5}, 5.25e-3});
  dem::ContactParameters law = elastic();
  for (const bool full : {false, true}) {
    law.arms = full ? dem::Arms::full_radius : dem::Arms::contact_point;
    const Packing now = packing_of(Engine(p, law, with_step(1e-8)));
    const auto pair = find_contact(now, 0, 1), wall = find_contact(now, 0, wall_partner(left));
    ASSERT_TRUE(pair && wall);
    const bool first_is_0 = now.contacts.i[*pair] == 0;
    const double arm_0 = first_is_0 ? now.contacts.arm_i[*pair] : now.contacts.arm_j[*pair];
    EXPECT_NEAR(arm_0, 8.2e-3 - (full ? 0 : 1.5 * h), 1e-12);
    EXPECT_NEAR(now.contacts.arm_i[*wall], 8.2e-3 - (full ? 0 : h), 1e-12);
    EXPECT_NEAR(now.contacts.overlap[*pair], 3 * h, 1e-12);
    const Vec2 n = now.contacts.normal[*pair];
    EXPECT_NEAR(n.x, first_is_0 ? -1 : 1, 1e-12);
    EXPECT_NEAR(now.contacts.normal[*wall].x, 1, 1e-15);
  }
}

}  // namespace
}  // namespace arenite::verification
