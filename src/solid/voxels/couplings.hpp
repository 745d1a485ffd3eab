#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "solid/statics/couplings.hpp"
#include "solid/voxels/voxels.hpp"

namespace arenite::voxels {

/// Amplitudes of the hats of one aggregate on one voxel, for a component: [mode][hat].
struct Part {
  using Hatwise = double[modes_of_a_voxel][8];
  Hatwise along{}, across{};  ///< the clamps: x and y; z

  void add(const statics::HatsIn<3>& hats, unsigned corner, bool slides) {
    for (unsigned m = 1; m < modes_of_a_voxel; ++m) {
      const double sign = std::popcount(m & ~corner) % 2 ? -1 : 1;
      for (int hat = 0; hat < 8; ++hat) {
        along[m][hat] += sign * hats[hat];
        if (!slides) across[m][hat] += sign * hats[hat];
      }
    }
  }
  ARENITE_INLINE const Hatwise& of(int component) const { return component == 2 ? across : along; }
};

/// Galerkin sums over all voxels, in double, one layer of cells after the other. In a bottom layer that slides, hats
/// move nodes across the clamps by nothing. `voxels` is asked again when the sums are.
statics::GalerkinSums<3> couplings(const Voxels& voxels, const Aggregates& aggregates, const BlockDiagonal& diagonal,
                                   const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::voxels
