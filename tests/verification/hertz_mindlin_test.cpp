#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/error.hpp"
#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;

constexpr double glass_modulus = 70e9, glass_poisson = 0.22, rubber_modulus = 0.5e9, rubber_poisson = 0.45;
constexpr std::int32_t glass = 0, rubber = 1;

Packing elastic_box() {
  Packing p = box(1, 1);
  p.materials = {{"glass", 2500}, {"rubber", 1100}};
  p.materials[glass].youngs_modulus = glass_modulus;
  p.materials[glass].poisson = glass_poisson;
  p.materials[rubber].youngs_modulus = rubber_modulus;
  p.materials[rubber].poisson = rubber_poisson;
  return p;
}

double modulus(const Packing& p, std::int32_t m) { return *p.materials[static_cast<std::size_t>(m)].youngs_modulus; }
double poisson(const Packing& p, std::int32_t m) { return *p.materials[static_cast<std::size_t>(m)].poisson; }
double compliance(const Packing& p, std::int32_t m) { return (1 - poisson(p, m) * poisson(p, m)) / modulus(p, m); }
double shear_compliance(const Packing& p, std::int32_t m) {
  return 2 * (2 - poisson(p, m)) * (1 + poisson(p, m)) / modulus(p, m);
}

dem::ContactParameters mindlin(double restitution) {
  dem::ContactParameters law = frictionless(restitution);
  law.normal = dem::HertzMindlin{};
  return law;
}

Packing pressed_pair(std::int32_t a, std::int32_t b, double ra, double rb, double overlap) {
  Packing p = elastic_box();
  add(p, {{0.5, 0.5}, ra, a});
  add(p, {{0.5 + ra + rb - overlap, 0.5}, rb, b});
  return p;
}

TEST(HertzMindlin, ForceOfTwoSpheresIsThatOfTheirModuli) {
  for (const auto& [a, b] : {std::pair{glass, glass}, {glass, rubber}, {rubber, rubber}})
    for (const double rb : {2e-3, 5e-3})
      for (const double h : {1e-7, 1e-5}) {
        const double ra = 2e-3, r = reduced(ra, rb);
        const Packing p = pressed_pair(a, b, ra, rb, h), now = packing_of(Engine(p, mindlin(1), with_step(1e-9)));
        const double e = 1 / (compliance(p, a) + compliance(p, b)), overlap = now.contacts.overlap.at(0);
        EXPECT_NEAR(now.contacts.fn.at(0) / (4.0 / 3 * e * std::sqrt(r) * std::pow(overlap, 1.5)), 1, 1e-12);
      }
}

TEST(HertzMindlin, AWallIsARigidPlane) {
  Packing p = elastic_box();
  const double r = 3e-3, h = 2e-6;
  add(p, {{r - h, 0.5}, r, rubber});
  const Packing now = packing_of(Engine(p, mindlin(1), with_step(1e-9)));
  EXPECT_NEAR(now.contacts.fn.at(0) * compliance(p, rubber) /
                  (4.0 / 3 * std::sqrt(r) * std::pow(now.contacts.overlap.at(0), 1.5)),
              1, 1e-12);
}

/// Two spheres that meet head on: restitution, time of contact, largest force and overlap.
struct Outcome {
  double restitution = 0, duration = 0, deepest = 0;
};
Outcome collide(const dem::ContactParameters& law, std::int32_t a, std::int32_t b, double speed, double dt) {
  const double ra = 2e-3, rb = 5e-3;
  Packing p = pressed_pair(a, b, ra, rb, -2.37 * speed * dt);
  p.grains.velocity = {{speed, 0}, {}};
  Engine engine(p, law, with_step(dt));
  Outcome out;
  for (int step = 0, touched = 0; step < 100000; ++step) {
    engine.advance(1);
    const Packing now = packing_of(engine);
    if (now.contacts.size() > 0) {
      ++touched;
      out.deepest = std::max(out.deepest, now.contacts.overlap[0]);
    } else if (touched > 0) {
      out.restitution = (now.grains.velocity[1].x - now.grains.velocity[0].x) / speed;
      out.duration = touched * dt;
      return out;
    }
  }
  ADD_FAILURE() << "no collision came to its end";
  return out;
}

/// Hertz: 2.94 h_max/v, in which h_max^(5/2) = (15/16) m v^2/(E* sqrt(R*)).
double classical_time(const Packing& p, std::int32_t a, std::int32_t b, double speed) {
  const double e = 1 / (compliance(p, a) + compliance(p, b)), r = reduced(p.grains.radius[0], p.grains.radius[1]),
               m = reduced(mass(p, 0), mass(p, 1));
  return 2.943275 * std::pow(15.0 / 16, 0.4) * std::pow(m * m / (r * e * e * speed), 0.2);
}

TEST(HertzMindlin, ACollisionLastsTheClassicalTime) {
  for (const auto& [a, b] : {std::pair{glass, glass}, {glass, rubber}})
    for (const double speed : {0.1, 2.0}) {
      const double time = classical_time(pressed_pair(a, b, 2e-3, 5e-3, 0), a, b, speed), dt = time / 2000;
      const Outcome out = collide(mindlin(1), a, b, speed, dt);
      EXPECT_NEAR(out.duration, time, 3 * dt);
      EXPECT_NEAR(out.deepest * 2.943275 / speed, time, 1e-4 * time);
      EXPECT_NEAR(out.restitution, 1, 1e-4);
    }
}

