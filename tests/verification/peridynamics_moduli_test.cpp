// Effective moduli of whole samples against the lattice's own and against laminate bounds.
#include "solid/peridynamics/load.hpp"

#include <gtest/gtest.h>

#include "solid/peridynamics/lattice.hpp"
#include "support/cemented_sample.hpp"
#include "support/homogeneous_sample.hpp"
#include "support/lattice_moduli.hpp"

namespace arenite::peridynamics {
namespace {

LoadOptions exactly() {
  LoadOptions options;
  options.tolerance = 1e-9;
  return options;
}

TEST(Moduli, SquareOfOneMaterialIsTheSameAlongBothAxes) {
  const auto m = effective_moduli(test::homogeneous_sample(96, 96), exactly());
  EXPECT_NEAR(m.young_x / m.young_y, 1, 1e-8);
  EXPECT_NEAR(m.poisson_xy / m.poisson_yx, 1, 1e-7);
  EXPECT_NEAR(m.young_y, 1, 0.02) << "clamps hinder the contraction, free sides and clamped rows are soft";
}

TEST(Moduli, WidePlateShearsByTheLatticesModulus) {
  // Far from the free sides a plate between fixed edges shears uniformly, but for the rows next to the clamps.
  const double ideal = lattice_moduli(nominal_micromodulus * calibration_factor()).c1122;  // C_1212 of a bond lattice
  const double narrow = effective_moduli(test::homogeneous_sample(240, 60), exactly()).shear / ideal,
               wide = effective_moduli(test::homogeneous_sample(480, 60), exactly()).shear / ideal;
  EXPECT_LT(wide, 1);
  EXPECT_NEAR(2 * wide - narrow, 1, 0.02) << "what the free sides take falls with the width";
}

PhaseMap turned(const PhaseMap& map) {
  PhaseMap t = transposed(map), out = t;
  for (int y = 0; y < t.height; ++y)
    for (int x = 0; x < t.width; ++x) {
      out.phase[t.index(t.width - 1 - x, y)] = t.phase[t.index(x, y)];
      out.grain[t.index(t.width - 1 - x, y)] = t.grain[t.index(x, y)];
    }
  return out;
}

TEST(Moduli, QuarterTurnOfASampleExchangesItsAxes) {
  const PhaseMap map = test::cemented_sample({.nodes = 96, .size_ratio = 2, .bridge = 0.4});
  const auto m = effective_moduli(map, exactly()), t = effective_moduli(turned(map), exactly());
  EXPECT_NEAR(t.young_x / m.young_y, 1, 1e-7);
  EXPECT_NEAR(t.young_y / m.young_x, 1, 1e-7);
  EXPECT_NEAR(t.poisson_xy, m.poisson_yx, 1e-6);
  EXPECT_NEAR(t.poisson_yx, m.poisson_xy, 1e-6);
  EXPECT_GT(std::abs(m.young_x / m.young_y - 1), 1e-3) << "a sample that cannot tell its axes shows nothing";
}

TEST(Moduli, LayersAreStifferAlongThanAcross) {
  PhaseMap map = test::homogeneous_sample(96, 96);
  map.grain_class.assign(3, GrainClass::none);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      if (y / 16 % 2) {
        map.phase[map.index(x, y)] = Phase::particle;
        map.grain[map.index(x, y)] = y / 32;
      }
  const auto m = effective_moduli(map, exactly());
  EXPECT_NEAR(m.young_x, 2.5, 0.08) << "mean of 1 and 4, less the seam, more the clamps";
  EXPECT_NEAR(m.young_y, 1.6, 0.16) << "harmonic mean, stiffened by the layers that hold each other's contraction";
  EXPECT_LT(m.shear, m.young_y / 2);
}

TEST(Moduli, WatchSeesOneRunAndStopsTheWhole) {
  double share = 0;
  LoadOptions options;
  options.watch = [&](const Progress& p) {
    EXPECT_GE(p.share, share);
    share = p.share;
    return p.share < 0.5;
  };
  const auto m = effective_moduli(test::homogeneous_sample(40, 40), options);
  EXPECT_GE(share, 0.5);
  EXPECT_EQ(m.reports[1].ending, Ending::stopped);
  EXPECT_EQ(m.young_x, 0);
}

}  // namespace
}  // namespace arenite::peridynamics
