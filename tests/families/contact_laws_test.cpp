#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "core/random.hpp"
#include "families/members.hpp"
#include "grains/dem/laws/laws.hpp"

namespace arenite::dem {
namespace {

const std::vector<NormalLaw> normal_laws = members(NormalLaw{});
const std::vector<Adhesion> adhesion_laws = members(Adhesion{});
const std::vector<FrictionLaw> friction_laws_there_are = members(FrictionLaw{});

/// Elastic force on a contact that remembers `memory` (a fresh one: 0), which is left as it was.
template <class L> double elastic(const L& law, double h, double k, double curvature, double memory = 0) {
  return law.elastic(h, k, curvature, memory);
}
/// What a contact remembers that was once twice as deep.
template <class L> double pressed_before(const L& law, double h, double k, double curvature) {
  double memory = 0;
  law.elastic(2 * h, k, curvature, memory);
  return memory;
}

struct Draw {
  RandomStream random{7, Purpose::test};
  double between(double a, double b) { return a * std::pow(b / a, random.uniform()); }
};

TEST(NormalLaws, ForceIsMinusTheGradientOfEnergy) {
  Draw draw;
  for (const auto& choice : normal_laws)
    for (int trial = 0; trial < 200; ++trial) {
      const double h = draw.between(1e-8, 1e-3), k = draw.between(1e4, 1e9), curvature = draw.between(10, 1e4);
      std::visit(
          [&](const auto& law) {
            const double d = 1e-4 * h, memory = pressed_before(law, h, k, curvature);
            const auto energy = [&](double at) { return law.energy(at, k, curvature, memory); };
            const double slope =
                (energy(h - 2 * d) - 8 * energy(h - d) + 8 * energy(h + d) - energy(h + 2 * d)) / (12 * d);
            EXPECT_NEAR(elastic(law, h, k, curvature, memory), slope, 1e-9 * std::abs(slope)) << law.word.word;
            EXPECT_EQ(law.energy(0.0, k, curvature, 0.0), 0);
            const double tangent = (elastic(law, h + d, k, curvature) - elastic(law, h - d, k, curvature)) / (2 * d);
            if (law.remembers)
              EXPECT_GE(law.tangent(h, k, curvature), std::max(tangent, slope / h) * (1 - 1e-6)) << law.word.word;
            else EXPECT_NEAR(law.tangent(h, k, curvature), tangent, 1e-6 * tangent) << law.word.word;
          },
          choice);
    }
}

TEST(NormalLaws, DashpotsResistTheApproach) {
  for (const auto& choice : normal_laws)
    std::visit(
        [&](const auto& law) {
          EXPECT_GT(law.damping_factor(1e-5, 200.0), 0) << law.word.word;
          EXPECT_TRUE(std::isfinite(law.damping_factor(1e-12, 200.0))) << law.word.word;
        },
        choice);
}

TEST(NormalLaws, AContactMetAtRestGoesOnWithTheForceThatItHas) {
  for (const auto& choice : normal_laws)
    std::visit(
        []<class L>(const L& law) {
          if constexpr (L::remembers) {
            const double h = 1e-5, k = 1e7, curvature = 200, memory = pressed_before(law, h, k, curvature);
            const double force = elastic(law, h, k, curvature, memory);
            EXPECT_NEAR(elastic(law, h, k, curvature, law.recall(force, h, k, curvature)), force, 1e-9 * force)
                << law.word.word;
          }
        },
        choice);
}

TEST(AdhesionLaws, ForceIsMinusTheGradientOfEnergy) {
  Draw draw;
  for (const auto& choice : adhesion_laws)
    for (int trial = 0; trial < 200; ++trial) {
      const double h = draw.between(1e-8, 1e-3), strength = draw.between(1, 1e6);
      std::visit(
          [&](const auto& law) {
            const double d = 1e-4 * h;
            const double slope = (law.energy(h - 2 * d, strength) - 8 * law.energy(h - d, strength) +
                                  8 * law.energy(h + d, strength) - law.energy(h + 2 * d, strength)) /
                                 (12 * d);
            EXPECT_NEAR(law.attraction(h, strength), -slope, 1e-9 * std::abs(slope)) << law.word.word;
            EXPECT_GE(law.attraction(h, strength), 0);
            EXPECT_EQ(law.attraction(h, 0.0), 0);
          },
          choice);
    }
}

TEST(AdhesionLaws, GeometricalAdhesionPullsOffAtItsForceAndDistance) {
  const double k = 27.35e6, gamma = 1.06e6, r = 0.0124, strength = gamma * std::sqrt(r);
  const GeometricalAdhesion adhesion;
  const auto total = [&](double h) { return elastic(Linear{}, h, k, 0.0) - adhesion.attraction(h, strength); };
  const double hc = r * gamma * gamma / (4 * k * k), fc = r * gamma * gamma / (4 * k), rest = 4 * hc;
  EXPECT_NEAR(total(hc), -fc, 1e-12 * fc);
  EXPECT_NEAR(total(rest), 0, 1e-9 * fc);
  EXPECT_GT(total(1.01 * hc), -fc);
  EXPECT_GT(total(0.99 * hc), -fc);
  EXPECT_NEAR(Linear{}.pull_off(strength, k, 0.0), fc, 1e-12 * fc);
}

/// The lowest net force over the overlap, by bisection of its slope.
template <class Normal> double deepest_pull(const Normal& normal, double k, double curvature, double strength) {
  const GeometricalAdhesion adhesion;
  const auto pull = [&](double h) { return adhesion.attraction(h, strength) - elastic(normal, h, k, curvature); };
  double low = 1e-12, high = 1;
  for (int turn = 0; turn < 400; ++turn) {
    const double a = low + (high - low) * 0.382, b = low + (high - low) * 0.618;
    (pull(a) > pull(b) ? high : low) = pull(a) > pull(b) ? b : a;
  }
  return pull(0.5 * (low + high));
}

TEST(AdhesionLaws, TheCapIsRaisedByThePullOffForceOfTheNormalLaw) {
  Draw draw;
  for (const auto& choice : normal_laws)
    for (int trial = 0; trial < 100; ++trial) {
      const double k = draw.between(1e5, 1e8), curvature = draw.between(50, 2000), strength = draw.between(1e3, 1e5);
      std::visit(
          [&](const auto& law) {
            const double fc = deepest_pull(law, k, curvature, strength);
            EXPECT_NEAR(law.pull_off(strength, k, curvature), fc, 1e-7 * fc) << law.word.word;
            EXPECT_EQ(law.pull_off(0.0, k, curvature), 0);
          },
          choice);
    }
  const double strength = 1.06e6 * std::sqrt(0.0124), curvature = 2 / 0.0062;
  EXPECT_NEAR(Hertz{}.pull_off(strength, 27.35e6, curvature),
              2.0 / 3 * strength * std::sqrt(strength / std::sqrt(curvature) / (3 * 27.35e6)), 1e-9);
}

TEST(AdhesionLaws, FrictionHoldsWhileGluedGrainsStillPull) {
  Draw draw;
  for (const auto& choice : normal_laws)
    std::visit(
        [&](const auto& law) {
          const double k = 27.35e6, curvature = 2 / 0.0062, strength = 1.06e6 * std::sqrt(0.0124);
          for (double share = 0.02; share < 1; share += 0.02) {
            ContactState<double> c{};
            c.overlap = share * 1e-4;
            c.sliding = 1;
            c.curvature = curvature;
            c.stiffness = k;
            c.viscosity = 1e12;
            c.strength = strength;
            c.friction = 0.3;
            c.floor = -1e300;
            const double fc = deepest_pull(law, k, curvature, strength);
            for (const double sign : {1.0, -1.0}) {
              ContactMemory<double> memory;
              ContactLaws shared;
              shared.cap_sign = sign;
              const auto force = contact_force(shared, law, GeometricalAdhesion{}, RegularisedCoulomb{}, c, memory);
              EXPECT_NEAR(std::abs(force.tangential), 0.3 * std::max(force.normal + sign * fc, 0.0), 1e-6 * fc)
                  << law.word.word;
            }
          }
        },
        choice);
}

TEST(FrictionLaws, StayWithinTheCapAndOpposeSliding) {
  Draw draw;
  for (const auto& choice : friction_laws_there_are)
    for (int trial = 0; trial < 500; ++trial) {
      const double v = draw.random.uniform(-1, 1), viscosity = draw.between(1, 1e4), cap = draw.between(1e-3, 1e3);
      double memory = draw.random.uniform(-1e-4, 1e-4);
      std::visit(
          [&](const auto& law) {
            const auto slip = [&](double within) { return Slip<double>{v, viscosity, within, 1e7, 1e-6, 0}; };
            const double f = law.tangential(slip(cap), memory);
            EXPECT_LE(std::abs(f), cap * (1 + 1e-12)) << law.word.word;
            double fresh = 0;
            EXPECT_LE(law.tangential(slip(cap), fresh) * v, 0) << law.word.word;
            double none = memory;
            EXPECT_EQ(law.tangential(slip(0), none), 0) << law.word.word;
          },
          choice);
    }
}

TEST(FrictionLaws, AContactMetAtRestGoesOnWithTheForceThatItHas) {
  for (const auto& choice : friction_laws_there_are)
    std::visit(
        []<class L>(const L& law) {
          if constexpr (L::remembers) {
            double memory = law.recall(-3.7, 1e6);
            EXPECT_NEAR(law.tangential(Slip<double>{0, 10, 1e9, 1e6, 1e-5, 0}, memory), -3.7, 1e-12) << law.word.word;
          }
        },
        choice);
}

TEST(FrictionLaws, SpringsThatStickGiveBackTheirEnergy) {
  const double dt = 1e-5, k = 0.8e6;
  for (const auto& choice : friction_laws_there_are)
    std::visit(
        [&](const auto& law) {
          if (law.tangent(k) == 0) return;
          double memory = 0, work = 0, last = 0, v_last = 0;
          for (int n = 1; n <= 1000; ++n) {
            const double v = 1e-3 * std::cos(0.01 * n);
            const Slip<double> slip{v, 0, 1e9, k, 0.5 * dt, 0.5 * dt};
            const double f = law.tangential(slip, memory);
            if (n > 1) work -= 0.5 * (f + last) * 0.5 * (v + v_last) * dt;
            if (n == 1) work = law.energy(slip, memory);
            last = f;
            v_last = v;
            EXPECT_NEAR(law.energy(slip, memory), work, 1e-9 * std::abs(work) + 1e-18) << law.word.word;
          }
        },
        choice);
}

TEST(FrictionLaws, ASpringNeverHoldsMoreThanTheCap) {
  const double dt = 1e-5, kt = 0.8e6, cap = 3;
  const Slip<double> slip{1, 50, cap, kt, 0.5 * dt, 0.5 * dt};
  const CundallStrack law;
  double memory = 0;
  for (int n = 0; n < 1000; ++n) law.tangential(slip, memory);
  EXPECT_NEAR(law.spring(slip, memory) * kt, cap, 1e-9);
}

}  // namespace
}  // namespace arenite::dem
