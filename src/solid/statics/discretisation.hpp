#pragma once
#include <concepts>
#include <cstdint>
#include <vector>

#include "solid/statics/aggregates.hpp"
#include "solid/statics/block_diagonal.hpp"
#include "solid/statics/couplings.hpp"
#include "solid/statics/grid.hpp"
#include "solid/statics/pool.hpp"

namespace arenite::statics {

/// The passes over all nodes that take the time, compiled once for each kind of machine. `f(u)` is the force of the
/// discretisation `D` on a node, -K u; in rows with prescribed displacement the force of that component is not formed.
template <class D> struct KernelsOf {
  static constexpr int dimension = D::dimension;
  template <class T> using To = PointersIn<dimension, T>;
  using Inverse = BlockPointers<dimension>;
  const char* name;

  /// f := f(u); returns sum u . f.
  double (*force)(const D&, const std::uint8_t* prescribed, To<const double> u, To<double> f);
  double (*force_float)(const D&, const std::uint8_t* prescribed, To<const float> u, To<float> f);
  /// r := f(u), kept in single precision; returns the sum of its squares.
  double (*imbalance)(const D&, const std::uint8_t* prescribed, To<const double> u, To<float> r);
  /// older := z + a (z - older) + b D^-1 (r + f(z)): one Chebyshev step; then `older` is the newer.
  void (*chebyshev)(const D&, To<const float> z, To<float> older, To<const float> r, Inverse inverse, float a, float b);
  /// out := r + f(z).
  void (*residual)(const D&, To<const float> z, To<const float> r, To<float> out);
  /// older := u + a (u - older) + b f(u): one step of damped motion; then `older` is the newer. Returns sum f . f.
  double (*stormer)(const D&, const std::uint8_t* prescribed, To<const double> u, To<double> older, double a, double b);
  /// older := u + a (u - older) + b D^-1 f(u); then `older` is the newer. Returns sum f . D^-1 f.
  double (*relax)(const D&, To<const double> u, To<double> older, Inverse inverse, double a, double b);

  /// u += alpha p, r += alpha f, z := b D^-1 r; returns r . r.
  double (*conjugate_step)(const D&, float alpha, To<const float> p, To<const float> f, To<double> u, To<float> r,
                           Inverse inverse, float b, To<float> z);
  double (*dot)(const D&, To<const float> a, To<const float> b);
  /// p := z + beta p.
  void (*direct)(const D&, float beta, To<const float> z, To<float> p);
};

/// What works on a sample beside the caller; of those that may have something.
template <class D> const ThreadPool* pool_of(const D& sample) {
  if constexpr (requires { sample.pool; }) return sample.pool;
  else return nullptr;
}

/// How often and on which part of the spectrum of D^-1 K, D the block diagonal, the smoother works. No eigenvalue lies
/// above the highest: an estimate from below would cost conjugate gradients their convergence.
struct Smoothing {
  int degree;
  double lowest, highest;
};

/// What the static solver asks of a sample that is cut into nodes and what joins them: bonds (solid/peridynamics), or
/// elements in the plane or in space (solid/elements). Each is a plain struct with its grid of nodes; these are
/// functions of it.
///  - kernels_of: the passes over all nodes, for this machine.
///  - block_diagonal: the stiffness of every node against its neighbours held fast, in double.
///  - blocks_of: the same of one node at a time, where couplings ask for none.
///  - dimension: of its displacements and of its grid.
///  - couplings: the Galerkin sums of the coarse space, in double: all, or GalerkinSums.
///  - smoothing_of: the steps of the smoother.
///  - pool, where there may be threads: passes and set-up are worked on by them.
///  - rests_when_strained: whether uniform strain of one material leaves no force on any node that is free.
/// What belongs to one grain and hangs together (`Aggregates`), and the stress that a field leaves, are up to the
/// discretisation, too, but the solver does not ask for them.
template <class D>
concept Discretisation = requires(const D& d, const Aggregates& aggregates,
                                  const BlockDiagonalIn<D::dimension, double>& diagonal,
                                  const std::vector<std::uint8_t>& prescribed) {
  { d.grid } -> std::convertible_to<Grid>;
  { D::rests_when_strained } -> std::convertible_to<bool>;
  { kernels_of(d) } -> std::same_as<const KernelsOf<D>&>;
  { block_diagonal(d) } -> std::same_as<BlockDiagonalIn<D::dimension, double>>;
  { couplings(d, aggregates, diagonal, prescribed) } -> std::convertible_to<GalerkinSums<D::dimension>>;
  { smoothing_of(d) } -> std::same_as<Smoothing>;
};

}  // namespace arenite::statics
