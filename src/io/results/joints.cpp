#include "io/results/joints.hpp"

#include <algorithm>
#include <vector>

namespace arenite::io {
namespace {

/// Refuses items whose grains are not i < j.
template <class Items>
void check_order(const Hdf5Group& at, const Items& items, std::size_t grains, const char* refusal) {
  check_ends(at, items, grains, refusal);
  if (at.reads() && std::any_of(items.begin(), items.end(), [](const auto& item) { return item.j <= item.i; }))
    at.refuse(refusal);
}

template <class Bonds> void check_bonds(const Hdf5Group& at, const Bonds& bonds, std::size_t grains, BondBreak last) {
  constexpr const char* refusal = "names a grain or a break that does not exist";
  check_order(at, bonds, grains, refusal);
  for (const auto& b : bonds)
    if (at.reads() && (b.broken < BondBreak::none || b.broken > last)) at.refuse(refusal);
}

void transfer_bonds(const Hdf5Group& at, std::vector<Bond>& bonds, std::size_t grains) {
  at.note("i and j",
          "indices into the arrays of grains, from 0, i < j; signs as for contacts; length, n and angles are those at "
          "the creation of the bond");
  at.note("broken", "0: intact; broken in 1 tension, 2 bending, 3 shear, at that time and place, with that energy");
  at.records(bonds, Named{"i", &Bond::i}, Named{"j", &Bond::j}, Named{"broken", &Bond::broken},
             Named{"length", &Bond::length, "m"}, Named{"nx", [](Bond& b) -> double& { return b.normal.x; }},
             Named{"ny", [](Bond& b) -> double& { return b.normal.y; }}, Named{"angle_i", &Bond::angle_i, "rad"},
             Named{"angle_j", &Bond::angle_j, "rad"}, Named{"fn", &Bond::fn, "N"}, Named{"ft", &Bond::ft, "N"},
             Named{"moment", &Bond::moment, "N m"}, Named{"energy", &Bond::energy, "J"}, Named{"load", &Bond::load},
             Named{"time", &Bond::time, "s"}, Named{"x", [](Bond& b) -> double& { return b.place.x; }, "m"},
             Named{"y", [](Bond& b) -> double& { return b.place.y; }, "m"});
  check_bonds(at, bonds, grains, BondBreak::shear);
}

template <int axis> constexpr auto on_axis(Vec3 BondIn<3>::*member) {
  return [member](BondIn<3>& b) -> double& { return (b.*member)[axis]; };
}
void transfer_bonds(const Hdf5Group& at, std::vector<BondIn<3>>& bonds, std::size_t grains) {
  using B = BondIn<3>;
  at.note("i and j",
          "indices into the arrays of grains, from 0, i < j; signs as for contacts; length and n are those at the "
          "creation of the bond, turn_i and turn_j the rotation vectors of its grains since then, moment acts on i in "
          "the middle of the beam");
  at.note("broken", "0: intact; broken in 1 tension, 2 bending, 3 shear, 4 twisting, at that time and place");
  at.records(bonds, Named{"i", &B::i}, Named{"j", &B::j}, Named{"broken", &B::broken}, Named{"length", &B::length, "m"},
             Named{"nx", on_axis<0>(&B::normal)}, Named{"ny", on_axis<1>(&B::normal)},
             Named{"nz", on_axis<2>(&B::normal)}, Named{"turn_i_x", on_axis<0>(&B::angle_i), "rad"},
             Named{"turn_i_y", on_axis<1>(&B::angle_i), "rad"}, Named{"turn_i_z", on_axis<2>(&B::angle_i), "rad"},
             Named{"turn_j_x", on_axis<0>(&B::angle_j), "rad"}, Named{"turn_j_y", on_axis<1>(&B::angle_j), "rad"},
             Named{"turn_j_z", on_axis<2>(&B::angle_j), "rad"}, Named{"fn", &B::fn, "N"},
             Named{"ft_x", on_axis<0>(&B::ft), "N"}, Named{"ft_y", on_axis<1>(&B::ft), "N"},
             Named{"ft_z", on_axis<2>(&B::ft), "N"}, Named{"moment_x", on_axis<0>(&B::moment), "N m"},
             Named{"moment_y", on_axis<1>(&B::moment), "N m"}, Named{"moment_z", on_axis<2>(&B::moment), "N m"},
             Named{"energy", &B::energy, "J"}, Named{"load", &B::load}, Named{"time", &B::time, "s"},
             Named{"x", on_axis<0>(&B::place), "m"}, Named{"y", on_axis<1>(&B::place), "m"},
             Named{"z", on_axis<2>(&B::place), "m"});
  check_bonds(at, bonds, grains, BondBreak::twisting);
}

void transfer_cohesive(const Hdf5Group& at, std::vector<CohesivePair>& pairs, std::size_t grains) {
  at.note("i and j",
          "indices into the arrays of grains, from 0, i < j; the pull of a pair whose gap is not above 0 is part of "
          "the force of its contact");
  at.records(pairs, Named{"i", &CohesivePair::i}, Named{"j", &CohesivePair::j}, Named{"gap", &CohesivePair::gap, "m"},
             Named{"pull", &CohesivePair::pull, "N"}, Named{"energy", &CohesivePair::energy, "J"});
  check_order(at, pairs, grains, "names a grain that does not exist");
}

}  // namespace

template <int D> void transfer_joints(const Hdf5Group& at, PackingIn<D>& packing) {
  const std::size_t grains = packing.grains.size();
  if (!at.lacks("bonds", packing.bonds.empty())) transfer_bonds(at.group("bonds"), packing.bonds, grains);
  if (!at.lacks("cohesive", packing.cohesive.empty()))
    transfer_cohesive(at.group("cohesive"), packing.cohesive, grains);
}

template void transfer_joints(const Hdf5Group&, Packing&);
template void transfer_joints(const Hdf5Group&, PackingIn<3>&);

}  // namespace arenite::io
