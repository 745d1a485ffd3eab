#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/mapped.hpp"
#include "core/random.hpp"
#include "solid/peridynamics/bonded_aggregates.hpp"
#include "solid/peridynamics/kernels/kernels.hpp"
#include "solid/statics/coarse_space.hpp"
#include "support/cemented_sample.hpp"

namespace arenite::peridynamics {
namespace {

struct Prepared {
  PhaseMap map;
  Bonds bonds;
  std::vector<std::uint8_t> prescribed;
  Aggregates aggregates;
  explicit Prepared(double bridge)
      : map(test::cemented_sample({.nodes = 96, .size_ratio = 2.5, .bridge = bridge})),
        bonds(make_bonds(map, {})) {
    prescribed.assign(static_cast<std::size_t>(map.height), 0);
    prescribed.front() = prescribed.back() = both_prescribed;
    aggregates = cut_into_aggregates(map, bonds, prescribed);
  }
};

TEST(Aggregates, EveryPieceHasOneOwnerAndOneCellAndHoldsTogether) {
  const Prepared s(0.4);
  std::vector<std::int32_t> nodes(s.aggregates.list.size(), 0);
  for (int y = 0; y < s.map.height; ++y)
    for (int x = 0; x < s.map.width; ++x) {
      const auto p = s.aggregates.of_node[s.bonds.grid.index(x, y)];
      const bool solid = s.map.phase[s.map.index(x, y)] != Phase::empty && y > 0 && y < s.map.height - 1;
      ASSERT_EQ(p >= 0, solid) << x << " " << y;
      if (p < 0) continue;
      const auto k = static_cast<std::size_t>(p);
      ASSERT_EQ(s.aggregates.list[k].cell[0], x / Aggregates::cell);
      ASSERT_EQ(s.aggregates.list[k].cell[1], y / Aggregates::cell);
      if (s.map.phase[s.map.index(x, y)] == Phase::particle) {
        ASSERT_EQ(s.aggregates.list[k].owner, s.map.grain[s.map.index(x, y)]);
      }
      ++nodes[k];
    }
  EXPECT_EQ(nodes, mapped(s.aggregates.list, &Aggregates::Aggregate::nodes));
}

void expect_energy_of_bonds(Prepared s, Prescribed bottom) {
  s.prescribed.front() = bottom;
  s.aggregates = cut_into_aggregates(s.map, s.bonds, s.prescribed);
  const auto sums = couplings(s.bonds, s.aggregates, block_diagonal(s.bonds), s.prescribed);
  RandomStream random(1, Purpose::test);
  std::vector<double> corner(8 * s.aggregates.list.size());
  for (double& c : corner) c = random.uniform(-1, 1);
  Field<double> u(s.bonds.grid.padded_size()), f(s.bonds.grid.padded_size());
  for (int y = 0; y < s.map.height; ++y)
    for (int x = 0; x < s.map.width; ++x) {
      const auto i = s.bonds.grid.index(x, y);
      const auto p = s.aggregates.of_node[i];
      if (p < 0) continue;
      const Hats& h = hats_at(x % Aggregates::cell, y % Aggregates::cell);
      for (unsigned a = 0; a < 4; ++a) {
        u.x[i] += h[a] * corner[8 * static_cast<std::size_t>(p) + 2 * a];
        if (!s.prescribed[static_cast<std::size_t>(y)])
          u.y[i] += h[a] * corner[8 * static_cast<std::size_t>(p) + 2 * a + 1];
      }
    }
  const double wanted = -kernels().force(s.bonds, s.prescribed.data(), pointers(u), pointers(f));
  double energy = 0;
  for (const Coupling& c : sums)
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = 0; b < 4; ++b) {
        const double* p = &corner[8 * static_cast<std::size_t>(c.p) + 2 * a];
        const double* q = &corner[8 * static_cast<std::size_t>(c.q) + 2 * b];
        energy += (c.p == c.q ? 1 : 2) * (c.block[0][a][b] * p[0] * q[0] + c.block[1][a][b] * p[0] * q[1] +
                                          c.block[2][a][b] * p[1] * q[0] + c.block[3][a][b] * p[1] * q[1]);
      }
  EXPECT_NEAR(energy / wanted, 1, 1e-12);
}

TEST(Couplings, EnergyOfHatsIsTheEnergyOfBonds) { expect_energy_of_bonds(Prepared(0.4), both_prescribed); }
TEST(Couplings, EnergyOfHatsIsTheEnergyOfBondsOnASlidingEdge) { expect_energy_of_bonds(Prepared(0.4), y_prescribed); }

TEST(CoarseSpace, CorrectionLeavesNothingOfAFieldThatItHolds) {
  // Rigid motion and strain of the whole sample lie in the space: r = -f(u) must give u back, but for what the clamped
  // rows take.
  const Prepared s(1000);
  const Aggregates aggregates = cut_into_aggregates(s.map, s.bonds, s.prescribed);
  statics::CoarseSpace coarse(s.bonds.grid, aggregates,
                              couplings(s.bonds, aggregates, block_diagonal(s.bonds), s.prescribed), s.prescribed);
  EXPECT_EQ(coarse.repairs(), 0);
  Field<float> u(s.bonds.grid.padded_size()), r(s.bonds.grid.padded_size()), z(s.bonds.grid.padded_size());
  for (int y = 1; y < s.map.height - 1; ++y)
    for (int x = 0; x < s.map.width; ++x) {
      u.x[s.bonds.grid.index(x, y)] = 1 + 0.01f * static_cast<float>(y);
      u.y[s.bonds.grid.index(x, y)] = 2 - 0.02f * static_cast<float>(x);
    }
  kernels().force_float(s.bonds, s.prescribed.data(), pointers(u), pointers(r));
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(r.x.size()); ++i) {
    r.x[i] = -r.x[i];
    r.y[i] = -r.y[i];
  }
  coarse.correct(pointers(r), pointers(z));
  for (int y = 1; y < s.map.height - 1; ++y)
    for (int x = 0; x < s.map.width; ++x) {
      ASSERT_NEAR(z.x[s.bonds.grid.index(x, y)], u.x[s.bonds.grid.index(x, y)], 2e-4) << x << " " << y;
      ASSERT_NEAR(z.y[s.bonds.grid.index(x, y)], u.y[s.bonds.grid.index(x, y)], 2e-4) << x << " " << y;
    }
}

}  // namespace
}  // namespace arenite::peridynamics
