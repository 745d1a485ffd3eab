#include "model/phase_map.hpp"

#include <fmt/core.h>

#include <cmath>

#include "core/problems.hpp"

namespace arenite {

PhaseMap make_phase_map(int width, int height, double dx) {
  PhaseMap map{width, height, dx, {}, {}, {}};
  map.phase.assign(map.size(), Phase::empty);
  map.grain.assign(map.size(), -1);
  return map;
}

void check(const PhaseMap& map) {
  Problems problems;
  const bool has_nodes = map.width > 0 && map.height > 0;
  problems.unless(has_nodes, "a phase map of {} x {} nodes is empty; give at least one node in each direction",
                  map.width, map.height);
  problems.unless(map.dx > 0 && std::isfinite(map.dx),
                  "the node spacing of a phase map is {:g} m; give a positive length", map.dx);
  problems.unless(!has_nodes || (map.phase.size() == map.size() && map.grain.size() == map.size()),
                  "a phase map of {} x {} nodes has {} phases and {} labels; give one of each per node", map.width,
                  map.height, map.phase.size(), map.grain.size());
  problems.raise();

  const auto grains = static_cast<std::int32_t>(map.grain_class.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    const bool particle = map.phase[i] == Phase::particle;
    const auto label = map.grain[i];
    if (particle ? label >= 0 && label < grains : label == -1) continue;
    const auto x = i % static_cast<std::size_t>(map.width), y = i / static_cast<std::size_t>(map.width);
    throw InputError(
        particle ? fmt::format("the particle node ({}, {}) has grain label {}; labels run from 0 to {}", x, y, label,
                               grains - 1)
                 : fmt::format("the node ({}, {}) is not a particle but has grain label {}; give it -1", x, y, label));
  }
}

PhaseMap transposed(const PhaseMap& map) {
  PhaseMap other = make_phase_map(map.height, map.width, map.dx);
  other.grain_class = map.grain_class;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      other.phase[other.index(y, x)] = map.phase[map.index(x, y)];
      other.grain[other.index(y, x)] = map.grain[map.index(x, y)];
    }
  return other;
}

}  // namespace arenite
