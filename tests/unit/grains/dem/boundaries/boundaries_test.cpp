#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/boundaries/containers.hpp"
#include "unit/grains/dem/boundaries/groove.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

/// Mean acceleration, along a segment of this slope, of a disk that is let go on it.
double acceleration_on(double slope, double mu) {
  const Vec2 along{std::cos(slope), -std::sin(slope)}, normal = perpendicular(along), start{0.2, 1.8};
  Packing p = container_with(polyline({start, start + 1.6 * along}));
  const double height = r - overlap_under(mass_of(r) * g * std::cos(slope));
  const Vec2 at = start + 0.1 * along + height * normal;
  testing::add_grain(p, at.x, at.y, r);
  Engine engine(p, with_friction(mu), {});
  set_gravity(engine, {0, -g});
  while (time_of(engine) < 0.5) engine.advance(100);
  const Packing now = packing_of(engine);
  EXPECT_NEAR(dot(now.grains.position[0] - start, normal), height, 1e-3 * r);
  return 2 * dot(now.grains.position[0] - at, along) / (time_of(engine) * time_of(engine));
}

TEST(Boundaries, DiskSlidesAndRollsDownASegmentAsOnAPlane) {
  const double slope = 0.5;
  EXPECT_NEAR(acceleration_on(slope, 0), g * std::sin(slope), 1e-5 * g);
  EXPECT_NEAR(acceleration_on(slope, 1), g * std::sin(slope) * 2 / 3, 1e-5 * g);
  EXPECT_NEAR(acceleration_on(slope, 0.1), g * (std::sin(slope) - 0.1 * std::cos(slope)), 1e-5 * g);
}

TEST(Boundaries, DiskInAGrooveRestsOnBothSides) {
  const double half = 0.6;  // of the angle of the groove
  const Vec2 tip{1, 0.5}, right_way{std::sin(half), std::cos(half)}, left_way{-std::sin(half), std::cos(half)};
  Packing p = container_with(polyline({tip + left_way, tip, tip + right_way}));
  testing::add_grain(p, 1, 0.5 + r / std::sin(half), r);
  Engine engine(p, with_friction(0), {});
  set_gravity(engine, {0, -g});
  while (time_of(engine) < 0.2) engine.advance(100);
  expect_rest_in_groove(packing_of(engine), half, mass_of(r) * g);
}

/// A disk that rolls at a speed along a plate and over its corner; the energy that it has too much or too little at the
/// end, over what it had.
double energy_change_over_corner(const ContactParameters& contact, IntegratorKind integrator) {
  // So slow that the disk keeps to the corner: v^2 < g r cos.
  Packing p = container_with(polyline({{0.2, 1}, {1, 1}, {1 + 0.5 * std::cos(0.3), 1 - 0.5 * std::sin(0.3)}}));
  const double overlap = overlap_under(mass_of(r) * g), speed = 0.1;
  testing::add_grain(p, 0.99, 1 + r - overlap, r);
  p.grains.velocity[0].x = speed;
  p.grains.omega[0] = -speed / r;
  IntegrationParameters integration;
  integration.track_energy = true;
  integration.integrator = integrator;
  Engine engine(p, contact, integration);
  set_gravity(engine, {0, -g});
  const double before = energies_of(engine).kinetic, elastic_before = energies_of(engine).elastic;
  while (packing_of(engine).grains.position[0].x < 1.03) engine.advance(20);
  const Energies e = energies_of(engine);
  EXPECT_GT(e.work_gravity, 0);
  EXPECT_NEAR(packing_of(engine).grains.velocity[0].x / std::cos(0.3), -packing_of(engine).grains.omega[0] * r,
              0.02 * speed);
  return (e.kinetic + e.elastic - elastic_before - e.work_gravity - before) / before;
}

TEST(Boundaries, DiskRollsOverACornerWithoutAJumpInEnergy) {
  EXPECT_NEAR(energy_change_over_corner(with_friction(1, 1), IntegratorKind::velocity_verlet), 0, 1e-4);
  // Without the spring that is handed over it would be -7e-8.
  EXPECT_NEAR(energy_change_over_corner(with_friction(1, 1), IntegratorKind::gear5), 0, 1e-9);
}

class BoundaryBits : public ::testing::TestWithParam<IntegratorKind> {};

TEST_P(BoundaryBits, AreTheSameOnTwoThreadsAndRestored) {
  const Packing p = crowded_drum();
  ContactParameters contact = with_friction(0.5);
  contact.rolling = ElasticPlasticRolling{0.1, 0.3};
  IntegrationParameters one, two;
  one.integrator = two.integrator = GetParam();
  one.track_energy = two.track_energy = true;
  two.threads = 2;
  const auto make = [&](const IntegrationParameters& integration) {
    Engine engine(p, contact, integration);
    set_gravity(engine, {0, -g});
    set_boundaries(engine, {{"plate", {}, 20, p.domain.boundaries[0].centre}});
    return engine;
  };
  Engine a = make(one), b = make(two), c(p, contact, one);
  a.advance(3000);
  b.advance(3000);
  EXPECT_EQ(state_hash(a), state_hash(b));
  EXPECT_GT(a.builds, 2);
  restore_sample(c, save_sample(a));
  a.advance(1500);
  c.advance(1500);
  EXPECT_EQ(state_hash(a), state_hash(c));
  EXPECT_EQ(energies_of(a).work_walls, energies_of(c).work_walls);
}

