#include "dem/sample.hpp"

namespace arenite::dem {

namespace {

/// Homogeneous motion between two walls or edges.
AffineMotion between(const Wall& a, const Wall& b) {
  return {a.position, a.velocity, (b.velocity - a.velocity) / (b.position - a.position)};
}

}  // namespace

AffineMotion affine_x(const Domain& d) { return d.periodic_x ? between(d.wall[left], d.wall[right]) : AffineMotion{}; }
AffineMotion affine_y(const Domain& d) { return d.periodic_y ? between(d.wall[bottom], d.wall[top]) : AffineMotion{}; }

AffineMotion carrier_x(const Domain& d) {
  return d.wall[left].present && d.wall[right].present ? between(d.wall[left], d.wall[right]) : affine_x(d);
}
AffineMotion carrier_y(const Domain& d) {
  return d.wall[bottom].present && d.wall[top].present ? between(d.wall[bottom], d.wall[top]) : affine_y(d);
}

}  // namespace arenite::dem
