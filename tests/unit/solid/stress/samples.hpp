#pragma once
#include "model/phase_map.hpp"

namespace arenite::stress {

/// A field of zero stress that fits the map.
inline StressField no_stress(const PhaseMap& map) {
  StressField field;
  field.width = map.width;
  field.height = map.height;
  field.dx = map.dx;
  field.ux = field.uy = field.xx = field.yy = field.xy = std::vector<double>(map.size(), 0.0);
  return field;
}

/// sigma_yy = f(x, y) in every node that is not void, x and y being node numbers.
template <class F> StressField pulled(const PhaseMap& map, F&& f) {
  StressField field = no_stress(map);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      if (const std::size_t i = map.index(x, y); map.phase[i] != Phase::empty) field.yy[i] = f(x, y);
  return field;
}

/// Disks of two classes on a square pattern, every second row void between them, the rest matrix.
inline PhaseMap disks(int nodes = 96, int spacing = 24) {
  PhaseMap map = make_phase_map(nodes, nodes, 1e-3);
  for (auto& p : map.phase) p = Phase::matrix;
  for (int cy = spacing / 2; cy < nodes; cy += spacing)
    for (int cx = spacing / 2; cx < nodes; cx += spacing) {
      const auto grain = static_cast<std::int32_t>(map.grain_class.size());
      const bool large = grain % 2 == 0;
      const int r = large ? 10 : 6;
      map.grain_class.push_back(large ? GrainClass::large : GrainClass::small);
      for (int y = 0; y < nodes; ++y)
        for (int x = 0; x < nodes; ++x)
          if ((x - cx) * (x - cx) + (y - cy) * (y - cy) <= r * r) {
            map.phase[map.index(x, y)] = Phase::particle;
            map.grain[map.index(x, y)] = grain;
          }
    }
  for (int y = 0; y < nodes; y += 12)
    for (int x = 0; x < nodes; ++x)
      if (map.phase[map.index(x, y)] == Phase::matrix) map.phase[map.index(x, y)] = Phase::empty;
  return map;
}

}  // namespace arenite::stress
