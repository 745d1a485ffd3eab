#pragma once
#include <utility>

#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// What the pair loop needs of W disks.
template <int W> struct DiskPack {
  Pack<W> x, y, vx, vy, omega, radius;

  ARENITE_INLINE DiskPack(const DiskRecord* record, const std::int32_t* index) {
    gather<W>([=](int k) { return &record[index[k]].place.x; }, x, y);
    gather<W>([=](int k) { return &record[index[k]].velocity.x; }, vx, vy);
    gather<W>([=](int k) { return &record[index[k]].omega; }, omega, radius);
  }
};

/// Forces of W slots from p on.
template <int W, class N, class A, class F>
ARENITE_INLINE void pair_batch(const PairTask& t, const ContactLaws& shared, const N& normal, const A& adhesion, const F& friction, std::size_t p) {
  using V = Pack<W>;
  const V zero(0.0);
  const DiskPack<W> a(t.record, t.i + p), b(t.record, t.j + p);
  const V dx = a.x - b.x, dy = a.y - b.y;
  const V squared = dx * dx + dy * dy, distance = sqrt(squared);
  const V inverse = distance * (V(1.0) / squared);  // root and quotient in parallel
  const V nx = inverse * dx, ny = inverse * dy;
  const V overlap = a.radius + b.radius - distance;
  const V arm_i = a.radius - V(t.arm_share) * overlap, arm_j = b.radius - V(t.arm_share) * overlap;
  const V ux = a.vx - b.vx, uy = a.vy - b.vy;

  const V strength = V::load(t.strength + p);
  V floor(t.floor);
  if constexpr (A::attracts) floor = select(strength > zero, V(-__builtin_inf()), floor);
  ContactState<V> state{overlap,
                        zero - (ux * nx + uy * ny),
                        uy * nx - ux * ny - a.omega * arm_i - b.omega * arm_j,
                        V(1.0) / a.radius + V(1.0) / b.radius,
                        V::load(t.stiffness + p),
                        V::load(t.damping + p),
                        V::load(t.viscosity + p),
                        strength,
                        V(t.friction),
                        floor};
  if constexpr (ElasticContact<N>) state.shear = V::load(t.shear + p);
  ContactMemory<V> memory;
  if constexpr (N::remembers) memory.normal = V::load(t.normal_memory + p);
  if constexpr (F::remembers) memory.slip = V::load(t.memory + p);
  const ContactForce<V> f = contact_force(shared, normal, adhesion, friction, state, memory);
  const auto touching_now = overlap > zero;
  const V fn = select(touching_now, f.normal, zero), ft = select(touching_now, f.tangential, zero);
  if constexpr (N::remembers) select(touching_now, memory.normal, zero).store(t.normal_memory + p);
  if constexpr (F::remembers) select(touching_now, memory.slip, zero).store(t.memory + p);
  scatter<W>([=](int k) { return &t.force[p + static_cast<std::size_t>(k)].on_i.x; }, fn * nx - ft * ny, fn * ny + ft * nx);
  scatter<W>([=](int k) { return &t.force[p + static_cast<std::size_t>(k)].torque_i; }, zero - arm_i * ft, zero - arm_j * ft);
}

/// `flatten` compiles the laws into the loop: as calls they would double its time.
template <int W, class N, class A, class F>
__attribute__((flatten)) void pair_loop(const PairTask& given, const ContactLaws& laws, std::size_t begin, std::size_t end) {
  const PairTask task = given;  // a copy that no store can reach stays in registers
  const ContactLaws shared = laws;
  const N normal = *std::get_if<N>(&shared.normal);
  const A adhesion = *std::get_if<A>(&shared.adhesion);
  const F friction = *std::get_if<F>(&shared.friction);
  std::size_t p = begin;
  for (; p + W <= end; p += W) pair_batch<W>(task, shared, normal, adhesion, friction, p);
  for (; p < end; ++p) pair_batch<1>(task, shared, normal, adhesion, friction, p);
}

/// The loops of all triples of laws, in the order of loop_index.
template <int W, std::size_t... Q> constexpr std::array<Kernel::PairLoop, law_triples> pair_loops(std::index_sequence<Q...>) {
  return {pair_loop<W, std::variant_alternative_t<Q / friction_laws / adhesions, NormalLaw::variant>,
                    std::variant_alternative_t<Q / friction_laws % adhesions, Adhesion::variant>,
                    std::variant_alternative_t<Q % friction_laws, FrictionLaw::variant>>...};
}

}  // namespace arenite::dem
