#pragma once
#include <cmath>

#include "core/vec.hpp"

namespace arenite::geometry {

/// A rotation in space as a unit quaternion: the cosine of half its angle, and its axis times the sine of that.
struct Rotation {
  double cosine = 1;
  Vec3 sine{};
  bool operator==(const Rotation&) const = default;
};

/// First b, then a.
inline Rotation operator*(const Rotation& a, const Rotation& b) {
  return {a.cosine * b.cosine - dot(a.sine, b.sine), a.cosine * b.sine + b.cosine * a.sine + cross(a.sine, b.sine)};
}
inline Rotation inverse(const Rotation& r) { return {r.cosine, -r.sine}; }

inline Vec3 turned(const Rotation& r, Vec3 v) {
  const Vec3 twice = 2 * cross(r.sine, v);
  return v + r.cosine * twice + cross(r.sine, twice);
}

/// About the axis of a vector, by its length, rad.
inline Rotation rotation_by(Vec3 vector) {
  const double half = 0.5 * norm(vector), square = half * half;
  if (half > 1e-4) return {std::cos(half), std::sin(half) / (2 * half) * vector};
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
  const double size = std::sqrt(r.cosine * r.cosine + dot(r.sine, r.sine));
  return {r.cosine / size, r.sine / size};
}

}  // namespace arenite::geometry
