#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "model/elasticity/disk_field.hpp"
#include "statistics/measured.hpp"

namespace arenite::identify {

/// A record of a test as it was measured: y against x, both SI, with the line of the file that each point stands in.
struct Curve {
  std::string file;  ///< for messages
  std::string name;  ///< of the test ("specimen 2"); empty where a file holds one
  std::vector<double> x, y;
  std::vector<int> line;  ///< as long as x and y
};

enum class Branch { loading, unloading };

struct StiffnessOptions {
  double preload = 1000;  ///< N; only what lies beyond it counts, so that the cylinder does not settle any more (T 2.2.2)
  Branch branch = Branch::loading;
};

/// One loading (or unloading) of a curve: points first to last, both included.
struct Cycle {
  std::size_t first = 0, last = 0;
  double peak = 0;                 ///< greatest force, N, positive
  statistics::Measured stiffness;  ///< N/m
  double r2 = statistics::unknown;
};

/// Contact stiffness k = F/delta (T eq. 2.1) of every cycle of a force-displacement record, x the displacement (m), y the
/// force (N); which sign compression has is found out. k is one over the slope of the displacement against the force, over
/// the points whose force exceeds the preload: the test controls the force, the noise is in the displacement, and points
/// chosen by what the line is drawn against leave its slope unbiased.
/// Cycles are cut at the turning points of the force, changes below 5 % of its range being noise. Throws InputError with
/// file and line if the preload is not reached, a cycle has fewer than five points beyond it, the force falls back in a loading
/// without coming below half of its peak, or the displacement runs back.
std::vector<Cycle> cycles_of(const Curve& curve, const StiffnessOptions& options = {});

using elasticity::effective_radius;
using elasticity::EffectiveRadius;

/// Separation force of a pull-off record, N: the peak of the force y (tension positive) over displacement or time x (T Fig. 2.12).
/// Its error is the scatter of up to ten points before the peak about their straight line, unknown where there are fewer
/// than five. Throws InputError with file and line if the record holds no tension or fewer than three points.
struct PullOff {
  statistics::Measured force;
  bool separated = true;  ///< false where the record ends before the force has fallen to half of its peak
};
PullOff pull_off(const Curve& curve);

/// Surface energy gamma = sqrt(4 k F_c/r_eff), N/m, from the separation force (T eq. 1.25), k of the pair in N/m.
statistics::Measured surface_energy(const statistics::Measured& separation_force, const statistics::Measured& stiffness, double effective_radius);

/// What geometrical adhesion then does at rest.
struct Threshold {
  double force = 0;         ///< F_c = r_eff gamma^2/(4 k): the greatest tension, N
  double overlap = 0;       ///< h_c = r_eff gamma^2/(4 k^2): where it acts, m
  double free_overlap = 0;  ///< h_eq = r_eff gamma^2/k^2: where no force acts, m
};
Threshold threshold(double surface_energy, double stiffness, double effective_radius);

/// A straight line through measured points.
struct Regression {
  statistics::Measured slope, intercept;  ///< the intercept is 0 and without error where the line was held to the origin
  double r2 = statistics::unknown;        ///< share of the variance of y that the line takes (about 0 if held to the origin)
  double correlation = 0;                 ///< of neighbouring residuals, 0 where it is not taken into account
};

/// y = intercept + slope x by least squares, y alone in error. Records are often sampled more densely than their noise
/// changes: from 10 points on, a positive correlation r of neighbouring residuals widens the errors by
/// sqrt((1 + r)/(1 - r)) and takes degrees of freedom by the same share, as for a first-order autoregressive noise.
/// Needs three points (two through the origin) and an x that varies; otherwise all is unknown.
Regression regress(const std::vector<double>& x, const std::vector<double>& y, bool through_origin = false);

}  // namespace arenite::identify
