#pragma once
#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "model/result.hpp"
#include "support/numbers_of.hpp"

namespace arenite::test {

/// Grains in a row that touch each other and stand on the bottom wall, with numbers that tell every field from every
/// other.
inline Packing row_of_grains(int n, double shift = 0) {
  Packing packing;
  packing.materials = {{"POM", 1410, 27.35e6, 0.0150e-6}, {"HDPE", 950, 6.43e6, 0.0258e-6}};
  packing.domain.thickness = 0.06;
  for (int side = 0; side < 4; ++side) {
    packing.domain.wall[static_cast<std::size_t>(side)].force = 100.0 + side;
    packing.domain.wall[static_cast<std::size_t>(side)].shear_force = -0.5 * side;
  }
  packing.domain.wall[left].position = -0.01;
  packing.domain.wall[right].position = 0.02 * n + shift;
  packing.domain.wall[bottom].position = 0.001 * shift;
  packing.domain.wall[top].position = 0.05;
  auto& grains = packing.grains;
  grains.resize(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double k = static_cast<double>(i);
    grains.id[i] = 100 + static_cast<std::int64_t>(i);
    grains.position[i] = {0.02 * k + shift, 0.01 + 0.0001 * k};
    grains.radius[i] = 0.0101;
    grains.material[i] = static_cast<std::int32_t>(i % 2);
    grains.zone[i] = i == 0 ? 1 : 0;
    grains.angle[i] = 0.1 * k;
    grains.velocity[i] = {1e-3 * k, -2e-3 * k};
    grains.omega[i] = 3e-3 * k;
    if (i > 0) {
      const Vec2 branch = grains.position[i - 1] - grains.position[i];
      const double half = 0.5 * norm(branch);
      packing.contacts.add(static_cast<std::int32_t>(i) - 1, static_cast<std::int32_t>(i), 0.5 / half * branch,
                           10.0 * k * k, 0.1 * k, half, half);
    }
    packing.contacts.add(static_cast<std::int32_t>(i), wall_partner(bottom), {0, 1}, 5.0 + k, -0.25,
                         grains.position[i].y - packing.domain.wall[bottom].position, 0);
  }
  if (packing.contacts.size() > 0) packing.contacts.overlap[0] = 1e-4;
  return packing;
}

inline StageResult two_snapshots(int n = 5) {
  StageResult result;
  result.provenance = {"0.1.0",
                       "load",
                       "0123456789abcdef0123456789abcdef",
                       "title = \"two snapshots\"\n",
                       7,
                       "portable",
                       {{"threads", "1"}},
                       "two snapshots"};
  result.name = "compact";
  result.outcome = "at rest after 2 increments";
  for (int f = 0; f < 2; ++f) {
    Snapshot snapshot;
    snapshot.time = 0.125 + 0.25 * f;
    snapshot.step = 1000 * (f + 1);
    snapshot.label = "increment " + std::to_string(f + 1) + " of 2";
    snapshot.packing = row_of_grains(n, 1e-4 * f);
    snapshot.energies = {1, 2, -3, 4, 5, 6, 7, 8, 9.5 + f};
    snapshot.equilibrium = {1e-5, 1e-7, 0.21, 1e-6};
    result.snapshots.push_back(snapshot);
  }
  result.history.columns = {
      {"time", "s", {0.125, 0.25, 0.375}}, {"bottom_force", "N", {1, 2, 3}}, {"age", "1", {0, 0, 0}}};
  result.texture = test::numbers_of("{\"grains\": 5}");
  return result;
}

}  // namespace arenite::test
