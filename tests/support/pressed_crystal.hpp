#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "model/packing.hpp"
#include "thermal/inference/balance.hpp"
#include "thermal/inference/normal_equations.hpp"

namespace arenite::test {

/// The contact forces nearest to `wanted` (fn and ft of every contact in turn, N) that hold every grain in balance.
inline void put_balanced_forces(Packing& p, const std::vector<double>& wanted) {
  const auto touches = inference::touches_of_grains(p, p.grains.position);
  inference::NormalEquations equations(static_cast<int>(wanted.size()));
  for (std::size_t u = 0; u < wanted.size(); ++u) equations.add_diagonal(static_cast<int>(u), 1, wanted[u]);
  for (const auto& of_grain : touches) {
    std::vector<int> columns;
    std::vector<double> rows(6 * of_grain.size());
    for (std::size_t k = 0; k < of_grain.size(); ++k) {
      const Vec2 n = of_grain[k].normal, t = perpendicular(n);
      const double row[6] = {n.x, t.x, n.y, t.y, 0, 1};
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t q = 0; q < 2; ++q) rows[2 * of_grain.size() * r + 2 * k + q] = row[2 * r + q];
      columns.push_back(2 * of_grain[k].contact), columns.push_back(2 * of_grain[k].contact + 1);
    }
    equations.add(columns, rows, {0, 0, 0}, {1e9, 1e9, 1e9});
  }
  const std::vector<double> f = equations.solve();
  for (std::size_t c = 0; c < p.contacts.size(); ++c) p.contacts.fn[c] = f[2 * c], p.contacts.ft[c] = f[2 * c + 1];
}

/// Random contact forces that hold every grain in balance: those nearest to independent random ones.
inline void put_balanced_forces(Packing& p, double force, std::uint64_t seed) {
  RandomStream random(seed, Purpose::test, 5);
  std::vector<double> wanted;
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    wanted.push_back(force * (1 + 0.4 * random.normal()));
    wanted.push_back(0.2 * force * random.normal());
  }
  put_balanced_forces(p, wanted);
}

/// Equal disks of two materials on a triangular lattice between four walls, one in ten missing, with balanced forces.
inline Packing pressed_crystal(int columns, int rows, double radius, std::uint64_t seed, double force = 500) {
  Packing p;
  p.materials = {{"POM", 1410, 27.35e6, 0.0150e-6}, {"HDPE", 950, 6.43e6, 0.0258e-6}};
  RandomStream random(seed, Purpose::test, 4);
  const double height = std::sqrt(3.0) * radius;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const bool border = r == 0 || c == 0 || r == rows - 1 || c == columns - 1;
      if (!border && random.uniform() < 0.1) continue;
      const std::size_t g = p.grains.size();
      p.grains.resize(g + 1);
      p.grains.position[g].x = radius * (1 + 2 * c + (r % 2)), p.grains.position[g].y = radius + height * r,
      p.grains.radius[g] = radius;
      p.grains.material[g] = static_cast<std::int32_t>(random.below(2));
    }
  p.domain.thickness = 0.06;
  p.domain.wall[right].position = radius * (2 * columns + 1),
  p.domain.wall[top].position = 2 * radius + height * (rows - 1);
  const auto n = static_cast<std::int32_t>(p.grains.size());
  for (std::int32_t i = 0; i < n; ++i) {
    const Vec2 a = p.grains.position[static_cast<std::size_t>(i)];
    for (std::int32_t j = i + 1; j < n; ++j)
      if (const Vec2 d = a - p.grains.position[static_cast<std::size_t>(j)]; norm(d) < 2.001 * radius)
        p.contacts.add(i, j, (1 / norm(d)) * d, 0, 0, radius, radius);
    const double gap[4] = {a.x, p.domain.wall[right].position - a.x, a.y, p.domain.wall[top].position - a.y};
    for (int side = 0; side < 4; ++side)
      if (gap[side] < 1.001 * radius) p.contacts.add(i, wall_partner(side), inward_normal(side), 0, 0, radius, 0);
  }
  put_balanced_forces(p, force, seed);
  return p;
}

/// The same, its forces not given.
inline Packing without_forces(Packing p) {
  p.contacts.fn.assign(p.contacts.size(), 0.0);
  p.contacts.ft.assign(p.contacts.size(), 0.0);
  return p;
}

/// Root of the sum of squared differences over that of squares.
inline double relative_error(const std::vector<double>& found, const std::vector<double>& truth) {
  double difference = 0, size = 0;
  for (std::size_t k = 0; k < truth.size(); ++k)
    difference += (found[k] - truth[k]) * (found[k] - truth[k]), size += truth[k] * truth[k];
  return std::sqrt(difference / size);
}

inline std::vector<double> factors(const Packing& p) {
  std::vector<double> out;
  for (const Material& m : p.materials) out.push_back(m.thermoelastic_factor);
  return out;
}

}  // namespace arenite::test
