#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "core/random.hpp"
#include "grains/dem/laws/laws.hpp"

namespace arenite::dem {
namespace {

/// Members of a family, in the order of their list.
template <class Choice, std::size_t... I>
std::vector<Choice> members(std::index_sequence<I...>) {
  return {std::variant_alternative_t<I, Choice>{}...};
}
template <class Choice>
std::vector<Choice> members() {
  return members<Choice>(std::make_index_sequence<std::variant_size_v<Choice>>{});
}

struct Draw {
  RandomStream random{7, Purpose::test};
  double between(double a, double b) { return a * std::pow(b / a, random.uniform()); }
};

TEST(NormalLaws, ForceIsMinusTheGradientOfEnergy) {
  Draw draw;
  for (const auto& choice : members<NormalChoice>())
    for (int trial = 0; trial < 200; ++trial) {
      const double h = draw.between(1e-8, 1e-3), k = draw.between(1e4, 1e9), curvature = draw.between(10, 1e4);
      std::visit([&](const auto& law) {
        const double d = 1e-4 * h;
        const double slope = (law.energy(h - 2 * d, k, curvature) - 8 * law.energy(h - d, k, curvature) +
                              8 * law.energy(h + d, k, curvature) - law.energy(h + 2 * d, k, curvature)) / (12 * d);
        EXPECT_NEAR(law.elastic(h, k, curvature), slope, 1e-9 * std::abs(slope)) << choice.index();
        EXPECT_EQ(law.energy(0.0, k, curvature), 0);
        const double tangent = (law.elastic(h + d, k, curvature) - law.elastic(h - d, k, curvature)) / (2 * d);
        EXPECT_NEAR(law.tangent(h, k, curvature), tangent, 1e-6 * tangent);
      }, choice);
    }
}

TEST(NormalLaws, ADashpotResistsTheApproach) {
  Draw draw;
  for (const auto& choice : members<NormalChoice>())
    std::visit([&](const auto& law) {
      EXPECT_GT(law.viscous(1e-5, 0.3, 100.0, 200.0), 0);
      EXPECT_LT(law.viscous(1e-5, -0.3, 100.0, 200.0), 0);
      EXPECT_EQ(law.viscous(1e-5, 0.0, 100.0, 200.0), 0);
    }, choice);
}

TEST(AdhesionLaws, ForceIsMinusTheGradientOfEnergy) {
  Draw draw;
  for (const auto& choice : members<AdhesionChoice>())
    for (int trial = 0; trial < 200; ++trial) {
      const double h = draw.between(1e-8, 1e-3), strength = draw.between(1, 1e6);
      std::visit([&](const auto& law) {
        const double d = 1e-4 * h;
        const double slope = (law.energy(h - 2 * d, strength) - 8 * law.energy(h - d, strength) +
                              8 * law.energy(h + d, strength) - law.energy(h + 2 * d, strength)) / (12 * d);
        EXPECT_NEAR(law.attraction(h, strength), -slope, 1e-9 * std::abs(slope)) << choice.index();
        EXPECT_GE(law.attraction(h, strength), 0);
        EXPECT_EQ(law.attraction(h, 0.0), 0);
      }, choice);
    }
}

TEST(AdhesionLaws, GeometricalAdhesionPullsOffAtItsForceAndDistance) {
  const double k = 27.35e6, gamma = 1.06e6, r = 0.0124, strength = gamma * std::sqrt(r);
  const GeometricalAdhesion adhesion;
  const auto total = [&](double h) { return Linear{}.elastic(h, k, 0.0) - adhesion.attraction(h, strength); };
  const double hc = r * gamma * gamma / (4 * k * k), fc = r * gamma * gamma / (4 * k), rest = 4 * hc;
  EXPECT_NEAR(total(hc), -fc, 1e-12 * fc);
  EXPECT_NEAR(total(rest), 0, 1e-9 * fc);
  EXPECT_GT(total(1.01 * hc), -fc);
  EXPECT_GT(total(0.99 * hc), -fc);
  EXPECT_NEAR(adhesion.cap_shift(Linear{}.pull_off(strength, k, 0.0)), fc, 1e-12 * fc);
  EXPECT_NEAR(GeometricalAdhesion{-1}.cap_shift(Linear{}.pull_off(strength, k, 0.0)), -fc, 1e-12 * fc);
}

/// The lowest net force over the overlap, by bisection of its slope.
template <class Normal>
double deepest_pull(const Normal& normal, double k, double curvature, double strength) {
  const GeometricalAdhesion adhesion;
  const auto pull = [&](double h) { return adhesion.attraction(h, strength) - normal.elastic(h, k, curvature); };
  double low = 1e-12, high = 1;
  for (int turn = 0; turn < 400; ++turn) {
    const double a = low + (high - low) * 0.382, b = low + (high - low) * 0.618;
    (pull(a) > pull(b) ? high : low) = pull(a) > pull(b) ? b : a;
  }
  return pull(0.5 * (low + high));
}

TEST(AdhesionLaws, TheCapIsRaisedByThePullOffForceOfTheNormalLaw) {
  Draw draw;
  for (const auto& choice : members<NormalChoice>())
    for (int trial = 0; trial < 100; ++trial) {
      const double k = draw.between(1e5, 1e8), curvature = draw.between(50, 2000), strength = draw.between(1e3, 1e5);
      std::visit([&](const auto& law) {
        const double fc = deepest_pull(law, k, curvature, strength);
        EXPECT_NEAR(law.pull_off(strength, k, curvature), fc, 1e-7 * fc) << choice.index();
        EXPECT_EQ(law.pull_off(0.0, k, curvature), 0);
      }, choice);
    }
  const double strength = 1.06e6 * std::sqrt(0.0124), curvature = 2 / 0.0062;
  EXPECT_NEAR(Hertz{}.pull_off(strength, 27.35e6, curvature), 2.0 / 3 * strength * std::sqrt(strength / std::sqrt(curvature) / (3 * 27.35e6)), 1e-9);
}

TEST(AdhesionLaws, FrictionHoldsWhileGluedGrainsStillPull) {
  Draw draw;
  for (const auto& choice : members<NormalChoice>())
    std::visit([&](const auto& law) {
      const double k = 27.35e6, curvature = 2 / 0.0062, strength = 1.06e6 * std::sqrt(0.0124);
      for (double share = 0.02; share < 1; share += 0.02) {
        double memory = 0;
        ContactState<double> c{};
        c.overlap = share * 1e-4;
        c.sliding = 1;
        c.curvature = curvature;
        c.stiffness = k;
        c.viscosity = 1e12;
        c.strength = strength;
        c.friction = 0.3;
        c.floor = -1e300;
        const auto force = contact_force(law, GeometricalAdhesion{}, RegularisedCoulomb{}, c, memory);
        const double fc = deepest_pull(law, k, curvature, strength);
        EXPECT_NEAR(std::abs(force.tangential), 0.3 * (force.normal + fc), 1e-6 * fc) << choice.index();
      }
    }, choice);
}

TEST(FrictionLaws, StayWithinTheCapAndOpposeSliding) {
  Draw draw;
  for (const auto& choice : members<FrictionChoice>())
    for (int trial = 0; trial < 500; ++trial) {
      const double v = draw.random.uniform(-1, 1), viscosity = draw.between(1, 1e4), cap = draw.between(1e-3, 1e3);
      double memory = draw.random.uniform(-1e-4, 1e-4);
      std::visit([&](const auto& law) {
        const double f = law.tangential(v, viscosity, cap, 1e7, memory);
        EXPECT_LE(std::abs(f), cap * (1 + 1e-12));
        double fresh = 0;
        EXPECT_LE(law.tangential(v, viscosity, cap, 1e7, fresh) * v, 0);
        double none = memory;
        EXPECT_EQ(law.tangential(v, viscosity, 0.0, 1e7, none), 0);
      }, choice);
    }
}

TEST(FrictionLaws, ASpringThatSticksGivesBackItsEnergy) {
  const double dt = 1e-5, k = 1e6;
  const CundallStrack law{0.8, 0.5 * dt, 0.5 * dt};
  double memory = 0, work = 0, last = 0, v_last = 0;
  for (int n = 1; n <= 1000; ++n) {
    const double v = 1e-3 * std::cos(0.01 * n);
    const double f = law.tangential(v, 0.0, 1e9, k, memory);
    if (n > 1) work -= 0.5 * (f + last) * 0.5 * (v + v_last) * dt;
    if (n == 1) work = law.energy(v, k, memory);
    last = f;
    v_last = v;
    EXPECT_NEAR(law.energy(v, k, memory), work, 1e-9 * std::abs(work) + 1e-18);
  }
}

TEST(FrictionLaws, ASpringNeverHoldsMoreThanTheCap) {
  const double dt = 1e-5, k = 1e6, cap = 3;
  const CundallStrack law{0.8, 0.5 * dt, 0.5 * dt};
  double memory = 0;
  for (int n = 0; n < 1000; ++n) law.tangential(1.0, 50.0, cap, k, memory);
  EXPECT_NEAR(law.spring(1.0, memory) * 0.8 * k, cap, 1e-9);
}

}  // namespace
}  // namespace arenite::dem
