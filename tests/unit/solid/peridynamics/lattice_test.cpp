#include "solid/peridynamics/lattice.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "support/crack_energy.hpp"
#include "support/lattice_moduli.hpp"

namespace arenite::peridynamics {
namespace {

TEST(Lattice, HalfBondsAndTheirOppositesAreAllNodesWithinTheHorizon) {
  std::set<std::pair<int, int>> found, wanted;
  for (const Offset e : half_bonds) {
    found.insert({e.x, e.y});
    found.insert({-e.x, -e.y});
  }
  for (int y = -horizon; y <= horizon; ++y)
    for (int x = -horizon; x <= horizon; ++x)
      if ((x != 0 || y != 0) && x * x + y * y <= horizon * horizon) wanted.insert({x, y});
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(found.size(), 28u);
}

TEST(Lattice, ElasticConstantsAreTheExactSums) {
  const LatticeModuli m = lattice_moduli();
  EXPECT_NEAR(m.c1111, 1.1843645, 5e-8);
  EXPECT_NEAR(m.c1122, 0.3769218, 5e-8);
  EXPECT_NEAR(m.young_axis, 1.0644099, 5e-8);
  EXPECT_NEAR(m.poisson_axis, 0.3182481, 5e-8);
  EXPECT_NEAR(m.young_diagonal, 1.0167599, 5e-8);
  EXPECT_NEAR(m.poisson_diagonal, 0.3487678, 5e-8);
  EXPECT_NEAR(calibration_factor(), 0.9394877, 5e-8);
}

TEST(Lattice, CrackEnergyByDirectionAgainstTheContinuum) {
  // Continuum with the nominal micromodulus and nu = 1/3: s_c^2 = 4 pi G/(9 E h).
  const double continuum = 9.0 * 3 / (4 * std::numbers::pi);
  EXPECT_NEAR(crack_energy_axis(), 2.20475, 5e-6);
  EXPECT_NEAR(crack_energy_axis() / continuum, 1.0261, 5e-5);
  EXPECT_NEAR(crack_energy_diagonal() / continuum, 1.0481, 5e-5);
}

}  // namespace
}  // namespace arenite::peridynamics
