#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "geometry/liquid_bridge.hpp"
#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::IntegratorKind;

constexpr double wet_radius = 5e-3, wet_thickness = 0.06;

dem::CapillaryDisks water(double contact_angle = 0, double share_of_square = 0.005) {
  dem::CapillaryDisks law;
  law.contact_angle = contact_angle;
  law.volume = share_of_square * wet_radius * wet_radius * wet_thickness;
  return law;
}
/// Strong enough to matter beside the elastic forces of these disks.
dem::Cohesion strong(const dem::Cohesion& law) {
  return std::visit(
      [](auto changed) -> dem::Cohesion {
        if constexpr (std::is_same_v<decltype(changed), dem::Dmt>) changed = {2e3, 2e-5};
        if constexpr (std::is_base_of_v<dem::Liquid, decltype(changed)>) {
          changed.surface_tension = std::is_same_v<decltype(changed), dem::CapillaryDisks> ? 100 : 3e3;
          changed.volume = 0.005 * wet_radius * wet_radius * wet_thickness;
        }
        return changed;
      },
      law);
}
const dem::Cohesion all_laws[] = {dem::Dmt{}, dem::CapillaryDisks{}, dem::CapillarySpheres{}};

dem::ContactParameters cohesive(const dem::Cohesion& law, double restitution = 1) {
  dem::ContactParameters contact = frictionless(restitution);
  contact.cohesion = law;
  return contact;
}

/// Two disks, each held by a wall, which draw apart slowly.
struct Pulled {
  double gap, force;
};
std::vector<Pulled> pulled_apart(const dem::Cohesion& law, double way, double radius_j, double overlap) {
  const double width = 2 * (wet_radius + radius_j) - overlap;
  Packing p = box(width, 0.5);
  add(p, {{wet_radius, 0.25}, wet_radius});
  add(p, {{width - radius_j, 0.25}, radius_j});
  dem::IntegrationParameters how;
  Engine engine(p, cohesive(law), how);
  set_rough(engine, {true, true, false, false});
  set_drives(engine, {dem::WallDrive{}, moved(way / (2000 * engine.dt)), {}, {}});
  std::vector<Pulled> curve;
  for (int n = 0; n < 2000; ++n) {
    engine.advance(1);
    curve.push_back({engine.domain.wall[right].position - width - overlap, -engine.domain.wall[right].force});
  }
  return curve;
}

TEST(Cohesion, DmtPullsOffAtTwoPiWRAndDoesTheWorkOfAdhesion) {
  const dem::Dmt law{0.1, 1e-6};
  const double most = 2 * pi * 0.1 * wet_radius / 2, overlap = 4 * most / k_pom;
  const auto curve = pulled_apart(law, 1.3e-6 + overlap, wet_radius, overlap);
  double strongest = 0, work = 0;
  for (std::size_t n = 1; n < curve.size(); ++n) {
    strongest = std::max(strongest, curve[n].force);
    if (curve[n - 1].gap > 0) work += 0.5 * (curve[n].force + curve[n - 1].force) * (curve[n].gap - curve[n - 1].gap);
    const double gap = curve[n].gap, expected = gap <= 0 ? most + k_pom * gap : most * std::max(1 - gap / 1e-6, 0.0);
    EXPECT_NEAR(curve[n].force, expected, 1e-6 * most) << gap;
  }
  EXPECT_NEAR(strongest, most, 2e-3 * most);
  EXPECT_NEAR(work, 0.5 * most * 1e-6,
              2e-3 * work);  // pi w d R: the energy of flat surfaces, w a unit of area, over the caps
}

TEST(Cohesion, AWetPairPulledApartFollowsTheExactBridgeUntilItBreaks) {
  for (const double radius_j : {wet_radius, 2.5 * wet_radius})
    for (const double angle : {0.0, 0.8}) {
      const dem::CapillaryDisks law = water(angle);
      const geometry::LiquidBridge bridge{wet_radius, radius_j, angle};
      const double area = law.volume / wet_thickness, reach = geometry::rupture_gap(bridge, area),
                   unit = law.surface_tension * wet_thickness;
      const auto curve = pulled_apart(law, 1.2 * reach, radius_j, 1e-9);
      double last = 0;
      for (const auto& [gap, force] : curve) {
        if (gap <= 0) continue;
        const double expected =
            gap < reach ? unit * geometry::bridge_state(bridge, gap, geometry::arc_radius(bridge, gap, area)).pull : 0;
        EXPECT_NEAR(force, expected, 1e-5 * unit) << gap / reach;
        if (force != 0) last = gap;
      }
      EXPECT_NEAR(last, reach, 1e-3 * reach);
    }
}

