#pragma once
#include <array>
#include <utility>

#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"

namespace arenite::dem {

/// Four numbers from `number` on, of the slots of groups first[q] .. first[q + 1] together.
template <int D>
ARENITE_INLINE Pack<4> sum_of_groups(const SlotForces<D>& slots, std::size_t q, std::size_t number = 0) {
  Pack<4> total(0.0);
  for (auto g = static_cast<std::size_t>(slots.first[q]); g < static_cast<std::size_t>(slots.first[q + 1]); g += 4) {
    const auto at = [&](std::size_t n) { return Pack<4>::load(&slots.force[slots.group[g + n]].on_i.x + number); };
    total = total + ((at(0) + at(1)) + (at(2) + at(3)));
  }
  return total;
}

/// Contact forces on W disks or spheres from k on: contact_load, four numbers at a time.
template <int W, int D> struct LoadPack {
  Vec<D, Pack<W>> force;
  Turning<D, Pack<W>> torque;

  ARENITE_INLINE LoadPack(const SlotForces<D>& slots, std::size_t k) {
    if constexpr (D == 2) {
      Pack<4> load[W];
#pragma GCC unroll 8
      for (std::size_t n = 0; n < W; ++n) {
        const Pack<4> own = sum_of_groups(slots, 2 * (k + n)), reaction = sum_of_groups(slots, 2 * (k + n) + 1);
        const Pack<4> turned = __builtin_shufflevector(reaction.v, reaction.v, 0, 1, 3, 2);
        load[n] = __builtin_shufflevector((own - reaction).v, (own + turned).v, 0, 1, 6, 7);
      }
      Pack<W> spare;
      sort_pieces<W>([&](int n) { return Piece(__builtin_shufflevector(load[n].v, load[n].v, 0, 1)); }, force.x,
                     force.y);
      sort_pieces<W>([&](int n) { return Piece(__builtin_shufflevector(load[n].v, load[n].v, 2, 3)); }, torque, spare);
    } else {
      Pack<4> head[W], tail[W];  // the force and the torque about x, the torques about y and z
#pragma GCC unroll 8
      for (std::size_t n = 0; n < W; ++n) {
        const std::size_t mine = 2 * (k + n), other = mine + 1;
        const Pack<4> own = sum_of_groups(slots, mine), own_behind = sum_of_groups(slots, mine, 4),
                      reaction = sum_of_groups(slots, other), reaction_behind = sum_of_groups(slots, other, 5);
        const Pack<4> turned = __builtin_shufflevector(reaction_behind.v, reaction_behind.v, 2, 3, 0, 1);
        head[n] = __builtin_shufflevector((own - reaction).v, (own + turned).v, 0, 1, 2, 7);
        tail[n] = own_behind + turned;
      }
      const auto half = [](const Pack<4>& of, bool second) {
        return second ? Piece(__builtin_shufflevector(of.v, of.v, 2, 3))
                      : Piece(__builtin_shufflevector(of.v, of.v, 0, 1));
      };
      sort_pieces<W>([&](int n) { return half(head[n], false); }, force.x, force.y);
      sort_pieces<W>([&](int n) { return half(head[n], true); }, force.z, torque.x);
      sort_pieces<W>([&](int n) { return half(tail[n], false); }, torque.y, torque.z);
    }
  }
};

/// W disks or spheres as they were seen by the forces, and their accelerations.
template <int W, int D> struct MotionPack {
  Vec<D, Pack<W>> place, acceleration;
  Pack<W> radius;
  Turning<D, Pack<W>> alpha;

  ARENITE_INLINE MotionPack(const SweepTask<D>& t, std::size_t k) {
    using V = Pack<W>;
    const LoadPack<W, D> load(t.slots, k);
    const GrainRecord<D>* d = t.record + k;
    Vec<D, V> velocity;
    V mass;
    const auto place_of = [=](int n) { return &d[n].place.x; };
    if constexpr (D == 2) {
      gather<W>(place_of, place.x, place.y, velocity.x, velocity.y);
    } else {
      gather<W>(place_of, place.x, place.y, place.z, velocity.x);
      gather<W>([=](int n) { return &d[n].velocity.y; }, velocity.y, velocity.z);
    }
    gather<W>([=](int n) { return &d[n].radius; }, radius, mass);
    const V inverse = V(1.0) / mass;
    acceleration = by_axis<D>([&](int axis) {
      return load.force[axis] * inverse + V(t.gravity[axis]) -
             V(t.drag) * (velocity[axis] - t.before.along[axis].at(place[axis]));
    });
    alpha = V(t.turning) * load.torque / (V(inertia_share<D>) * mass * radius * radius);
  }
};

/// Puts W disks or spheres where they are seen next. All bits set where one is near enough to its place in the list.
template <int W, int D>
ARENITE_INLINE typename Pack<W>::Truths put(const SweepTask<D>& t, std::size_t k, const MotionPack<W, D>& m,
                                            Vec<D, Pack<W>> place, Vec<D, Pack<W>> velocity,
                                            Turning<D, Pack<W>> omega) {
  GrainRecord<D>* d = t.record + k;
  const auto place_of = [=](int n) { return &d[n].place.x; };
  const Vec<D, Pack<W>> seen = velocity + t.after.at(place);
  if constexpr (D == 2) {
    scatter<W>(place_of, place.x, place.y, seen.x, seen.y);
    scatter<W>([=](int n) { return &d[n].omega; }, omega, m.radius);
  } else {
    scatter<W>(place_of, place.x, place.y, place.z, seen.x);
    scatter<W>([=](int n) { return &d[n].velocity.y; }, seen.y, seen.z, omega.x, omega.y);
    scatter<W>([=](int n) { return &d[n].omega.z; }, omega.z, m.radius);
  }
  const auto way = way_since_listed(t, place, load_columns<W>(t.listed, k));
  return dot(way, way) <= Pack<W>(t.limit);
}

/// A step of W disks or spheres that kicks the integrated velocities on by the accelerations and then drifts with them.
/// A scheme that does otherwise has a specialisation.
template <IntegratorKind scheme, int W, int D> struct Step {
  ARENITE_INLINE static typename Pack<W>::Truths run(const SweepTask<D>& t, std::size_t k) {
    using V = Pack<W>;
    const MotionPack<W, D> m(t, k);
    const V kick(t.kick), ahead(t.ahead);
    const Vec<D, V> velocity = load_columns<W>(t.velocity, k) + kick * m.acceleration;
    const Turning<D, V> omega = load_columns<W>(t.omega, k) + kick * m.alpha;
    store_columns(velocity, t.velocity, k);
    store_columns(omega, t.omega, k);
    store_columns(load_columns<W>(t.angle, k) + V(t.dt) * omega, t.angle, k);
    // A way made during the step is carried along by a growing cell for half of it, on average.
    const auto place = by_axis<D>([&](int axis) {
      const Stretch& cell = t.moved[axis];
      return cell.apply(m.place[axis]) + V(t.dt * (1 + 0.5 * cell.growth())) * velocity[axis];
    });
    return put(t, k, m, place, velocity + ahead * m.acceleration, omega + ahead * m.alpha);
  }
};

/// The forces of W disks or spheres from k on.
template <int W, int D> ARENITE_INLINE void fetch(const SlotForces<D>& slots, std::size_t k) {
  for (auto g = slots.first[2 * k]; g < slots.first[2 * (k + W)]; ++g) __builtin_prefetch(&slots.force[slots.group[g]]);
}

/// W disks or spheres at a time, the last ones singly.
template <int W, int D, IntegratorKind scheme>
__attribute__((flatten)) bool sweep(const SweepTask<D>& task, std::size_t begin, std::size_t end) {
  const SweepTask<D> t = task;  // a copy that no store can reach stays in registers
  auto near = Pack<W>(0.0) <= Pack<W>(0.0);
  bool last_near = true;
  std::size_t k = begin;
  for (; k + W <= end; k += W) {
    if (t.slots.fetches && k + 2 * W <= end) fetch<W>(t.slots, k + W);
    near &= Step<scheme, W, D>::run(t, k);
  }
  for (; k < end; ++k) last_near &= Step<scheme, 1, D>::run(t, k)[0] != 0;
  for (int n = 0; n < W; ++n) last_near &= near[n] != 0;
  return last_near;
}

/// The loops of all integrators.
template <int W, int D, std::size_t... Q>
constexpr std::array<typename KernelIn<D>::Sweep, integrator_count> sweeps(std::index_sequence<Q...>) {
  return {sweep<W, D, static_cast<IntegratorKind>(Q)>...};
}

}  // namespace arenite::dem
