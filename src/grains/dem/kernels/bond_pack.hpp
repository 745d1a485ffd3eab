#pragma once
#include <cstdint>

#include "geometry/rotation.hpp"
#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"
#include "grains/dem/kernels/slots.hpp"

namespace arenite::dem {

/// The arc sine, to the last bit where |sine| < 0.15.
template <int W> ARENITE_INLINE Pack<W> small_angle(Pack<W> sine) {
  constexpr double terms[] = {135135.0 / 9676800, 10395.0 / 599040, 945.0 / 42240, 105.0 / 3456,
                              15.0 / 336,         3.0 / 40,         1.0 / 6,       1.0};
  const Pack<W> q = sine * sine;
  Pack<W> sum(2027025.0 / 175472640);
#pragma GCC unroll 8
  for (const double term : terms) sum = sum * q + Pack<W>(term);
  return sine * sum;
}

/// Of W bonds from p on, all in one row of eight.
template <int W> ARENITE_INLINE Pack<W> numbers_of(const Eight& numbers, std::size_t p) {
  return Pack<W>::load(numbers.data() + p % 8);
}
template <int W, int D> ARENITE_INLINE Vec<D, Pack<W>> numbers_of(const Vec<D, Eight>& numbers, std::size_t p) {
  if constexpr (D == 2) return {numbers_of<W>(numbers.x, p), numbers_of<W>(numbers.y, p)};
  else return {numbers_of<W>(numbers.x, p), numbers_of<W>(numbers.y, p), numbers_of<W>(numbers.z, p)};
}

template <int W> ARENITE_INLINE Pack<W> picked_numbers(const double* values, const std::int32_t* index) {
  Pack<W> numbers;
  for (int k = 0; k < W; ++k) numbers.v[k] = values[index[k]];
  return numbers;
}

/// The lines from j to i of W bonds from p on.
template <int W, int D> struct BondLine {
  using V = Pack<W>;
  Vec<D, V> normal;
  V distance, inverse;  ///< inverse: 1 over the distance

  ARENITE_INLINE BondLine(const BondTask<D>& t, std::size_t p) {
    const Vec<D, V> branch =
        places<W>(t.record, t.i + p) - places<W>(t.record, t.j + p) - numbers_of<W>(t.row[p / 8].image, p);
    const V squared = dot(branch, branch);
    distance = sqrt(squared);
    inverse = distance * (V(1.0) / squared);
    normal = inverse * branch;
  }
};

/// How W bonds from p on are strained; the same as beam_motion says of one.
template <int W, int D> struct BondPack;

template <int W> struct BondPack<W, 2> : BondLine<W, 2> {
  using V = Pack<W>;
  using BondLine<W, 2>::normal, BondLine<W, 2>::distance, BondLine<W, 2>::inverse;
  BeamArms<V> arms;
  BeamOf<V> beam;
  BeamStrain<V> strain;
  V strength;
  typename V::Truths far;  ///< has turned far since the list was built

  ARENITE_INLINE BondPack(const BondTask<2>& t, std::size_t p) : BondLine<W, 2>(t, p) {
    const auto& b = t.row[p / 8];
    const auto of_bonds = [p](const auto& numbers) { return numbers_of<W>(numbers, p); };
    const std::int32_t *i = t.i + p, *j = t.j + p;
    const Vec<2, V> before = of_bonds(b.normal);
    const V sine = cross(before, normal), cosine = dot(before, normal), turned = small_angle(sine);
    const V turn_i = picked_numbers<W>(t.attitude, i) - of_bonds(b.angle_i) - turned,
            turn_j = picked_numbers<W>(t.attitude, j) - of_bonds(b.angle_j) - turned;
    arms = {of_bonds(b.length), of_bonds(b.arm_i), of_bonds(b.arm_j)};
    beam = {of_bonds(b.beam.normal),   of_bonds(b.beam.shear),       of_bonds(b.beam.bending),
            of_bonds(b.beam.per_area), of_bonds(b.beam.per_section), of_bonds(b.beam.friction)};
    strain = arms.strain(distance, turn_i, turn_j);
    strength = of_bonds(b.strength);
    far = ~(abs(sine) <= V(0.15)) | ~(cosine > V(0.0));
  }
  /// Of its dashpots.
  ARENITE_INLINE BeamForce<V> damping(const BondTask<2>& t, std::size_t p) const {
    const auto& b = t.row[p / 8];
    const auto of_bonds = [p](const auto& numbers) { return numbers_of<W>(numbers, p); };
    const GrainPack<W, 2> at_i(t.record, t.i + p), at_j(t.record, t.j + p);
    const Vec<2, V> u = at_i.velocity - at_j.velocity - of_bonds(b.image_velocity);
    const BeamDashpots<V> dashpots{of_bonds(b.dashpots.normal), of_bonds(b.dashpots.shear),
                                   of_bonds(b.dashpots.bending)};
    return dashpots.force(arms.rate(dot(u, normal), cross(normal, u) * inverse, at_i.omega, at_j.omega));
  }
  ARENITE_INLINE void put(const BeamForce<V>& force, SlotForce<2>* to) const {
    const BeamPull<V> pull = arms.pull(force, normal, force.shear * arms.length * inverse);
    write_slots<W>(to, pull.on_i, pull.torque_i, pull.torque_j);
  }
};

template <int W> struct BondPack<W, 3> : BondLine<W, 3> {
  using V = Pack<W>;
  using BondLine<W, 3>::normal, BondLine<W, 3>::distance, BondLine<W, 3>::inverse;
  RoundArms<V> arms;
  RoundBeamOf<V> beam;
  RoundStrainOf<V> strain;
  RoundEnds<V> ends;
  V strength;
  typename V::Truths far;  ///< is twisted far

  ARENITE_INLINE BondPack(const BondTask<3>& t, std::size_t p) : BondLine<W, 3>(t, p) {
    const auto& b = t.row[p / 8];
    const auto of_bonds = [p](const auto& numbers) { return numbers_of<W>(numbers, p); };
    const V zero(0.0), one(1.0);
    const geometry::RotationOf<V> of_i = attitudes(t, t.i + p), of_j = attitudes(t, t.j + p),
                                  rest{of_bonds(b.rest_cosine), of_bonds(b.rest_sine)};
    ends = {turned(of_i, of_bonds(b.along_i)), turned(of_j, of_bonds(b.along_j)),
            of_i * rest * geometry::inverse(of_j)};
    const V sign = select(ends.between.cosine > zero, one, zero - one);
    ends.between = {sign * ends.between.cosine, sign * ends.between.sine};
    const V about = dot(ends.between.sine, normal), cosine = ends.between.cosine,
            sine = about / sqrt(cosine * cosine + about * about);
    arms = {{of_bonds(b.length), of_bonds(b.arm_i), of_bonds(b.arm_j)}};
    beam = {{of_bonds(b.beam.normal), of_bonds(b.beam.shear), of_bonds(b.beam.bending), of_bonds(b.beam.per_area),
             of_bonds(b.beam.per_section), of_bonds(b.beam.friction)},
            of_bonds(b.beam.twist),
            of_bonds(b.beam.per_twist)};
    strain = arms.strain(distance, normal, ends, V(2.0) * small_angle(sine));
    strength = of_bonds(b.strength);
    far = ~(abs(sine) <= V(0.15));
  }
  ARENITE_INLINE RoundForceOf<V> damping(const BondTask<3>& t, std::size_t p) const {
    const auto& b = t.row[p / 8];
    const auto of_bonds = [p](const auto& numbers) { return numbers_of<W>(numbers, p); };
    const GrainPack<W, 3> at_i(t.record, t.i + p), at_j(t.record, t.j + p);
    const Vec<3, V> u = at_i.velocity - at_j.velocity - of_bonds(b.image_velocity);
    const RoundDashpotsOf<V> dashpots{
        {of_bonds(b.dashpots.normal), of_bonds(b.dashpots.shear), of_bonds(b.dashpots.bending)},
        of_bonds(b.dashpots.twist)};
    return dashpots.force(arms.rate(normal, inverse, u, at_i.omega, at_j.omega));
  }
  ARENITE_INLINE void put(const RoundForceOf<V>& force, SlotForce<3>* to) const {
    const RoundPull<V> pull = arms.pull(force, normal, inverse, ends);
    write_slots<W>(to, pull.on_i, pull.torque_i, pull.torque_j);
  }

 private:
  ARENITE_INLINE static geometry::RotationOf<V> attitudes(const BondTask<3>& t, const std::int32_t* index) {
    geometry::RotationOf<V> turn;
    gather<W>([=](int k) { return &t.attitude[t.record[index[k]].grain].cosine; }, turn.cosine, turn.sine.x,
              turn.sine.y, turn.sine.z);
    return turn;
  }
};

}  // namespace arenite::dem
