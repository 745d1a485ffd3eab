#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "elasticity/disk_field.hpp"

namespace arenite::elasticity {
namespace {

constexpr double pi = std::numbers::pi, radius = 6e-3, length = 0.06, load = 500;

Disk diametral(double half_angle = 0, Traction traction = Traction::point) {
  return {radius, length, {{{0, 1}, load, 0, half_angle}, {{0, -1}, load, 0, half_angle}}, traction};
}

/// Forces at random places of the rim; without `balance` their sum is what it is.
Disk random_disk(std::uint64_t seed, Traction traction, bool balance) {
  RandomStream random(seed, Purpose::test);
  Disk disk{radius, length, {}, traction};
  Vec2 total;
  double couple = 0;
  for (int c = 0; c < 4; ++c) {
    const double angle = 2 * pi * (c + 0.5 * random.uniform()) / 4;
    const RimForce f{{std::cos(angle), std::sin(angle)}, load * random.uniform(), 0.3 * load * random.uniform(-1, 1), 0.1};
    disk.forces.push_back(f);
    total += f.fn * f.normal + f.ft * perpendicular(f.normal);
    couple += f.ft;
  }
  if (!balance) return disk;
  // Three more forces along three tangents balance sum and couple.
  for (const double angle : {0.3, 0.3 + 2 * pi / 3, 0.3 + 4 * pi / 3}) {
    const Vec2 n{std::cos(angle), std::sin(angle)};
    disk.forces.push_back({n, 0, -2.0 / 3 * dot(total, perpendicular(n)) - couple / 3, 0.1});
  }
  return disk;
}

/// Stress along the loaded diameter and across it (Michell; Timoshenko and Goodier).
TEST(DiskField, IsTheBrazilianTest) {
  for (const double s : {0.0, 0.2, 0.5, 0.8}) {
    const double across = load / (pi * radius * length) * (1 - 4 / ((1 + s * s) * (1 + s * s)));
    const double sideways = load / (pi * radius * length) * (1 - s * s) * (1 - s * s) / ((1 + s * s) * (1 + s * s));
    const Stress on_x = stress(diametral(), {s * radius, 0});
    EXPECT_NEAR(on_x.yy, across, 1e-9 * std::abs(load / (radius * length)));
    EXPECT_NEAR(on_x.xx, sideways, 1e-9 * load / (radius * length));
    EXPECT_NEAR(on_x.xy, 0, 1e-9 * load / (radius * length));
    const Stress on_y = stress(diametral(), {0, s * radius});
    EXPECT_NEAR(on_y.xx, load / (pi * radius * length), 1e-9 * load / (radius * length));
    EXPECT_NEAR(on_y.yy, load / (pi * radius * length) * (1 - 4 / (1 - s * s)), 1e-8 * load / (radius * length));
  }
  EXPECT_NEAR(sigma_kk(diametral(), {0, 0}), -2 * load / (pi * radius * length), 1e-9 * load / (radius * length));
  EXPECT_NEAR(sigma_kk(diametral(), {radius, 0}), 0, 1e-9 * load / (radius * length));
}

/// Balanced forces leave the rim between them free, whatever their places and directions.
TEST(DiskField, RimIsFree) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Disk disk = random_disk(seed, Traction::point, true);
    for (int k = 0; k < 50; ++k) {
      const double angle = 2 * pi * (k + 0.37) / 50;
      const Vec2 n{std::cos(angle), std::sin(angle)};
      const Stress s = stress(disk, radius * n);
      const double size = std::abs(s.xx) + std::abs(s.yy) + std::abs(s.xy) + load / (radius * length);
      EXPECT_NEAR((s.xx * n.x + s.xy * n.y) / size, 0, 1e-9);
      EXPECT_NEAR((s.xy * n.x + s.yy * n.y) / size, 0, 1e-9);
    }
  }
}

/// A disk that weighs: the rim is free and the divergence of stress is the body force that balances the contacts.
TEST(DiskField, BodyForceBalancesWhatContactsLeave) {
  const Disk disk{radius, length, {{{0, 1}, load, 0}, {{0.6, 0.8}, load, 0.2 * load}, {{-1, 0}, 0, -0.2 * load}}};
  const Vec2 total{0.6 * load - 0.2 * load * 0.8, load + 0.8 * load + 0.2 * load * 0.6 + 0.2 * load};
  const Vec2 x{0.1 * radius, 0.3 * radius};
  const double h = 1e-4 * radius, volume = pi * radius * radius * length;
  const auto at = [&](double dx, double dy) { return stress(disk, x + Vec2{dx, dy}); };
  const double div_x = (at(h, 0).xx - at(-h, 0).xx + at(0, h).xy - at(0, -h).xy) / (2 * h);
  const double div_y = (at(h, 0).xy - at(-h, 0).xy + at(0, h).yy - at(0, -h).yy) / (2 * h);
  EXPECT_NEAR(div_x, total.x / volume, 1e-5 * load / volume);
  EXPECT_NEAR(div_y, total.y / volume, 1e-5 * load / volume);
  for (const double angle : {0.2, 1.0, 2.5, -0.6}) {
    const Vec2 n{std::cos(angle), std::sin(angle)};
    const Stress s = stress(disk, radius * n);
    EXPECT_NEAR(s.xx * n.x + s.xy * n.y, 0, 1e-9 * load / (radius * length));
    EXPECT_NEAR(s.xy * n.x + s.yy * n.y, 0, 1e-9 * load / (radius * length));
  }
}

