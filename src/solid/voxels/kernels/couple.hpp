#pragma once
#include "core/lanes.hpp"
#include "solid/statics/couplings.hpp"
#include "solid/statics/machine.hpp"
#include "solid/voxels/kernels/kernels.hpp"
#include "solid/voxels/modes.hpp"

namespace arenite::voxels {
namespace {

/// What two parts of a voxel add to the coupling of their aggregates: some hats of the second at a time. A component
/// that moves alone works on itself in seven modes, on another one in four.
void couple(const Modes& m, const Part& p, const Part& q, statics::CouplingIn<3>& to) {
  using V = Lanes<double, statics::Machine::bytes / 8>;
  const ModesOf<V> modes{V(m.axial), V(m.cross), V(m.shear), V(m.along), V(m.across), V(m.trilinear)};
  constexpr int axis_mode[3] = {mode_x, mode_y, mode_z};
  for (int b = 0; b < 3; ++b)
    for (int hats = 0; hats < 8; hats += V::lanes) {
      Amplitudes<V> moved{};
      for (int mode = 1; mode < modes_of_a_voxel; ++mode) moved.at[b][mode] = V::load(&q.of(b)[mode][hats]);
      const Amplitudes<V> work = work_of(modes, moved);
      for (int a = 0; a < 3; ++a) {
        for (int own = 0; own < 8; ++own) {
          double* const at =
              reinterpret_cast<double*>(&to.block[static_cast<std::size_t>(3 * a + b)][static_cast<std::size_t>(own)]) +
              hats;
          V sum = V::load(at);
          const auto add = [&](int mode) { sum = fma(V(p.of(a)[mode][own]), work.at[a][mode], sum); };
          if (a == b) {
            for (int mode = 1; mode < modes_of_a_voxel; ++mode) add(mode);
          } else {
            const int third = mode_xyz & ~(axis_mode[a] | axis_mode[b]);
            add(axis_mode[a]);
            add(axis_mode[b]);
            add(axis_mode[a] | third);
            add(axis_mode[b] | third);
          }
          sum.store(at);
        }
      }
    }
}

}  // namespace
}  // namespace arenite::voxels
