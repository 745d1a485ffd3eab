#pragma once
#include "grains/dem/integrators/nordsieck.hpp"
#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"

namespace arenite::dem {

/// Sum of the slots of groups first[q] .. first[q + 1].
ARENITE_INLINE Pack<4> sum_of_groups(const SweepTask& t, std::size_t q) {
  Pack<4> total(0.0);
  for (auto g = static_cast<std::size_t>(t.first[q]); g < static_cast<std::size_t>(t.first[q + 1]); g += 4) {
    const auto at = [&](std::size_t n) { return Pack<4>::load(&t.force[t.group[g + n]].on_i.x); };
    total = total + ((at(0) + at(1)) + (at(2) + at(3)));
  }
  return total;
}

/// Contact forces on W disks from k on; the same sums as contact_load.
template <int W> struct LoadPack {
  Vec<2, Pack<W>> force;
  Pack<W> torque;

  ARENITE_INLINE LoadPack(const SweepTask& t, std::size_t k) {
    Pack<4> load[W];
#pragma GCC unroll 8
    for (std::size_t n = 0; n < W; ++n) {
      const Pack<4> own = sum_of_groups(t, 2 * (k + n)), reaction = sum_of_groups(t, 2 * (k + n) + 1);
      const Pack<4> turned = __builtin_shufflevector(reaction.raw, reaction.raw, 0, 1, 3, 2);
      load[n] = __builtin_shufflevector((own - reaction).raw, (own + turned).raw, 0, 1, 6, 7);
    }
    Pack<W> spare;
    sort_pieces<W>([&](int n) { return Piece(__builtin_shufflevector(load[n].raw, load[n].raw, 0, 1)); }, force.x, force.y);
    sort_pieces<W>([&](int n) { return Piece(__builtin_shufflevector(load[n].raw, load[n].raw, 2, 3)); }, torque, spare);
  }
};

/// W disks as they were seen by the forces, and their accelerations.
template <int W> struct MotionPack {
  Vec<2, Pack<W>> place, acceleration;
  Pack<W> radius, alpha;

  ARENITE_INLINE MotionPack(const SweepTask& t, std::size_t k) {
    using V = Pack<W>;
    const LoadPack<W> load(t, k);
    const DiskRecord* d = t.record + k;
    Vec<2, V> velocity;
    V omega, mass, spare;
    gather<W>([=](int n) { return &d[n].place.x; }, place);
    gather<W>([=](int n) { return &d[n].velocity.x; }, velocity);
    gather<W>([=](int n) { return &d[n].omega; }, omega, radius);
    gather<W>([=](int n) { return &d[n].mass; }, mass, spare);
    const V inverse = V(1.0) / mass;
    acceleration = by_axis<2>(
        [&](int axis) { return load.force[axis] * inverse + V(t.gravity[axis]) - V(t.drag) * (velocity[axis] - t.before.along[axis].at(place[axis])); });
    alpha = V(t.turning) * load.torque / (V(0.5) * mass * radius * radius);
  }
};

/// Puts W disks where they are seen next. All bits set where a disk is near enough to its place in the list.
template <int W>
ARENITE_INLINE typename Pack<W>::Bits put(const SweepTask& t, std::size_t k, const MotionPack<W>& m, Vec<2, Pack<W>> place, Vec<2, Pack<W>> velocity,
                                          Pack<W> omega) {
  DiskRecord* d = t.record + k;
  const Vec<2, Pack<W>> seen = velocity + t.after.at(place);
  scatter<W>([=](int n) { return &d[n].place.x; }, place.x, place.y);
  scatter<W>([=](int n) { return &d[n].velocity.x; }, seen.x, seen.y);
  scatter<W>([=](int n) { return &d[n].omega; }, omega, m.radius);
  const auto way = way_since_listed(t, place, load_vector<W, 2>(t.listed, k));
  return dot(way, way) <= Pack<W>(t.limit);
}

/// W disks at a time by Batch<W>, the last ones singly.
template <int W, template <int> class Batch> __attribute__((flatten)) bool sweep(const SweepTask& task, std::size_t begin, std::size_t end) {
  const SweepTask t = task;  // a copy that no store can reach stays in registers
  auto near = Pack<W>(0.0) <= Pack<W>(0.0);
  bool last_near = true;
  std::size_t k = begin;
  for (; k + W <= end; k += W) near &= Batch<W>::run(t, k);
  for (; k < end; ++k) last_near &= Batch<1>::run(t, k)[0] != 0;
  for (int n = 0; n < W; ++n) last_near &= near[n] != 0;
  return last_near;
}

/// One step of velocity Verlet for W disks (integrators/verlet.cpp).
template <int W> struct VerletBatch {
  ARENITE_INLINE static typename Pack<W>::Bits run(const SweepTask& t, std::size_t k) {
    using V = Pack<W>;
    const MotionPack<W> m(t, k);
    const V kick(t.kick), ahead(t.ahead);
    const Vec<2, V> velocity = load_vector<W, 2>(t.velocity, k) + kick * m.acceleration;
    const V omega = V::load(t.omega + k) + kick * m.alpha;
    store_vector<W, 2>(velocity, t.velocity, k);
    omega.store(t.omega + k);
    (V::load(t.angle + k) + V(t.dt) * omega).store(t.angle + k);
    // A way made during the step is carried along by a growing cell for half of it, on average.
    const auto place = by_axis<2>([&](int axis) {
      const Stretch& cell = t.moved[axis];
      return cell.apply(m.place[axis]) + V(t.dt * (1 + 0.5 * cell.growth())) * velocity[axis];
    });
    return put<W>(t, k, m, place, velocity + ahead * m.acceleration, omega + ahead * m.alpha);
  }
};

/// Corrects one coordinate (x, y or angle) of W disks and predicts its next values. Returns the way made in the step, from `start` on; `growth` is that of a periodic
/// cell, which carries a way along for what is left of the step.
template <int W>
ARENITE_INLINE Pack<W> correct_and_predict(const SweepTask& t, std::size_t k, int axis, double* velocity, double* acceleration, Pack<W> now, Pack<W> start,
                                           double growth) {
  using V = Pack<W>;
  const double half = 0.5 * t.dt * t.dt;
  double *const q3 = t.higher[axis][0] + k, *const q4 = t.higher[axis][1] + k, *const q5 = t.higher[axis][2] + k;
  const V predicted = V::load(acceleration + k);
  Nordsieck<V> q{start, V(t.dt) * V::load(velocity + k), V(half) * predicted, V::load(q3), V::load(q4), V::load(q5)};
  q.correct(V(half) * (now - predicted));
  const V carried = V(growth) * q.weighted_way();
  q.predict();
  (V(1.0 / t.dt) * q.q1).store(velocity + k);
  (V(1.0 / half) * q.q2).store(acceleration + k);
  q.q3.store(q3);
  q.q4.store(q4);
  q.q5.store(q5);
  return q.q0 + carried;
}

/// One fused sweep of Gear's method for W disks (integrators/gear.cpp).
template <int W> struct GearBatch {
  ARENITE_INLINE static typename Pack<W>::Bits run(const SweepTask& t, std::size_t k) {
    using V = Pack<W>;
    const V zero(0.0);
    const MotionPack<W> m(t, k);
    const auto place = by_axis<2>([&](int axis) {
      const Stretch& cell = t.moved[axis];
      return cell.apply(m.place[axis]) + correct_and_predict<W>(t, k, axis, t.velocity[axis], t.acceleration[axis], m.acceleration[axis], zero, cell.growth());
    });
    correct_and_predict<W>(t, k, 2, t.omega, t.alpha, m.alpha, V::load(t.angle + k), 0).store(t.angle + k);
    return put<W>(t, k, m, place, load_vector<W, 2>(t.velocity, k), V::load(t.omega + k));
  }
};

}  // namespace arenite::dem
