#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <variant>

#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"
#include "grains/dem/kernels/slots.hpp"

namespace arenite::dem {

/// How the grains of a contact, or of some side by side, turn against each other and press; what a contact remembers is
/// turned as the first of the caller's two grains turns, which `sense` (+1 or -1) says.
template <int D, class V> struct RollingGrains {
  Vec<D, V> normal;
  V normal_force;         ///< N, above 0 where they push
  Turning<D, V> against;  ///< of the first against the second, rad/s
  Turning<D, V> spin;     ///< both together
  V radius, inertia;      ///< R = r_i r_j/(r_i + r_j), m; likewise of the moments of inertia, kg m^2
  V stiffness, damping;   ///< of the contact along n
  V sense;
};

/// What a law of rolling, or of twisting, sees of them.
template <int D, class V, class Law, class T>
inline Slip<V, T> rolling_slip(const Law& law, const RollingGrains<D, V>& c, T turning, double lead, double lag) {
  using lane::max;
  const V stiffness = law.stiffness(c.stiffness, c.radius);
  return {turning,
          law.damping(c.damping, c.radius, stiffness, c.inertia),
          max(V(law.coefficient) * c.radius * c.normal_force, V(0.0)),
          stiffness,
          V(lead),
          V(lag)};
}

/// The moment on i against rolling; what the contact remembers goes on.
template <int D, class V, class Law>
inline Turning<D, V> rolling_moment(const Law& law, const RollingGrains<D, V>& c, Turning<D, V>& memory, double lead,
                                    double lag) {
  memory = turned_along(memory, c.normal, c.spin, lead);
  const auto slip = rolling_slip<D>(law, c, without_twist(c.against, c.normal), lead, lag);
  const Turning<D, V> moment = c.sense * law.moment(slip, memory);
  memory = turned_along(memory, c.normal, c.spin, lag);
  return moment;
}

/// The moment on i of spheres against twisting about the line between them.
template <class V, class Law>
inline Vec<3, V> twisting_moment(const Law& rolling, const RollingGrains<3, V>& c, V& memory, double lead, double lag) {
  const Law law = against_twisting(rolling);
  const V twist = c.sense * dot(c.against, c.normal);
  return law.moment(rolling_slip<3>(law, c, twist, lead, lag), memory) * c.normal;
}

template <int W, int D>
ARENITE_INLINE RollingGrains<D, Pack<W>> rolling_grains(const RollingTask<D>& t, std::size_t p,
                                                        const Vec<D, Pack<W>>& on_i) {
  using V = Pack<W>;
  const std::int32_t *i = t.i + p, *j = t.j + p;
  const GrainPack<W, D> a(t.record, i), b(t.record, j);
  V mass_i, mass_j, sense;
  for (int k = 0; k < W; ++k) {
    const GrainRecord<D>&one = t.record[i[k]], &other = t.record[j[k]];
    mass_i.v[k] = one.mass, mass_j.v[k] = other.mass;
    sense.v[k] = one.grain < other.grain ? 1 : -1;
  }
  const V share(inertia_share<D>), inertia_i = share * mass_i * a.radius * a.radius,
                                   inertia_j = share * mass_j * b.radius * b.radius;
  const Vec<D, V> line = a.place - b.place;
  const V length = sqrt(dot(line, line));
  return {line / length,
          dot(on_i, line) / length,
          sense * (a.omega - b.omega),
          a.omega + b.omega,
          a.radius * b.radius / (a.radius + b.radius),
          inertia_i * inertia_j / (inertia_i + inertia_j),
          V::load(t.stiffness + p),
          V::load(t.damping + p),
          sense};
}

template <int W, int D, class Law>
ARENITE_INLINE void rolling_batch(const RollingTask<D>& t, const Law& law, std::size_t p) {
  using V = Pack<W>;
  using T = Turning<D, V>;
  const V zero(0.0);
  SlotPack<W, D> slot(t.force + p);
  const RollingGrains<D, V> c = rolling_grains<W>(t, p, slot.on_i);
  const auto push = c.normal_force > zero;
  T memory = load_columns<W>(t.memory, p);
  T moment = select(push, rolling_moment(law, c, memory, t.lead, t.lag), T{});
  store_columns(select(push, memory, T{}), t.memory, p);
  slot.torque_i = slot.torque_i + moment;
  slot.torque_j = slot.torque_j - moment;
  if constexpr (D == 3)
    if (t.twist_memory) {
      V twisted = V::load(t.twist_memory + p);
      moment = select(push, twisting_moment(law, c, twisted, t.lead, t.lag), T{});
      select(push, twisted, zero).store(t.twist_memory + p);
      slot.torque_i = slot.torque_i + moment;
      slot.torque_j = slot.torque_j - moment;
    }
  write_slots<W>(t.force + p, slot.on_i, slot.torque_i, slot.torque_j);
}

template <int W, int D, class Law>
__attribute__((flatten)) void rolling_loop(const RollingTask<D>& given, const RollingLaw& choice, std::size_t begin,
                                           std::size_t end) {
  const RollingTask<D> task = given;  // copies that no store can reach stay in registers
  const Law law = *std::get_if<Law>(&choice);
  std::size_t p = begin;
  for (; p + W <= end; p += W) rolling_batch<W>(task, law, p);
  for (; p < end; ++p) rolling_batch<1>(task, law, p);
}

/// The loops of all laws of rolling.
template <int W, int D, std::size_t... Q>
constexpr std::array<typename KernelIn<D>::RollingLoop, sizeof...(Q)> rolling_loops(std::index_sequence<Q...>) {
  return {rolling_loop<W, D, std::variant_alternative_t<Q, RollingLaw::variant>>...};
}

}  // namespace arenite::dem
