#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "unit/grains/dem/boundaries/boxes.hpp"
#include "unit/grains/dem/boundaries/groove.hpp"

namespace arenite::dem {
namespace {

using namespace testing;

/// Axes of a plane that falls by an angle, oblique to all of space: down the slope, across it, and off it.
struct Slope {
  Vec3 along, across, normal;
  explicit Slope(double angle, double azimuth = 0.4)
      : along{std::cos(angle) * std::cos(azimuth), -std::sin(angle), std::cos(angle) * std::sin(azimuth)},
        across{-std::sin(azimuth), 0, std::cos(azimuth)},
        normal{std::sin(angle) * std::cos(azimuth), std::cos(angle), std::sin(angle) * std::sin(azimuth)} {}
  Vec3 at(double down, double aside) const { return down * along + aside * across; }
  /// A strip in four parts, whose seams lie on the way and end on edges of others.
  BoundaryIn<3> strip(Vec3 from) const {
    const auto face = [&](double a, double b, double c, double d) {
      return std::vector<Vec3>{from + at(a, c), from + at(b, c), from + at(b, d), from + at(a, d)};
    };
    return faces({face(-0.05, 0.05, -0.05, 0.05), face(0.05, 0.1, -0.05, 0.001), face(0.05, 0.3, 0.001, 0.05),
                  face(0.1, 0.3, -0.05, 0.001)});
  }
};

/// Mean acceleration down a slope of a sphere that is let go on it.
double acceleration_down(double angle, double mu) {
  const Slope slope(angle);
  const Vec3 from{0.1, 0.35, 0.15}, start = from + (ball - weight * std::cos(angle) / stiff) * slope.normal;
  PackingIn<3> p = box_with(slope.strip(from));
  add_ball(p, start);
  EngineIn<3> engine(p, rubbing(mu), {});
  set_gravity(engine, Vec3{0, -gravity, 0});
  run_until(engine, 0.25);
  const Vec3 way = packing_of(engine).grains.position[0] - start;
  EXPECT_NEAR(dot(way, slope.normal), 0, 1e-3 * ball);
  EXPECT_NEAR(dot(way, slope.across), 0, 1e-6);
  return 2 * dot(way, slope.along) / (time_of(engine) * time_of(engine));
}

// A sphere has the moment of inertia 2/5 m r^2, and so rolls with 5/7 of what it slides with where nothing rubs; it
// slides and rolls at once where mu < 2/7 tan.
TEST(Faces, ASphereSlidesAndRollsDownThemAsOnAPlane) {
  const double angle = 0.5;
  const double tolerance = 3e-5 * gravity;  // the spring of friction is built up within a tenth of a millisecond
  EXPECT_NEAR(acceleration_down(angle, 0), gravity * std::sin(angle), tolerance);
  EXPECT_NEAR(acceleration_down(angle, 1), gravity * std::sin(angle) * 5 / 7, tolerance);
  EXPECT_NEAR(acceleration_down(angle, 0.1), gravity * (std::sin(angle) - 0.1 * std::cos(angle)), tolerance);
}

// A dashpot of a restitution takes its share of the normal velocity, whatever the direction in space.
TEST(Faces, ASphereBouncesOffAnObliqueOneByItsRestitution) {
  for (const double restitution : {1.0, 0.6}) {
    const Slope slope(0.7);
    const Vec3 from{0.1, 0.35, 0.15}, touched = from + slope.at(0.2, 0.03),
                                      before = -1.5 * slope.normal + slope.at(0.4, -0.3);
    PackingIn<3> p = box_with(slope.strip(from));
    add_ball(p, touched + 1.01 * ball * slope.normal, before);
    ContactParameters contact = rubbing(0, restitution);
    contact.attractive_dashpot = true;  // clipped, it would take less
    IntegrationParameters fine;
    fine.safety = 0.002;  // the dashpot sees velocities of half a step before
    EngineIn<3> engine(p, contact, fine);
    run_until(engine, 0.01);
    const Vec3 after = packing_of(engine).grains.velocity[0];
    EXPECT_NEAR(dot(after, slope.normal), 1.5 * restitution, 1e-3);
    EXPECT_NEAR(dot(after - before, slope.along), 0, 1e-12);
    EXPECT_NEAR(dot(after - before, slope.across), 0, 1e-12);
  }
}

TEST(Faces, ASphereInAGrooveRestsOnBoth) {
  const double half = 0.6;  // of the angle of the groove
  const auto wing = [&](double sense) {
    const Vec3 tip{0.25, 0.1, 0.1}, out{0.2 * sense * std::sin(half), 0.2 * std::cos(half), 0}, length{0, 0, 0.3};
    return std::vector<Vec3>{tip, tip + length, tip + length + out, tip + out};
  };
  PackingIn<3> p = box_with(faces({wing(1), wing(-1)}));
  add_ball(p, {0.25, 0.1 + ball / std::sin(half), 0.25});
  EngineIn<3> engine(p, rubbing(0), {});
  set_gravity(engine, Vec3{0, -gravity, 0});
  run_until(engine, 0.3);
  expect_rest_in_groove(packing_of(engine), half, weight);
}

/// The only contact of a sphere that lies there with its centre so far from the nearest point of a boundary.
void expect_one_contact(const BoundaryIn<3>& boundary, Vec3 nearest, Vec3 direction) {
  const Vec3 normal = direction / norm(direction);
  PackingIn<3> p = box_with(boundary);
  add_ball(p, nearest + 0.999 * ball * normal);
  IntegrationParameters still;
  still.safety = 1e-4;
  EngineIn<3> engine(p, rubbing(0), still);
  engine.advance(1);
  const PackingIn<3> now = packing_of(engine);
  ASSERT_EQ(now.contacts.size(), 1U) << nearest.x << " " << nearest.y << " " << nearest.z;
  EXPECT_NEAR(norm(now.contacts.normal[0] - normal), 0, 1e-6);
  EXPECT_NEAR(now.contacts.fn[0], 0.001 * ball * stiff, 1e-5 * ball * stiff);
}

TEST(Faces, AreTouchedOnceWithinOnAnEdgeAndAtACorner) {
  const Vec3 c{0.25, 0.25, 0.25}, x{0.1, 0, 0}, y{0, 0.1, 0}, z{0, 0, 0.1};
  const BoundaryIn<3> one = faces({{c, c + x, c + x + z, c + z}});
  expect_one_contact(one, c + 0.5 * (x + z), {0, 1, 0});
  expect_one_contact(one, c + 0.5 * (x + z), {0, -1, 0});
  expect_one_contact(one, c + 0.5 * x, {0, 1, -1});
  expect_one_contact(one, c, {-1, 2, -3});
  // Three faces of a cube, whose seams jut out: edges of two, a corner of three.
  const BoundaryIn<3> cube =
      faces({{c, c + x, c + x + z, c + z}, {c, c + x, c + x + y, c + y}, {c, c + y, c + y + z, c + z}});
  expect_one_contact(cube, c + 0.5 * x, {0, -1, -1});
  expect_one_contact(cube, c + 0.3 * z, {-1, -2, 0});
  expect_one_contact(cube, c, {-1, -1, -2});
  // A point of an edge that ends within another's, and the corner of one that lies on the other's edge.
  const BoundaryIn<3> part =
      faces({{c, c + x, c + x + z, c + z}, {c + 0.2 * x, c + 0.6 * x, c + 0.6 * x - z, c + 0.2 * x - z}});
  expect_one_contact(part, c + 0.4 * x, {0, 1, 0});
  expect_one_contact(part, c + 0.2 * x, {0, 1, 0});
  expect_one_contact(part, c + 0.1 * x, {0, 1, -1});
}

/// A plate from side to side of a container that is periodic along x and z, with seams on the way and at the sides.
TEST(Faces, ASphereSlidesOverSeamsAndThroughPeriodicSidesAsOverAPlane) {
  const auto level = [](double x0, double x1, double z0, double z1) {
    return std::vector<Vec3>{{x0, 0.2, z0}, {x1, 0.2, z0}, {x1, 0.2, z1}, {x0, 0.2, z1}};
  };
  PackingIn<3> p = box_with(faces({level(0, 0.07, 0, 0.2), level(0.07, 0.2, 0, 0.08), level(0.07, 0.2, 0.08, 0.2)}));
  p.domain.periodic = {true, false, true};
  p.domain.wall[right].position = p.domain.wall[front].position = 0.2;
  const double height = 0.2 + ball - weight / stiff;
  add_ball(p, {0.1, height, 0.05}, {2, 0, 1.3});
  EngineIn<3> engine(p, rubbing(0), {});
  set_gravity(engine, Vec3{0, -gravity, 0});
  while (time_of(engine) < 0.4) {
    engine.advance(20);
    const PackingIn<3> now = packing_of(engine);
    ASSERT_EQ(now.contacts.size(), 1U) << now.grains.position[0].x << " " << now.grains.position[0].z;
    ASSERT_NEAR(now.grains.position[0].y, height, 1e-9);
    ASSERT_NEAR(now.grains.velocity[0].x, 2, 1e-9);
    ASSERT_NEAR(now.grains.velocity[0].z, 1.3, 1e-9);
  }
  EXPECT_NEAR(engine.domain.boundaries[0].force.y, -weight, 1e-6 * weight);
}

/// A sphere that rolls along a face, over its edge and down the next; the energy that it has too much or too little at
/// the end, over what it had.
double energy_change_over_edge(IntegratorKind integrator) {
  // So slow that the sphere keeps to the edge: v^2 < g r cos.
  const Vec3 edge{0.25, 0.25, 0.1}, length{0, 0, 0.3}, down{std::cos(0.3), -std::sin(0.3), 0};
  PackingIn<3> p = box_with(faces({{edge - Vec3{0.2, 0, 0}, edge, edge + length, edge + length - Vec3{0.2, 0, 0}},
                                   {edge, edge + 0.2 * down, edge + 0.2 * down + length, edge + length}}));
  const double speed = 0.1;
  add_ball(p, edge + Vec3{-0.01, ball - weight / stiff, 0.15}, {speed, 0, 0});
  p.grains.omega[0] = {0, 0, -speed / ball};
  IntegrationParameters integration;
  integration.track_energy = true;
  integration.integrator = integrator;
  EngineIn<3> engine(p, rubbing(1, 1), integration);
  set_gravity(engine, Vec3{0, -gravity, 0});
  const double before = energies_of(engine).kinetic, elastic = energies_of(engine).elastic;
  while (packing_of(engine).grains.position[0].x < 0.28) engine.advance(20);
  const Energies e = energies_of(engine);
  const GrainsIn<3> now = packing_of(engine).grains;
  EXPECT_GT(e.work_gravity, 0);
  EXPECT_NEAR(now.velocity[0].x / std::cos(0.3), -now.omega[0].z * ball, 0.02 * speed);
  return (e.kinetic + e.elastic - elastic - e.work_gravity - before) / before;
}

TEST(Faces, ASphereRollsOverAnEdgeWithoutAJumpInEnergy) {
  EXPECT_NEAR(energy_change_over_edge(IntegratorKind::velocity_verlet), 0, 2e-4);
  EXPECT_NEAR(energy_change_over_edge(IntegratorKind::gear5), 0, 1e-6);
}

TEST(Faces, ASphereThatIsShotThroughOneEndsInAnErrorThatNamesIt) {
  const Vec3 c{0.25, 0.25, 0.25};
  const std::vector<std::vector<Vec3>> halves{
      {c - Vec3{0, 0.2, 0.2}, c + Vec3{0, 0.2, -0.2}, c + Vec3{0, 0.2, 0}, c - Vec3{0, 0.2, 0}},
      {c - Vec3{0, 0.2, 0}, c + Vec3{0, 0.2, 0}, c + Vec3{0, 0.2, 0.2}, c + Vec3{0, -0.2, 0.2}}};
  for (const double aside : {0.0, 1e-4}) {  // through the seam, and beside it
    PackingIn<3> p = box_with(faces(halves));
    add_ball(p, c + Vec3{-0.05, 0.01, aside}, {1000, 0, 0});
    EngineIn<3> engine(p, {}, {});
    try {
      engine.advance(1000);
      ADD_FAILURE() << "it went through";
    } catch (const CannotGoOn& error) {
      EXPECT_NE(std::string(error.what()).find("the boundary \"plate\""), std::string::npos);
    }
  }
}

TEST(Faces, ThatMakeNoSenseAreRefused) {
  const Vec3 c{0.25, 0.25, 0.25}, x{0.1, 0, 0}, z{0, 0, 0.1};
  EXPECT_THROW(EngineIn<3>(box_with(faces({{c, c + x}})), {}, {}), InputError);
  EXPECT_THROW(EngineIn<3>(box_with(faces({{c, c + x, c + z, c + x + z}})), {}, {}), InputError);  // crossed
  BoundaryIn<3> short_of_points = faces({{c, c + x, c + x + z, c + z}});
  short_of_points.points.pop_back();
  EXPECT_THROW(EngineIn<3>(box_with(short_of_points), {}, {}), InputError);
  PackingIn<3> p = box_with(faces({{{0, 0.1, 0.1}, {0.5, 0.1, 0.1}, {0.5, 0.2, 0.1}}}));
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  add_ball(p, {0.25, 0.25, 0.25});
  EngineIn<3> engine(p, {}, {});
  EXPECT_THROW(set_shear_rate(engine, 1), InputError);
  EXPECT_THROW(set_boundaries<3>(engine, {{"gate"}}), InputError);
  p.domain.wall[right].position = 0.4;  // shorter than the face
  EXPECT_THROW(EngineIn<3>(p, {}, {}), InputError);
}

}  // namespace
}  // namespace arenite::dem
