#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/membranes/membranes.hpp"
#include "grains/dem/run_stage.hpp"
#include "shapes.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::membranes {
namespace {

using namespace verification;
using dem::Engine;
using dem::Membrane;
using dem::Membranes;
using dem::SideDrive;
using dem::Stage;
using dem::testing::crowd;
using dem::testing::to_its_end;
using Kind = SideDrive::Kind;

/// Of the sides across `axis`, one or both.
Stage pressed(double pressure, std::initializer_list<int> membranes) {
  Stage stage;
  stage.name = "cell";
  stage.skin.ends = dem::SkinEnds::held;
  for (const int side : membranes) stage.side[static_cast<std::size_t>(side)] = {Kind::membrane, pressure};
  return stage;
}

const std::vector<Vec2>& points(const dem::Sample& s, int side) {
  return s.domain.boundaries[dem::the<Membranes>(s).on_side(side)->boundary].points;
}

/// A small soft disk in the middle of a wide box, which no membrane comes near.
Packing all_but_empty(double side) {
  Packing p = box(side, side);
  p.materials[pom].stiffness = 1e4;
  add(p, Disk{{0.5 * side, 0.5 * side}, 5e-3});
  return p;
}

/// A chain of n equal segments under pressure p between two ends at a distance H takes the n sides of a regular polygon
/// on a circle; its tension is p times the distance of the sides from the centre, which for many sides is Laplace's p
/// R.
struct Arc {
  double angle, radius, tension;  ///< between two nodes at the centre, rad; of the circle, m; N
};
Arc arc_of(double n, double distance, double pressure, double stiffness) {
  const auto at = [&](double angle) {
    const double radius = 0.5 * distance / std::sin(0.5 * n * angle);
    return Arc{angle, radius, pressure * radius * std::cos(0.5 * angle)};
  };
  double low = 1e-9, high = std::numbers::pi / n;
  for (int round = 0; round < 200; ++round) {
    const double middle = 0.5 * (low + high);
    const Arc arc = at(middle);
    const double strain = 2 * arc.radius * std::sin(0.5 * arc.angle) * n / distance - 1;
    (stiffness * strain < arc.tension ? low : high) = middle;
  }
  return at(low);
}

TEST(Membrane, BetweenTwoPlatensTakesTheArcOfLaplace) {
  const double side = 0.2, pressure = 200;
  for (const int where : {left, right, bottom, top}) {
    Engine engine(all_but_empty(side), {}, {});
    Stage stage = pressed(pressure, {where});
    stage.skin.stiffness = 5e3;
    stage.drag = 60;
    engine.begin(stage);
    engine.advance(static_cast<std::int64_t>(3 / engine.dt));
    const Membrane& m = *dem::the<Membranes>(engine).on_side(where);
    const double thickness = engine.domain.thickness, n = static_cast<double>(m.nodes() - 1);
    const Arc arc = arc_of(n, side, pressure * thickness, 5e3 * thickness);
    EXPECT_NEAR(arc.tension, pressure * thickness * arc.radius, 1e-4 * arc.tension);
    const Vec2 inward = inward_normal(where), middle{0.5 * side, 0.5 * side};
    const double deep = arc.radius * std::cos(0.5 * n * arc.angle);  // of the centre, beyond the side
    const Vec2 centre = middle - (0.5 * side + deep) * inward;
    for (const Vec2& place : points(engine, where)) EXPECT_NEAR(norm(place - centre), arc.radius, 1e-7) << where;
    const double stretched = norm(points(engine, where)[1] - points(engine, where)[0]);
    EXPECT_NEAR(dem::pull_of(m.skin, stretched), arc.tension, 1e-5 * arc.tension);
    // The area between the polygon and the side: n triangles less the one below the chord.
    const double area = 0.5 * arc.radius * arc.radius * n * std::sin(arc.angle) - 0.5 * side * deep;
    EXPECT_NEAR(engine.domain.area(), side * side - area, 1e-7 * side * side);
  }
}

/// From half of the pressure to all of it by a table, and at rest there.
TEST(Membrane, FollowsATableOfItsPressure) {
  const double side = 0.2, pressure = 200, ramp = 0.5;
  Engine engine(all_but_empty(side), {}, {});
  Stage stage = pressed(0.5 * pressure, {left});
  stage.skin.stiffness = 5e3;
  stage.drag = 60;
  stage.programmes = {{{dem::Driven::What::pressure, left}, {{0, 0.5 * pressure}, {ramp, pressure}}}};
  engine.begin(stage);
  engine.advance(static_cast<std::int64_t>(0.5 * ramp / engine.dt));
  const Membrane& m = *dem::the<Membranes>(engine).on_side(left);
  const double thickness = engine.domain.thickness;
  EXPECT_NEAR(m.skin.pressure, 0.75 * pressure * thickness, 1e-4 * pressure * thickness);
  engine.advance(static_cast<std::int64_t>(3 / engine.dt));
  const Arc arc = arc_of(static_cast<double>(m.nodes() - 1), side, pressure * thickness, 5e3 * thickness);
  const double stretched = norm(points(engine, left)[1] - points(engine, left)[0]);
  EXPECT_NEAR(dem::pull_of(m.skin, stretched), arc.tension, 1e-5 * arc.tension);
}

TEST(Membrane, IsSlackWhereItIsShortenedAndDoesNotFold) {
  const dem::Skin skin{100, 0.01};
  EXPECT_NEAR(dem::pull_of(skin, 0.011), 10, 1e-12);
  EXPECT_EQ(dem::pull_of(skin, 0.007), 0);
  EXPECT_NEAR(dem::pull_of(skin, 0.003), -20, 1e-12);
  for (const double length : {0.002, 0.004, 0.012}) {
    const double h = 1e-7, slope = (energy_of(skin, length + h) - energy_of(skin, length - h)) / (2 * h);
    EXPECT_NEAR(dem::pull_of(skin, length), slope, 1e-6);
  }
}

dem::ContactParameters law(double mu) {
  dem::ContactParameters contact;
  contact.friction = mu;
  contact.wall_friction = 0;
  return contact;
}

/// Compacted between walls, then at rest between membranes on both sides.
Engine between_membranes(Packing p, dem::SkinEnds ends, double pressure, dem::IntegrationParameters integration = {}) {
  Engine engine(p, law(0.5), integration);
  Stage compact;
  compact.friction = 0;
  compact.critical_drag = 0.2;
  compact.side[right] = compact.side[top] = {Kind::pressure, pressure};
  EXPECT_TRUE(to_its_end(engine, compact).result.converged);
  Stage cell = pressed(pressure, {left, right});
  cell.side[top] = {Kind::pressure, pressure};
  cell.skin.ends = ends;
  cell.skin.stiffness = 0.02 * pressure;  // a tension of a thousandth of what the pressure does to the sample
  cell.skin.largest_strain = 0.01;
  cell.critical_drag = 0.2;
  const dem::StageRun run = to_its_end(engine, cell);
  EXPECT_TRUE(run.result.converged);
  EXPECT_NE(run.result.outcome.find("beyond its largest strain"), std::string::npos) << run.result.outcome;
  return engine;
}

/// Mean stress by the contacts, Pa: the sum of force times branch over the area, which knows nothing of sides.
Vec2 stress_by_contacts(const Packing& p) {
  Vec2 sum;
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const Vec2 branch = p.contacts.branch(c), force = p.contacts.force_on_i(c);
    sum += Vec2{-force.x * branch.x, -force.y * branch.y};
  }
  return 1 / (p.domain.area() * p.domain.thickness) * sum;
}

