#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::FrictionLaw;

/// How a setting maps under a rigid motion of the plane that keeps the frame's axes.
struct Motion {
  const char* name;
  std::function<Vec2(Vec2, double width, double height)> point;
  std::function<Vec2(Vec2)> vector;
  double turning;               ///< sign of rotations
  std::array<int, 4> to;        ///< where each wall goes
  std::array<double, 4> speed;  ///< sign of each wall's velocity there
  bool swaps_axes;
};

const Motion mirror{"mirrored left to right",
                    [](Vec2 p, double w, double) {
                      return Vec2{w - p.x, p.y};
                    },
                    [](Vec2 v) {
                      return Vec2{-v.x, v.y};
                    },
                    -1,
                    {right, left, bottom, top},
                    {-1, -1, 1, 1},
                    false};
const Motion quarter_turn{"turned by a quarter",
                          [](Vec2 p, double, double h) {
                            return Vec2{h - p.y, p.x};
                          },
                          [](Vec2 v) { return perpendicular(v); },
                          1,
                          {bottom, top, right, left},
                          {1, 1, -1, -1},
                          true};

Packing moved_by(const Motion& motion, Packing p) {
  const double w = p.domain.width(), h = p.domain.height();
  for (std::size_t i = 0; i < p.grains.size(); ++i) {
    const Vec2 x = motion.point(p.grains.position[i], w, h), v = motion.vector(velocity(p, i));
    p.grains.position[i] = x;
    p.grains.velocity[i] = v;
    p.grains.omega[i] *= motion.turning;
  }
  if (motion.swaps_axes) {
    p.domain.wall[right].position = h;
    p.domain.wall[top].position = w;
  }
  return p;
}

const dem::WallDrives drives{moved(0.7), pressed(800), moved(1.5), pressed(500)};

Packing run(const Packing& start, const dem::ContactParameters& law, const dem::WallDrives& how, Vec2 g,
            dem::IntegratorKind kind, std::int64_t steps = 4000) {
  Engine engine(start, law, with_step(shortest_contact_time() / 100, kind));
  set_drives(engine, how);
  set_gravity(engine, g);
  engine.advance(steps);
  return packing_of(engine);
}

dem::ContactParameters with(FrictionLaw friction) {
  dem::ContactParameters law;
  law.friction_law = friction;
  law.restitution = 0.5;
  law.attractive_dashpot = true;
  law.adhesion = dem::GeometricalAdhesion{};
  law.surface_energy = 0.2e6;
  return law;
}

Packing sample(bool periodic = false) {
  Packing p = shaken_lattice(7, 5, 11, periodic, 0.3);
  for (std::size_t i = 0; i < p.grains.size(); i += 4) p.grains.zone[i] = 1;
  return p;
}

TEST(Symmetry, MovedSamplesGiveMovedResults) {
  // Rounding of 1e-16 grows by the collisions, 4000 steps leave it a margin.
  for (const Motion& motion : {mirror, quarter_turn})
    for (const dem::FrictionLaw& friction :
         std::initializer_list<dem::FrictionLaw>{dem::RegularisedCoulomb{}, dem::CundallStrack{}})
      for (const auto kind : integrators) {
        SCOPED_TRACE(std::string(motion.name) + ", " + name(kind));
        const Packing start = sample();
        const Vec2 g{500, -2000};
        dem::WallDrives there;
        for (std::size_t side = 0; side < 4; ++side) {
          dem::WallDrive drive = drives[side];
          if (drive.kind == dem::WallDrive::Kind::velocity) drive.value *= motion.speed[side];
          there[static_cast<std::size_t>(motion.to[side])] = drive;
        }
        const Packing plain = run(start, with(friction), drives, g, kind);
        const Packing moved_run = run(moved_by(motion, start), with(friction), there, motion.vector(g), kind);
        EXPECT_EQ(plain.contacts.size(), moved_run.contacts.size());
        EXPECT_GT(plain.contacts.size(), 30u);
        const double w = start.domain.width(), h = start.domain.height();
        for (std::size_t i = 0; i < plain.grains.size(); ++i) {
          const Vec2 expected = motion.point(plain.grains.position[i], w, h);
          EXPECT_LT(norm(moved_run.grains.position[i] - expected), 1e-9 * 6e-3);
          EXPECT_NEAR(moved_run.grains.angle[i], motion.turning * plain.grains.angle[i], 1e-9);
        }
        for (std::size_t side = 0; side < 4; ++side) {
          const Wall& a = plain.domain.wall[side];
          const Wall& b = moved_run.domain.wall[static_cast<std::size_t>(motion.to[side])];
          EXPECT_NEAR(b.force, a.force, 1e-7 * 800);
        }
      }
}

