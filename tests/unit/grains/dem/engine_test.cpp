#include "grains/dem/engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/error.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

using testing::add_grain;
using testing::crowd;
using testing::empty_container;

TEST(Engine, ABinaryCollisionGivesBackTheRestitutionAsked) {
  for (const auto& [e, pulls] :
       {std::pair{0.1, true}, {0.5, true}, {0.9, true}, {0.1, false}, {0.5, false}, {0.9, false}}) {
    Packing p = empty_container(0.2, 0.2);
    add_grain(p, 0.09, 0.1, 0.005);
    add_grain(p, 0.10001, 0.1, 0.005);
    p.grains.velocity[0].x = 1.0;
    ContactParameters contact;
    contact.restitution = e;
    contact.friction_law = dem::NoFriction{};
    contact.attractive_dashpot = pulls;
    IntegrationParameters integration;
    integration.safety = 1.0 / 500;
    Engine engine(p, contact, integration);
    engine.advance(2000);
    const Packing after = packing_of(engine);
    // Clipped, the force has an edge, which a step meets to first order.
    EXPECT_NEAR(after.grains.velocity[1].x - after.grains.velocity[0].x, e, (pulls ? 1e-3 : 5e-3) * e)
        << e << " " << pulls;
    EXPECT_NEAR(after.grains.velocity[1].x + after.grains.velocity[0].x, 1.0, 1e-12);
  }
}

TEST(Engine, AFallingGrainFollowsItsParabola) {
  Packing p = empty_container(0.2, 10);
  add_grain(p, 0.1, 9, 0.005);
  p.grains.velocity[0].y = 0.3;
  Engine engine(p, {}, {});
  set_gravity(engine, {0, -9.81});
  engine.advance(100000);
  const double t = time_of(engine);
  const Packing after = packing_of(engine);
  EXPECT_NEAR(after.grains.position[0].y, 9 + 0.3 * t - 0.5 * 9.81 * t * t, 1e-10);
  EXPECT_NEAR(after.grains.velocity[0].y, 0.3 - 9.81 * t, 1e-10);
}

TEST(Engine, DragBrakesExponentially) {
  Packing p = empty_container(2, 2);
  add_grain(p, 1, 1, 0.005);
  p.grains.velocity[0].x = 1;
  IntegrationParameters integration;
  integration.drag = 100;
  Engine engine(p, {}, integration);
  while (time_of(engine) < 0.02) engine.advance(100);
  EXPECT_NEAR(packing_of(engine).grains.velocity[0].x, std::exp(-100 * time_of(engine)), 1e-8);
}

TEST(Engine, AStackUnderGravityPressesTheBottomWithItsWeight) {
  Packing p = empty_container(0.1, 0.1);
  double weight = 0;
  for (int k = 0; k < 3; ++k) {
    const auto g = add_grain(p, 0.05, 0.005 + 0.01 * k, 0.005);
    weight += 9.81 * 1410 * std::numbers::pi * p.grains.radius[g] * p.grains.radius[g] * 0.06;
  }
  Engine engine(p, {}, {});
  set_gravity(engine, {0, -9.81});
  engine.advance(200000);
  EXPECT_NEAR(engine.domain.wall[bottom].force, weight, 1e-6 * weight);
  const Packing after = packing_of(engine);
  ASSERT_EQ(after.contacts.size(), 3u);
  EXPECT_EQ(after.contacts.j[0], wall_partner(bottom));
  EXPECT_EQ(after.contacts.normal[0].y, 1);
  EXPECT_NEAR(after.contacts.fn[1], weight * 2 / 3, 1e-6 * weight);
  EXPECT_EQ(after.contacts.normal[1].y, -1);  // from grain 1 down to grain 0
  EXPECT_LT(equilibrium_of(engine).unbalanced_ratio, 1e-6);
  EXPECT_LT(equilibrium_of(engine).kinetic_ratio, 1e-8);
}

