#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/vec.hpp"
#include "geometry/meniscus.hpp"
#include "model/cement.hpp"
#include "solid/grid/grid.hpp"

namespace arenite::grid {

/// Nodes of a square about the origin, n a side, at the middles of its cells. Coordinates of node k and its mirror image
/// n - 1 - k differ in sign only, to the last bit.
struct Lattice {
  int n;
  double dx;
  double at(int k) const { return (k - 0.5 * (n - 1)) * dx; }
  double place(double x) const { return x / dx + 0.5 * (n - 1); }  ///< the k, between nodes, where x lies
  int first(double x) const { return static_cast<int>(std::clamp(std::ceil(place(x)), 0.0, static_cast<double>(n))); }
  int last(double x) const { return static_cast<int>(std::clamp(std::floor(place(x)), -1.0, n - 1.0)); }
};

/// Calls row(y, x0, x1) for every row of nodes with those in the disk: distance^2 <= radius^2 as computed.
template <class Row> void visit_disk(const Lattice& lattice, Vec2 centre, double radius, Row&& row) {
  const double r2 = radius * radius;
  const int top = std::min(lattice.n - 1, lattice.last(centre.y + radius) + 1);
  for (int y = std::max(0, lattice.first(centre.y - radius) - 1); y <= top; ++y) {
    const double dy = lattice.at(y) - centre.y, dy2 = dy * dy;
    const auto inside = [&](int x) {
      const double d = lattice.at(x) - centre.x;
      return d * d + dy2 <= r2;
    };
    if (dy2 > r2) continue;
    const double half = std::sqrt(r2 - dy2);
    int x0 = lattice.first(centre.x - half), x1 = lattice.last(centre.x + half);
    // A root's rounding may miss a node on the circle, or take one beside it.
    while (x0 > 0 && inside(x0 - 1)) --x0;
    while (x1 < lattice.n - 1 && inside(x1 + 1)) ++x1;
    while (x0 <= x1 && !inside(x0)) ++x0;
    while (x0 <= x1 && !inside(x1)) --x1;
    if (x0 <= x1) row(y, x0, x1);
  }
}

/// Calls row(y, x0, x1) for every row of nodes that may lie in the polygon, one node wider on both sides.
template <class Row> void visit_polygon(const Lattice& lattice, const Vec2* corner, int corners, Row&& row) {
  double low = corner[0].y, high = low;
  for (int k = 1; k < corners; ++k) low = std::min(low, corner[k].y), high = std::max(high, corner[k].y);
  const double slack = 1e-6 * lattice.dx;
  const int last = lattice.last(high + slack);
  for (int y = lattice.first(low - slack); y <= last; ++y) {
    const double at = std::clamp(lattice.at(y), low, high);
    double left = INFINITY, right = -INFINITY;
    for (int k = 0; k < corners; ++k) {
      const Vec2 p = corner[k], q = corner[k + 1 == corners ? 0 : k + 1];
      if (at < std::min(p.y, q.y) || at > std::max(p.y, q.y)) continue;
      const double x = q.y == p.y ? q.x : p.x + (at - p.y) / (q.y - p.y) * (q.x - p.x);
      left = std::min({left, x, q.y == p.y ? p.x : x});
      right = std::max({right, x, q.y == p.y ? p.x : x});
    }
    if (left > right) continue;
    const int x0 = std::max(0, lattice.first(left) - 1), x1 = std::min(lattice.n - 1, lattice.last(right) + 1);
    if (x0 <= x1) row(y, x0, x1);
  }
}

/// Whether a point lies in a bridge or meniscus. Only products whose value a mirror image or an exchange of x and y keeps
/// to the last bit are used, so that the map of a mirrored sample is the mirrored map.
class NeckShape {
 public:
  static NeckShape bridge(const PlacedCement::Neck& neck) { return NeckShape(neck); }
  /// Nothing where the arcs meet.
  static std::optional<NeckShape> meniscus(const PlacedCement::Neck& neck) {
    NeckShape shape(neck);
    shape.arcs_ = geometry::meniscus_shape({neck.radius_a, neck.radius_b, shape.length_}, neck.arc);
    if (!shape.arcs_) return {};
    return shape;
  }

  bool contains(Vec2 p) const {
    const Vec2 e = p - neck_.a;
    const double along = dot(e, d_), across = std::abs(cross(e, d_));
    if (arcs_) return arcs_->contains({along / length_, across / length_});
    return along >= 0 && along <= length2_ && across * length_ <= neck_.half_a * (length2_ - along) + neck_.half_b * along;
  }

  const PlacedCement::Neck& neck() const { return neck_; }
  double length() const { return length_; }
  Vec2 direction() const { return (1 / length_) * d_; }
  bool is_meniscus() const { return arcs_.has_value(); }

  /// Corners of a polygon that holds it all.
  struct Hull {
    Vec2 corner[6];
    int count;
  };
  Hull hull() const {
    const Vec2 along = direction(), up = perpendicular(along), a = neck_.a, b = neck_.b;
    if (!arcs_) return {{a - neck_.half_a * up, b - neck_.half_b * up, b + neck_.half_b * up, a + neck_.half_a * up}, 4};
    const Vec2 i = arcs_->touch_i, j = arcs_->touch_j;
    return {{a, a + i.x * along - i.y * up, a + j.x * along - j.y * up, b, a + j.x * along + j.y * up, a + i.x * along + i.y * up}, 6};
  }

 private:
  explicit NeckShape(const PlacedCement::Neck& neck) : neck_(neck), d_(neck.b - neck.a), length2_(dot(d_, d_)), length_(std::sqrt(length2_)) {}

  PlacedCement::Neck neck_;
  Vec2 d_;
  double length2_, length_;
  std::optional<geometry::MeniscusShape> arcs_;
};

}  // namespace arenite::grid
