#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/engine.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

struct Swing {
  const char* name;
  IntegratorKind integrator;
  double damping;      ///< share of the critical
  double least_order;  ///< of position and velocity after half a period
};

/// One disk squeezed between two walls swings as x'' = -2 (k/m) x - 2 (alpha/m) x' for ever.
double error_of(const Swing& c, int steps) {
  const double r = 0.005, k = 27.35e6, amplitude = 1e-6;
  Packing p = testing::empty_container(2 * r - 1e-5, 0.1);
  testing::add_grain(p, 0.5 * p.domain.width() + amplitude, 0.05, r);
  const double m = 1410 * std::numbers::pi * r * r * 0.06;
  const double omega = std::sqrt(2 * k / m), decay = c.damping * omega;
  const double turn = std::sqrt(omega * omega - decay * decay), end = std::numbers::pi / omega;
  ContactParameters contact;
  contact.friction_law = dem::NoFriction{};
  contact.attractive_dashpot = true;  // the closed form is of a dashpot that may pull
  contact.wall_stiffness = WallStiffness::grain;
  contact.normal_damping = decay * m;
  IntegrationParameters integration;
  integration.integrator = c.integrator;
  integration.time_step = end / steps;
  Engine engine(p, contact, integration);
  engine.advance(steps);
  const Packing after = packing_of(engine);
  const double fall = std::exp(-decay * end);
  const double x = amplitude * fall * (std::cos(turn * end) + decay / turn * std::sin(turn * end));
  const double v = -amplitude * fall * omega * omega / turn * std::sin(turn * end);
  const double ex = after.grains.position[0].x - 0.5 * p.domain.width() - x,
               ev = (after.grains.velocity[0].x - v) / omega;
  return std::hypot(ex, ev) / amplitude;
}

class Integrators : public ::testing::TestWithParam<Swing> {};

TEST_P(Integrators, ConvergeAtTheirOrderOnAContactThatSwings) {
  const Swing c = GetParam();
  const double coarse = error_of(c, 60), fine = error_of(c, 120);
  const double order = std::log2(coarse / fine);
  RecordProperty("order", std::to_string(order));
  EXPECT_GT(order, c.least_order) << coarse << " " << fine;
  EXPECT_LT(order, c.least_order + 1.7) << coarse << " " << fine;
}

INSTANTIATE_TEST_SUITE_P(All, Integrators,
                         ::testing::Values(Swing{"verlet", IntegratorKind::velocity_verlet, 0, 1.9},
                                           Swing{"verlet_damped", IntegratorKind::velocity_verlet, 0.05, 1.9},
                                           Swing{"leapfrog", IntegratorKind::leapfrog, 0, 1.9},
                                           Swing{"leapfrog_damped", IntegratorKind::leapfrog, 0.05, 0.9},
                                           Swing{"gear", IntegratorKind::gear5, 0, 3.9},
                                           Swing{"gear_damped", IntegratorKind::gear5, 0.05, 3.9}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace arenite::dem