TEST(Cohesion, BridgesFormAtTheTouchAndNotBefore) {
  // A disk flies to another one at rest, rebounds, and is slowed by the bridge alone.
  Packing p = box(1, 1);
  const double speed = 0.2, gap = 1e-4;
  add(p, {{0.5, 0.5}, wet_radius, pom, {speed, 0}});
  add(p, {{0.5 + 2 * wet_radius + gap, 0.5}, wet_radius});
  const dem::CapillaryDisks law = water();
  dem::IntegrationParameters how;
  how.safety = 1.0 / 500;
  how.track_energy = true;
  Engine engine(p, cohesive(law), how);
  engine.advance(static_cast<std::int64_t>(0.9 * gap / speed / engine.dt));
  EXPECT_EQ(count_cohesion(engine).joined, 0u);
  EXPECT_EQ(energies_of(engine).kinetic, energies_of(engine).kinetic + energies_of(engine).adhesive);
  const double before = energies_of(engine).kinetic;
  while (count_cohesion(engine).joined == 0) engine.advance(1);
  while (count_cohesion(engine).joined == 1) engine.advance(10);
  const dem::PullCurve curve = law.curve(wet_radius, wet_radius, wet_thickness);
  const Energies after = energies_of(engine);
  EXPECT_NEAR(after.dissipated_breakage, curve.energy(curve.reach()), 1e-3 * curve.energy(curve.reach()));
  EXPECT_NEAR(before - after.kinetic, curve.energy(curve.reach()), 1e-3 * curve.energy(curve.reach()));
  EXPECT_LT(std::abs(before - after.kinetic - after.dissipated_breakage - after.elastic - after.adhesive),
            1e-6 * before);
}

TEST(Cohesion, FrictionIsCappedByMuTimesTheForceAbovePullOff) {
  // Both disks are held; the right one slides along the other.
  for (const dem::Cohesion& given : all_laws) {
    const dem::Cohesion law = strong(given);
    SCOPED_TRACE(law.word());
    const double overlap = 5e-6, width = 4 * wet_radius - overlap;
    Packing p = box(width, 0.5);
    add(p, {{wet_radius, 0.25}, wet_radius});
    add(p, {{width - wet_radius, 0.25}, wet_radius});
    dem::ContactParameters contact = cohesive(law);
    contact.friction_law = dem::CundallStrack{};
    contact.friction = 0.3;
    Engine engine(p, contact, {});
    set_rough(engine, {true, true, false, false});
    dem::WallDrive slides;
    slides.slide = 0.05;
    set_drives(engine, {dem::WallDrive{}, slides, {}, {}});
    while (time_of(engine) < 2e-4) engine.advance(1);
    const Packing now = packing_of(engine);
    const auto pair = find_contact(now, 0, 1);
    ASSERT_TRUE(pair);
    const double pull = now.cohesive.at(0).pull, elastic = k_pom * now.contacts.overlap[*pair];
    EXPECT_NEAR(now.contacts.fn[*pair], elastic - pull, 1e-9 * elastic);
    EXPECT_GT(pull, 0.1 * elastic);
    EXPECT_NEAR(std::abs(now.contacts.ft[*pair]), 0.3 * elastic, 1e-9 * elastic);
  }
}

struct DrivenBalance {
  double imbalance, work, broken;
  std::size_t joined, fewer;  ///< pairs joined at the end; how many less than there once were
};

