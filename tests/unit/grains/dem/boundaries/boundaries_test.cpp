#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

constexpr double g = 9.81, r = 0.01;

Boundary polyline(std::vector<Vec2> points, bool closed = false) {
  Boundary boundary;
  boundary.name = "plate";
  boundary.centre = mean_point(points);
  boundary.points = std::move(points);
  boundary.closed = closed;
  return boundary;
}

Packing container_with(Boundary boundary) {
  Packing p = testing::empty_container(2, 2);
  p.domain.boundaries.push_back(std::move(boundary));
  return p;
}

ContactParameters with_friction(double mu, double restitution = 0.5) {
  ContactParameters contact;
  contact.friction = mu;
  contact.restitution = restitution;
  return contact;
}

/// Overlap under which a wall carries a force.
double overlap_under(double force) { return force / 27.35e6; }

double mass_of(double radius) { return 1410 * std::numbers::pi * radius * radius * 0.06; }

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
  const Packing now = packing_of(engine);
  const double weight = mass_of(r) * g;
  ASSERT_EQ(now.contacts.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_TRUE(now.contacts.is_boundary(c));
    EXPECT_EQ(now.domain.boundary_of(now.contacts.element(c)), 0);
    EXPECT_NEAR(now.contacts.fn[c], weight / (2 * std::sin(half)), 1e-8 * weight);
  }
  EXPECT_NEAR(engine.domain.boundaries[0].force.y, -weight, 1e-8 * weight);
  EXPECT_NEAR(engine.domain.boundaries[0].force.x, 0, 1e-8 * weight);
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

TEST(Boundaries, TurningPlateCarriesADiskAndItsWorkIsBooked) {
  // A plate that begins to turn about a point of it; a disk rests on it, held by friction.
  Boundary plate = polyline({{0.5, 1}, {1.5, 1}});
  Packing p = container_with(plate);
  const double x = 1.1, weight = mass_of(r) * g, spin = 0.2;
  testing::add_grain(p, x, 1 + r - overlap_under(weight), r);
  ContactParameters contact = with_friction(1);
  contact.rolling = ElasticPlasticRolling{0.5, 0.3};
  IntegrationParameters integration;
  integration.track_energy = true;
  Engine engine(p, contact, integration);
  set_gravity(engine, {0, -g});
  set_boundaries(engine, {{"plate", {}, spin, Vec2{1, 1}}});
  while (time_of(engine) < 0.5) engine.advance(100);
  const double turned = spin * time_of(engine);
  const Packing now = packing_of(engine);
  const Vec2 along{std::cos(turned), std::sin(turned)}, at = Vec2{1, 1} + 0.1 * along + r * perpendicular(along);
  EXPECT_NEAR(now.grains.position[0].x, at.x, 2e-5);
  EXPECT_NEAR(now.grains.position[0].y, at.y, 2e-5);
  EXPECT_NEAR(now.grains.omega[0], spin, 1e-3 * spin);
  EXPECT_NEAR(norm(now.domain.boundaries[0].points[1] - Vec2{1, 1}), 0.5, 1e-10);
  EXPECT_NEAR(now.domain.boundaries[0].points[1].y, 1 + 0.5 * std::sin(turned), 1e-9);
  EXPECT_NEAR(now.domain.boundaries[0].torque, -weight * (at.x - 1), 0.01 * weight * 0.1);
  const Energies e = energies_of(engine);
  const double gained = e.kinetic + e.elastic + e.dissipated_normal + e.dissipated_friction - e.work_gravity;
  EXPECT_NEAR(e.work_walls, weight * (at.y - 1 - r), 0.01 * e.work_walls);
  EXPECT_NEAR(gained, e.work_walls, 1e-4 * e.work_walls + 1e-9);
}

TEST(Boundaries, IntruderGivesItsMomentum) {
  // A wedge at constant speed hits a disk at rest: it leaves with (1 + e) times the speed along the normal.
  Boundary intruder = polyline({{0.5, 0.9}, {0.6, 1.0}, {0.5, 1.1}}, true);
  Packing p = container_with(intruder);
  testing::add_grain(p, 0.6 + r + 0.001, 1, r);
  Engine engine(p, with_friction(0, 0.5), {});
  set_boundaries(engine, {{"plate", {1, 0}, 0, intruder.centre}});
  double impulse = 0;
  while (time_of(engine) < 0.01) {
    const double from = time_of(engine);
    engine.advance(1);
    impulse += engine.domain.boundaries[0].force.x * (time_of(engine) - from);
  }
  const Packing now = packing_of(engine);
  EXPECT_NEAR(now.grains.velocity[0].x, 1.5, 0.02);
  EXPECT_NEAR(impulse, -mass_of(r) * now.grains.velocity[0].x, 1e-3 * mass_of(r));
  EXPECT_NEAR(now.domain.boundaries[0].points[1].x, 0.6 + time_of(engine), 1e-12);
}