TEST(Engine, AServoWallReachesItsForceAndStopsThere) {
  const Packing p = crowd(15, 15, 3);
  ContactParameters contact;
  contact.friction_law = dem::CundallStrack{};
  Engine engine(p, contact, {});
  WallDrives drives;
  drives[bottom] = {WallDrive::Kind::force, 5000};
  set_drives(engine, drives);
  engine.advance(60000);
  EXPECT_NEAR(engine.domain.wall[bottom].force, 5000, 5);
  EXPECT_LT(equilibrium_of(engine).wall_speed, 1e-3);
  EXPECT_LT(equilibrium_of(engine).unbalanced_ratio, 1e-2);
}

TEST(Engine, AServoWallHoldsItsForceWhileItGivesWay) {
  const Packing p = crowd(12, 12, 3, 0.0122);
  ContactParameters contact;
  contact.restitution = 0.3;
  Engine engine(p, contact, {});
  WallDrives drives;
  drives[bottom] = drives[left] = {WallDrive::Kind::force, 4000};
  set_drives(engine, drives);
  engine.advance(20000);
  drives[top] = {WallDrive::Kind::velocity, -0.1};
  drives[right] = {WallDrive::Kind::velocity, -0.1};
  set_drives(engine, drives);
  engine.advance(40000);
  EXPECT_NEAR(engine.domain.wall[bottom].velocity, -0.1, 0.02);
  EXPECT_NEAR(engine.domain.wall[bottom].force, 4000, 200);
  EXPECT_NEAR(engine.domain.wall[left].force, 4000, 200);
}

TEST(Engine, AStepBeyondTheBoundsIsRefusedWithTheStepThatWouldDo) {
  const Packing p = crowd(4, 4, 1);
  IntegrationParameters integration;
  const double largest = step_bounds(Engine(p, {}, integration)).largest();
  integration.time_step = 0.99 * largest;
  EXPECT_NO_THROW(Engine(p, {}, integration));
  integration.time_step = 1.01 * largest;
  try {
    Engine(p, {}, integration);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("or leave the key out"), std::string::npos) << error.what();
  }
}

TEST(Engine, AGrainThatIsShotThroughAWallEndsInAnError) {
  Packing p = empty_container(0.1, 0.1);
  add_grain(p, 0.05, 0.05, 0.005);
  p.grains.velocity[0].x = 3000;
  Engine engine(p, {}, {});
  EXPECT_THROW(engine.advance(10000), CannotGoOn);
  p.grains.position[0].x = 0.2;
  EXPECT_THROW(Engine(p, {}, {}), InputError);
}

/// A stiff and a soft disk of 5 mm that meet: 1 N/mm takes up the energy of their relative motion within 5 mm below
/// some 8 m/s, and cannot hold them apart at 56 m/s.
TEST(Engine, GrainsThatPassThroughEachOtherEndInAnErrorThatNamesThem) {
  const auto meet = [](double speed) {
    Packing p = empty_container(0.1, 1);
    p.materials = {{"stiff", 1000, 1e6, 0}, {"soft", 1000, 1e3, 0}};
    p.domain.thickness = 0.01;
    add_grain(p, 0.05, 0.494, 0.005, 0);
    add_grain(p, 0.05, 0.506, 0.005, 1);
    p.grains.id = {7, 9};
    p.grains.velocity[0].y = speed;
    Engine engine(p, {}, {});
    engine.advance(static_cast<std::int64_t>(0.03 / speed / engine.dt));
    return packing_of(engine).grains;
  };
  const Grains bounced = meet(6);
  EXPECT_LT(bounced.position[0].y, bounced.position[1].y);
  try {
    meet(56);
    FAIL() << "passed through";
  } catch (const CannotGoOn& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with("grains 7 and 9 ") || what.starts_with("grains 9 and 7 ")) << what;
  }
}

}  // namespace
}  // namespace arenite::dem