TEST(Symmetry, RenumberedGrainsGetTheSameForcesAndPaths) {
  const Packing start = sample();
  const std::size_t n = start.grains.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  RandomStream random(3, Purpose::test);
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  Packing shuffled = start;
  shuffled.grains = {};
  for (const std::size_t i : order) {
    const Grains& g = start.grains;
    add(shuffled, {g.position[i], g.radius[i], g.material[i], g.velocity[i], g.omega[i], g.zone[i]});
  }
  for (const dem::FrictionLaw& friction :
       std::initializer_list<dem::FrictionLaw>{dem::RegularisedCoulomb{}, dem::CundallStrack{}}) {
    const Packing a = run(start, with(friction), drives, {0, -2000}, dem::IntegratorKind::velocity_verlet);
    const Packing b = run(shuffled, with(friction), drives, {0, -2000}, dem::IntegratorKind::velocity_verlet);
    ASSERT_EQ(a.contacts.size(), b.contacts.size());
    for (std::size_t s = 0; s < n; ++s)
      EXPECT_LT(norm(b.grains.position[s] - a.grains.position[order[s]]), 1e-9 * 6e-3);
    for (std::size_t c = 0; c < b.contacts.size(); ++c) {
      const auto grain = [&](std::int32_t k) {
        return k < 0 ? k : static_cast<std::int32_t>(order[static_cast<std::size_t>(k)]);
      };
      const auto same = find_contact(a, grain(b.contacts.i[c]), grain(b.contacts.j[c]));
      ASSERT_TRUE(same.has_value());
      EXPECT_NEAR(b.contacts.fn[c], a.contacts.fn[*same], 1e-6);
      EXPECT_NEAR(b.contacts.ft[c], a.contacts.ft[*same], 1e-6);
    }
  }
}

TEST(Symmetry, ResultsComeBackInTheCallersOrderWithTheirNames) {
  Packing start = sample();
  for (std::size_t i = 0; i < start.grains.size(); ++i) start.grains.id[i] = 1000 - static_cast<std::int64_t>(7 * i);
  const Packing end = run(start, with(dem::RegularisedCoulomb{}), drives, {}, dem::IntegratorKind::leapfrog);
  EXPECT_EQ(end.grains.id, start.grains.id);
  EXPECT_EQ(end.grains.radius, start.grains.radius);
  EXPECT_EQ(end.grains.material, start.grains.material);
  EXPECT_EQ(end.grains.zone, start.grains.zone);
  for (std::size_t c = 1; c < end.contacts.size(); ++c)
    EXPECT_LT(std::pair(end.contacts.i[c - 1], end.contacts.j[c - 1]), std::pair(end.contacts.i[c], end.contacts.j[c]));
}

TEST(Symmetry, APeriodicCellDoesNotKnowWhereItsEdgesAre) {
  const Packing start = sample(true);
  Packing shifted = start;
  const double w = start.domain.width(), h = start.domain.height();
  for (std::size_t i = 0; i < start.grains.size(); ++i) {
    shifted.grains.position[i] = {std::fmod(start.grains.position[i].x + 0.37 * w, w),
                                  std::fmod(start.grains.position[i].y + 0.61 * h, h)};
  }
  const dem::WallDrives none{};
  const Packing a = run(start, with(dem::CundallStrack{}), none, {}, dem::IntegratorKind::velocity_verlet);
  const Packing b = run(shifted, with(dem::CundallStrack{}), none, {}, dem::IntegratorKind::velocity_verlet);
  EXPECT_EQ(a.contacts.size(), b.contacts.size());
  EXPECT_GT(a.contacts.size(), 10u);
  for (std::size_t i = 0; i < a.grains.size(); ++i) {
    const Vec2 d = b.grains.position[i] - a.grains.position[i] - Vec2{0.37 * w, 0.61 * h};
    EXPECT_LT(norm(a.domain.nearest_image(d)), 1e-9 * 6e-3);
  }
}

TEST(Symmetry, AUniformMotionThroughThePeriodicEdgesChangesNothing) {
  Packing start = sample(true);
  for (double& r : start.grains.radius) r *= 1.01;  // contacts that last, with their springs, cross the edges
  Packing drifting = start;
  const Vec2 drift{25, -80};  // m/s: a good part of the cell during the run
  for (std::size_t i = 0; i < start.grains.size(); ++i) {
    drifting.grains.velocity[i].x += drift.x;
    drifting.grains.velocity[i].y += drift.y;
  }
  const dem::WallDrives none{};
  const std::int64_t steps = 10000;
  const Packing a = run(start, with(dem::CundallStrack{}), none, {}, dem::IntegratorKind::leapfrog, steps);
  const Packing b = run(drifting, with(dem::CundallStrack{}), none, {}, dem::IntegratorKind::leapfrog, steps);
  const double t = static_cast<double>(steps) * shortest_contact_time() / 100;
  EXPECT_GT(-drift.y * t, 0.4 * a.domain.height());
  for (std::size_t i = 0; i < a.grains.size(); ++i) {
    const Vec2 d = b.grains.position[i] - a.grains.position[i] - t * drift;
    EXPECT_LT(norm(a.domain.nearest_image(d)), 1e-8 * 6e-3);
  }
}

TEST(Symmetry, ACellTiltedByItsWholeWidthIsTheUprightOne) {
  const Packing start = sample(true);
  Packing tilted = start;
  tilted.domain.tilt = start.domain.width();
  const dem::WallDrives none{};
  const Packing a = run(start, with(dem::CundallStrack{}), none, {}, dem::IntegratorKind::velocity_verlet);
  const Packing b = run(tilted, with(dem::CundallStrack{}), none, {}, dem::IntegratorKind::velocity_verlet);
  EXPECT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t i = 0; i < a.grains.size(); ++i)
    EXPECT_LT(norm(a.domain.nearest_image(b.grains.position[i] - a.grains.position[i])), 1e-9 * 6e-3);
}

}  // namespace
}  // namespace arenite::verification