/// A crowd in a turning drum within the container.
Packing crowded_drum() {
  Packing p = testing::crowd(30, 30, 3, 0.0165);
  const Vec2 middle{0.5 * p.domain.width(), 0.5 * p.domain.height()};
  std::vector<Vec2> points;
  for (int k = 0; k < 24; ++k)
    points.push_back(middle + 0.18 * Vec2{std::cos(k * std::numbers::pi / 12), std::sin(k * std::numbers::pi / 12)});
  Packing inside = p;
  inside.grains = {};
  for (std::size_t k = 0; k < p.grains.size(); ++k)
    if (norm(p.grains.position[k] - middle) < 0.168)
      testing::add_grain(inside, p.grains.position[k].x, p.grains.position[k].y, p.grains.radius[k],
                         p.grains.material[k]);
  inside.domain.boundaries.push_back(polyline(points, true));
  return inside;
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

TEST(Boundaries, DrumHoldsItsGrainsAndItsEnergyIsAccounted) {
  const Packing p = crowded_drum();
  IntegrationParameters integration;
  integration.track_energy = true;
  Engine engine(p, with_friction(0.5), integration);
  const double before = energies_of(engine).elastic;
  set_gravity(engine, {0, -g});
  const Vec2 middle = p.domain.boundaries[0].centre;
  set_boundaries(engine, {{"plate", {}, 5, middle}});
  while (time_of(engine) < 0.1) engine.advance(1000);
  const Packing now = packing_of(engine);
  for (std::size_t k = 0; k < now.grains.size(); ++k)
    EXPECT_LT(norm(now.grains.position[k] - middle) + 0.9 * now.grains.radius[k], 0.18);
  const Energies e = energies_of(engine);
  const double open =
      e.kinetic + e.elastic + e.dissipated_normal + e.dissipated_friction - before - e.work_gravity - e.work_walls;
  EXPECT_GT(e.work_walls, 0);
  EXPECT_NEAR(open / (e.dissipated_normal + e.dissipated_friction), 0, 1e-3);  // walls alone: -5e-4
}

TEST(Boundaries, GateThatGoesLetsItsGrainFallAndOpenSideLetsItOut) {
  Packing p = container_with(polyline({{0.5, 1}, {1.5, 1}}));
  testing::add_grain(p, 1, 1 + r, r);
  Engine engine(p, with_friction(0.5), {});
  set_gravity(engine, {0, -g});
  while (time_of(engine) < 0.1) engine.advance(100);
  EXPECT_NEAR(packing_of(engine).grains.position[0].y, 1 + r, 1e-5);
  set_boundaries(engine, {{"plate", {}, 0, Vec2{1, 1}, true}});
  set_open(engine, {false, false, true, false});
  const double then = time_of(engine);
  while (time_of(engine) < then + 0.6) engine.advance(100);
  const double fallen = time_of(engine) - then;
  EXPECT_NEAR(packing_of(engine).grains.position[0].y, 1 + r - 0.5 * g * fallen * fallen, 1e-4);
  EXPECT_LT(packing_of(engine).grains.position[0].y, 0);
  EXPECT_EQ(amount_below(engine, 0).grains, 1u);
  EXPECT_NEAR(amount_below(engine, 0).mass, mass_of(r), 1e-12);
  EXPECT_THROW(set_open(engine, {}), InputError);
  Engine again(p, with_friction(0.5), {});
  restore_sample(again, save_sample(engine));
  again.advance(100);
  engine.advance(100);
  EXPECT_EQ(state_hash(again), state_hash(engine));
}

TEST(Boundaries, StagesMoveThemByName) {
  Packing p = container_with(polyline({{0.5, 1}, {1.5, 1}}));
  testing::add_grain(p, 1, 1 + r, r);
  Engine engine(p, with_friction(0.5), {});
  Stage stage;
  stage.name = "lift";
  stage.duration = 0.1;
  stage.boundaries = {{"plate", {0, 0.5}, 0, {}, false}};
  stage.count_below = 1.5;
  StageRun run = begin_stage(engine, stage);
  while (!run.finished) continue_stage(engine, stage, run);
  EXPECT_NEAR(engine.domain.boundaries[0].points[0].y, 1 + 0.5 * time_of(engine), 1e-9);
  const auto& columns = run.result.history.columns;
  const auto has = [&](const char* name) {
    return std::any_of(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
  };
  EXPECT_TRUE(has("plate_force_x") && has("plate_force_y") && has("plate_torque") && has("passed") &&
              has("passed_mass"));
  stage.boundaries[0].name = "gate";
  EXPECT_THROW(begin_stage(engine, stage), InputError);
}

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

/// What a boundary does to a disk does not depend on where the cell is cut.
TEST(Boundaries, AnIntruderGoesOnThroughPeriodicSides) {
  const auto pushed = [](double from) {
    Packing p = testing::empty_container(0.2, 0.4);
    p.domain.periodic[0] = true;
    Boundary intruder = polyline({{from, 0.18}, {from + 0.02, 0.2}, {from, 0.22}}, true);
    p.domain.boundaries.push_back(intruder);
    testing::add_grain(p, std::fmod(from + 0.06, 0.2), 0.205, r);
    Engine engine(p, with_friction(0.3), {});
    set_boundaries(engine, {{"plate", {3, 0}, 0, intruder.centre}});
    while (time_of(engine) < 0.06) engine.advance(50);
    EXPECT_GE(engine.domain.boundaries[0].centre.x, -1e-3);
    EXPECT_LE(engine.domain.boundaries[0].centre.x, 0.2 + 1e-3);
    return packing_of(engine).grains;
  };
  const Grains a = pushed(0.03), b = pushed(0.15);
  EXPECT_GT(a.velocity[0].x, 1);
  EXPECT_NEAR(a.velocity[0].x, b.velocity[0].x, 1e-8);
  EXPECT_NEAR(a.velocity[0].y, b.velocity[0].y, 1e-8);
  EXPECT_NEAR(std::remainder(b.position[0].x - a.position[0].x - 0.12, 0.2), 0, 1e-8);
}

TEST(Boundaries, OneWithAMassBouncesOffADiskAndFalls) {
  ContactParameters elastic = with_friction(0, 1);
  elastic.normal_damping = 0;
  for (const IntegratorKind kind : {IntegratorKind::velocity_verlet, IntegratorKind::leapfrog}) {
    Packing p = container_with(polyline({{1, 0.5}, {1, 1.5}}));
    testing::add_grain(p, 0.989, 1, r);
    p.grains.velocity[0].x = 1;
    IntegrationParameters integration;
    integration.integrator = kind;
    integration.safety = 0.0005;
    integration.track_energy = true;
    Engine engine(p, elastic, integration);
    const double m = mass_of(r), mass = 3 * m;
    set_boundaries(engine, {{"plate", {-0.5, 0}, 0, Vec2{1, 1}, false, mass}});
    const Energies before = energies_of(engine);
    EXPECT_NEAR(before.kinetic, 0.5 * m + 0.5 * mass * 0.25, 1e-12);
    while (time_of(engine) < 0.002) engine.advance(50);
    const double common = (m - 0.5 * mass) / (m + mass);
    EXPECT_NEAR(packing_of(engine).grains.velocity[0].x, 2 * common - 1, 1e-6);
    EXPECT_NEAR(packing_of(engine).domain.boundaries[0].velocity.x, 2 * common + 0.5, 1e-6);
    set_gravity(engine, {0, -g});
    const double then = time_of(engine), place = engine.domain.boundaries[0].centre.y;
    const auto bytes = save_sample(engine);
    while (time_of(engine) < then + 0.002) engine.advance(50);
    const double fallen = time_of(engine) - then;
    EXPECT_NEAR(packing_of(engine).domain.boundaries[0].velocity.y, -g * fallen, 1e-9);
    EXPECT_NEAR(engine.domain.boundaries[0].centre.y - place, -0.5 * g * fallen * fallen, 1e-9);
    const Energies e = energies_of(engine);
    EXPECT_NEAR(e.kinetic + e.elastic - before.kinetic, e.work_gravity + e.work_walls - before.work_walls,
                1e-6 * before.kinetic);
    const std::uint64_t hash = state_hash(engine);
    const std::int64_t steps = engine.step;
    Engine again(p, elastic, integration);
    set_boundaries(again, {{"plate", {-0.5, 0}, 0, Vec2{1, 1}, false, mass}});
    set_gravity(again, {0, -g});
    restore_sample(again, bytes);
    again.advance(steps - again.step);
    EXPECT_EQ(state_hash(again), hash);
  }
  IntegrationParameters gear;
  gear.integrator = IntegratorKind::gear5;
  Packing p = container_with(polyline({{1, 0.5}, {1, 1.5}}));
  testing::add_grain(p, 0.5, 1, r);
  Engine engine(p, elastic, gear);
  EXPECT_THROW(set_boundaries(engine, {{"plate", {}, 0, {}, false, 1.0}}), InputError);
}

}  // namespace
}  // namespace arenite::dem
