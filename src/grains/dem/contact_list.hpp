#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/threads.hpp"
#include "core/vec.hpp"
#include "grains/dem/coefficients.hpp"
#include "grains/dem/kernels/kernel.hpp"
#include "model/packing.hpp"

namespace arenite::dem {

/// A vector of N components, or with one a number, of each disk or contact: one array a component, as the loops read
/// them.
template <int N> struct Components {
  std::array<std::vector<double>, N> along;
  auto operator[](std::size_t k) const {
    if constexpr (N == 1) return along[0][k];
    else return by_axis<N>([&](int axis) { return along[axis][k]; });
  }
  double& operator[](std::size_t k) requires(N == 1) { return along[0][k]; }
  template <class V> void put(std::size_t k, const V& v) {
    if constexpr (N == 1) along[0][k] = v;
    else
      for (int axis = 0; axis < N; ++axis) along[axis][k] = v[axis];
  }
  void assign(std::size_t size) {
    for (auto& a : along) a.assign(size, 0.0);
  }
  std::size_t size() const { return along[0].size(); }
  bool empty() const { return size() == 0; }
  std::array<double*, N> data() {
    std::array<double*, N> begin{};
    std::ranges::transform(along, begin.begin(), [](auto& numbers) { return numbers.data(); });
    return begin;
  }
};
template <int D> using Turnings = Components<turnings<D>>;

/// Candidate contacts and what they carry. Slots 0 .. pairs-1 join two disks (i < j, sorted by i; j may be a ghost);
/// the slots behind them join a disk i with wall `side` (j = wall_partner(side)) or with an element of a boundary (j =
/// boundary_partner(element)), sorted by i. Those from `polygons` on join a polygon, whose first disk is i, with a
/// point of a boundary.
template <int D> struct ContactListIn {
  std::size_t pairs = 0, polygons = 0;
  std::vector<std::int32_t> i, j;
  std::vector<std::int32_t> owner;  ///< the disk that takes the reaction: j, or the source of the ghost j
  std::vector<double> stiffness, damping, viscosity, strength, shear;  ///< Coefficients of each
  std::vector<SlotForce<D>> force;  ///< one more than slots, which stays 0; behind it those of parts
  Turnings<D> memory;               ///< of the friction law
  Components<1> normal_memory;      ///< of the normal law; empty unless it remembers
  Turnings<D>
      rolling_memory;  ///< of the rolling law, turned as the first of the caller's two grains turns; empty without one
  Components<1> twist_memory;      ///< the same of spheres that twist; empty unless that is resisted
  std::vector<std::uint8_t> glue;  ///< of glued pairs: see GlueState
  /// Slots (and bonds' places) by disk, in groups of four that are filled up with the slot whose force stays 0, so that
  /// most disks have as many groups as their neighbours and the processor guesses the loops' ends right. Those where
  /// disk k is i, pairs before walls before bonds, are group[first[2k]] to group[first[2k + 1]]; those where it owns
  /// the reaction go on to first[2k + 2].
  std::vector<std::int32_t> group, first;

  std::size_t size() const { return i.size(); }
  /// Where the forces of spheres outgrow the near caches, it pays to ask for what is read before its turn comes (a
  /// third at 100 000 of them); elsewhere, and for disks, it costs some per cent.
  bool outgrows_caches() const { return D > 2 && force.size() * sizeof(SlotForce<D>) > std::size_t{1} << 22; }
  /// What group_slots and list_contacts fill is not touched.
  void resize(std::size_t slots) {
    for (auto* a : {&i, &j, &owner}) a->resize(slots);
    for (auto* a : {&stiffness, &damping, &viscosity, &strength, &shear}) a->resize(slots);
  }
};
using ContactList = ContactListIn<2>;

template <int D>
inline void fill_slot(ContactListIn<D>& list, std::size_t p, std::int32_t i, std::int32_t j, std::int32_t owner,
                      const Coefficients& c) {
  list.i[p] = i;
  list.j[p] = j;
  list.owner[p] = owner;
  list.stiffness[p] = c.stiffness;
  list.damping[p] = c.damping;
  list.viscosity[p] = c.viscosity;
  list.strength[p] = c.strength;
  list.shear[p] = c.shear;
}
template <int D>
inline void add_slot(ContactListIn<D>& list, std::int32_t i, std::int32_t j, std::int32_t owner,
                     const Coefficients& c) {
  list.resize(list.size() + 1);
  fill_slot(list, list.size() - 1, i, j, owner, c);
}

template <int D> inline SlotForces<D> slot_forces(const ContactListIn<D>& list) {
  return {list.force.data(), list.group.data(), list.first.data(), list.outgrows_caches()};
}

/// Glue that breaks for good is gone once its contact has opened again.
enum GlueState : std::uint8_t { never_touched = 0, touching = 1 };

/// From the centres of two bodies to where a force acts on them, m.
template <int D> struct Levers { Vec<D> i, j; };

/// Where the n-th force of all parts stands in the list.
template <int D> inline std::size_t place_of_force(const ContactListIn<D>& list, std::size_t n) {
  return list.size() + 1 + n;
}

template <int D> struct SampleIn;
using Sample = SampleIn<2>;

/// Lists the pairs at the records' present order and places without sorting; what rebuild_list does at its end, and
/// what a restored sample needs.
template <int D> void list_contacts(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

/// Copies the sources of ghosts to their images (positions and seen velocities).
template <int D> void refresh_ghosts(SampleIn<D>& sample);

/// Disks whose partners are sought in one go.
inline constexpr std::size_t disks_of_block = 64;

}  // namespace arenite::dem
