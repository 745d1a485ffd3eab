#pragma once
#include <cstddef>
#include <vector>

#include "thermal/identify/curve.hpp"
#include "thermal/identify/regression.hpp"

namespace arenite::identify {

enum class Branch { loading, unloading };

struct StiffnessOptions {
  double preload = 1000;            ///< N; only what lies beyond it counts, so that the cylinder does not settle any more (T 2.2.2)
  Branch branch = Branch::loading;
};

/// One loading (or unloading) of a curve: points first to last, both included.
struct Cycle {
  std::size_t first = 0, last = 0;
  double peak = 0;                  ///< greatest force, N, positive
  statistics::Measured stiffness;   ///< N/m
  double r2 = statistics::unknown;
};

/// Contact stiffness k = F/delta (T eq. 2.1) of every cycle of a force-displacement record, x the displacement (m), y the
/// force (N); which sign compression has is found out. k is one over the slope of the displacement against the force, over
/// the points whose force exceeds the preload: the test controls the force, the noise is in the displacement, and points
/// chosen by what the line is drawn against leave its slope unbiased.
/// Cycles are cut at the turning points of the force, swings below 5 % of its range being noise. Throws InputError with
/// file and line if the preload is not reached, a cycle has fewer than five points beyond it, the force falls back in a loading
/// without coming below half of its peak, or the displacement runs back.
std::vector<Cycle> cycles_of(const Curve& curve, const StiffnessOptions& options = {});

}  // namespace arenite::identify