TEST(DiskField, TraceIsHarmonicAndItsMeanIsTheSumOfNormalForces) {
  for (const Traction traction : {Traction::point, Traction::uniform, Traction::elliptic}) {
    const Disk disk = random_disk(4, traction, false);
    for (const double share : {0.1, 0.5, 0.9}) {
      double mean = 0;
      for (int k = 0; k < 2000; ++k)
        mean += sigma_kk(disk, share * radius * Vec2{std::cos(2 * pi * k / 2000), std::sin(2 * pi * k / 2000)}) / 2000;
      EXPECT_NEAR(mean / mean_sigma_kk(disk), 1, 1e-6) << share;
    }
    const Stress s = stress(disk, {0.4 * radius, -0.3 * radius});
    EXPECT_NEAR((s.xx + s.yy) / sigma_kk(disk, {0.4 * radius, -0.3 * radius}), 1, 1e-9);
  }
  const Disk disk = random_disk(4, Traction::point, false);
  double sum = 0;
  for (const RimForce& f : disk.forces) sum += f.fn;
  EXPECT_NEAR(2 * pi * radius * length * (-0.5 * mean_sigma_kk(disk)) / sum, 1, 1e-12);
}

/// A spread force is many point forces side by side, each with the direction of the whole.
TEST(DiskField, ArcsAreTheLimitOfManyPoints) {
  for (const Traction traction : {Traction::uniform, Traction::elliptic}) {
    const double half = 0.15;
    Disk points{radius, length, {}};
    const int n = 20000;
    double total = 0;
    for (int k = 0; k < n; ++k) {
      const double t = -1 + (k + 0.5) * 2 / n;
      total += traction == Traction::uniform ? 1 : std::sqrt(1 - t * t);
    }
    for (int k = 0; k < n; ++k) {
      const double t = -1 + (k + 0.5) * 2 / n, a = half * t;
      const double share = (traction == Traction::uniform ? 1 : std::sqrt(1 - t * t)) / total;
      // The force keeps its direction (0, 1) while the place turns: normal and tangential parts of it.
      points.forces.push_back({{std::sin(a), std::cos(a)}, share * load * std::cos(a), share * load * std::sin(a)});
    }
    const Disk arc{radius, length, {{{0, 1}, load, 0, half}}, traction};
    for (const double gap : {0.1, 0.5, 2.0, 6.0}) {  // distance from the arc in its half lengths
      const Vec2 x{0.02 * radius, -radius * (1 - gap * half)};
      EXPECT_NEAR(sigma_kk(arc, x) / sigma_kk(points, x), 1, 1e-4) << gap;
    }
  }
}

TEST(DiskField, MeanOverASquareIsTheMeanOfItsPoints) {
  const double side = 1.6e-3;
  for (const Traction traction : {Traction::point, Traction::elliptic}) {
    const Disk disk = random_disk(5, traction, true);
    for (const Vec2 centre : {Vec2{0, 0}, Vec2{0.5 * radius, 0.5 * radius}, Vec2{-0.8 * radius, 0.1 * radius}}) {
      double mean = 0;
      const int n = 160;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          mean += sigma_kk(disk, centre + Vec2{((i + 0.5) / n - 0.5) * side, ((j + 0.5) / n - 0.5) * side}) / (n * n);
      EXPECT_NEAR(square_mean(disk, centre, side), mean, 1e-4 * std::abs(mean_sigma_kk(disk)));
    }
  }
}

/// Squares that tile the plane add up to the whole disk, those cut by the rim and holding a contact point included.
TEST(DiskField, SquaresAddUpToTheDisk) {
  for (const Traction traction : {Traction::point, Traction::uniform}) {
    const Disk disk = random_disk(6, traction, true);
    const double side = 1.6e-3, area = pi * radius * radius;
    double sum = 0;
    for (int i = -5; i <= 5; ++i)
      for (int j = -5; j <= 5; ++j) sum += square_integral(disk, {(i + 0.31) * side, (j - 0.17) * side}, side);
    EXPECT_NEAR(sum / (area * mean_sigma_kk(disk)), 1, 3e-3);
  }
}

TEST(DiskField, ResponseIsTheFieldOfOneNewton) {
  const Disk disk = random_disk(7, Traction::point, false);
  const Vec2 x{0.2 * radius, -0.5 * radius};
  double sum = 0;
  for (const RimForce& f : disk.forces) {
    const Response r = point_response(radius, length, f.normal, x);
    sum += r.fn * f.fn + r.ft * f.ft;
  }
  EXPECT_NEAR(sum / sigma_kk(disk, x), 1, 1e-12);
}

}  // namespace
}  // namespace arenite::elasticity