INSTANTIATE_TEST_SUITE_P(Integrators, BoundaryBits,
                         ::testing::Values(IntegratorKind::velocity_verlet, IntegratorKind::leapfrog,
                                           IntegratorKind::gear5));

/// Whether the error of a grain that is shot from there at a boundary names the boundary.
bool shot_names_it(std::vector<Vec2> points, Vec2 from, Vec2 velocity) {
  Packing p = container_with(polyline(std::move(points)));
  testing::add_grain(p, from.x, from.y, r);
  p.grains.velocity[0] = velocity;
  Engine engine(p, {}, {});
  try {
    engine.advance(1000);
  } catch (const CannotGoOn& error) {
    return std::string(error.what()).find("the boundary \"plate\"") != std::string::npos;
  }
  return false;
}

TEST(Boundaries, AGrainThatIsShotThroughOneEndsInAnErrorThatNamesIt) {
  EXPECT_TRUE(shot_names_it({{1, 0.5}, {1, 1.5}}, {0.95, 1}, {1000, 0}));
}

/// Straight and obliquely through a point of a boundary that is straight there or turns to either side, and from one
/// segment's side to the other's close to the point.
TEST(Boundaries, AGrainThatIsShotThroughAPointOfOneEndsInAnErrorThatNamesIt) {
  for (const double back : {-0.3, 0., 0.3})
    for (const double upwards : {-100., 0., 100.})
      for (const double aside : {0., 1e-4}) {
        const Vec2 from{0.95, 1 + aside - 0.05 * upwards / 1000};
        EXPECT_TRUE(shot_names_it({{1 - back, 0.5}, {1, 1}, {1 - back, 1.5}}, from, {1000, upwards}))
            << back << " " << upwards << " " << aside;
      }
}

TEST(Boundaries, ThatMakeNoSenseAreRefused) {
  EXPECT_THROW(Engine(container_with(polyline({{0, 0}})), {}, {}), InputError);
  Packing p = container_with(polyline({{0, 0}, {2, 1}}));
  testing::add_grain(p, 1, 1, r);
  p.domain.periodic[0] = true;
  EXPECT_THROW(Engine(p, {}, {}), InputError);  // longer than the cell
  p.domain.boundaries[0].points[1] = {1, 0};
  p.domain.periodic[1] = true;
  Engine engine(p, {}, {});
  EXPECT_THROW(set_shear_rate(engine, 1), InputError);
  EXPECT_THROW(set_boundaries(engine, {{"gate"}}), InputError);
  EXPECT_THROW(set_drives(engine, {{{WallDrive::Kind::velocity, 1}, {}, {}, {}}}), InputError);
  EXPECT_THROW(set_programmes(engine, {{{{Programme::What::boundary_x}, {{0, 0}}, false, "gate"}}, 0, 0, 0}),
               InputError);
  EXPECT_THROW(set_programmes(engine, {{{{Programme::What::boundary_force_x}, {{0, 0}}, false, "plate"}}, 0, 0, 0}),
               InputError);  // a force without a mass
}

/// A plate from side to side of a periodic container, with a seam at the sides.
TEST(Boundaries, ADiskSlidesThroughAPeriodicSideAsOverAPlane) {
  for (const double begin : {0.0, 0.05}) {
    Packing p = testing::empty_container(0.2, 2);
    p.domain.periodic[0] = true;
    p.domain.boundaries.push_back(polyline({{begin, 1}, {begin + 0.07, 1}, {begin + 0.2, 1}}));
    const double height = 1 + r - overlap_under(mass_of(r) * g);
    testing::add_grain(p, 0.1, height, r);
    p.grains.velocity[0].x = 2;
    Engine engine(p, with_friction(0), {});
    set_gravity(engine, {0, -g});
    while (time_of(engine) < 0.25) {
      engine.advance(20);
      const Packing now = packing_of(engine);
      ASSERT_EQ(now.contacts.size(), 1U) << now.grains.position[0].x;
      ASSERT_NEAR(now.grains.position[0].y, height, 1e-9);
      ASSERT_NEAR(now.grains.velocity[0].x, 2, 1e-9);
    }
    EXPECT_LT(packing_of(engine).grains.position[0].x, 0.21);
    EXPECT_NEAR(engine.domain.boundaries[0].force.y, -mass_of(r) * g, 1e-6 * mass_of(r) * g);
  }
}

}  // namespace
}  // namespace arenite::dem
