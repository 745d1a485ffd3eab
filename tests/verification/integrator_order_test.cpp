#include <gtest/gtest.h>

#include <functional>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::IntegratorKind;

constexpr double ball_radius = 6.2e-3;

/// Errors in phase space, hypot(x, v/omega), after a fixed time with n, 2n and 4n steps.
struct Convergence {
  double error[3];
  double order(int i) const { return std::log2(error[i] / error[i + 1]); }
};

Convergence converge(const Packing& start, const dem::ContactParameters& law, IntegratorKind kind, double end, int n,
                     double g, const std::function<Vec2(const Packing&)>& error) {
  Convergence c{};
  for (int level = 0; level < 3; ++level) {
    const int steps = n << level;
    Engine engine(start, law, with_step(end / steps, kind));
    set_gravity(engine, {0, -g});
    engine.advance(steps);
    c.error[level] = norm(error(packing_of(engine)));
  }
  return c;
}

/// Velocity Verlet and leapfrog are of second order; of Gear's it is the observed order that is held here.
double least_order(IntegratorKind kind) { return kind == IntegratorKind::gear5 ? 4.6 : 1.9; }

void expect_convergence(const Convergence& c, double order, double finest, IntegratorKind kind) {
  for (int i = 0; i < 2; ++i)
    EXPECT_GT(c.order(i), order) << name(kind) << ", errors " << c.error[i] << " " << c.error[i + 1];
  EXPECT_LT(c.error[2], finest) << name(kind);
}

/// One disk that never leaves the bottom wall under a strong gravity, started at rest above its resting overlap.
struct OnTheWall {
  Packing start = box(1, 1);
  double g = 1e5, omega, rest, amplitude;
  OnTheWall() {
    add(start, {{0.5, ball_radius}, ball_radius});
    omega = std::sqrt(k_pom / mass(start, 0));
    rest = ball_radius - g / (omega * omega);
    amplitude = 0.4 * (ball_radius - rest);
    start.grains.position[0].y = rest + amplitude;
  }
  /// Errors against the damped oscillation with share zeta of the critical damping; velocity over omega.
  Vec2 error(const Packing& p, double zeta, double t) const {
    const double s = std::sqrt(1 - zeta * zeta), phase = omega * s * t, decay = std::exp(-zeta * omega * t);
    const double y = amplitude * decay * (std::cos(phase) + zeta / s * std::sin(phase));
    const double v = -amplitude * omega / s * decay * std::sin(phase);
    return {(p.grains.position[0].y - rest - y) / amplitude, (p.grains.velocity[0].y - v) / (amplitude * omega)};
  }
};

TEST(IntegratorOrder, UndampedOscillationConvergesWithTheStepSquaredOrBetter) {
  const OnTheWall disk;
  const double end = 2.3 * 2 * pi / disk.omega;
  for (const auto kind : integrators) {
    const Convergence c = converge(disk.start, elastic(), kind, end, 150, disk.g,
                                   [&](const Packing& p) { return disk.error(p, 0, end); });
    expect_convergence(c, least_order(kind), 0.02, kind);
  }
}

TEST(IntegratorOrder, DampingLowersItForLeapfrogOnly) {
  // Leapfrog gives the forces the velocity of half a step ago: first order in the damping.
  const OnTheWall disk;
  const double zeta = 0.2, end = 1.3 * 2 * pi / disk.omega;
  dem::ContactParameters law = elastic();
  law.normal_damping = 2 * zeta * std::sqrt(k_pom * mass(disk.start, 0));
  for (const auto kind : integrators) {
    const Convergence c =
        converge(disk.start, law, kind, end, 200, disk.g, [&](const Packing& p) { return disk.error(p, zeta, end); });
    expect_convergence(c, kind == IntegratorKind::leapfrog ? 0.95 : least_order(kind), 0.01, kind);
  }
}