/// A sample driven for some contact times, with friction and dashpots.
DrivenBalance driven(const Packing& start, const dem::Cohesion& law, IntegratorKind kind, const ByAnySide<bool>& rough,
                     const dem::WallDrives& drives, int contact_times) {
  constexpr std::int64_t share = 500;
  dem::ContactParameters contact;
  contact.friction = 0.5;
  contact.restitution = 0.5;
  contact.cohesion = strong(law);
  dem::IntegrationParameters how = with_step(shortest_contact_time() / share, kind);
  how.track_energy = true;
  Engine engine(start, contact, how);
  set_rough(engine, rough);
  set_drives(engine, drives);
  const Energies before = energies_of(engine);
  std::size_t most = count_cohesion(engine).joined;
  for (int n = 0; n < contact_times; ++n) {
    engine.advance(share);
    most = std::max(most, count_cohesion(engine).joined);
  }
  const Energies after = energies_of(engine);
  const std::size_t joined = count_cohesion(engine).joined;
  return {stored(after) - stored(before) + lost(after) - lost(before) - after.work_walls + before.work_walls,
          after.work_walls - before.work_walls, after.dissipated_breakage, joined, most - joined};
}

TEST(Cohesion, EnergyIsClosedToAMillionthOfTheWorkWhereGrainsMeet) {
  for (const dem::Cohesion& law : all_laws)
    for (const auto kind : integrators) {
      SCOPED_TRACE(std::string(law.word()) + ", " + name(kind));
      const DrivenBalance b = driven(shaken_lattice(7, 7, 1, false, 1), law, kind, {},
                                     {dem::WallDrive{}, moved(-0.8), moved(1.1), dem::WallDrive{}}, 30);
      EXPECT_GT(b.joined, 60u);
      EXPECT_GT(b.work, 1);
      EXPECT_LT(std::abs(b.imbalance), 1e-6 * b.work);
    }
}

/// Equal disks that just touch.
Packing touching_lattice(int columns, int rows) {
  const double r = 6e-3, pitch = 2 * r - 1e-7;
  Packing p = box(pitch * (columns + 0.5), 2 * r + pitch * std::sqrt(0.75) * (rows - 1));
  for (int row = 0; row < rows; ++row)
    for (int c = 0; c < columns; ++c)
      add(p, {{r + pitch * (c + 0.5 * (row % 2)), r + pitch * std::sqrt(0.75) * row}, r});
  return p;
}

TEST(Cohesion, EnergyIsClosedToAMillionthOfTheWorkWhereGrainsPart) {
  // Drawn by two walls that hold the outermost rows.
  for (const dem::Cohesion& law : all_laws)
    for (const auto kind : integrators) {
      SCOPED_TRACE(std::string(law.word()) + ", " + name(kind));
      const bool breaks = law.word() != std::string(dem::Dmt::word.word);
      const double speed = breaks ? 2 : 0.2;  // adhesion reaches less far
      const DrivenBalance b = driven(touching_lattice(7, 7), law, kind, {false, false, true, true},
                                     {dem::WallDrive{}, {}, {}, moved(speed)}, 60);
      EXPECT_GT(b.fewer, 5u);
      EXPECT_GT(b.work, 1e-3);
      EXPECT_EQ(b.broken > 0.05 * b.work, breaks);
      EXPECT_EQ(b.broken > 0, breaks);
      EXPECT_LT(std::abs(b.imbalance), 1e-6 * b.work);
    }
}

TEST(Cohesion, KeepsMomentumAndAngularMomentum) {
  for (const dem::Cohesion& law : all_laws) {
    SCOPED_TRACE(law.word());
    Packing p = box(1, 1);
    RandomStream random(3, Purpose::test);
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c)
        add(p, {{0.4 + 2.001 * wet_radius * (c + 0.5 * (r % 2)), 0.4 + 2.001 * wet_radius * std::sqrt(0.75) * r},
                wet_radius,
                pom,
                {random.uniform(-1, 1), random.uniform(-1, 1)},
                random.uniform(-200, 200)});
    dem::ContactParameters contact = cohesive(strong(law), 0.5);
    contact.friction_law = dem::CundallStrack{};
    contact.friction = 0.5;
    Engine engine(p, contact, {});
    engine.advance(3000);
    EXPECT_GT(count_cohesion(engine).joined, 0u);
    const double scale = 36 * mass(p, 0) * 1;
    EXPECT_LT(norm(momentum(packing_of(engine)) - momentum(p)), 1e-12 * scale);
    EXPECT_NEAR(angular_momentum(packing_of(engine), {0.43, 0.43}), angular_momentum(p, {0.43, 0.43}),
                1e-12 * scale * 0.06);
  }
}

}  // namespace
}  // namespace arenite::verification