TEST(HertzMindlin, RestitutionIsTheOneAskedForAtEverySpeed) {
  for (const bool pulls : {true, false})
    for (const double e : {0.9, 0.5, 0.2})
      for (const double speed : {0.05, 1.0}) {
        dem::ContactParameters law = mindlin(e);
        law.attractive_dashpot = pulls;
        const double dt = classical_time(pressed_pair(glass, rubber, 2e-3, 5e-3, 0), glass, rubber, speed) / 4000;
        EXPECT_NEAR(collide(law, glass, rubber, speed, dt).restitution, e, 2e-3 * e) << pulls << " " << speed;
      }
}

dem::ContactParameters sticking() {
  dem::ContactParameters law = mindlin(1);
  law.friction_law = dem::CundallStrack{};
  law.friction = 100;
  law.arms = dem::Arms::full_radius;
  return law;
}

/// k_t of a pair at rest, from the force after its grains have turned a little.
double sliding_stiffness(Packing p, double& normal_force) {
  constexpr int steps = 2000;
  const double spin = 1e-3, dt = 1e-11;
  p.grains.omega = {spin, spin};
  Engine engine(p, sticking(), with_step(dt, dem::IntegratorKind::leapfrog));
  engine.advance(steps);
  const Packing now = packing_of(engine);
  normal_force = now.contacts.fn.at(0);
  const double force = now.contacts.ft.at(0), slip = steps * dt * spin * (p.grains.radius[0] + p.grains.radius[1]);
  EXPECT_NEAR(packing_of(Engine(now, sticking(), with_step(dt))).contacts.ft.at(0), force,
              1e-9 * std::abs(force));  // as a next stage begins
  return std::abs(force) / slip;
}

TEST(HertzMindlin, TheSpringOfFrictionIsMindlins) {
  for (const auto& [a, b] : {std::pair{glass, glass}, {glass, rubber}, {rubber, rubber}})
    for (const double h : {1e-7, 4e-6}) {
      const Packing p = pressed_pair(a, b, 2e-3, 5e-3, h);
      const double g = 1 / (shear_compliance(p, a) + shear_compliance(p, b)), root = std::sqrt(reduced(2e-3, 5e-3) * h);
      double fn = 0;
      const double kt = sliding_stiffness(p, fn);
      EXPECT_NEAR(kt / (8 * g * root), 1, 1e-3) << a << b << " " << h;
      if (a != b) continue;
      const double nu = poisson(p, a);
      EXPECT_NEAR(kt / (1.5 * fn / h), 2 * (1 - nu) / (2 - nu),
                  1e-3);  // k_t over the tangent stiffness of like spheres
    }
}

TEST(HertzMindlin, EveryKernelGivesTheSameForces) {
  Packing p = elastic_box();
  for (int n = 0; n < 23; ++n) {
    const double y = 0.02 + 0.04 * n, ra = 2e-3 + 1e-4 * n, rb = 5e-3, h = 1e-7 * (n + 1);
    add(p, {{0.5, y}, ra, n % 2, {}, 1e-3});
    add(p, {{0.5 + ra + rb - h, y}, rb, n % 3 == 0 ? glass : rubber, {}, 2e-3});
  }
  const auto after = [&](const std::string& kernel) {
    dem::IntegrationParameters how = with_step(1e-9);
    how.kernel = kernel;
    Engine engine(p, sticking(), how);
    engine.advance(10);
    return packing_of(engine).contacts;
  };
  const Contacts one = after("portable"), other = after("auto");
  ASSERT_EQ(one.size(), 23u);
  ASSERT_EQ(other.size(), 23u);
  for (std::size_t c = 0; c < one.size(); ++c) {
    EXPECT_GT(std::abs(one.ft[c]), 0);
    EXPECT_NEAR(other.fn[c] / one.fn[c], 1, 1e-9);
    EXPECT_NEAR(other.ft[c] / one.ft[c], 1, 1e-6);
  }
}

TEST(HertzMindlin, AMaterialWithoutTheConstantsIsRefusedInOneSentence) {
  const auto sentence = [](const Packing& p) -> std::string {
    try {
      Engine(p, mindlin(1), {});
    } catch (const InputError& error) { return error.problems().size() == 1 ? error.what() : "several problems"; }
    return "accepted";
  };
  Packing p = pressed_pair(glass, rubber, 2e-3, 5e-3, 0);
  EXPECT_EQ(sentence(p), "accepted");
  p.materials[rubber].poisson.reset();
  EXPECT_NE(sentence(p).find("material \"rubber\" has no poisson, which the normal law \"hertz_mindlin\" needs"),
            std::string::npos)
      << sentence(p);
  p.materials[rubber].youngs_modulus.reset();
  EXPECT_NE(sentence(p).find("material \"rubber\" has no youngs_modulus"), std::string::npos) << sentence(p);
}

}  // namespace
}  // namespace arenite::verification