void expect_pressure(const Engine& engine, double pressure) {
  const double thickness = engine.domain.thickness;
  for (const int side : {left, right})
    EXPECT_NEAR(engine.domain.wall[side].force / (engine.domain.height() * thickness * pressure), 1, 0.005) << side;
  const Vec2 force = mean_forces(engine), stress = stress_by_contacts(packing_of(engine));
  EXPECT_NEAR(force.x / (engine.domain.height() * thickness), stress.x, 2e-3 * pressure);
  EXPECT_NEAR(force.y / (engine.domain.width() * thickness), stress.y, 2e-3 * pressure);
  // What is more than the pressure is the tension of the two skins, where they wind around grains.
  double pull = 0;
  for (const Membrane& m : dem::the<Membranes>(engine).list)
    pull += m.skin.stiffness * mean_strain(m.skin, engine.domain.boundaries[m.boundary].points);
  EXPECT_NEAR(stress.x, pressure + 0.5 * pull / (engine.domain.width() * thickness),
              0.5 * pull / (engine.domain.width() * thickness));
}

TEST(Membrane, PressesGrainsWithItsPressure) {
  expect_pressure(between_membranes(crowd(9, 9, 3), dem::SkinEnds::sliding, 2e5), 2e5);
}

TEST(Membrane, LetsASampleDriftAsAWholeWhichIsNoUnrest) {
  Engine engine = between_membranes(crowd(9, 9, 3), dem::SkinEnds::sliding, 2e5);
  engine.wall_friction = 0;
  const double still = dem::equilibrium_of<2>(engine).kinetic_ratio;
  for (double& v : engine.velocity.along[0]) v += 0.1;
  EXPECT_NEAR(dem::equilibrium_of<2>(engine).kinetic_ratio, still, 1e-6 * still);
  engine.wall_friction = 0.5;
  EXPECT_GT(dem::equilibrium_of<2>(engine).kinetic_ratio, 100 * still) << "friction of the platens will stop it";
}

