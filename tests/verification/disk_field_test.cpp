// The closed form of a loaded disk against a lattice of bonds that knows nothing of it.
#include <gtest/gtest.h>

#include <cmath>

#include "model/elasticity/disk_field.hpp"
#include "solid/peridynamics/load.hpp"

namespace arenite {
namespace {

/// One disk of `n` nodes across that touches the lower and the upper row.
PhaseMap disk_between_rows(int n) {
  PhaseMap map = make_phase_map(n, n, 1e-4);
  map.grain_class = {GrainClass::none};
  const double middle = 0.5 * (n - 1), radius = 0.5 * n;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      if (std::hypot(x - middle, y - middle) < radius) {
        map.phase[map.index(x, y)] = Phase::particle;
        map.grain[map.index(x, y)] = 0;
      }
  return map;
}

/// Relative difference (L2) of sigma_kk in the inner part of the disk, up to `part` of its radius.
double difference(int n, double part) {
  const PhaseMap map = disk_between_rows(n);
  peridynamics::LoadOptions options;
  options.loading = peridynamics::Loading::compression;
  options.tolerance = 1e-8;
  const auto loaded = peridynamics::load(map, options);
  EXPECT_EQ(loaded.report.ending, peridynamics::Ending::solved) << loaded.report.sentence;
  const double force = -loaded.report.top_force.y;
  const double radius = 0.5 * n * map.dx, chord = std::acos(1 - 2.0 / n);
  const elasticity::Disk disk{
      radius, 1, {{{0, 1}, force, 0, chord}, {{0, -1}, force, 0, chord}}, elasticity::Traction::uniform};
  double error = 0, sum = 0;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const Vec2 at{(x - 0.5 * (n - 1)) * map.dx, (y - 0.5 * (n - 1)) * map.dx};
      if (norm(at) > part * radius) continue;
      const auto k = map.index(x, y);
      const double exact = elasticity::sigma_kk(disk, at), found = loaded.field.xx[k] + loaded.field.yy[k];
      error += (found - exact) * (found - exact);
      sum += exact * exact;
    }
  }
  return std::sqrt(error / sum);
}

TEST(DiskField, LatticeOfBondsFindsTheSameStresses) {
  // 1.7 % whatever the number of nodes: what the slight anisotropy of the square lattice leaves.
  EXPECT_LT(difference(200, 0.7), 0.02);
}

}  // namespace
}  // namespace arenite
