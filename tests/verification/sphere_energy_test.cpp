// The account of energy of spheres, and what attracts them across a gap.
#include "balance.hpp"
#include "core/error.hpp"
#include "spheres.hpp"

namespace arenite::verification {
namespace {

constexpr IntegratorKind schemes[] = {IntegratorKind::velocity_verlet, IntegratorKind::gear5};

/// Spheres that fly about between walls which close in on them.
struct Shaken : Spheres {
  SampleIn<3> s;
  explicit Shaken(IntegratorKind scheme) : Spheres(1e7) {
    const auto share = [](int k, double by) { return std::fmod(k * by, 1.0) - 0.5; };
    for (int k = 0; k < 64; ++k)
      add(0.0121 + 0.0004 * share(k, 0.37), 0.025 * Vec3{k % 4 + 0.5, k / 4 % 4 + 0.5, k / 16 + 0.5},
          2.0 * Vec3{share(k, 0.7548), share(k, 0.5698), share(k, 0.4302)},
          100.0 * Vec3{share(k, 0.221), share(k, 0.531), share(k, 0.819)});
    contact.friction_law = CundallStrack{};
    contact.restitution = 0.5;
    integration.integrator = scheme;
    integration.track_energy = true;
    integration.safety = 1.0 / 500;
  }
  /// What the balance lacks over the work of the walls.
  double run(int contact_times, double speed = 1) {
    s = sample();
    WallDrivesIn<3> drives{};
    drives[right] = {DriveKind::velocity, -speed, {}};
    drives[bottom] = {DriveKind::velocity, 0.8 * speed, {}};
    drives[front] = {DriveKind::fixed, 0, {0.3 * speed, 0.2 * speed, 0}};
    for (int side = 0; side < 6; ++side)
      if (s.domain.is_periodic(side)) drives[side] = {};
    set_drives(s, drives);
    const Energies before = energies_of(s);
    advance(s, ThreadPool(), 500 * contact_times);
    after = energies_of(s);
    return std::abs(imbalance(before, after)) / std::max(std::abs(after.work_walls), 0.01 * before.kinetic);
  }
  Energies after;
};

TEST(SphereEnergy, IsClosedForWhatDissipatesAndWhatDrives) {
  for (const auto scheme : schemes)
    for (const bool rolls : {false, true}) {
      SCOPED_TRACE(static_cast<int>(scheme) * 10 + rolls);
      Shaken c(scheme);
      if (rolls) c.contact.rolling = ElasticPlasticRolling{0.2, 0.3, 0.1};
      else c.integration.drag = 10;
      EXPECT_LT(c.run(12), 1e-5);
      EXPECT_GT(c.after.work_walls, 0.1);
      EXPECT_GT(c.after.dissipated_normal, 0.01 * c.after.work_walls);
      EXPECT_GT(c.after.dissipated_friction, 0.01 * c.after.work_walls);
      EXPECT_EQ(c.after.dissipated_drag > 0, !rolls);
    }
}

/// A sheared cell under a pressure: its edges do work, and its servo is damped.
TEST(SphereEnergy, IsClosedInACellThatIsShearedAndPressed) {
  Shaken c(IntegratorKind::velocity_verlet);
  c.start.domain.periodic = {true, true, true};
  c.contact.rolling = ConstantTorque{0.1, 0.1};
  c.s = c.sample();
  WallDrivesIn<3> drives{};
  drives[right] = drives[top] = drives[front] = {DriveKind::force, 200, {}};
  set_drives(c.s, drives);
  set_shear_rate(c.s, 10);
  const Energies before = energies_of(c.s);
  advance(c.s, ThreadPool(), 10000);
  const Energies after = energies_of(c.s);
  EXPECT_GT(std::abs(after.work_walls), 0.01);
  EXPECT_LT(std::abs(imbalance(before, after)), 1e-4 * before.kinetic);
}

/// Spheres that a rough wall carries upwards: what lifts them is no work on the sample, nor does their drag brake it.
TEST(SphereEnergy, IsClosedWhereARoughWallCarriesGrainsUpwards) {
  Shaken c(IntegratorKind::velocity_verlet);
  c.integration.drag = 10;
  c.s = c.sample();
  set_gravity(c.s, {0, -2000, 0});
  ByAnySide<bool> rough{};
  rough[bottom] = true;
  set_rough(c.s, rough, ThreadPool());
  WallDrivesIn<3> drives{};
  drives[bottom] = {DriveKind::velocity, 1, {}};
  set_drives(c.s, drives);
  const Energies before = energies_of(c.s);
  advance(c.s, ThreadPool(), 10000);
  const Energies after = energies_of(c.s);
  EXPECT_GT(after.dissipated_drag, 0.01);
  EXPECT_LT(std::abs(imbalance(before, after)), 1e-5 * std::abs(after.work_walls));
}

Cohesion water(double angle) {
  CapillarySpheres law;
  law.contact_angle = angle;
  law.volume = 2e-9;
  return law;
}

/// Two spheres that fly apart from a touch lose the work of what pulls them, which ends at its reach.
TEST(SphereCohesion, ABridgePullsAndBreaksByItsClosedForm) {
  for (const double angle : {0.0, 0.6}) {
    Spheres box(1e6);
    const double r = 0.005, apart = 1e-9;
    box.add(r, {0.05, 0.05, 0.05}, {0, 0.1, 0});
    box.add(r, {0.05, 0.05 - 2 * r + apart, 0.05}, {0, -0.1, 0});
    box.contact.cohesion = water(angle);
    box.contact.restitution = 1;
    box.integration.track_energy = true;
    box.integration.time_step = 1e-6;
    SampleIn<3> s = box.sample();
    const double gamma = 0.0728, volume = 2e-9, reach = (1 + angle / 2) * std::cbrt(volume);
    const double most = 2 * std::numbers::pi * r * gamma * std::cos(angle);
    ASSERT_EQ(count_cohesion(s).joined, 1U);
    EXPECT_NEAR(packing_of(s).cohesive.at(0).pull, most, 1e-4 * most) << "pull-off";
    const Energies before = energies_of(s);
    double last = 0;
    while (count_cohesion(s).joined == 1 && s.step < 100000) {
      advance(s, ThreadPool(), 5);
      const PackingIn<3> now = packing_of(s);
      if (now.cohesive.empty()) break;
      const double gap = last = now.cohesive[0].gap, x = gap * std::sqrt(r / volume);
      EXPECT_NEAR(now.cohesive[0].pull, gap > 0 ? most / (1 + 1.05 * x + 2.5 * x * x) : most, 1e-9 * most);
    }
    EXPECT_NEAR(last, reach, 0.01 * reach) << "rupture distance";
    const Energies after = energies_of(s);
    EXPECT_GT(after.dissipated_breakage, 0);
    EXPECT_LT(std::abs(imbalance(before, after)), 1e-5 * before.kinetic);
  }
}

/// The strongest net pull of a pair that is drawn apart is 2 pi w R, and it ends at the range.
TEST(SphereCohesion, DmtPullsOffAtTwoPiWR) {
  const double r = 0.005, w = 20, range = 1e-5, most = 2 * std::numbers::pi * w * r / 2;
  Spheres box(1e6);
  box.add(r, {0.05, 0.05 + 2 * r - 1e-7, 0.05});
  box.add(r, {0.05, 0.05, 0.05});
  box.contact.cohesion = Dmt{w, range};
  SampleIn<3> s = box.sample();
  double strongest = 0;
  for (int n = -40; n <= 44; ++n) {
    const double gap = 0.025 * n * range;
    const std::size_t upper = s.record[0].place.y > s.record[1].place.y ? 0 : 1;
    s.record[upper].place.y = s.record[1 - upper].place.y + 2 * r + gap;
    compute_forces(s);
    const double pull = -contact_load(slot_forces(s.list), upper).force.y;
    EXPECT_NEAR(pull, gap < 0 ? most + 1e6 * gap : most * std::max(1 - gap / range, 0.0), 1e-8 * most) << gap;
    strongest = std::max(strongest, pull);
  }
  EXPECT_NEAR(strongest, most, 1e-9 * most);
  EXPECT_EQ(count_cohesion(s).joined, 0U) << "rupture distance";
}

TEST(SphereCohesion, DisksOwnBridgesAreRefused) {
  Spheres box;
  box.add(0.01, {0.05, 0.05, 0.05});
  box.contact.cohesion = CapillaryDisks{};
  EXPECT_THROW(box.sample(), InputError);
}

/// Attraction is part of an energy balance that closes.
TEST(SphereCohesion, ACrowdThatClingsClosesItsBalance) {
  for (const Cohesion& law : {Cohesion(Dmt{20, 1e-4}), [] {
                                CapillarySpheres wet;
                                wet.surface_tension = 100, wet.volume = 1e-8;
                                return Cohesion(wet);
                              }()}) {
    Shaken c(IntegratorKind::velocity_verlet);
    c.contact.cohesion = law;
    EXPECT_LT(c.run(12), 1e-5);
    EXPECT_GT(count_cohesion(c.s).joined, 20U);
    EXPECT_NE(c.after.adhesive, 0);
  }
}

}  // namespace
}  // namespace arenite::verification
