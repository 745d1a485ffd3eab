#pragma once
#include <cstddef>
#include <vector>

namespace arenite {

/// Displacement and stress at every node of a phase map, in its order; zero in the void. Tension is positive.
struct StressField {
  int width = 0, height = 0;
  double dx = 1;                   ///< m
  std::vector<double> ux, uy;      ///< m
  std::vector<double> xx, yy, xy;  ///< Pa
  std::size_t size() const { return xx.size(); }
};

}  // namespace arenite
