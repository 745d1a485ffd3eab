#include <gtest/gtest.h>

#include <cmath>

#include "grains/dem/engine.hpp"
#include "grains/dem/glue.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

/// Two glued grains between walls that are driven apart and together again; the force of the contact is the walls'.
struct Pull {
  Pull(Adhesion adhesion, bool by_name) {
    const double r = 0.0062;
    Packing p = testing::empty_container(5 * r, 0.1);
    testing::add_grain(p, 1.5 * r, 0.05, r);
    testing::add_grain(p, 3.5 * r - 4e-6, 0.05, r);
    testing::add_grain(p, 1.5 * r, 0.08, r);
    contact.adhesion = adhesion;
    contact.surface_energy = 0.5e6;
    contact.restitution = 0.3;
    contact.friction_law = dem::NoFriction{};
    if (by_name) contact.glued_pairs = {{1, 0}};
    if (!by_name) p.grains.zone = {1, 1, 0};
    start = p;
  }
  Packing start;
  ContactParameters contact;
};

/// Strongest tension of the pair's contact while grain 1 moves away and back.
double strongest_tension(Engine& engine, int steps) {
  double lowest = 0;
  for (int n = 0; n < steps; ++n) {
    engine.advance(1);
    const Packing now = packing_of(engine);
    for (std::size_t c = 0; c < now.contacts.size(); ++c)
      if (now.contacts.j[c] >= 0) lowest = std::min(lowest, now.contacts.fn[c]);
  }
  return lowest;
}

class Glue : public ::testing::TestWithParam<bool> {};

TEST_P(Glue, ThatBreaksForGoodDoesNotActASecondTime) {
  for (const dem::Adhesion& adhesion :
       std::initializer_list<dem::Adhesion>{dem::GeometricalAdhesion{}, dem::BreakingAdhesion{}}) {
    Pull pull(adhesion, GetParam());
    pull.start.grains.velocity = {{-0.5, 0}, {0.5, 0}, {}};  // torn apart, thrown back by the walls
    IntegrationParameters integration;
    integration.safety = 0.01;
    Engine engine(pull.start, pull.contact, integration);
    const double first = strongest_tension(engine, 600);
    EXPECT_LT(first, 0);
    EXPECT_EQ(packing_of(engine).contacts.size(), 0u);  // between two contacts
    bool touched = false, glued = false;
    for (int n = 0; n < 20000 && !touched; ++n) {
      engine.advance(10);
      const Packing now = packing_of(engine);
      for (std::size_t c = 0; c < now.contacts.size(); ++c)
        if (now.contacts.j[c] >= 0) {
          touched = true;
          glued = now.contacts.glued[c] != 0;
        }
    }
    ASSERT_TRUE(touched);
    EXPECT_EQ(glued, adhesion == dem::GeometricalAdhesion{});
  }
}

INSTANTIATE_TEST_SUITE_P(ByZoneAndByName, Glue, ::testing::Bool());

TEST(Glue, ActsOnlyWhileItIsSwitchedOnAndBetweenThePairsThatAreNamed) {
  Pull pull(dem::GeometricalAdhesion{}, true);
  pull.start.grains.zone = {0, 0, 1};
  Engine engine(pull.start, pull.contact, {});
  EXPECT_LT(energies_of(engine).adhesive, 0);
  set_glue(engine, false);
  EXPECT_EQ(energies_of(engine).adhesive, 0);
  engine.advance(1);
  for (const double fn : packing_of(engine).contacts.fn) EXPECT_GE(fn, 0);
  set_glue(engine, true);
  EXPECT_LT(energies_of(engine).adhesive, 0);
}

TEST(Glue, BondsThatBreakForGoodAreThosePairsThatTouchWhenItIsSwitchedOn) {
  Pull pull(dem::BreakingAdhesion{}, false);
  pull.start.grains.zone = {1, 1, 1};
  pull.start.grains.position[2].y = 0.05 + 2 * 0.0062 + 1e-4;  // near grain 0, not touching
  pull.start.grains.velocity[2].y = -0.1;
  Engine engine(pull.start, pull.contact, {});
  bool met = false;
  for (int n = 0; n < 5000 && !met; ++n) {
    engine.advance(10);
    const Packing now = packing_of(engine);
    for (std::size_t c = 0; c < now.contacts.size(); ++c)
      if (now.contacts.j[c] == 2) {
        met = true;
        EXPECT_EQ(now.contacts.glued[c], 0);
      } else if (now.contacts.j[c] == 1) {
        EXPECT_EQ(now.contacts.glued[c], 1);
      }
  }
  EXPECT_TRUE(met);
}

}  // namespace
}  // namespace arenite::dem
