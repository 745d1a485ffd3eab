#pragma once
#include <cmath>
#include <type_traits>

namespace arenite {

/// Vector of the plane or of space, of numbers V; SI units of whatever it holds.
template <int D, class V = double> struct Vec;
template <class V> struct Vec<2, V> {
  V x{}, y{};
  constexpr V& operator[](int axis) { return axis == 0 ? x : y; }
  constexpr V operator[](int axis) const { return axis == 0 ? x : y; }
  bool operator==(const Vec&) const = default;
};
template <class V> struct Vec<3, V> {
  V x{}, y{}, z{};
  constexpr V& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr V operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  bool operator==(const Vec&) const = default;
};
using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

/// What turns, and what turns it: a number in the plane, a vector in space.
template <int D, class V = double> using Turning = std::conditional_t<D == 2, V, Vec<3, V>>;
template <int D> inline constexpr int turnings = D*(D - 1) / 2;  ///< in so many ways
/// About one of the axes of these ways.
template <class V> constexpr V about(const V& turning, int /*way*/) { return turning; }
template <class V> constexpr V about(const Vec<3, V>& turning, int way) { return turning[way]; }

/// The vector whose component along each axis is what `along` says of it.
template <int D, class Along> constexpr auto by_axis(Along&& along) {
  if constexpr (D == 2) return Vec<2, decltype(along(0))>{along(0), along(1)};
  else return Vec<3, decltype(along(0))>{along(0), along(1), along(2)};
}

template <int D, class V> constexpr Vec<D, V> operator+(Vec<D, V> a, Vec<D, V> b) {
  if constexpr (D == 2) return {a.x + b.x, a.y + b.y};
  else return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <int D, class V> constexpr Vec<D, V> operator-(Vec<D, V> a, Vec<D, V> b) {
  if constexpr (D == 2) return {a.x - b.x, a.y - b.y};
  else return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <int D, class V> constexpr Vec<D, V> operator-(Vec<D, V> a) {
  if constexpr (D == 2) return {-a.x, -a.y};
  else return {-a.x, -a.y, -a.z};
}
template <int D, class V> constexpr Vec<D, V> operator*(std::type_identity_t<V> s, Vec<D, V> a) {
  if constexpr (D == 2) return {s * a.x, s * a.y};
  else return {s * a.x, s * a.y, s * a.z};
}
template <int D, class V> constexpr Vec<D, V> operator/(Vec<D, V> a, std::type_identity_t<V> s) {
  if constexpr (D == 2) return {a.x / s, a.y / s};
  else return {a.x / s, a.y / s, a.z / s};
}
template <int D, class V> constexpr Vec<D, V>& operator+=(Vec<D, V>& a, Vec<D, V> b) { return a = a + b; }
template <int D, class V> constexpr Vec<D, V>& operator-=(Vec<D, V>& a, Vec<D, V> b) { return a = a - b; }
template <int D, class V> constexpr V dot(Vec<D, V> a, Vec<D, V> b) {
  if constexpr (D == 2) return a.x * b.x + a.y * b.y;
  else return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline bool is_finite(double a) { return std::isfinite(a); }
template <int D> bool is_finite(Vec<D> a) {
  if constexpr (D == 2) return std::isfinite(a.x) && std::isfinite(a.y);
  else return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
template <int D, class V> V norm(Vec<D, V> a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
/// Out-of-plane component of the cross product.
template <class V> constexpr V cross(Vec<2, V> a, Vec<2, V> b) { return a.x * b.y - a.y * b.x; }
template <class V> constexpr Vec<3, V> cross(Vec<3, V> a, Vec<3, V> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The same of a vector out of the plane, given by its length, and one in it.
template <class V> constexpr Vec<2, V> cross(std::type_identity_t<V> a, Vec<2, V> b) { return {-(a * b.y), a * b.x}; }
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
/// Radius of Mohr's circle: half the difference of the principal values of the symmetric part.
inline double mohr_radius(const Tensor2& a) { return 0.5 * std::hypot(a.xx - a.yy, a.xy + a.yx); }

}  // namespace arenite
