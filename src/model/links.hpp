#pragma once
#include <cstdint>

#include "core/vec.hpp"

namespace arenite {

/// What broke a bond: the pull on its whole section, the pull on the fibre that bending stretches most, shear, or, in
/// space, the shear on the rim that twisting causes.
enum class BondBreak : std::int32_t { none = 0, tension = 1, bending = 2, shear = 3, twisting = 4 };

/// A beam of cement between grains i < j, free of stress where it was made, which breaks for good. Signs are those of
/// Contacts: n points from j to i, the force on i is fn n + ft t, in space fn n + ft x n, fn > 0 pushes.
template <int D> struct BondIn {
  std::int32_t i = 0, j = 0;
  double length = 0;                ///< of the branch when it was made, m
  Vec<D> normal;                    ///< then
  Turning<D> angle_i{}, angle_j{};  ///< of the grains then, rad; in space how they have turned since
  double fn = 0;                    ///< now, N; 0 once broken, as
  Turning<D> ft{};                  ///< N, and
  Turning<D> moment{};              ///< on i in the middle of the beam, counter-clockwise, N m
  double energy = 0;                ///< that it holds, or held as it broke, J
  double load = 0;                  ///< greatest of its stresses now over the strength for it; 1 and more as it broke
  BondBreak broken = BondBreak::none;
  double time = 0;  ///< when it broke, s since the start of the run
  Vec<D> place;     ///< of its middle as it broke, m
};
using Bond = BondIn<2>;

/// Two grains i < j that a liquid bridge joins, or that attract each other by adhesion, touching or not.
struct CohesivePair {
  std::int32_t i = 0, j = 0;
  double gap =
      0;  ///< between the surfaces, m; negative where they overlap. The force of such a contact has the pull in it
  double pull = 0;    ///< along the line that joins them, N
  double energy = 0;  ///< J, 0 where it begins to act
};

}  // namespace arenite
