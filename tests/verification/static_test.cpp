#include <gtest/gtest.h>

#include <algorithm>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::FrictionLaw;

dem::ContactParameters rough(FrictionLaw friction) {
  dem::ContactParameters law;
  law.friction_law = friction;
  law.restitution = 0.5;
  law.attractive_dashpot = true;
  return law;
}

TEST(Column, EachContactCarriesTheWeightAboveIt) {
  Packing p = box(0.2, 1);
  const double g = 1e4;  // strong, so that overlaps stand out of rounding
  const int disks = 8;
  double y = 0;
  for (int i = 0; i < disks; ++i) {
    const double r = i % 3 == 0 ? 8.2e-3 : 5.25e-3;
    add(p, {{0.1, y + r}, r, i % 2 ? hdpe : pom});
    y += 2 * r;
  }
  Engine engine(p, frictionless(0.2), with_step(contact_time(0.5 * mass(p, 1), k_pom) / 20));
  set_gravity(engine, {0, -g});
  set_drag(engine, 1000);
  ASSERT_TRUE(settle(engine, 1e-9, 1e-18));
  const Packing now = packing_of(engine);
  ASSERT_EQ(now.contacts.size(), static_cast<std::size_t>(disks));
  double above = 0;
  for (int i = disks - 1; i >= 0; --i) {
    above += mass(p, static_cast<std::size_t>(i)) * g;
    const auto c = find_contact(now, i, i > 0 ? i - 1 : wall_partner(bottom));
    ASSERT_TRUE(c.has_value());
    const double k = i > 0 ? reduced(k_pom, k_hdpe) : k_pom;
    EXPECT_NEAR(now.contacts.fn[*c], above, 1e-7 * above);
    EXPECT_NEAR(now.contacts.overlap[*c], above / k, 1e-7 * above / k);
    EXPECT_EQ(now.contacts.ft[*c], 0);
  }
  EXPECT_NEAR(now.domain.wall[bottom].force, above, 1e-7 * above);
  EXPECT_EQ(now.domain.wall[left].force, 0);
}

TEST(Column, UnderAForceControlledTopEachContactCarriesThatForceAndTheWeightAbove) {
  Packing p = box(0.2, 5 * 12.4e-3);
  for (int i = 0; i < 5; ++i) add(p, {{0.1, 6.2e-3 * (2 * i + 1)}, 6.2e-3});
  Engine engine(p, frictionless(0.2), with_step(contact_time(0.5 * mass(p, 1), k_pom) / 20));
  set_gravity(engine, {0, -gravity});
  set_drag(engine, 1000);
  set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, dem::WallDrive{}, pressed(500)});
  ASSERT_TRUE(settle(engine, 1e-8, 1e-16));
  const Packing now = packing_of(engine);
  EXPECT_NEAR(now.domain.wall[top].force, 500, 500e-6);
  for (int i = 0; i < 5; ++i) {
    const auto c = find_contact(now, i, i > 0 ? i - 1 : wall_partner(bottom));
    ASSERT_TRUE(c.has_value());
    EXPECT_NEAR(now.contacts.fn[*c], 500 + (5 - i) * mass(p, 0) * gravity, 500e-6);
  }
}

/// Sum of what the grains exert on a wall, from the contacts.
struct WallLoad {
  double normal = 0, shear = 0;
};
WallLoad load_on(const Packing& p, int side) {
  WallLoad load;
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    if (p.contacts.j[c] == wall_partner(side)) {
      const Vec2 on_wall = -p.contacts.force_on_i(c);
      load.normal -= dot(on_wall, inward_normal(side));
      load.shear += side == left || side == right ? on_wall.y : on_wall.x;
    }
  return load;
}

TEST(Box, BottomAndSideFrictionCarryTheWeightTogether) {
  for (const dem::FrictionLaw& friction :
       std::initializer_list<dem::FrictionLaw>{dem::NoFriction{}, dem::CundallStrack{}}) {
    const double g = 3000;
    const dem::ContactParameters law = rough(friction);
    Engine engine(shaken_lattice(6, 14, 7), law, with_step(shortest_contact_time() / 20));
    set_gravity(engine, {0.1 * g, -g});
    set_drag(engine, 300);
    ASSERT_TRUE(settle(engine, 1e-7, 1e-14)) << equilibrium_of(engine).unbalanced_ratio;
    const Packing p = packing_of(engine);
    const double w = weight(p) / gravity * g;
    const auto& wall = p.domain.wall;
    // Within the residual: the mean unbalanced force of 1e-7 of a contact force, at most once a grain.
    EXPECT_NEAR(wall[bottom].force - wall[top].force - wall[left].shear_force - wall[right].shear_force, w, 1e-5 * w);
    EXPECT_NEAR(wall[right].force - wall[left].force + wall[bottom].shear_force + wall[top].shear_force, 0.1 * w,
                1e-5 * w);
    EXPECT_EQ(wall[top].force, 0);
    if (friction == dem::NoFriction{}) EXPECT_EQ(wall[left].shear_force, 0);
    else EXPECT_LT(wall[left].shear_force + wall[right].shear_force, -0.01 * w);  // the filling hangs on the sides
    for (int side = 0; side < 4; ++side) {
      EXPECT_NEAR(load_on(p, side).normal, wall[side].force, 1e-12 * w) << side_names[side];
      EXPECT_NEAR(load_on(p, side).shear, wall[side].shear_force, 1e-12 * w) << side_names[side];
    }
  }
}

