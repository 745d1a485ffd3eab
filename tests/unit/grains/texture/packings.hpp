#pragma once
#include <cmath>

#include "core/random.hpp"
#include "model/packing.hpp"

namespace arenite::test {

/// A packing without grains: a box of this size with walls, materials A and B.
inline Packing empty_box(double width, double height, double thickness = 1) {
  Packing p;
  p.materials = {{"A", 1000, 0, 0}, {"B", 2000, 0, 0}};
  p.domain.wall[right].position = width;
  p.domain.wall[top].position = height;
  p.domain.thickness = thickness;
  return p;
}

inline void add_grain(Packing& p, Vec2 centre, double radius, int material = 0) {
  const std::size_t g = p.grains.size();
  p.grains.resize(g + 1);
  p.grains.position[g] = centre;
  p.grains.radius[g] = radius;
  p.grains.material[g] = material;
}

/// A contact between two grains as the centres have it (nearest image), arms halving the overlap.
inline void add_contact(Packing& p, std::size_t i, std::size_t j, double fn, double ft = 0) {
  const Vec2 branch = p.domain.nearest_image(p.grains.position[i] - p.grains.position[j]);
  const double d = norm(branch), h = p.grains.radius[i] + p.grains.radius[j] - d;
  p.contacts.add(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), 1 / d * branch, fn, ft,
                 p.grains.radius[i] - h / 2, p.grains.radius[j] - h / 2);
}

inline void add_wall_contact(Packing& p, std::size_t i, int side, double fn, double ft = 0) {
  const double arm = side == left || side == right ? std::abs(p.grains.position[i].x - p.domain.wall[side].position)
                                                   : std::abs(p.grains.position[i].y - p.domain.wall[side].position);
  p.contacts.add(static_cast<std::int32_t>(i), wall_partner(side), inward_normal(side), fn, ft, arm, 0);
}

/// n x n touching disks of radius 1/2 on a square lattice, periodic; every contact carries 1 N.
inline Packing square_lattice(int n) {
  Packing p = empty_box(n, n);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) add_grain(p, {x + 0.5, y + 0.5}, 0.5);
  const auto at = [&](int x, int y) { return static_cast<std::size_t>((y + n) % n * n + (x + n) % n); };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      add_contact(p, at(x, y), at(x + 1, y), 1);
      add_contact(p, at(x, y), at(x, y + 1), 1);
    }
  return p;
}

/// Touching disks of radius 1/2 on a triangular lattice with a row along x, periodic; n even. Every contact carries 1
/// N.
inline Packing triangular_lattice(int n) {
  const double row = std::sqrt(3.0) / 2;
  Packing p = empty_box(n, n * row);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) add_grain(p, {x + (y % 2 ? 0.5 : 0.0), (y + 0.5) * row}, 0.5);
  const auto at = [&](int x, int y) { return static_cast<std::size_t>((y + n) % n * n + (x + n) % n); };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int up = y % 2;  // an odd row is shifted by half a disk
      add_contact(p, at(x, y), at(x + 1, y), 1);
      add_contact(p, at(x, y), at(x + up, y + 1), 1);
      add_contact(p, at(x, y), at(x + up - 1, y + 1), 1);
    }
  return p;
}

/// Grains at random places in a box with walls, contacts between near ones with random forces, some at walls: no
/// packing at rest, but all that statistics may meet.
inline Packing random_network(std::uint64_t seed, int grains = 80) {
  RandomStream random(seed, Purpose::test);
  Packing p = empty_box(10, 8, 0.06);
  for (int g = 0; g < grains; ++g) {
    const int material = static_cast<int>(random.below(2));
    const double radius = random.uniform(0.3, 0.6);
    add_grain(p, {random.uniform(0.5, 9.5), random.uniform(0.5, 7.5)}, radius, material);
  }
  for (std::size_t i = 0; i < p.grains.size(); ++i)
    for (std::size_t j = i + 1; j < p.grains.size(); ++j)
      if (norm(p.grains.position[i] - p.grains.position[j]) < p.grains.radius[i] + p.grains.radius[j]) {
        const double along = random.uniform(-0.3, 0.3);
        add_contact(p, j, i, -std::log(1 - random.uniform()), along);
      }
  for (std::size_t i = 0; i < p.grains.size(); ++i)
    if (p.grains.position[i].y < p.grains.radius[i] + 0.2) {
      const double along = random.uniform(-0.1, 0.1);
      add_wall_contact(p, i, bottom, random.uniform(), along);
    }
  return p;
}

}  // namespace arenite::test
