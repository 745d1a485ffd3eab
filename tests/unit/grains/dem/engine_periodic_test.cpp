#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/engine.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

Packing periodic_crowd(std::uint64_t seed, double pitch) {
  Packing p = testing::crowd(9, 9, seed, pitch);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  return p;
}

double mass_of(const Packing& p, std::size_t k) {
  return p.materials[static_cast<std::size_t>(p.grains.material[k])].density * std::numbers::pi * p.grains.radius[k] *
         p.grains.radius[k] * p.domain.thickness;
}

TEST(PeriodicCell, KeepsItsMomentum) {
  for (const auto kind : {IntegratorKind::velocity_verlet, IntegratorKind::gear5}) {
    Packing p = periodic_crowd(2, 0.0122);
    for (std::size_t k = 0; k < p.grains.size(); ++k) p.grains.velocity[k].x = 0.3;
    IntegrationParameters integration;
    integration.integrator = kind;
    Engine engine(p, {}, integration);
    engine.advance(2000);
    const Packing now = packing_of(engine);
    double px = 0, py = 0, before = 0, scale = 0;
    for (std::size_t k = 0; k < p.grains.size(); ++k) {
      const double m = mass_of(p, k);
      px += m * now.grains.velocity[k].x;
      py += m * now.grains.velocity[k].y;
      before += m * p.grains.velocity[k].x;
      scale += m * std::hypot(now.grains.velocity[k].x, now.grains.velocity[k].y);
    }
    EXPECT_NEAR(px, before, 1e-11 * scale);
    EXPECT_NEAR(py, 0, 1e-11 * scale);
  }
}

TEST(PeriodicCell, DisksFarAboveAnOpenTopMeetAcrossItsSides) {
  Packing p = testing::empty_container(0.2, 0.05);
  p.domain.periodic[0] = true;
  p.domain.wall[top].present = false;
  testing::add_grain(p, 0.004, 0.2, 0.005);
  testing::add_grain(p, 0.1945, 0.2, 0.005);
  EXPECT_EQ(packing_of(Engine(p, {}, {})).contacts.size(), 1u);
}

TEST(PeriodicCell, GivesTheSameMotionWhereverItsEdgesLie) {
  Packing p = periodic_crowd(3, 0.0122);
  Packing q = p;
  const Vec2 shift{0.4 * p.domain.width(), 0.7 * p.domain.height()};
  for (std::size_t k = 0; k < q.grains.size(); ++k) {
    q.grains.position[k] = {std::fmod(q.grains.position[k].x + shift.x, q.domain.width()),
                            std::fmod(q.grains.position[k].y + shift.y, q.domain.height())};
  }
  Engine a(p, {}, {}), b(q, {}, {});
  a.advance(300);
  b.advance(300);
  const Packing pa = packing_of(a), pb = packing_of(b);
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    EXPECT_NEAR(pa.grains.velocity[k].x, pb.grains.velocity[k].x, 1e-7);
    const Vec2 d = pa.domain.nearest_image(pb.grains.position[k] - shift - pa.grains.position[k]);
    EXPECT_NEAR(norm(d), 0, 1e-10);
  }
}

TEST(PeriodicCell, ThatIsSqueezedMovesItsGrainsAffinely) {
  Packing p = testing::empty_container(0.2, 0.2);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  testing::add_grain(p, 0.05, 0.1, 0.003);
  testing::add_grain(p, 0.15, 0.03, 0.003);
  Engine engine(p, {}, {});
  WallDrives drives;
  drives[right] = {WallDrive::Kind::velocity, -1};
  drives[bottom] = {WallDrive::Kind::velocity, 0.5};
  set_drives(engine, drives);
  while (time_of(engine) < 0.01) engine.advance(1);
  const double t = time_of(engine);
  const Packing now = packing_of(engine);
  EXPECT_NEAR(now.domain.wall[right].position, 0.2 - t, 1e-12);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(now.grains.position[k].x, p.grains.position[k].x * (0.2 - t) / 0.2, 1e-12);
    EXPECT_NEAR(0.2 - now.grains.position[k].y, (0.2 - p.grains.position[k].y) * (0.2 - 0.5 * t) / 0.2, 1e-12);
    EXPECT_NEAR(now.grains.velocity[k].x, -now.grains.position[k].x / now.domain.width(), 1e-9);
  }
}

TEST(PeriodicCell, IsServedToItsPressureBothWays) {
  Packing p = periodic_crowd(5, 0.0125);
  ContactParameters contact;
  contact.friction_law = dem::CundallStrack{};
  Engine engine(p, contact, {});
  WallDrives drives;
  drives[right] = {WallDrive::Kind::force, 2000};
  drives[top] = {WallDrive::Kind::force, 3000};
  set_drives(engine, drives);
  for (int n = 0; n < 100; ++n) engine.advance(1000);
  const Packing now = packing_of(engine);
  EXPECT_NEAR(now.domain.wall[right].force, 2000, 20);
  EXPECT_NEAR(now.domain.wall[top].force, 3000, 30);
  double xx = 0, yy = 0;
  for (std::size_t c = 0; c < now.contacts.size(); ++c) {
    const Vec2 f = now.contacts.force_on_i(c),
               l = (now.contacts.arm_i[c] + now.contacts.arm_j[c]) * now.contacts.normal[c];
    xx += f.x * l.x;
    yy += f.y * l.y;
  }
  EXPECT_NEAR(xx / now.domain.width(), now.domain.wall[right].force, 1e-6 * 2000);
  EXPECT_NEAR(yy / now.domain.height(), now.domain.wall[top].force, 1e-6 * 3000);
}

}  // namespace
}  // namespace arenite::dem
