#pragma once
#include <cmath>
#include <optional>

#include "geometry/meniscus.hpp"
#include "model/placed_cement.hpp"

namespace arenite::raster {

/// Whether a point lies in a bridge or meniscus. Only products whose value a mirror image or an exchange of x and y keeps
/// to the last bit are used, so that the raster of a mirrored sample is the mirrored raster.
class JointShape {
 public:
  static JointShape bridge(const PlacedCement::Joint& joint) { return JointShape(joint); }
  /// Nothing where the arcs meet.
  static std::optional<JointShape> meniscus(const PlacedCement::Joint& joint) {
    JointShape shape(joint);
    shape.arcs_ = geometry::meniscus_shape({joint.radius_a, joint.radius_b, shape.length_}, joint.arc);
    if (!shape.arcs_) return {};
    return shape;
  }

  bool contains(Vec2 p) const {
    const Vec2 e = p - joint_.a;
    const double along = dot(e, d_), across = std::abs(cross(e, d_));
    if (arcs_) return arcs_->contains({along / length_, across / length_});
    return along >= 0 && along <= length2_ &&
           across * length_ <= joint_.half_a * (length2_ - along) + joint_.half_b * along;
  }

  const PlacedCement::Joint& joint() const { return joint_; }
  double length() const { return length_; }
  Vec2 direction() const { return (1 / length_) * d_; }
  bool is_meniscus() const { return arcs_.has_value(); }

  /// Corners of a polygon that holds it all.
  struct Hull {
    Vec2 corner[6];
    int count;
  };
  Hull hull() const {
    const Vec2 along = direction(), up = perpendicular(along), a = joint_.a, b = joint_.b;
    if (!arcs_)
      return {{a - joint_.half_a * up, b - joint_.half_b * up, b + joint_.half_b * up, a + joint_.half_a * up}, 4};
    const Vec2 i = arcs_->touch_i, j = arcs_->touch_j;
    return {{a, a + i.x * along - i.y * up, a + j.x * along - j.y * up, b, a + j.x * along + j.y * up,
             a + i.x * along + i.y * up}, 6};
  }

 private:
  explicit JointShape(const PlacedCement::Joint& joint)
      : joint_(joint), d_(joint.b - joint.a), length2_(dot(d_, d_)), length_(std::sqrt(length2_)) {}

  PlacedCement::Joint joint_;
  Vec2 d_;
  double length2_, length_;
  std::optional<geometry::MeniscusShape> arcs_;
};

}  // namespace arenite::raster
