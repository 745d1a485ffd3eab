// A face-centred crystal of spheres against its closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/engine.hpp"
#include "grains/texture/spheres/spheres.hpp"

namespace arenite::verification {
namespace {

constexpr double stiffness = 1e5, diameter = 2e-3;
constexpr int cells = 4;  // along each axis

/// Of 4 cells^3 spheres whose contacts are shortened by a millionth, strained by exx along x and sheared by gamma,
/// du_x/dy: what the crystal bears against that, Pa.
Numbers stress_of(double exx, double gamma) {
  PackingIn<3> start;
  start.materials = {{"glass", 2500, stiffness}};
  const double side = diameter * (1 - 1e-6) * std::numbers::sqrt2, height = cells * side;
  start.domain.periodic = {true, true, true};
  for (int s = 0; s < 6; ++s) start.domain.wall[s] = {false, s % 2 == 0 ? 0 : height * (s == right ? 1 + exx : 1)};
  start.domain.tilt = gamma * height;
  for (int k = 0; k < cells * cells * cells; ++k)
    for (const Vec3 of : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}}) {
      const Vec3 place = side * (of + Vec3{k % cells + 0.2, k / cells % cells + 0.2, k / cells / cells + 0.2});
      start.grains.resize(start.grains.size() + 1);
      start.grains.radius.back() = diameter / 2;
      start.grains.position.back() = start.domain.wrapped({place.x * (1 + exx) + gamma * place.y, place.y, place.z});
    }
  dem::ContactParameters contact;
  contact.friction = 0;
  const dem::EngineIn<3> engine(start, contact, {});
  const Numbers numbers = texture::measure_spheres(dem::packing_of<3>(engine));
  EXPECT_EQ(numbers["coordination"]["all"]["value"].get<double>(), 12);
  return numbers["stress"]["value"];
}

double part(const Numbers& stress, int a, int b) { return stress[a][b].get<double>(); }

/// Twelve springs k of length d to the nearest: C_11 = sqrt(2) k/d, C_12 = C_44 = C_11/2 (M. Born and K. Huang,
/// Dynamical Theory of Crystal Lattices, 1954).
TEST(SphereCrystal, HasTheModuliOfItsSprings) {
  const double c11 = std::numbers::sqrt2 * stiffness / diameter, strain = 1e-7;
  const Numbers at_rest = stress_of(0, 0), pressed = stress_of(-strain, 0), sheared = stress_of(0, strain);
  const auto rise = [&](const Numbers& now, int a, int b) { return (part(now, a, b) - part(at_rest, a, b)) / strain; };
  EXPECT_NEAR(-rise(pressed, 0, 0) / c11, 1, 1e-4);
  EXPECT_NEAR(-rise(pressed, 1, 1) / (c11 / 2), 1, 1e-4);
  EXPECT_NEAR(-rise(pressed, 2, 2) / (c11 / 2), 1, 1e-4);
  EXPECT_NEAR(rise(sheared, 0, 1) / (c11 / 2), 1, 1e-4);
  EXPECT_NEAR(rise(sheared, 0, 2) / c11, 0, 1e-4);
}

/// A pressure on three edges of its cell compresses it by what its bulk modulus 2 sqrt(2)/3 k/d says.
TEST(SphereCrystal, ComesToRestUnderThePressureAsked) {
  PackingIn<3> start;
  start.materials = {{"glass", 2500, stiffness}};
  const double side = diameter * std::numbers::sqrt2, pressure = 1e4;
  start.domain.periodic = {true, true, true};
  for (int s = 0; s < 6; ++s) start.domain.wall[s] = {false, s % 2 == 0 ? 0 : cells * side};
  for (int k = 0; k < cells * cells * cells; ++k)
    for (const Vec3 of : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}}) {
      start.grains.resize(start.grains.size() + 1);
      start.grains.radius.back() = diameter / 2;
      start.grains.position.back() =
          side * (of + Vec3{k % cells + 0.2, k / cells % cells + 0.2, k / cells / cells + 0.2});
    }
  dem::ContactParameters contact;
  contact.friction = 0;
  dem::EngineIn<3> engine(start, contact, {});
  dem::Stage stage;
  stage.name = "press";
  for (const int s : {right, top, front}) stage.side[s] = {dem::SideDrive::Kind::pressure, pressure};
  stage.equilibrium.unbalanced = 1e-6;
  stage.equilibrium.kinetic = 1e-10;
  engine.begin(stage);
  for (int look = 0; look < 200; ++look) {
    dem::set_drives<3>(engine, dem::drives_for<3>(stage, dem::leg_at(stage, {}, 0, 0, engine.dt), engine.domain));
    engine.advance(200);
  }
  const double bulk = 2 * std::numbers::sqrt2 / 3 * stiffness / diameter;
  const double closed =
      1 - engine.domain.extent(0) * engine.domain.extent(1) * engine.domain.extent(2) / std::pow(cells * side, 3);
  EXPECT_NEAR(closed / (pressure / bulk), 1, 1e-3);
  const Numbers stress = texture::measure_spheres(dem::packing_of<3>(engine))["stress"]["value"];
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(part(stress, axis, axis) / -pressure, 1, 1e-4);
}

}  // namespace
}  // namespace arenite::verification
