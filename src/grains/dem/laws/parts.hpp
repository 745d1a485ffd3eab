#pragma once
#include <cmath>

#include "core/parameters.hpp"
#include "core/vec.hpp"

namespace arenite::dem {

/// The few functions that a law calls beside + - * /. Laws are written once over a number type V; these serve V =
/// double, a batch type brings its own overloads (found by its namespace). `dot` and `within` also take the vectors T
/// in which slip is counted where space has three dimensions.
namespace lane {
inline double min(double a, double b) { return b < a ? b : a; }
inline double max(double a, double b) { return a < b ? b : a; }
inline double sqrt(double a) { return std::sqrt(a); }
inline double abs(double a) { return std::abs(a); }
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
inline double dot(double a, double b) { return a * b; }
template <int D, class C, class V> Vec<D, V> select(const C& condition, Vec<D, V> yes, Vec<D, V> no) {
  return by_axis<D>([&](int axis) { return select(condition, yes[axis], no[axis]); });
}

/// a held within [-bound, bound], bound >= 0.
template <class V> V within(V a, V bound) { return max(min(a, bound), V(0.0) - bound); }
template <int D, class V> Vec<D, V> within(Vec<D, V> a, V bound) {
  const V size = norm(a);
  return select(size > bound, bound / size, V(1.0)) * a;
}
}  // namespace lane

/// What of a turning about a contact of this normal slides: grains that turn about the normal itself twist, which
/// spheres of space alone can do.
template <class V> inline V without_twist(V turning, const Vec<2, V>& /*normal*/) { return turning; }
template <class V> inline Vec<3, V> without_twist(const Vec<3, V>& turning, const Vec<3, V>& normal) {
  return turning - dot(turning, normal) * normal;
}

/// A law without parameters of its own. One that has some declares and compares them.
struct WithoutParameters {
  void declare(ParameterVisitor&) {}
  bool operator==(const WithoutParameters&) const = default;
};

/// The law of a family that gives no force.
struct NoLaw : WithoutParameters {};

/// What a friction law sees of one contact. T counts along the contact: it is V in the plane, a vector in space.
template <class V, class T = V> struct Slip {
  T velocity;   ///< v_s, m/s
  V viscosity;  ///< gamma_s, N s/m
  V cap;        ///< greatest force, N
  V stiffness;  ///< k_t, N/m
  V lead, lag;  ///< s: ways that the memory has yet to make at this velocity, before the force is known and after it
};

}  // namespace arenite::dem
