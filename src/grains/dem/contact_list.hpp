#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/vec.hpp"
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
  std::vector<SlotForce<D>> force;  ///< one more than slots, which stays 0; behind it those of bonds
  Turnings<D> memory;               ///< of the friction law
  Components<1> normal_memory;      ///< of the normal law; empty unless it remembers
  Turnings<D>
      rolling_memory;  ///< of the rolling law, turned as the first of the caller's two grains turns; empty without one
  Components<1> pull;  ///< of cohesion now, N; > 0 where a pair is joined. Empty without it
  std::vector<std::int32_t> curve;  ///< of joined pairs: place in CohesionTable::curve
  std::vector<std::uint8_t> bond;   ///< of glued pairs: see BondState
  /// Slots (and bonds' places) by disk, in groups of four that are filled up with the slot whose force stays 0, so that
  /// most disks have as many groups as their neighbours and the processor guesses the loops' ends right. Those where
  /// disk k is i, pairs before walls before bonds, are group[first[2k]] to group[first[2k + 1]]; those where it owns
  /// the reaction go on to first[2k + 2].
  std::vector<std::int32_t> group, first;

  std::size_t size() const { return i.size(); }
  /// What group_slots and list_contacts fill is not touched.
  void resize(std::size_t slots) {
    for (auto* a : {&i, &j, &owner}) a->resize(slots);
    for (auto* a : {&stiffness, &damping, &viscosity, &strength, &shear}) a->resize(slots);
  }
};
using ContactList = ContactListIn<2>;

template <int D> inline SlotForces<D> slot_forces(const ContactListIn<D>& list) {
  return {list.force.data(), list.group.data(), list.first.data()};
}

/// A bond that breaks for good is gone once its contact has opened again.
enum BondState : std::uint8_t { never_touched = 0, touching = 1 };

/// Pulls of the pairs of radii that have been joined so far, and up to which gap the list must show pairs, m.
struct CohesionTable {
  std::vector<PullCurve> curve;
  std::map<std::pair<double, double>, std::int32_t> place;  ///< by the smaller and the larger radius
  double reach = 0, steepest = 0;                           ///< m; largest slope of equal grains, N/m
  double joins_within = 0;                                  ///< the law's, m
  bool breaks = false;                                      ///< the law's
};

/// A bond that holds, with what follows from its making and from where its disks are numbered now. Its force stands
/// behind those of the contacts, in ContactList::force at bond_force_place.
struct BondSlot : BondRow<double> {
  enum class State : std::int32_t { holds, breaking, broken };
  std::int32_t bond = 0;      ///< place in Sample::bonds
  std::int32_t i = 0, j = 0;  ///< inner numbers of its disks
  Cells<2> shift;             ///< by which the image of j that is meant is away from j
  State state = State::holds;
};

/// The slots' numbers side by side, for the loop over them.
struct BondNumbers {
  std::vector<std::int32_t> i, j;
  Components<bond_columns> column;  ///< in the order of BondRow
  std::vector<std::uint8_t> look;
  std::vector<std::int32_t> across;  ///< slots that mean another image of j than j itself
  bool damped = false;
  BondRow<double*> columns() { return std::bit_cast<BondRow<double*>>(column.data()); }
};

/// Where the force of bond slot b stands in the list.
template <int D> inline std::size_t bond_force_place(const ContactListIn<D>& list, std::size_t b) {
  return list.size() + 1 + b;
}

}  // namespace arenite::dem
