#include "grains/dem/sample.hpp"

namespace arenite::dem {

namespace {

/// Homogeneous motion between two edges.
AffineMotion between(const Wall& a, const Wall& b) {
  return {a.position, a.velocity, (b.velocity - a.velocity) / (b.position - a.position)};
}

}  // namespace

AffineMotion affine_x(const Domain& d) { return d.periodic_x ? between(d.wall[left], d.wall[right]) : AffineMotion{}; }
AffineMotion affine_y(const Domain& d) { return d.periodic_y ? between(d.wall[bottom], d.wall[top]) : AffineMotion{}; }

}  // namespace arenite::dem
