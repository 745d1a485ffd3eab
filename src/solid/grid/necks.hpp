#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/vec.hpp"
#include "geometry/meniscus.hpp"
#include "model/cement.hpp"

namespace arenite::grid {

/// Nodes of a square about the origin, n a side, at the middles of its cells. Coordinates of node k and its mirror
/// image n - 1 - k differ in sign only, to the last bit.
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

/// Calls row(y, x0, x1) for every row of nodes that may lie in the quadrilateral, one node wider on both sides.
template <class Row> void visit_quadrilateral(const Lattice& lattice, const std::array<Vec2, 4>& corner, Row&& row) {
  const auto [lowest, highest] = std::ranges::minmax(corner, {}, &Vec2::y);
  const double low = lowest.y, high = highest.y, slack = 1e-6 * lattice.dx;
  const int last = lattice.last(high + slack);
  for (int y = lattice.first(low - slack); y <= last; ++y) {
    const double at = std::clamp(lattice.at(y), low, high);
    double left = INFINITY, right = -INFINITY;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec2 p = corner[k], q = corner[(k + 1) % 4];
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

/// A bridge or meniscus, and whether a point lies in it. Only products whose value a mirror image or an exchange of x
/// and y keeps to the last bit are used, so that the map of a mirrored sample is the mirrored map.
class NeckShape {
 public:
  explicit NeckShape(const PlacedCement::Neck& n)
      : neck(n),
        outlines(outlines_of(n)),
        d_(n.b - n.a),
        length2_(dot(d_, d_)),
        length_(std::sqrt(length2_)),
        arcs_(n.arc > 0 ? geometry::meniscus_shape({n.radius_a, n.radius_b, length_}, n.arc) : std::nullopt) {}

  PlacedCement::Neck neck;
  std::vector<geometry::Outline> outlines;  ///< empty: there is no such neck

  bool contains(Vec2 p) const {
    const Vec2 e = p - neck.a;
    const double along = dot(e, d_), across = std::abs(cross(e, d_));
    if (arcs_) return arcs_->contains({along / length_, across / length_});
    return along >= 0 && along <= length2_ &&
           across * length_ <= neck.half_a * (length2_ - along) + neck.half_b * along;
  }
  double length() const { return length_; }
  Vec2 direction() const { return (1 / length_) * d_; }

 private:
  Vec2 d_;
  double length2_, length_;
  std::optional<geometry::MeniscusShape> arcs_;
};

}  // namespace arenite::grid
