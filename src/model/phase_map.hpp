#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"

namespace arenite {

/// What fills a node of a grid: nothing, binding matrix, or a particle.
enum class Phase : std::uint8_t { empty = 0, matrix = 1, particle = 2 };

/// Size class of a grain (P II.B); `none` where classes mean nothing, as in a foreign map.
enum class GrainClass : std::uint8_t { none = 0, small = 1, large = 2 };

/// A cemented packing on a square lattice of nodes, row by row from the bottom: node (x, y) has index x + width y.
/// Nodes of one particle carry the same grain label, an index into `grain_class`; -1 where there is no particle.
struct PhaseMap {
  int width = 0, height = 0;            ///< nodes
  double dx = 1;                        ///< distance between neighbouring nodes, m
  std::vector<Phase> phase;             ///< one a node
  std::vector<std::int32_t> grain;      ///< one a node
  std::vector<GrainClass> grain_class;  ///< one a grain

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(y);
  }
};

/// All nodes empty, no grains.
PhaseMap make_phase_map(int width, int height, double dx);

/// What the force of a clamp is spread over: the width, m.
inline double section_of(const PhaseMap& map) { return map.width * map.dx; }

/// Throws InputError, with every problem found, unless sizes, labels and spacing fit each other.
void check(const PhaseMap& map);

/// The same sample with x and y exchanged, to load it along its other axis.
PhaseMap transposed(const PhaseMap& map);

/// Displacement and stress at every node of a phase map, in its order; zero in the void. Tension is positive.
struct StressField {
  int width = 0, height = 0;
  double dx = 1;                   ///< m
  std::vector<double> ux, uy;      ///< m
  std::vector<double> xx, yy, xy;  ///< Pa
  std::size_t size() const { return xx.size(); }
  Vec2 displacement(std::size_t node) const { return {ux[node], uy[node]}; }
};

}  // namespace arenite
