#pragma once
#include <vector>

// The ways to the field against each other, and properties that any right field has.

#include "solid/peridynamics/load.hpp"
#include "support/cemented_sample.hpp"
#include "support/homogeneous_sample.hpp"

namespace arenite::peridynamics {

inline PhaseMap cemented(int nodes = 96, double bridge = 0.4, double gamma = 2) {
  return test::cemented_sample({.nodes = nodes, .size_ratio = gamma, .bridge = bridge});
}

inline LoadResult loaded(const PhaseMap& map, LoadOptions options, double tolerance = 1e-10) {
  options.tolerance = tolerance;
  return load(map, options);
}

inline double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

}  // namespace arenite::peridynamics
