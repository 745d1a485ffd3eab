#pragma once
#include <array>
#include <cstdint>
#include <type_traits>

#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// Plain pointers to one padded plane field.
template <class T> struct Plane {
  T *x, *y;
  operator Plane<const T>() const requires(!std::is_const_v<T>) { return {x, y}; }
};

template <class T> Plane<T> plane(Field<T>& f) { return {f.x.data(), f.y.data()}; }
template <class T> Plane<const T> plane(const Field<T>& f) { return {f.x.data(), f.y.data()}; }

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

/// The kernels of a law for this machine; "portable", "avx2" or "avx512" asks for one by name, nullptr if it cannot run
/// here. "avx2" and "avx512" give the same bits, "portable" rounds products and sums apart.
const Kernels& kernels(const BondLawChoice& law = {});
const Kernels* kernels(const char* name, const BondLawChoice& law = {});

/// The kernels of every law, in the order of BondLawChoice.
struct KernelSet {
  const char* name;
  std::array<Kernels, std::variant_size_v<BondLawChoice>> by_law;
};

}  // namespace arenite::peridynamics
