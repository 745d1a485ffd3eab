#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <variant>

#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"
#include "grains/dem/kernels/slots.hpp"

namespace arenite::dem {

/// How W pairs lie and move. What is tangential is counted as the turning about the contact that it makes, n x u of the
/// relative velocity u and n x f of the force f: a number in the plane, along t; in space a vector normal to n, as long
/// as the velocity or force itself.
template <int W, int D> struct PairPack {
  using V = Pack<W>;
  using Tangential = Turning<D, V>;
  Vec<D, V> normal;
  V overlap, arm_i, arm_j, approach, curvature;
  Tangential sliding;

  ARENITE_INLINE PairPack(const GrainPack<W, D>& a, const GrainPack<W, D>& b, double arm_share) {
    const Vec<D, V> branch = a.place - b.place, u = a.velocity - b.velocity;
    const V squared = dot(branch, branch), distance = sqrt(squared);
    normal = distance * (V(1.0) / squared) * branch;  // root and quotient in parallel
    overlap = a.radius + b.radius - distance;
    arm_i = a.radius - V(arm_share) * overlap;
    arm_j = b.radius - V(arm_share) * overlap;
    approach = V(0.0) - dot(u, normal);
    sliding = without_twist(cross(normal, u) - arm_i * a.omega - arm_j * b.omega, normal);
    curvature = V(1.0) / a.radius + V(1.0) / b.radius;
  }
  /// On i, N.
  ARENITE_INLINE Vec<D, V> force(V fn, Tangential ft) const { return fn * normal + cross(ft, normal); }
  /// On one of the two, N m.
  ARENITE_INLINE Tangential torque(V arm, Tangential ft) const { return Tangential{} - arm * ft; }
};

/// Forces of W slots from p on.
template <int W, int D, class N, class A, class F>
ARENITE_INLINE void pair_batch(const PairTask<D>& t, const ContactLaws& shared, const N& normal, const A& adhesion,
                               const F& friction, std::size_t p) {
  using V = Pack<W>;
  using T = Turning<D, V>;
  const V zero(0.0);
  const GrainPack<W, D> a(t.record, t.i + p), b(t.record, t.j + p);
  const PairPack<W, D> pair(a, b, t.arm_share);

  const V strength = V::load(t.strength + p);
  V floor(t.floor);
  if constexpr (A::attracts) floor = select(strength > zero, V(-__builtin_inf()), floor);
  ContactState<V, T> state{pair.overlap,
                           pair.approach,
                           pair.sliding,
                           pair.curvature,
                           V::load(t.stiffness + p),
                           V::load(t.damping + p),
                           V::load(t.viscosity + p),
                           strength,
                           V(t.friction),
                           floor};
  if constexpr (ElasticContact<N>) state.shear = V::load(t.shear + p);
  ContactMemory<V, T> memory;
  if constexpr (N::remembers) memory.normal = V::load(t.normal_memory + p);
  const T spin = a.omega + b.omega;
  if constexpr (F::remembers) memory.slip = turned_along(load_columns<W>(t.memory, p), pair.normal, spin, shared.lead);
  const ContactForce<V, T> f = contact_force(shared, normal, adhesion, friction, state, memory);
  const auto touching_now = pair.overlap > zero;
  const V fn = select(touching_now, f.normal, zero);
  const T ft = select(touching_now, without_twist(f.tangential, pair.normal), T{});
  if constexpr (N::remembers) select(touching_now, memory.normal, zero).store(t.normal_memory + p);
  if constexpr (F::remembers)
    store_columns(select(touching_now, turned_along(memory.slip, pair.normal, spin, shared.lag), T{}), t.memory, p);
  write_slots<W>(t.force + p, pair.force(fn, ft), pair.torque(pair.arm_i, ft), pair.torque(pair.arm_j, ft));
}

/// The records of the second grains of W slots from p on.
template <int W, int D> ARENITE_INLINE void fetch(const PairTask<D>& t, std::size_t p) {
  for (int k = 0; k < W; ++k) {
    const auto* const record = reinterpret_cast<const char*>(&t.record[t.j[p + k]]);
    __builtin_prefetch(record);
    if (sizeof(GrainRecord<D>) > 64) __builtin_prefetch(record + 64);
  }
}

/// `flatten` compiles the laws into the loop: as calls they would double its time.
template <int W, int D, class N, class A, class F>
__attribute__((flatten)) void pair_loop(const PairTask<D>& given, const ContactLaws& laws, std::size_t begin,
                                        std::size_t end) {
  const PairTask<D> task = given;  // a copy that no store can reach stays in registers
  const ContactLaws shared = laws;
  const N normal = *std::get_if<N>(&shared.normal);
  const A adhesion = *std::get_if<A>(&shared.adhesion);
  const F friction = *std::get_if<F>(&shared.friction);
  std::size_t p = begin;
  for (; p + W <= end; p += W) {
    if (task.fetches && p + 5 * W <= end) fetch<W>(task, p + 4 * W);
    pair_batch<W>(task, shared, normal, adhesion, friction, p);
  }
  for (; p < end; ++p) pair_batch<1>(task, shared, normal, adhesion, friction, p);
}

/// The loops of all triples of laws, in the order of loop_index.
template <int W, int D, std::size_t... Q>
constexpr std::array<typename KernelIn<D>::PairLoop, law_triples> pair_loops(std::index_sequence<Q...>) {
  return {pair_loop<W, D, std::variant_alternative_t<Q / friction_laws / adhesions, NormalLaw::variant>,
                    std::variant_alternative_t<Q / friction_laws % adhesions, Adhesion::variant>,
                    std::variant_alternative_t<Q % friction_laws, FrictionLaw::variant>>...};
}

}  // namespace arenite::dem
