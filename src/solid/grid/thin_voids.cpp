#include "solid/grid/thin_voids.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
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

enum class Kind : std::uint8_t { other, wide, thin, counted };

/// Nodes that hang together and are thin, and how far they reach along an axis.
struct Part {
  std::vector<std::size_t> nodes;
  int extent = 0;
};

class ThinVoids {
 public:
  ThinVoids(const Nodes& nodes, int most) : nodes_(nodes), steps_(half_of_neighbours(nodes.size[2])) {
    kind_.resize(nodes.phase.size());
    for (std::size_t i = 0; i < kind_.size(); ++i)
      if (const Place p = nodes.place(i); nodes.is_void(p))
        kind_[i] = is_thin(nodes, steps_, p, most) ? Kind::thin : Kind::wide;
  }

  int longest() {
    int found = 0;
    for (std::size_t first = 0; first < kind_.size(); ++first)
      if (kind_[first] == Kind::thin) {
        const Part part = part_from(first);
        const auto mouths = mouths_of(part);
        found = std::max(found, mouths.empty() ? part.extent : depth_from(mouths));
      }
    return found;
  }

 private:
  template <class See> void each_neighbour(std::size_t i, const See& see) const {
    const Place p = nodes_.place(i);
    for (const Place& step : steps_)
      for (const int way : {1, -1})
        if (const Place next = moved(p, step, way); nodes_.holds(next)) see(nodes_.index(next));
  }

  Part part_from(std::size_t first) {
    Part part;
    Place low = nodes_.place(first), high = low;
    kind_[first] = Kind::counted;
    part.nodes.assign(1, first);
    for (std::size_t at = 0; at < part.nodes.size(); ++at) {
      const Place p = nodes_.place(part.nodes[at]);
      for (std::size_t axis = 0; axis < 3; ++axis)
        low[axis] = std::min(low[axis], p[axis]), high[axis] = std::max(high[axis], p[axis]);
      each_neighbour(part.nodes[at], [&](std::size_t next) {
        if (kind_[next] == Kind::thin) kind_[next] = Kind::counted, part.nodes.push_back(next);
      });
    }
    for (std::size_t axis = 0; axis < 3; ++axis) part.extent = std::max(part.extent, high[axis] - low[axis] + 1);
    return part;
  }

  bool is_mouth(std::size_t i) const {
    bool is = false;
    each_neighbour(i, [&](std::size_t next) { is = is || kind_[next] == Kind::wide; });
    return is;
  }
  /// Where it opens into wider voids.
  std::vector<std::size_t> mouths_of(const Part& part) const {
    std::vector<std::size_t> mouths;
    std::ranges::copy_if(part.nodes, std::back_inserter(mouths), [&](std::size_t i) { return is_mouth(i); });
    return mouths;
  }

  /// From the mouths of a part to the node farthest from all of them. Its nodes become others, which are done with.
  int depth_from(std::vector<std::size_t> front) {
    std::vector<std::size_t> next;
    for (const std::size_t i : front) kind_[i] = Kind::other;
    int depth = 0;
    for (; !front.empty(); ++depth, front.swap(next)) {
      next.clear();
      for (const std::size_t i : front)
        each_neighbour(i, [&](std::size_t beside) {
          if (kind_[beside] == Kind::counted) kind_[beside] = Kind::other, next.push_back(beside);
        });
    }
    return depth;
  }

  const Nodes& nodes_;
  std::vector<Place> steps_;
  std::vector<Kind> kind_;
};

}  // namespace

int longest_thin_void(const PhaseMap& map, int most) {
  const Nodes nodes{{map.width, map.height, 1}, map.phase};
  return ThinVoids(nodes, most).longest();
}
int longest_thin_void(const VoxelMap& map, int most) {
  const Nodes nodes{{map.width, map.height, map.depth}, map.phase};
  return ThinVoids(nodes, most).longest();
}

}  // namespace arenite::grid
