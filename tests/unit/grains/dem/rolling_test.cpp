#include <gtest/gtest.h>

#include <cmath>

#include "grains/dem/engine.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

ContactParameters with(const RollingLaw& rolling) {
  ContactParameters contact;
  contact.friction = 0.5;
  contact.rolling = rolling;
  return contact;
}

/// A disk at rest on the floor under gravity of this angle from straight down; its mean acceleration along the floor in
/// a second.
double acceleration_on_slope(const RollingLaw& rolling, double angle) {
  Packing p = testing::empty_container(100, 0.2);
  testing::add_grain(p, 1, 0.01 - 1e-7, 0.01);
  Engine engine(p, with(rolling), {});
  set_gravity(engine, {9.81 * std::sin(angle), -9.81 * std::cos(angle)});
  while (time_of(engine) < 1) engine.advance(1000);
  return 2 * (packing_of(engine).grains.position[0].x - 1) / (time_of(engine) * time_of(engine));
}

TEST(Rolling, FreeDiskRunsDownASlopeWithTwoThirdsOfTheAcceleration) {
  EXPECT_NEAR(acceleration_on_slope(NoRolling{}, 0.1), 9.81 * std::sin(0.1) * 2 / 3, 1e-3);
}

TEST(Rolling, ResistanceSlowsTheDiskByItsMoment) {
  // m a = m g sin - F, I a/r = F r - mu_r r m g cos: a = (2/3) g (sin - mu_r cos).
  const double angle = 0.3, mu = 0.1, a = 2.0 / 3.0 * 9.81 * (std::sin(angle) - mu * std::cos(angle));
  EXPECT_NEAR(acceleration_on_slope(ConstantTorque{mu}, angle), a, 0.005 * a);
  EXPECT_NEAR(acceleration_on_slope(ElasticPlasticRolling{mu, 0.3}, angle), a, 0.005 * a);
}

TEST(Rolling, SpringHoldsADiskOnASlopeBelowItsCoefficient) {
  EXPECT_LT(std::abs(acceleration_on_slope(ElasticPlasticRolling{0.1, 0.3}, std::atan(0.09))), 1e-4);
  EXPECT_GT(acceleration_on_slope(ElasticPlasticRolling{0.1, 0.3}, std::atan(0.12)), 0.01);
}

TEST(Rolling, MomentIsMinusTheGradientOfTheSpringsEnergy) {
  const ElasticPlasticRolling law{0.2, 0};
  const double k = law.stiffness(1e6, 0.005), step = 1e-7;
  Slip<double> turning{0, 0, 1e9, k, 0, 0};
  for (const double angle : {-0.02, 0.001, 0.3}) {
    double memory = angle;
    const double above = law.energy(turning, angle + step), below = law.energy(turning, angle - step);
    EXPECT_NEAR(law.moment(turning, memory), -(above - below) / (2 * step), 1e-6 * std::abs(k * angle));
  }
}

TEST(Rolling, SameBitsOnTwoThreadsAndRestored) {
  const Packing p = testing::crowd(50, 50, 6, 0.0122);
  IntegrationParameters two;
  two.threads = 2;
  const ContactParameters contact = with(ElasticPlasticRolling{0.3, 0.3});
  Engine a(p, contact, {}), b(p, contact, two), c(p, contact, {});
  a.advance(2000);
  b.advance(2000);
  EXPECT_EQ(state_hash(a), state_hash(b));
  restore_sample(c, save_sample(a));
  a.advance(500);
  c.advance(500);
  EXPECT_EQ(state_hash(a), state_hash(c));
}

}  // namespace
}  // namespace arenite::dem
