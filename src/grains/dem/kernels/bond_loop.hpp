#pragma once
#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"

namespace arenite::dem {

/// The arc sine, to the last bit where |sine| < 0.15.
template <int W> ARENITE_INLINE Pack<W> small_angle(Pack<W> sine) {
  constexpr double terms[] = {135135.0 / 9676800, 10395.0 / 599040, 945.0 / 42240, 105.0 / 3456, 15.0 / 336, 3.0 / 40, 1.0 / 6, 1.0};
  const Pack<W> q = sine * sine;
  Pack<W> sum(2027025.0 / 175472640);
  for (const double term : terms) sum = sum * q + Pack<W>(term);
  return sine * sum;
}

template <int W> ARENITE_INLINE Pack<W> picked_numbers(const double* values, const std::int32_t* index) {
  Pack<W> numbers;
  for (int k = 0; k < W; ++k) numbers.raw[k] = values[index[k]];
  return numbers;
}

/// Forces of W bonds from p on; the same as beam_motion and beam_slot_force say of one. Notes which need a closer look: those that may break, and
/// those that have turned far since the list was built.
template <int W, bool damped> ARENITE_INLINE bool bond_batch(const BondTask& t, std::size_t p) {
  using V = Pack<W>;
  const auto number = [p](const double* column) { return V::load(column + p); };
  const auto vector = [p](const Vec<2, const double*>& columns) { return Vec<2, V>{V::load(columns.x + p), V::load(columns.y + p)}; };
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
  const V turn_i = picked_numbers<W>(t.angle, i) - number(b.angle_i) - turned, turn_j = picked_numbers<W>(t.angle, j) - number(b.angle_j) - turned;
  const V length = number(b.length), arm_i = number(b.arm_i), arm_j = number(b.arm_j);
  V tension = number(b.beam.normal) * (distance - length), shear = number(b.beam.shear) * (arm_i * turn_i + arm_j * turn_j),
    moment = number(b.beam.bending) * (turn_i - turn_j);

  const V per_area = number(b.beam.per_area), mean = tension * per_area;
  const V fibre = mean + max(moment, zero - moment) * number(b.beam.per_section), across = max(shear, zero - shear) * per_area;
  const V shear_limit = number(b.cohesion) + number(b.strength) * number(b.beam.friction) * max(zero - mean, zero);
  const auto look = ~(fibre <= number(b.tensile)) | ~(across <= shear_limit) | ~(max(sine, zero - sine) <= V(0.15)) | ~(cosine > zero);

  if constexpr (damped) {
    Vec<2, V> velocity_i, velocity_j;
    V omega_i, omega_j, radius;
    gather<W>([=](int k) { return &t.record[i[k]].velocity.x; }, velocity_i);
    gather<W>([=](int k) { return &t.record[j[k]].velocity.x; }, velocity_j);
    gather<W>([=](int k) { return &t.record[i[k]].omega; }, omega_i, radius);
    gather<W>([=](int k) { return &t.record[j[k]].omega; }, omega_j, radius);
    const Vec<2, V> u = velocity_i - velocity_j - vector(b.image_velocity);
    tension = tension + number(b.normal_damping) * dot(u, normal);
    shear = shear + number(b.shear_damping) * (arm_i * omega_i + arm_j * omega_j - length * (cross(normal, u) * inverse));
    moment = moment + number(b.bending_damping) * (omega_i - omega_j);
  }
  const V along = shear * length * inverse;
  scatter<W>([=](int k) { return &t.force[p + static_cast<std::size_t>(k)].on_i.x; }, zero - tension * normal.x - along * normal.y,
             along * normal.x - tension * normal.y);
  scatter<W>([=](int k) { return &t.force[p + static_cast<std::size_t>(k)].torque_i; }, zero - shear * arm_i - moment, moment - shear * arm_j);
  bool any = false;
  for (int k = 0; k < W; ++k) {
    t.look[p + static_cast<std::size_t>(k)] = look[k] != 0;
    any |= look[k] != 0;
  }
  return any;
}

template <int W, bool damped> __attribute__((flatten)) bool bond_range(const BondTask& given, std::size_t begin, std::size_t end) {
  const BondTask task = given;  // a copy that no store can reach stays in registers
  bool any = false;
  std::size_t p = begin;
  for (; p + W <= end; p += W) any |= bond_batch<W, damped>(task, p);
  for (; p < end; ++p) any |= bond_batch<1, damped>(task, p);
  return any;
}

/// Bonds begin .. end-1. True if some need a closer look.
template <int W> bool bond_loop(const BondTask& task, std::size_t begin, std::size_t end) {
  return task.damped ? bond_range<W, true>(task, begin, end) : bond_range<W, false>(task, begin, end);
}

}  // namespace arenite::dem
