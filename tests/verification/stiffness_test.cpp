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
  return Engine(p, law, with_step(1e-8)).packing().contacts.fn.at(0);
}

double wall_force(std::int32_t material, WallStiffness rule, bool both_present = true) {
  Packing p = box(1, 1);
  add(p, {{5e-3 - h, 0.5}, 5e-3, material});
  if (both_present) add(p, {{0.5, 0.5}, 5e-3, pom});
  dem::ContactParameters law = elastic();
  law.wall_stiffness = rule;
  return Engine(p, law, with_step(1e-8)).packing().contacts.fn.at(0);
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
    const Contacts c = Engine(p, frictionless(e), with_step(1e-8)).packing().contacts;
    EXPECT_NEAR(c.fn.at(0) - k * c.overlap.at(0), alpha * speed, 1e-10 * alpha * speed);
  }
}

TEST(Stiffness, ContactPointHalvesTheOverlapAndLiesOnTheWall) {
  Packing p = box(1, 1);
  add(p, {{8.2e-3 - h, 0.5}, 8.2e-3});
  add(p, {{8.2e-3 - h + 8.2e-3 + 5.25e-3 - 3 * h, 0.5}, 5.25e-3});
  dem::ContactParameters law = elastic();
  for (const bool full : {false, true}) {
    law.arms = full ? dem::Arms::full_radius : dem::Arms::contact_point;
    const Packing now = Engine(p, law, with_step(1e-8)).packing();
    const auto pair = find_contact(now, 0, 1), wall = find_contact(now, 0, wall_partner(left));
    ASSERT_TRUE(pair && wall);
    const bool first_is_0 = now.contacts.i[*pair] == 0;
    const double arm_0 = first_is_0 ? now.contacts.arm_i[*pair] : now.contacts.arm_j[*pair];
    EXPECT_NEAR(arm_0, 8.2e-3 - (full ? 0 : 1.5 * h), 1e-12);
    EXPECT_NEAR(now.contacts.arm_i[*wall], 8.2e-3 - (full ? 0 : h), 1e-12);
    EXPECT_NEAR(now.contacts.overlap[*pair], 3 * h, 1e-12);
    const Vec2 n = now.contacts.normal(*pair);
    EXPECT_NEAR(n.x, first_is_0 ? -1 : 1, 1e-12);
    EXPECT_NEAR(now.contacts.normal(*wall).x, 1, 1e-15);
  }
}

}  // namespace
}  // namespace arenite::verification
