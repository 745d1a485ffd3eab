#pragma once
#include <cmath>

#include "core/vec.hpp"

namespace arenite::geometry {

/// A rotation in space as a unit quaternion: the cosine of half its angle, and its axis times the sine of that.
template <class V> struct RotationOf {
  V cosine = V(1.0);
  Vec<3, V> sine{};
  bool operator==(const RotationOf&) const = default;
};
using Rotation = RotationOf<double>;

/// First b, then a.
template <class V> inline RotationOf<V> operator*(const RotationOf<V>& a, const RotationOf<V>& b) {
  return {a.cosine * b.cosine - dot(a.sine, b.sine), a.cosine * b.sine + b.cosine * a.sine + cross(a.sine, b.sine)};
}
template <class V> inline RotationOf<V> inverse(const RotationOf<V>& r) { return {r.cosine, -r.sine}; }

template <class V> inline Vec<3, V> turned(const RotationOf<V>& r, Vec<3, V> v) {
  const Vec<3, V> twice = V(2.0) * cross(r.sine, v);
  return v + r.cosine * twice + cross(r.sine, twice);
}

/// About the axis of a vector, by its length, rad.
inline Rotation rotation_by(Vec3 vector) {
  const double square = 0.25 * dot(vector, vector);
  if (square > 1e-8) {
    const double half = std::sqrt(square);
    return {std::cos(half), std::sin(half) / (2 * half) * vector};
  }
  return {1 - square / 2, (0.5 - square / 12) * vector};  // exact to the last bit
}

/// The vector that turns so, at most half a turn long, rad.
inline Vec3 vector_of(const Rotation& r) {
  const double size = norm(r.sine);
  if (!(size > 0)) return {};
  const double half = r.cosine < 0 ? std::atan2(-size, -r.cosine) : std::atan2(size, r.cosine);
  return 2 * half / size * r.sine;
}

/// With rounding errors taken off its length.
inline Rotation normalised(const Rotation& r) {
  const double share = 1 / std::sqrt(r.cosine * r.cosine + dot(r.sine, r.sine));
  return {share * r.cosine, share * r.sine};
}

}  // namespace arenite::geometry
