#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/boundaries/boxes.hpp"
#include "verification/balance.hpp"

namespace arenite::dem {
namespace {

using namespace testing;

// An elastic collision of two masses: the one that was at rest flies off at 2 m/(m + M) of the other's speed.
TEST(MovingFaces, OneWithAMassIsHitAsABody) {
  const double heavy = 3 * mass;
  const Vec3 c{0.25, 0.25, 0.25};
  PackingIn<3> p = box_with(faces({{c, c + Vec3{0.2, 0, 0}, c + Vec3{0.2, 0, 0.2}, c + Vec3{0, 0, 0.2}}}));
  add_ball(p, c + Vec3{0.1, 1.02 * ball, 0.1}, {0, -2, 0});
  IntegrationParameters fine;
  fine.safety = 0.01;
  EngineIn<3> engine(p, rubbing(0, 1), fine);
  set_boundaries<3>(engine, {{"plate", {}, {}, {}, false, heavy}});
  run_until(engine, 0.01);
  EXPECT_NEAR(packing_of(engine).domain.boundaries[0].velocity.y, -2 * 2 * mass / (mass + heavy), 1e-4);
  EXPECT_NEAR(packing_of(engine).grains.velocity[0].y, -2 * (mass - heavy) / (mass + heavy), 1e-4);
}

/// A turntable carries a sphere that sticks to it round its axis at first: the velocity of the face is that of its
/// places.
TEST(MovingFaces, OneThatTurnsDragsASphereAlong) {
  const Vec3 c{0.25, 0.25, 0.25};
  PackingIn<3> p =
      box_with(faces({{c - Vec3{0.2, 0, 0.2}, c + Vec3{0.2, 0, -0.2}, c + Vec3{0.2, 0, 0.2}, c + Vec3{-0.2, 0, 0.2}}}));
  add_ball(p, c + Vec3{0.15, ball - weight / stiff, 0});
  EngineIn<3> engine(p, rubbing(0.3), {});
  set_gravity(engine, Vec3{0, -gravity, 0});
  set_boundaries<3>(engine, {{"plate", {}, {0, 5, 0}, c}});
  run_until(engine, 0.05);
  // It slides: mu g t along the place's velocity, (0, 5, 0) x (0.15, 0, 0) = (0, 0, -1).
  EXPECT_NEAR(packing_of(engine).grains.velocity[0].z, -0.3 * gravity * time_of(engine), 0.02 * 0.3 * gravity * 0.05);
  const BoundaryIn<3> turned = packing_of(engine).domain.boundaries[0];
  const double angle = 5 * time_of(engine);
  EXPECT_NEAR(norm(turned.points[0] - turned.centre), 0.2 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(dot(turned.points[0] - turned.centre, Vec3{-0.2, 0, -0.2}) / 0.08, std::cos(angle), 1e-6);
}

/// A level triangle by tables of its place along z, of its angle about x, and of the force on it.
TEST(MovingFaces, FollowTables) {
  using What = Programme::What;
  PackingIn<3> start = box_with(faces({{{0.08, 0.1, 0.08}, {0.12, 0.1, 0.08}, {0.1, 0.1, 0.14}}}));
  add_ball(start, {0.4, 0.4, 0.4});
  const auto moved = [&](std::vector<std::pair<What, double>> ends, std::optional<double> kg = {}) {
    Stage stage;
    stage.duration = 0.005;
    for (const auto& [what, end] : ends)
      stage.programmes.push_back({{what}, {{0, end < 0 ? -end : 0}, {0.005, std::max(0.0, end)}}, false, "plate"});
    if (kg) stage.boundaries_in_space = {{.name = "plate", .mass = kg}};
    EngineIn<3> engine(start, {}, {});
    StageRunIn<3> run = begin_stage(engine, stage);
    while (!run.finished) continue_stage(engine, stage, run);
    return packing_of(engine).domain.boundaries[0];
  };
  const BoundaryIn<3> there = moved({{What::boundary_z, 0.01}, {What::boundary_angle_x, 0.3}});
  EXPECT_NEAR(there.centre.z - 0.1, 0.01, 1e-9);
  const Vec3 across = there.points[2] - 0.5 * (there.points[0] + there.points[1]);
  EXPECT_NEAR(std::atan2(-across.y, across.z), 0.3, 1e-6);  // from z towards -y
  EXPECT_NEAR(norm(across), 0.06, 1e-9);
  EXPECT_NEAR(moved({{What::boundary_spin_y, 2}}).spin.y, 2, 0.01);
  // A force that falls from 2 N to nothing.
  EXPECT_NEAR(moved({{What::boundary_force_z, -2}}, 0.5).velocity.z, 0.5 * 2 * 0.005 / 0.5, 1e-6);
}

/// Spheres in a funnel that turns and sinks.
EngineIn<3> stirred(IntegratorKind integrator) {
  std::vector<std::vector<Vec3>> wings;
  const auto at = [](int k, double radius, double y) {
    return Vec3{0.1 + radius * std::cos(k * std::numbers::pi / 4), y,
                0.1 + radius * std::sin(k * std::numbers::pi / 4)};
  };
  for (int k = 0; k < 8; ++k)
    wings.push_back({at(k, 0.02, 0.05), at(k + 1, 0.02, 0.05), at(k + 1, 0.09, 0.12), at(k, 0.09, 0.12)});
  PackingIn<3> p = box_with(faces(wings), 0.2);
  for (int k = 0; k < 27; ++k)
    add_ball(p, Vec3{0.1, 0.1, 0.1} + 0.0202 * Vec3{k % 3 - 1.0, k / 9 - 1.0, k / 3 % 3 - 1.0}, {0, -1, 0});
  ContactParameters contact = rubbing(0.5);
  contact.rolling = ElasticPlasticRolling{0.1, 0.3};
  IntegrationParameters integration;
  integration.integrator = integrator;
  integration.track_energy = true;
  EngineIn<3> engine(p, contact, integration);
  set_gravity(engine, Vec3{0, -gravity, 0});
  set_boundaries<3>(engine, {{"plate", {0, -0.05, 0}, {0, 10, 0}, p.domain.boundaries[0].centre}});
  return engine;
}

/// Spheres that fly about in a box in which one face turns and sinks and another is thrown about by them: what the
/// balance lacks over the work of the first.
TEST(MovingFaces, CloseTheBalanceOfEnergyWhereTheyMoveTurnAndFly) {
  const Vec3 c{0.05, 0.05, 0.05}, y{0, 0.03, 0}, z{0, 0, 0.03}, x{0.03, 0, 0};
  PackingIn<3> p = box_with(faces({{c - y - z, c + y - z, c + y, c - y}, {c - y, c + y, c + y + z, c - y + z}}), 0.1);
  BoundaryIn<3> lid = faces({{c - x - z, c + x - z, c + x + z, c - x + z}});
  lid.name = "lid";
  for (Vec3& corner : lid.points) corner.y = 0.0753;
  p.domain.boundaries.push_back(lid);
  const auto share = [](int k, double by) { return std::fmod(k * by, 1.0) - 0.5; };
  for (int k = 0; k < 64; ++k)
    add_ball(p, 0.025 * Vec3{k % 4 + 0.5, k / 4 % 4 + 0.5, k / 16 + 0.5},
             2.0 * Vec3{share(k, 0.7548), share(k, 0.5698), share(k, 0.4302)});
  IntegrationParameters fine;
  fine.safety = 1.0 / 500;
  fine.track_energy = true;
  EngineIn<3> engine(p, rubbing(0.3), fine);
  set_boundaries<3>(engine, {{"plate", {0.2, -0.3, 0}, {10, 20, -15}}, {"lid", {}, {}, {}, false, 0.02, {0, -3, 0}}});
  const Energies before = energies_of(engine);
  engine.advance(500 * 40);
  const Energies after = energies_of(engine);
  EXPECT_GT(std::abs(after.work_walls), 0.01 * before.kinetic);
  EXPECT_LT(std::abs(verification::imbalance(before, after)), 1e-5 * before.kinetic);
  EXPECT_NE(packing_of(engine).domain.boundaries[1].velocity, (Vec3{}));
}

TEST(MovingFaces, GoOnToTheSameBitsAfterTheyWereStored) {
  for (const IntegratorKind integrator : {IntegratorKind::velocity_verlet, IntegratorKind::gear5}) {
    EngineIn<3> a = stirred(integrator), b = stirred(integrator);
    run_until(a, 0.015);
    EXPECT_GT(a.builds, 2);
    restore_sample(b, save_sample(a));
    a.advance(1500);
    b.advance(1500);
    EXPECT_EQ(state_hash(a), state_hash(b));
    EXPECT_NE(energies_of(a).work_walls, 0);
    EXPECT_EQ(energies_of(a).work_walls, energies_of(b).work_walls);
  }
}

}  // namespace
}  // namespace arenite::dem
