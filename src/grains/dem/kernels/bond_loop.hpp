#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <variant>

#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"

namespace arenite::dem {

/// The arc sine, to the last bit where |sine| < 0.15.
template <int W> ARENITE_INLINE Pack<W> small_angle(Pack<W> sine) {
  constexpr double terms[] = {135135.0 / 9676800, 10395.0 / 599040, 945.0 / 42240, 105.0 / 3456,
                              15.0 / 336,         3.0 / 40,         1.0 / 6,       1.0};
  const Pack<W> q = sine * sine;
  Pack<W> sum(2027025.0 / 175472640);
  for (const double term : terms) sum = sum * q + Pack<W>(term);
  return sine * sum;
}

template <int W> ARENITE_INLINE Pack<W> picked_numbers(const double* values, const std::int32_t* index) {
  Pack<W> numbers;
  for (int k = 0; k < W; ++k) numbers.v[k] = values[index[k]];
  return numbers;
}

/// Forces of W bonds from p on; the same as beam_motion and the law say of one. Notes which need a closer look: those
/// that may break, and those that have turned far since the list was built.
template <int W, bool damped, class Law>
ARENITE_INLINE bool bond_batch(const BondTask& t, const Law& law, std::size_t p) {
  using V = Pack<W>;
  const auto number = [p](const double* column) { return V::load(column + p); };
  const auto vector = [p](const Vec<2, const double*>& columns) {
    return Vec<2, V>{V::load(columns.x + p), V::load(columns.y + p)};
  };
  const auto& b = t.column;
  const std::int32_t *i = t.i + p, *j = t.j + p;
  const V zero(0.0), one(1.0);
  Vec<2, V> place_i, place_j;
  gather<W>([=](int k) { return &t.record[i[k]].place.x; }, place_i);
  gather<W>([=](int k) { return &t.record[j[k]].place.x; }, place_j);
  const Vec<2, V> branch = place_i - place_j - vector(b.image), before = vector(b.normal);
  const V squared = dot(branch, branch), distance = sqrt(squared), inverse = distance * (one / squared);
  const Vec<2, V> normal = inverse * branch;
  const V sine = cross(before, normal), cosine = dot(before, normal), turned = small_angle(sine);
  const V turn_i = picked_numbers<W>(t.angle, i) - number(b.angle_i) - turned,
          turn_j = picked_numbers<W>(t.angle, j) - number(b.angle_j) - turned;
  const BeamArms<V> arms{number(b.length), number(b.arm_i), number(b.arm_j)};
  const BeamOf<V> beam{number(b.beam.normal),   number(b.beam.shear),       number(b.beam.bending),
                       number(b.beam.per_area), number(b.beam.per_section), number(b.beam.friction)};
  BeamForce<V> force = law.elastic(beam, arms.strain(distance, turn_i, turn_j));
  const auto look = ~law.holds(beam, force, number(b.strength)) | ~(abs(sine) <= V(0.15)) | ~(cosine > zero);

  if constexpr (damped) {
    Vec<2, V> velocity_i, velocity_j;
    V omega_i, omega_j, radius;
    gather<W>([=](int k) { return &t.record[i[k]].velocity.x; }, velocity_i);
    gather<W>([=](int k) { return &t.record[j[k]].velocity.x; }, velocity_j);
    gather<W>([=](int k) { return &t.record[i[k]].omega; }, omega_i, radius);
    gather<W>([=](int k) { return &t.record[j[k]].omega; }, omega_j, radius);
    const Vec<2, V> u = velocity_i - velocity_j - vector(b.image_velocity);
    const BeamDashpots<V> dashpots{number(b.dashpots.normal), number(b.dashpots.shear), number(b.dashpots.bending)};
    force = force + dashpots.force(arms.rate(dot(u, normal), cross(normal, u) * inverse, omega_i, omega_j));
  }
  const BeamPull<V> pull = arms.pull(force, normal, force.shear * arms.length * inverse);
  scatter<W>([=](int k) { return &t.force[p + static_cast<std::size_t>(k)].on_i.x; }, pull.on_i.x, pull.on_i.y);
  scatter<W>([=](int k) { return &t.force[p + static_cast<std::size_t>(k)].torque_i; }, pull.torque_i, pull.torque_j);
  bool any = false;
  for (int k = 0; k < W; ++k) {
    t.look[p + static_cast<std::size_t>(k)] = look[k] != 0;
    any |= look[k] != 0;
  }
  return any;
}

template <int W, bool damped, class Law>
__attribute__((flatten)) bool bond_range(const BondTask& given, const Law& given_law, std::size_t begin,
                                         std::size_t end) {
  const BondTask task = given;  // copies that no store can reach stay in registers
  const Law law = given_law;
  bool any = false;
  std::size_t p = begin;
  for (; p + W <= end; p += W) any |= bond_batch<W, damped>(task, law, p);
  for (; p < end; ++p) any |= bond_batch<1, damped>(task, law, p);
  return any;
}

/// Bonds begin .. end-1. True if some need a closer look.
template <int W, class Law>
bool bond_loop(const BondTask& task, const BondLaw& choice, std::size_t begin, std::size_t end) {
  const Law& law = *std::get_if<Law>(&choice);
  return task.damped ? bond_range<W, true>(task, law, begin, end) : bond_range<W, false>(task, law, begin, end);
}

/// The loops of all bond laws.
template <int W, std::size_t... Q>
constexpr std::array<Kernel::BondLoop, sizeof...(Q)> bond_loops(std::index_sequence<Q...>) {
  return {bond_loop<W, std::variant_alternative_t<Q, BondLaw::variant>>...};
}

}  // namespace arenite::dem