TEST(Box, TheLowerWallReachesItsForceAndTheWallsBalance) {
  const dem::ContactParameters law = rough(dem::CundallStrack{});
  Engine engine(shaken_lattice(8, 8, 4), law, with_step(shortest_contact_time() / 20));
  const double force = 5000;
  set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, pressed(force), dem::WallDrive{}});
  ASSERT_TRUE(settle(engine, 1e-7, 1e-14)) << equilibrium_of(engine).unbalanced_ratio;
  const auto& wall = engine.domain.wall;
  EXPECT_NEAR(wall[bottom].force, force, 1e-5 * force);
  EXPECT_NEAR(wall[bottom].force - wall[top].force - wall[left].shear_force - wall[right].shear_force, 0, 1e-5 * force);
  EXPECT_NEAR(wall[left].force - wall[right].force - wall[bottom].shear_force - wall[top].shear_force, 0, 1e-5 * force);
  EXPECT_NEAR(wall[bottom].velocity, 0, 1e-6);
  EXPECT_GT(wall[bottom].position, 0);
}

/// sigma = (1/V) sum over contacts of f (x) l, compression positive: f on i, l from j to i.
Tensor2 stress(const Packing& p) {
  Tensor2 sum;
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    sum += outer(p.contacts.force_on_i(c), (p.contacts.arm_i[c] + p.contacts.arm_j[c]) * p.contacts.normal[c]);
  return 1 / (p.domain.area() * p.domain.thickness) * sum;
}

TEST(Box, ServoStressIsThePressureAskedForInAPeriodicCell) {
  const dem::ContactParameters law = rough(dem::CundallStrack{});
  Engine engine(shaken_lattice(10, 10, 4, true), law, with_step(shortest_contact_time() / 20));
  const double fx = 2000, fy = 3000;
  set_drives(engine, {dem::WallDrive{}, pressed(fx), dem::WallDrive{}, pressed(fy)});
  ASSERT_TRUE(settle(engine, 1e-7, 1e-14)) << equilibrium_of(engine).unbalanced_ratio;
  const Packing p = packing_of(engine);
  const Tensor2 s = stress(p);
  const double px = fx / (p.domain.height() * p.domain.thickness), py = fy / (p.domain.width() * p.domain.thickness);
  EXPECT_NEAR(s.xx, px, 1e-5 * px);
  EXPECT_NEAR(s.yy, py, 1e-5 * py);
  EXPECT_NEAR(s.xy, s.yx, 1e-6 * px);  // no couple is left
}

TEST(Box, StressOfTheContactsIsThatOfTheWalls) {
  Engine engine(shaken_lattice(8, 8, 4), elastic(), with_step(shortest_contact_time() / 20));
  set_drag(engine, 2000);
  set_drives(engine, {dem::WallDrive{}, pressed(4000), pressed(3000), dem::WallDrive{}});
  ASSERT_TRUE(settle(engine, 1e-7, 1e-14)) << equilibrium_of(engine).unbalanced_ratio;
  const Packing p = packing_of(engine);
  const Tensor2 s = stress(p);
  EXPECT_NEAR(s.xx * p.domain.height() * p.domain.thickness, 4000, 4000e-5);
  EXPECT_NEAR(s.yy * p.domain.width() * p.domain.thickness, 3000, 3000e-5);
}

TEST(Box, APeriodicFillingRestsWithItsWholeWeightOnTheBottom) {
  Packing start = shaken_lattice(8, 6, 2, true);
  start.domain.periodic[1] = false;
  for (const int side : {bottom, top}) start.domain.wall[static_cast<std::size_t>(side)].present = true;
  start.domain.wall[top].position *= 1.1;
  Engine engine(start, rough(dem::CundallStrack{}), with_step(shortest_contact_time() / 20));
  set_gravity(engine, {0, -3000});
  set_drag(engine, 300);
  ASSERT_TRUE(settle(engine, 1e-7, 1e-14)) << equilibrium_of(engine).unbalanced_ratio;
  const Packing p = packing_of(engine);
  const double w = weight(p) / gravity * 3000;
  EXPECT_NEAR(p.domain.wall[bottom].force, w, 1e-5 * w);
  EXPECT_NEAR(p.domain.wall[bottom].shear_force, 0, 1e-5 * w);
  EXPECT_EQ(p.domain.wall[top].force, 0);
}

TEST(Equilibrium, MeasuresAreThoseOfTheirDefinitionsOnOneDisk) {
  // Held between bottom and top with the same overlap while it slides and weighs.
  const double h = 1e-5, mu = 0.2, speed = 0.3, fn = k_pom * h;
  Packing p = box(0.1, 2 * (6.2e-3 - h));
  add(p, {{0.05, 6.2e-3 - h}, 6.2e-3, pom, {speed, 0}});
  const double m = mass(p, 0), g = 0.7 * fn / m;
  dem::ContactParameters law = elastic();
  law.friction_law = dem::RegularisedCoulomb{};
  law.friction = mu;
  law.sliding_viscosity = 1e3;
  Engine engine(p, law, with_step(1e-9));
  set_gravity(engine, {0, -g});
  const Equilibrium e = equilibrium_of(engine);
  EXPECT_NEAR(e.mobilisation, mu, 1e-9);
  EXPECT_NEAR(e.kinetic_ratio, 0.5 * m * speed * speed / (fn * fn / k_pom), 1e-9 * e.kinetic_ratio);
  // The resultant of weight and two friction forces over the mean normal force.
  EXPECT_NEAR(e.unbalanced_ratio, std::hypot(0.7, 2 * mu), 1e-9);
}

}  // namespace
}  // namespace arenite::verification
