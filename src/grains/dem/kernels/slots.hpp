#pragma once
#include <cstdint>

#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/kernels/pack.hpp"

namespace arenite::dem {

/// Where W disks or spheres are.
template <int W> ARENITE_INLINE Vec<2, Pack<W>> places(const GrainRecord<2>* record, const std::int32_t* index) {
  Vec<2, Pack<W>> place;
  gather<W>([=](int k) { return &record[index[k]].place.x; }, place);
  return place;
}
template <int W> ARENITE_INLINE Vec<3, Pack<W>> places(const GrainRecord<3>* record, const std::int32_t* index) {
  Vec<3, Pack<W>> place;
  Pack<W> velocity;  // rows are of four numbers
  gather<W>([=](int k) { return &record[index[k]].place.x; }, place.x, place.y, place.z, velocity);
  return place;
}

/// What the pair loop needs of W disks or spheres.
template <int W, int D> struct GrainPack {
  Vec<D, Pack<W>> place, velocity;
  Turning<D, Pack<W>> omega;
  Pack<W> radius;

  ARENITE_INLINE GrainPack(const GrainRecord<D>* record, const std::int32_t* index) {
    const auto place_of = [=](int k) { return &record[index[k]].place.x; };
    if constexpr (D == 2) {
      gather<W>(place_of, place.x, place.y, velocity.x, velocity.y);
      gather<W>([=](int k) { return &record[index[k]].omega; }, omega, radius);
    } else {
      gather<W>(place_of, place.x, place.y, place.z, velocity.x);
      gather<W>([=](int k) { return &record[index[k]].velocity.y; }, velocity.y, velocity.z, omega.x, omega.y);
      gather<W>([=](int k) { return &record[index[k]].omega.z; }, omega.z, radius);
    }
  }
};

/// The forces of W slots, from one on, as the pair loop has left them.
template <int W, int D> struct SlotPack {
  Vec<D, Pack<W>> on_i;
  Turning<D, Pack<W>> torque_i, torque_j;

  ARENITE_INLINE explicit SlotPack(const SlotForce<D>* slot) {
    if constexpr (D == 2) {
      gather<W>([=](int k) { return &slot[k].on_i.x; }, on_i.x, on_i.y, torque_i, torque_j);
    } else {
      gather<W>([=](int k) { return &slot[k].on_i.x; }, on_i.x, on_i.y, on_i.z, torque_i.x);
      gather<W>([=](int k) { return &slot[k].torque_i.y; }, torque_i.y, torque_i.z, torque_j.x, torque_j.y);
      for (int k = 0; k < W; ++k) torque_j.z.v[k] = slot[k].torque_j.z;
    }
  }
};

/// Writes the forces of W slots, from one on.
template <int W>
ARENITE_INLINE void write_slots(SlotForce<2>* slot, Vec<2, Pack<W>> on_i, Pack<W> torque_i, Pack<W> torque_j) {
  scatter<W>([=](int k) { return &slot[k].on_i.x; }, on_i.x, on_i.y, torque_i, torque_j);
}
template <int W>
ARENITE_INLINE void write_slots(SlotForce<3>* slot, Vec<3, Pack<W>> on_i, Vec<3, Pack<W>> torque_i,
                                Vec<3, Pack<W>> torque_j) {
  scatter<W>([=](int k) { return &slot[k].on_i.x; }, on_i.x, on_i.y, on_i.z, torque_i.x);
  scatter<W>([=](int k) { return &slot[k].torque_i.y; }, torque_i.y, torque_i.z, torque_j.x, torque_j.y);
  for (int k = 0; k < W; ++k) slot[k].torque_j.z = torque_j.z.v[k];
}

}  // namespace arenite::dem
