#pragma once
#include "model/elasticity/effective_radius.hpp"
#include "thermal/identify/curve.hpp"
#include "statistics/measured.hpp"

namespace arenite::identify {

using elasticity::EffectiveRadius;
using elasticity::effective_radius;

/// Separation force of a pull-off record, N: the peak of the force y (tension positive) over displacement or time x (T Fig. 2.12).
/// Its error is the scatter of up to ten points before the peak about their straight line, unknown where there are fewer
/// than five. Throws InputError with file and line if the record holds no tension or fewer than three points.
struct PullOff {
  statistics::Measured force;
  bool separated = true;   ///< false where the record ends before the force has fallen to half of its peak
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

}  // namespace arenite::identify
