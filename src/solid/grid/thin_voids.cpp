#include "solid/grid/thin_voids.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace arenite::grid {
namespace {

using Place = std::array<int, 3>;

/// Nodes of a plane, which has one layer, or of space.
struct Nodes {
  Place size;
  std::span<const Phase> phase;

  bool holds(const Place& p) const {
    return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < size[0] && p[1] < size[1] && p[2] < size[2];
  }
  std::size_t index(const Place& p) const {
    return static_cast<std::size_t>(p[0]) +
           static_cast<std::size_t>(size[0]) *
               (static_cast<std::size_t>(p[1]) + static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(p[2]));
  }
  Place place(std::size_t i) const {
    const auto x = i % static_cast<std::size_t>(size[0]), rows = i / static_cast<std::size_t>(size[0]);
    return {static_cast<int>(x), static_cast<int>(rows % static_cast<std::size_t>(size[1])),
            static_cast<int>(rows / static_cast<std::size_t>(size[1]))};
  }
  bool is_void(const Place& p) const { return phase[index(p)] == Phase::empty; }
};

Place moved(const Place& p, const Place& step, int times) {
  return {p[0] + times * step[0], p[1] + times * step[1], p[2] + times * step[2]};
}

/// Steps to half of the neighbours; back they lead to the other half.
std::vector<Place> half_of_neighbours(int layers) {
  std::vector<Place> steps;
  for (int z = 0; z <= (layers > 1 ? 1 : 0); ++z)
    for (int y = z > 0 ? -1 : 0; y <= 1; ++y)
      for (int x = z > 0 || y > 0 ? -1 : 1; x <= 1; ++x) steps.push_back({x, y, z});
  return steps;
}

/// Void nodes from one on, itself included, before the next solid; more than `most` where none follows in time.
int way_to_solid(const Nodes& nodes, const Place& from, const Place& step, int way, int most) {
  for (int k = 1; k <= most; ++k) {
    const Place next = moved(from, step, way * k);
    if (!nodes.holds(next)) break;
    if (!nodes.is_void(next)) return k;
  }
  return most + 1;
}

bool is_thin(const Nodes& nodes, const std::vector<Place>& steps, const Place& p, int most) {
  return std::ranges::any_of(steps, [&](const Place& step) {
    const int ahead = way_to_solid(nodes, p, step, 1, most);
    return ahead <= most && ahead + way_to_solid(nodes, p, step, -1, most) - 1 <= most;
  });
}

int longest(const Nodes& nodes, int most) {
  const std::vector<Place> steps = half_of_neighbours(nodes.size[2]);
  std::vector<std::uint8_t> is_open(nodes.phase.size());  // thin, and not counted yet
  for (std::size_t i = 0; i < is_open.size(); ++i)
    if (const Place p = nodes.place(i); nodes.is_void(p)) is_open[i] = is_thin(nodes, steps, p, most);
  int found = 0;
  std::vector<std::size_t> stack;
  for (std::size_t first = 0; first < is_open.size(); ++first) {
    if (is_open[first] == 0) continue;
    Place low = nodes.place(first), high = low;
    is_open[first] = 0;
    stack.assign(1, first);
    while (!stack.empty()) {
      const Place p = nodes.place(stack.back());
      stack.pop_back();
      for (std::size_t axis = 0; axis < 3; ++axis)
        low[axis] = std::min(low[axis], p[axis]), high[axis] = std::max(high[axis], p[axis]);
      for (const Place& step : steps)
        for (const int way : {1, -1})
          if (const Place next = moved(p, step, way); nodes.holds(next) && is_open[nodes.index(next)] != 0) {
            is_open[nodes.index(next)] = 0;
            stack.push_back(nodes.index(next));
          }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) found = std::max(found, high[axis] - low[axis] + 1);
  }
  return found;
}

}  // namespace

int longest_thin_void(const PhaseMap& map, int most) { return longest({{map.width, map.height, 1}, map.phase}, most); }
int longest_thin_void(const VoxelMap& map, int most) {
  return longest({{map.width, map.height, map.depth}, map.phase}, most);
}

}  // namespace arenite::grid