TEST(Membrane, CarriesClumpsAsWell) {
  Packing p = box(0.085, 0.085);
  p.materials[pom].stiffness = 2e6;
  RandomStream random(5, Purpose::test);
  for (int k = 0; k < 25; ++k) {
    const Vec2 at{0.017 * (k % 5 + 0.5), 0.017 * (k / 5 + 0.5)};
    add(p, Clump{k % 2 == 0 ? dumbbell : bent, at, 5e-3, random.uniform(0, 6)});
  }
  expect_pressure(between_membranes(p, dem::SkinEnds::sliding, 5e4), 5e4);
}

/// Work and energies since a while ago: what is open over the work done.
TEST(Membrane, ClosesTheEnergyBalance) {
  dem::IntegrationParameters integration;
  integration.track_energy = true;
  integration.safety = 0.02;
  Packing p = crowd(5, 5, 4);
  for (Material& material : p.materials) material.stiffness = 2e6;
  Engine engine = between_membranes(p, dem::SkinEnds::held, 5e4, integration);
  const auto held = [&] {
    const Energies e = energies_of(engine);
    return Vec2{e.kinetic + e.elastic + e.dissipated_normal + e.dissipated_friction + e.dissipated_drag, e.work_walls};
  };
  Stage shear = pressed(5e4, {left, right});
  shear.side[top] = {Kind::velocity, 0.5};
  shear.duration = 0.01;
  shear.programmes = {{{dem::Driven::What::pressure, left}, {{0, 5e4}, {0.01, 8e4}}}};
  const Vec2 before = held();
  to_its_end(engine, shear);
  const Vec2 gain = held() - before;
  EXPECT_GT(gain.y, 0);
  // The balance is that of contacts, whose opening and closing leaves 1e-3 to 1e-4 open at such steps.
  EXPECT_NEAR(gain.x, gain.y, 1e-3 * gain.y);
}

Stage sheared() {
  Stage stage = pressed(3e5, {left, right});
  stage.side[top] = {Kind::velocity, 0.3};
  stage.duration = 1;
  stage.programmes = {{{dem::Driven::What::pressure, right}, {{0, 3e5}, {1e-3, 4e5}}}};
  return stage;
}

TEST(Membrane, ThatIsResumedHasTheBitsOfOneInOnePiece) {
  dem::IntegrationParameters integration;
  integration.track_energy = true;
  const Packing p = crowd(8, 8, 5, 0.0118);
  Engine whole(p, law(0.5), integration), resumed(p, law(0.5), integration);
  const auto before = save_sample(whole);
  whole.begin(sheared());
  continue_stage(whole, sheared(), *std::make_unique<dem::StageRun>());
  const auto bytes = save_sample(whole);
  whole.advance(811);
  resumed.begin(sheared());  // its table is no part of a state
  restore_sample(resumed, bytes);
  EXPECT_EQ(save_sample(resumed), bytes);
  resumed.advance(500);
  resumed.advance(311);
  EXPECT_EQ(save_sample(resumed), save_sample(whole));
  restore_sample(resumed, before);
  EXPECT_TRUE(dem::the<Membranes>(resumed).list.empty());
  EXPECT_EQ(save_sample(resumed), before);
}

TEST(Membrane, HasTheSameBitsOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2}) {
    dem::IntegrationParameters integration;
    integration.threads = threads;
    Engine engine(crowd(46, 46, 6, 0.0118), law(0.5), integration);
    engine.begin(sheared());
    engine.advance(150);
    hashes.push_back(state_hash(engine));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

std::string refusal(Engine& engine, const Stage& stage) {
  try {
    engine.begin(stage);
  } catch (const InputError& error) { return error.what(); }
  return "";
}

TEST(Membrane, IsRefusedWhereItCannotBe) {
  Packing cell = crowd(5, 5, 7);
  cell.domain.periodic[0] = true;
  Engine periodic(cell, {}, {}), walls(crowd(5, 5, 7), {}, {});
  EXPECT_NE(refusal(periodic, pressed(1e5, {right})), "");
  EXPECT_NE(refusal(walls, pressed(1e5, {right, top})).find("no wall at the"), std::string::npos);
  Engine on_left(crowd(5, 5, 7), {}, {});
  on_left.begin(pressed(1e5, {left}));
  EXPECT_NE(refusal(on_left, Stage{}).find("cannot become a wall again"), std::string::npos);
}

TEST(Membrane, SaysWhichGrainHasGoneThroughIt) {
  Packing p = all_but_empty(0.2);
  p.grains.velocity[0] = {20, 0};
  p.grains.position[0].y += 1e-3;  // beside a node
  Engine engine(p, {}, {});
  Stage stage = pressed(1e3, {right});
  stage.skin.node_mass = 10;  // too heavy to give way, and the grain is too fast for its soft contact
  engine.begin(stage);
  try {
    engine.advance(2000);
    FAIL();
  } catch (const CannotGoOn& error) {
    EXPECT_NE(std::string(error.what()).find("right_membrane"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace arenite::membranes
