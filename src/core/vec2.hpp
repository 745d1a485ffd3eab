#pragma once
#include <cmath>

namespace arenite {

/// Plane vector; SI units of whatever it holds.
struct Vec2 {
  double x = 0, y = 0;
  constexpr Vec2& operator+=(Vec2 b) { x += b.x; y += b.y; return *this; }
  constexpr Vec2& operator-=(Vec2 b) { x -= b.x; y -= b.y; return *this; }
};
constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Out-of-plane component of the cross product.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }
/// a turned by +90 degrees (counter-clockwise).
constexpr Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }

/// 2 x 2 tensor, row by row; not necessarily symmetric.
struct Tensor2 {
  double xx = 0, xy = 0, yx = 0, yy = 0;
  constexpr Tensor2& operator+=(const Tensor2& b) {
    xx += b.xx; xy += b.xy; yx += b.yx; yy += b.yy;
    return *this;
  }
};
constexpr Tensor2 operator*(double s, const Tensor2& a) { return {s * a.xx, s * a.xy, s * a.yx, s * a.yy}; }
/// Dyadic product a (x) b.
constexpr Tensor2 outer(Vec2 a, Vec2 b) { return {a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y}; }
constexpr double trace(const Tensor2& a) { return a.xx + a.yy; }

}  // namespace arenite
