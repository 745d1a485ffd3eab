#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/engine.hpp"
#include "grains/fields/steady_state.hpp"

namespace arenite {
namespace {

constexpr double length = 0.01, density = 2500, diameter = 0.01, stiffness = 1e6, pressure = 1e4;
const double mass = density * std::numbers::pi / 4 * diameter * diameter * length;

struct Steady {
  fields::SteadyState mu, phi;
};

/// 400 disks spread by 20 % in a cell without walls at given pressure and inertial number, as in da Cruz et al. 2005: mu = 0.4, e = 0.1, k/P = 1e4.
Steady sheared(double inertial_number, double strain) {
  Packing p;
  p.materials = {{"glass", density, stiffness, 0}};
  p.domain.thickness = length;
  p.domain.periodic_x = p.domain.periodic_y = true;
  p.domain.wall[right].position = p.domain.wall[top].position = 20 * diameter;
  const int n = 19;
  p.grains.resize(n * n);
  double area = 0;
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    const double r = 0.5 * diameter * (0.8 + 0.4 * static_cast<double>((k * 7919) % (n * n)) / (n * n));
    p.grains.radius[k] = r;
    p.grains.x[k] = (static_cast<double>(k % n) + 0.5) * p.domain.width() / n;
    p.grains.y[k] = (static_cast<double>(k / n) + 0.5) * p.domain.height() / n;
    area += std::numbers::pi * r * r;
  }
  dem::ContactParameters contact;
  contact.friction = 0.4;
  contact.restitution = 0.1;
  contact.tangential_stiffness_ratio = 0.5;
  dem::Engine engine(p, contact, {});
  engine.set_inertial_number(0.1);
  dem::WallDrives drives;
  drives[top] = {dem::WallDrive::Kind::force, pressure * p.domain.width() * length};
  engine.set_drives(drives);
  const double rate = inertial_number / std::sqrt(mass / (pressure * length));
  engine.set_shear_rate(rate);
  std::vector<double> mu, phi;
  while (engine.shear_strain() < strain) {
    engine.advance(200);
    const Domain& now = engine.domain();
    mu.push_back(std::abs(now.wall[top].shear_force) / drives[top].value);
    phi.push_back(area / now.area());
  }
  return {fields::find_steady_state(mu), fields::find_steady_state(phi)};
}

// Their mu(I) begins at 0.26 +- 0.02 and rises by about I, their phi(I) falls from 0.81 by about 0.3 I; cells of 361 grains scatter by 0.02.
TEST(Rheology, FrictionAndSolidFractionOfDisksAreThePublishedOnes) {
  const Steady slow = sheared(0.02, 4), quick = sheared(0.1, 12);
  EXPECT_NEAR(slow.mu.mean.value, 0.29, 0.035);
  EXPECT_NEAR(quick.mu.mean.value, 0.38, 0.04);
  EXPECT_NEAR(slow.phi.mean.value, 0.805, 0.015);
  EXPECT_NEAR(quick.phi.mean.value, 0.78, 0.015);
  EXPECT_GT(quick.mu.mean.value - slow.mu.mean.value, 3 * (slow.mu.mean.error + quick.mu.mean.error));
  EXPECT_GT(slow.phi.mean.value - quick.phi.mean.value, 0.01);
}

}  // namespace
}  // namespace arenite
