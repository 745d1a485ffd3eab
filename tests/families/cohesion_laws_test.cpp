#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "families/members.hpp"
#include "grains/dem/laws/laws.hpp"

namespace arenite::dem {
namespace {

using std::numbers::pi;

constexpr double thickness = 0.02;
struct Pair {
  double i, j;
};
constexpr Pair pairs[] = {{1e-3, 1e-3}, {1e-3, 4e-3}, {2e-3, 2.1e-3}};

/// Each law of the list, by type, with each pair.
template <class See> void each_curve(const See& see) {
  for (const auto& choice : members(Cohesion{}))
    std::visit(
        [&](const auto& law) {
          if (std::is_same_v<std::decay_t<decltype(law)>, NoCohesion>) return;
          for (const Pair& pair : pairs) {
            SCOPED_TRACE(law.word.word);
            see(law, pair, law.curve(pair.i, pair.j, thickness));
          }
        },
        choice);
}

TEST(CohesionLaws, PullIsTheGradientOfTheEnergyAtEveryGap) {
  each_curve([](const auto&, const Pair&, const PullCurve& curve) {
    for (double share = 0.003; share < 0.99; share *= 1.07) {
      const double gap = share * curve.reach(), d = 1e-4 * gap;
      const double slope = (curve.energy(gap - 2 * d) - 8 * curve.energy(gap - d) + 8 * curve.energy(gap + d) -
                            curve.energy(gap + 2 * d)) /
                           (12 * d);
      EXPECT_NEAR(curve.pull(gap), slope, 1e-7 * slope) << share;
    }
    const double h = 1e-3 * curve.reach();
    EXPECT_NEAR((curve.energy(0) - curve.energy(-h)) / h, curve.pull(-0.5 * h), 1e-9 * curve.pull(0));
    EXPECT_EQ(curve.pull(-h), curve.pull(0));
  });
}

TEST(CohesionLaws, PullGoesOnFromTheContactIntoTheGap) {
  each_curve([](const auto&, const Pair&, const PullCurve& curve) {
    const double near = 1e-9 * curve.reach();
    EXPECT_NEAR(curve.pull(near), curve.pull(0), 1e-6 * curve.pull(0));
    EXPECT_NEAR(curve.energy(near), curve.energy(0), 1e-8 * curve.pull(0) * curve.reach());
    for (double share = 0; share < 1; share += 0.01) EXPECT_GT(curve.pull(share * curve.reach()), 0);
  });
}

TEST(CohesionLaws, EnergyIsNoneWhereAPairIsJoined) {
  each_curve([](const auto& law, const Pair&, const PullCurve& curve) {
    EXPECT_NEAR(curve.energy(law.joins_within()), 0, 1e-12 * curve.pull(0) * curve.reach());
    if (!law.breaks) { EXPECT_LT(curve.pull(curve.reach()), 1e-12 * curve.pull(0)); }
  });
}

TEST(CohesionLaws, SteepestSlopeIsNowhereExceeded) {
  each_curve([](const auto&, const Pair&, const PullCurve& curve) {
    for (double share = 0.001; share < 0.99; share += 0.001) {
      const double gap = share * curve.reach(), d = 1e-3 * curve.reach();
      EXPECT_LE(std::abs(curve.pull(gap + d) - curve.pull(gap)) / d, 1.01 * curve.steepest());
    }
  });
}

TEST(CohesionLaws, DmtPullsByThePullOffForceOfSpheres) {
  const Dmt law{0.05, 2e-6};
  for (const Pair& pair : pairs) {
    const PullCurve curve = law.curve(pair.i, pair.j, thickness);
    const double most = 2 * pi * 0.05 * pair.i * pair.j / (pair.i + pair.j);
    EXPECT_NEAR(curve.pull(-1e-6), most, 1e-14 * most);
    for (const double share : {0.01, 0.3, 0.77}) {
      EXPECT_NEAR(curve.pull(share * 2e-6), most * (1 - share), 1e-9 * most);
      EXPECT_NEAR(curve.energy(share * 2e-6), -0.5 * most * 2e-6 * (1 - share) * (1 - share), 1e-9 * most * 2e-6);
    }
  }
}

TEST(CohesionLaws, BridgesBetweenDisksAreTheExactOnes) {
  for (const double angle : {0.0, 0.9})
    for (const Pair& pair : pairs) {
      CapillaryDisks law;
      law.contact_angle = angle;
      law.volume = 2e-3 * 1e-6 * thickness;
      const geometry::LiquidBridge bridge{pair.i, pair.j, angle};
      const PullCurve curve = law.curve(pair.i, pair.j, thickness);
      EXPECT_NEAR(curve.reach(), geometry::rupture_gap(bridge, 2e-9), 1e-12 * curve.reach());
      for (double share = 0.001; share < 1; share += 0.0137) {
        const double gap = share * curve.reach();
        const double pull = law.surface_tension * thickness *
                            geometry::bridge_state(bridge, gap, geometry::arc_radius(bridge, gap, 2e-9)).pull;
        EXPECT_NEAR(curve.pull(gap), pull, 3e-6 * pull) << share;
      }
    }
}

TEST(CohesionLaws, BridgesBetweenSpheresAreThoseOfWillett) {
  CapillarySpheres law;
  law.contact_angle = 0.5;
  law.volume = 1e-12;
  for (const Pair& pair : pairs) {
    const PullCurve curve = law.curve(pair.i, pair.j, thickness);
    const double radius = 2 * pair.i * pair.j / (pair.i + pair.j),
                 most = 2 * pi * radius * law.surface_tension * std::cos(0.5);
    EXPECT_NEAR(curve.reach(), 1.25 * 1e-4, 1e-18);
    for (double share = 0; share < 1; share += 0.0137) {
      const double s = share * curve.reach() * std::sqrt(radius / law.volume);
      EXPECT_NEAR(curve.pull(share * curve.reach()), most / (1 + 1.05 * s + 2.5 * s * s), 3e-6 * most) << share;
    }
  }
}

}  // namespace
}  // namespace arenite::dem
