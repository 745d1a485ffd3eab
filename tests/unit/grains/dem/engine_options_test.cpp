#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

TEST(Options, LockedGrainsDoNotTurn) {
  Packing p = testing::crowd(6, 6, 2, 0.0122);
  p.grains.omega[3] = 5;
  IntegrationParameters integration;
  for (const auto kind : {IntegratorKind::velocity_verlet, IntegratorKind::gear5}) {
    integration.integrator = kind;
    integration.rotations = false;
    Engine engine(p, {}, integration);
    engine.advance(500);
    for (const double omega : packing_of(engine).grains.omega) EXPECT_EQ(omega, 0);
    for (const double angle : packing_of(engine).grains.angle) EXPECT_EQ(angle, 0);
  }
}

TEST(Options, TheOrderOfTheCallersGrainsDoesNotMatter) {
  const Packing p = testing::crowd(7, 7, 2, 0.0122);
  Packing q = p;
  const std::size_t n = p.grains.size();
  const auto place = [n](std::size_t k) { return (k * 20 + 3) % n; };
  for (std::size_t k = 0; k < n; ++k) {
    q.grains.position[place(k)] = p.grains.position[k];
    q.grains.radius[place(k)] = p.grains.radius[k];
    q.grains.material[place(k)] = p.grains.material[k];
    q.grains.id[place(k)] = p.grains.id[k];
  }
  Engine a(p, {}, {}), b(q, {}, {});
  a.advance(200);
  b.advance(200);
  const Packing pa = packing_of(a), pb = packing_of(b);
  EXPECT_EQ(pa.contacts.size(), pb.contacts.size());
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_EQ(pa.grains.id[k], pb.grains.id[place(k)]);
    EXPECT_NEAR(pa.grains.position[k].x, pb.grains.position[place(k)].x, 1e-12);
    EXPECT_NEAR(pa.grains.omega[k], pb.grains.omega[place(k)], 1e-6);
  }
}

TEST(Options, ASampleHandedOnKeepsTheFrictionOfItsSprings) {
  ContactParameters contact;
  contact.friction_law = dem::CundallStrack{};
  Engine first(testing::crowd(10, 10, 6, 0.012), contact, {});
  WallDrives drives;
  drives[top] = {WallDrive::Kind::velocity, -0.02};
  set_drives(first, drives);
  first.advance(20000);
  set_drives(first, {});
  first.advance(60000);
  const Packing handed = packing_of(first);
  Packing bare = handed;
  bare.contacts = {};
  const double before = equilibrium_of(first).mobilisation;
  ASSERT_GT(before, 0.02);
  EXPECT_NEAR(equilibrium_of(Engine(handed, contact, {})).mobilisation, before, 0.01 * before);
  EXPECT_LT(equilibrium_of(Engine(bare, contact, {})).mobilisation, 0.2 * before);
}

TEST(Options, FrictionOverriddenForAStageComesBack) {
  Packing p = testing::empty_container(0.1, 0.1);
  testing::add_grain(p, 0.05, 0.005 - 2.3e-9, 0.005);
  p.grains.velocity[0].x = 1;
  Engine engine(p, {}, {});
  set_gravity(engine, {0, -9.81});
  set_friction(engine, 0.0);
  engine.advance(200);
  const Packing smooth = packing_of(engine);
  EXPECT_EQ(smooth.contacts.ft.at(0), 0);
  set_friction(engine, std::nullopt);
  engine.advance(200);
  const Packing rough = packing_of(engine);
  ASSERT_GT(rough.contacts.fn.at(0), 0);
  EXPECT_NEAR(std::abs(rough.contacts.ft.at(0)), 0.3 * rough.contacts.fn.at(0), 1e-9 * rough.contacts.fn.at(0));
  EXPECT_THROW(set_friction(engine, -0.1), InputError);
}

TEST(Options, EveryProblemOfTheInputIsReportedInOnePass) {
  Packing p = testing::empty_container(0.1, 0.1);
  testing::add_grain(p, 0.05, 0.05, -1);
  testing::add_grain(p, 0.5, 0.05, 0.005);
  testing::add_grain(p, std::nan(""), 0.05, 0.005);
  ContactParameters contact;
  contact.restitution = 0;
  contact.friction = -1;
  contact.glued_pairs = {{0, 7}};
  try {
    Engine(p, contact, {});
    FAIL() << "accepted";
  } catch (const InputError& error) { EXPECT_GE(error.problems().size(), 6u) << error.what(); }
}

}  // namespace
}  // namespace arenite::dem
