#include "geometry/liquid_bridge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/meniscus.hpp"

namespace arenite::geometry {
namespace {

const std::vector<LiquidBridge> bridges{{1, 1, 0}, {1, 1, 0.5}, {1, 1, 1.2}, {1, 5, 0}, {5, 1, 0.7}, {0.3, 1, 1.2}};

TEST(LiquidBridge, OfZeroContactAngleIsTheMeniscusOfTheCement) {
  for (const LiquidBridge& b : bridges) {
    if (b.contact_angle > 0) continue;
    for (const double gap : {0.0, 0.01, 0.2})
      for (const double arc : {0.3, 1.0, 30.0}) {
        const MeniscusDisks disks{b.radius_i, b.radius_j, b.radius_i + b.radius_j + gap};
        EXPECT_NEAR(bridge_state(b, gap, arc).area, meniscus_area(disks, 1 / arc), 1e-12) << gap << " " << arc;
      }
    EXPECT_NEAR(1 / thinnest_arc(b, 0.1),
                largest_meniscus_curvature({b.radius_i, b.radius_j, b.radius_i + b.radius_j + 0.1}), 1e-9);
  }
}

TEST(LiquidBridge, BetweenEqualDisksPullsByTensionAndLaplacePressure) {
  // At the line where the arc meets the rim, beta from the axis: 2 sin(beta + theta) + 2 r sin(beta)/R, R = (2 r (1 -
  // cos beta) + gap)/(2 cos(beta + theta)).
  for (const double theta : {0.0, 0.4, 1.0})
    for (const double gap : {0.0, 0.03, 0.2})
      for (const double beta : {0.1, 0.2, 0.5}) {
        const double r = 0.7, arc = (2 * r * (1 - std::cos(beta)) + gap) / (2 * std::cos(beta + theta));
        const LiquidBridge b{r, r, theta};
        if (gap > 0 && arc < thinnest_arc(b, gap)) continue;
        const double pull = 2 * std::sin(beta + theta) + 2 * r * std::sin(beta) / arc;
        EXPECT_NEAR(bridge_state(b, gap, arc).pull, pull, 1e-12 * pull) << theta << " " << gap << " " << beta;
      }
}

TEST(LiquidBridge, PullIsTheGradientOfTheSurfacesEnergyAtConstantArea) {
  for (const LiquidBridge& b : bridges)
    for (const double area : {1e-4, 1e-3, 1e-2}) {
      const double reach = rupture_gap(b, area);
      const auto at = [&](double gap) { return bridge_state(b, gap, arc_radius(b, gap, area)); };
      for (const double share : {0.02, 0.1, 0.5, 0.9}) {
        const double gap = share * reach, d = 1e-3 * gap;
        const BridgeState now = at(gap), less = at(gap - d), more = at(gap + d), far_less = at(gap - 2 * d),
                          far_more = at(gap + 2 * d);
        EXPECT_NEAR(now.area, area, 1e-12);
        EXPECT_NEAR((far_less.energy - 8 * less.energy + 8 * more.energy - far_more.energy) / (12 * d), now.pull,
                    2e-6 * now.pull)
            << area << " " << share;
        EXPECT_NEAR((far_less.pull - 8 * less.pull + 8 * more.pull - far_more.pull) / (12 * d), now.slope,
                    1e-6 * now.pull / gap)
            << area << " " << share;
      }
    }
}

TEST(LiquidBridge, BreaksWhereItsArcsMeet) {
  for (const LiquidBridge& b : bridges)
    for (const double area : {1e-4, 1e-3, 1e-2}) {
      const double reach = rupture_gap(b, area), arc = thinnest_arc(b, reach);
      const BridgeState end = bridge_state(b, reach, arc);
      EXPECT_NEAR(end.area, area, 1e-12);
      EXPECT_NEAR(end.neck, 0, 1e-9 * arc);
      EXPECT_NEAR(end.pull, 2, 1e-6);  // two surfaces, and no width that the pressure acts on
      EXPECT_GT(bridge_state(b, 0.99 * reach, arc_radius(b, 0.99 * reach, area)).neck, 0);
    }
}

TEST(LiquidBridge, IsTheSameFromEitherSide) {
  const LiquidBridge b{1, 3, 0.6}, turned{3, 1, 0.6};
  for (const double gap : {0.0, 0.02}) {
    const BridgeState x = bridge_state(b, gap, arc_radius(b, gap, 0.01)),
                      y = bridge_state(turned, gap, arc_radius(turned, gap, 0.01));
    EXPECT_NEAR(x.pull, y.pull, 1e-9 * x.pull);
    EXPECT_NEAR(x.energy, y.energy, 1e-9);
  }
}

TEST(LiquidBridge, HoldsAtMostWhatStraightSurfacesEncloseBetweenDisks) {
  EXPECT_NEAR(straight_bridge_area({1, 1, 0}), 4 - std::acos(-1.0), 2e-2);
  EXPECT_LT(straight_bridge_area({1, 1, 1.2}), straight_bridge_area({1, 1, 0.5}));
}

}  // namespace
}  // namespace arenite::geometry
