#pragma once
#include <vector>

#include "model/elasticity/disk_field.hpp"

namespace arenite::elasticity {

/// Points of an arc in units of its half angle (-1 to 1) and their shares of its force, which add up to 1.
struct ArcNodes {
  std::vector<double> place, share;
};

/// Fejer's second rule (even traction) or Gauss's rule for Chebyshev polynomials of the second kind (half ellipse), with
/// as many points as a field needs that is looked at from `distance`, in units of the arc's half length.
const ArcNodes& arc_nodes(Traction traction, double distance);

}  // namespace arenite::elasticity