/// y'' = f(y, v) by classical Runge-Kutta.
Vec2 runge_kutta(Vec2 state, double end, int steps, const std::function<double(double, double)>& f) {
  const double dt = end / steps;
  const auto rate = [&](Vec2 s) { return Vec2{s.y, f(s.x, s.y)}; };
  for (int i = 0; i < steps; ++i) {
    const Vec2 a = rate(state), b = rate(state + 0.5 * dt * a), c = rate(state + 0.5 * dt * b),
               d = rate(state + dt * c);
    state += dt / 6 * (a + 2 * b + 2 * c + d);
  }
  return state;
}

TEST(IntegratorOrder, HoldsForTheNonlinearGluedPair) {
  constexpr double gamma = 1.060e6;
  Packing p = box(1, 1);
  const double r_eff = 2 * ball_radius, h_eq = r_eff * gamma * gamma / (k_pom * k_pom), h0 = 0.7 * h_eq;
  add(p, {{0.5, 0.5}, ball_radius, pom, {}, 0, 1});
  add(p, {{0.5 + 2 * ball_radius - h0, 0.5}, ball_radius, pom, {}, 0, 1});
  dem::ContactParameters law = elastic();
  law.adhesion = dem::GeometricalAdhesion{};
  law.surface_energy = gamma;
  const double m = 0.5 * mass(p, 0), end = 2.3 * 2 * pi / std::sqrt(0.5 * k_pom / m);
  const Vec2 exact = runge_kutta({h0, 0}, end, 40000,
                                 [&](double h, double) { return -(k_pom * h - gamma * std::sqrt(r_eff * h)) / m; });
  for (const auto kind : integrators) {
    const Convergence c = converge(p, law, kind, end, 150, 0, [&](const Packing& now) {
      const double h = 2 * ball_radius - (now.grains.position[1].x - now.grains.position[0].x);
      return Vec2{(h - exact.x) / h_eq,
                  (now.grains.velocity[0].x - now.grains.velocity[1].x - exact.y) / (h_eq * std::sqrt(k_pom / m))};
    });
    expect_convergence(c, least_order(kind), 0.01, kind);
  }
}

TEST(IntegratorOrder, HoldsForHertz) {
  Packing p = box(1, 1);
  const double h0 = 2e-5;
  add(p, {{0.5, ball_radius - h0}, ball_radius});
  dem::ContactParameters law = elastic();
  law.normal = dem::Hertz{};
  const double k_hertz = packing_of(Engine(p, law, with_step(1e-8))).contacts.fn.at(0) / std::pow(h0, 1.5);
  const double m = mass(p, 0), g = 0.7 * k_hertz * std::pow(h0, 1.5) / m;
  const double period = 2 * pi / std::sqrt(1.5 * k_hertz * std::sqrt(h0) / m);
  const double end = 2.3 * period;
  const Vec2 exact =
      runge_kutta({h0, 0}, end, 40000, [&](double h, double) { return g - k_hertz / m * std::pow(h, 1.5); });
  for (const auto kind : integrators) {
    const Convergence c = converge(p, law, kind, end, 300, g, [&](const Packing& now) {
      return Vec2{(ball_radius - now.grains.position[0].y - exact.x) / h0,
                  (-now.grains.velocity[0].y - exact.y) * period / h0};
    });
    expect_convergence(c, least_order(kind), 0.01, kind);
  }
}

TEST(IntegratorOrder, GlobalDragDecaysExponentially) {
  Packing p = box(1, 1);
  const double rate = 2e4, speed = 2, end = 4 / rate;
  add(p, {{0.5, 0.5}, ball_radius, pom, {0, speed}});
  const double distance = speed / rate * (1 - std::exp(-rate * end));
  for (const auto kind : integrators) {
    Convergence c{};
    for (int level = 0; level < 3; ++level) {
      const int steps = 100 << level;
      dem::IntegrationParameters how = with_step(end / steps, kind);
      how.drag = rate;
      Engine engine(p, elastic(), how);
      engine.advance(steps);
      c.error[level] = std::abs(packing_of(engine).grains.position[0].y - 0.5 - distance) / distance;
    }
    expect_convergence(c, kind == IntegratorKind::leapfrog ? 0.95 : least_order(kind), 1e-2, kind);
  }
}

}  // namespace
}  // namespace arenite::verification
