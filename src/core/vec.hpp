#pragma once
#include <cmath>

namespace arenite {

/// Vector of the plane or of space; SI units of whatever it holds.
template <int D> struct Vec;
template <> struct Vec<2> {
  double x = 0, y = 0;
  constexpr double& operator[](int axis) { return axis == 0 ? x : y; }
  constexpr double operator[](int axis) const { return axis == 0 ? x : y; }
  bool operator==(const Vec&) const = default;
};
template <> struct Vec<3> {
  double x = 0, y = 0, z = 0;
  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  bool operator==(const Vec&) const = default;
};
using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

template <int D> constexpr Vec<D> operator+(Vec<D> a, Vec<D> b) {
  if constexpr (D == 2) return {a.x + b.x, a.y + b.y};
  else return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <int D> constexpr Vec<D> operator-(Vec<D> a, Vec<D> b) {
  if constexpr (D == 2) return {a.x - b.x, a.y - b.y};
  else return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <int D> constexpr Vec<D> operator-(Vec<D> a) {
  if constexpr (D == 2) return {-a.x, -a.y};
  else return {-a.x, -a.y, -a.z};
}
template <int D> constexpr Vec<D> operator*(double s, Vec<D> a) {
  if constexpr (D == 2) return {s * a.x, s * a.y};
  else return {s * a.x, s * a.y, s * a.z};
}
template <int D> constexpr Vec<D> operator/(Vec<D> a, double s) {
  if constexpr (D == 2) return {a.x / s, a.y / s};
  else return {a.x / s, a.y / s, a.z / s};
}
template <int D> constexpr Vec<D>& operator+=(Vec<D>& a, Vec<D> b) { return a = a + b; }
template <int D> constexpr Vec<D>& operator-=(Vec<D>& a, Vec<D> b) { return a = a - b; }
template <int D> constexpr double dot(Vec<D> a, Vec<D> b) {
  if constexpr (D == 2) return a.x * b.x + a.y * b.y;
  else return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <int D> bool is_finite(Vec<D> a) {
  if constexpr (D == 2) return std::isfinite(a.x) && std::isfinite(a.y);
  else return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
template <int D> double norm(Vec<D> a) { return std::sqrt(dot(a, a)); }
/// Out-of-plane component of the cross product.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
/// a turned by +90 degrees (counter-clockwise).
constexpr Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }

/// 2 x 2 tensor, row by row; not necessarily symmetric.
struct Tensor2 {
  double xx = 0, xy = 0, yx = 0, yy = 0;
  constexpr Tensor2& operator+=(const Tensor2& b) {
    xx += b.xx;
    xy += b.xy;
    yx += b.yx;
    yy += b.yy;
    return *this;
  }
};
constexpr Tensor2 operator*(double s, const Tensor2& a) { return {s * a.xx, s * a.xy, s * a.yx, s * a.yy}; }
/// Dyadic product a (x) b.
constexpr Tensor2 outer(Vec2 a, Vec2 b) { return {a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y}; }
constexpr double trace(const Tensor2& a) { return a.xx + a.yy; }

}  // namespace arenite
