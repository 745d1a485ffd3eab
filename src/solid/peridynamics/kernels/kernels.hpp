#pragma once
#include <cstdint>
#include <type_traits>

#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// What is prescribed in a row of nodes, as bits.
enum Prescribed : std::uint8_t { nothing_prescribed = 0, x_prescribed = 1, y_prescribed = 2, both_prescribed = 3 };

/// Plain pointers to one padded plane field.
template <class T>
struct Plane {
  T *x, *y;
  operator Plane<const T>() const requires(!std::is_const_v<T>) { return {x, y}; }
};

template <class T>
Plane<T> plane(Field<T>& f) {
  return {f.x.data(), f.y.data()};
}
template <class T>
Plane<const T> plane(const Field<T>& f) {
  return {f.x.data(), f.y.data()};
}

/// Symmetric 2 x 2 block of a node, the inverse of its diagonal stiffness.
struct BlockPlane {
  const float *xx, *xy, *yy;
};

/// The passes over all nodes that take the time, compiled once for each kind of machine. `f(u)` is the force of the
/// bonds on a node, linearised stretch; in rows with prescribed displacement the force of that component is not formed.
struct Kernels {
  const char* name;

  /// f := f(u); returns sum u . f.
  double (*force)(const Bonds&, const std::uint8_t* prescribed, Plane<const double> u, Plane<double> f);
  double (*force_float)(const Bonds&, const std::uint8_t* prescribed, Plane<const float> u, Plane<float> f);
  /// r := f(u), kept in single precision; returns the sum of its squares.
  double (*imbalance)(const Bonds&, const std::uint8_t* prescribed, Plane<const double> u, Plane<float> r);
  /// older := z + a (z - older) + b D^-1 (r + f(z)): one Chebyshev step; then `older` is the newer.
  void (*chebyshev)(const Bonds&, Plane<const float> z, Plane<float> older, Plane<const float> r, BlockPlane inverse,
                    float a, float b);
  /// out := r + f(z).
  void (*residual)(const Bonds&, Plane<const float> z, Plane<const float> r, Plane<float> out);
  /// older := u + a (u - older) + b f(u): one step of damped motion; then `older` is the newer. Returns sum f . f.
  double (*stormer)(const Bonds&, const std::uint8_t* prescribed, Plane<const double> u, Plane<double> older, double a,
                    double b);
  /// older := u + a (u - older) + b D^-1 f(u); then `older` is the newer. Returns sum f . D^-1 f.
  double (*relax)(const Bonds&, Plane<const double> u, Plane<double> older, BlockPlane inverse, double a, double b);

  /// u += alpha p, r += alpha f, z := b D^-1 r; returns r . r.
  double (*conjugate_step)(const Bonds&, float alpha, Plane<const float> p, Plane<const float> f, Plane<double> u,
                           Plane<float> r, BlockPlane inverse, float b, Plane<float> z);
  double (*dot)(const Bonds&, Plane<const float> a, Plane<const float> b);
  /// p := z + beta p.
  void (*direct)(const Bonds&, float beta, Plane<const float> z, Plane<float> p);
};

/// The kernels for this machine; "portable", "avx2" or "avx512" asks for one by name, nullptr if it
/// cannot run here. "avx2" and "avx512" give the same bits, "portable" rounds products and sums apart.
const Kernels& kernels();
const Kernels* kernels(const char* name);

}  // namespace arenite::peridynamics
