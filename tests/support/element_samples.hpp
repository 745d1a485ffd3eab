#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "core/vec.hpp"
#include "model/voxel_map.hpp"
#include "solid/elements/elements.hpp"

namespace arenite::test {

inline elements::Material alike(elements::Constants c, elements::Element element = elements::Element::wilson,
                                elements::PlaneState plane = elements::PlaneState::stress) {
  return {c, c, c, element, plane};
}
inline elements::Material two_phases() { return {{1, 0.3}, {1.5, 0.2}, {4, 0.25}}; }

/// All of one phase; particles are one grain.
inline PhaseMap solid(int width, int height, Phase phase = Phase::matrix) {
  PhaseMap map = make_phase_map(width, height, 1e-3);
  std::ranges::fill(map.phase, phase);
  if (phase == Phase::particle) {
    map.grain_class = {GrainClass::none};
    std::ranges::fill(map.grain, 0);
  }
  return map;
}
inline VoxelMap solid(int width, int height, int depth, double dx = 1) {
  VoxelMap map = make_voxel_map(width, height, depth, dx);
  std::ranges::fill(map.phase, Phase::matrix);
  return map;
}

/// A third void, a third matrix, a third of two grains that lie side by side.
inline VoxelMap random_voxels(int width, int height, int depth) {
  VoxelMap map = make_voxel_map(width, height, depth, 1);
  map.grain_class = {GrainClass::none, GrainClass::none};
  RandomStream random(2, Purpose::test);
  for (std::size_t k = 0; k < map.size(); ++k) {
    map.phase[k] = static_cast<Phase>(static_cast<int>(random.uniform(0, 3)));
    if (map.phase[k] == Phase::particle)
      map.grain[k] = k % static_cast<std::size_t>(width) * 2 > static_cast<std::size_t>(width);
  }
  return map;
}

/// Spheres of radius 12 about the places of a dense crystal, a tenth of them missing, each moved by up to one voxel,
/// with necks of radius 4 between those that are near; `filled`: all that is left is matrix.
inline VoxelMap cemented_spheres(int n, bool filled) {
  constexpr double radius = 12, neck = 4, reach = 2.3 * radius, half_step = radius * 1.41421356;
  VoxelMap map = make_voxel_map(n, n, n, 1);
  RandomStream random(5, Purpose::test);
  std::vector<Vec3> centres;
  const int steps = static_cast<int>((n + 2 * half_step) / half_step) + 1;
  for (int k = 0; k < steps; ++k)
    for (int j = 0; j < steps; ++j)
      for (int i = (k + j) % 2; i < steps; i += 2)
        if (random.uniform(0, 1) > 0.1)
          centres.push_back({i * half_step + random.uniform(-1, 1), j * half_step + random.uniform(-1, 1),
                             k * half_step + random.uniform(-1, 1)});
  const auto each_near = [&](Vec3 centre, double far, auto&& visit) {
    const auto range = [&](double at) {
      return std::pair{std::max(0, static_cast<int>(at - far)), std::min(n, static_cast<int>(at + far) + 1)};
    };
    const auto [x0, x1] = range(centre.x);
    const auto [y0, y1] = range(centre.y);
    const auto [z0, z1] = range(centre.z);
    for (int z = z0; z < z1; ++z)
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) visit(map.index(x, y, z), Vec3{x + 0.5, y + 0.5, z + 0.5} - centre);
  };
  for (std::size_t g = 0; g < centres.size(); ++g) {
    map.grain_class.push_back(GrainClass::none);
    each_near(centres[g], radius + 1, [&](std::size_t k, Vec3 d) {
      if (norm(d) >= radius) return;
      map.phase[k] = Phase::particle;
      map.grain[k] = static_cast<std::int32_t>(g);
    });
  }
  for (std::size_t g = 0; g < centres.size(); ++g)
    for (std::size_t h = g + 1; h < centres.size(); ++h) {
      const Vec3 apart = centres[h] - centres[g];
      if (norm(apart) > reach) continue;
      const Vec3 along = apart / norm(apart);
      each_near(centres[g] + 0.5 * apart, 8, [&](std::size_t k, Vec3 d) {
        if (map.phase[k] == Phase::empty && norm(d - dot(d, along) * along) < neck) map.phase[k] = Phase::matrix;
      });
    }
  if (filled) std::ranges::replace(map.phase, Phase::empty, Phase::matrix);
  return map;
}

}  // namespace arenite::test
