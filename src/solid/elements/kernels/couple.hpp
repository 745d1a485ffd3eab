#pragma once
#include <algorithm>
#include <cstddef>

#include "core/lanes.hpp"
#include "solid/elements/kernels/couple_cell.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/modes.hpp"
#include "solid/statics/couplings.hpp"
#include "solid/statics/machine.hpp"
#include "solid/statics/passes.hpp"

namespace arenite::elements {
namespace {

/// The same number in every lane.
template <class V> ARENITE_INLINE ModesOf<2, V> in_lanes(const Modes<2>& m) {
  return {V(m.axial), V(m.cross), V(m.shear), V(m.bending)};
}
template <class V> ARENITE_INLINE ModesOf<3, V> in_lanes(const Modes<3>& m) {
  return {V(m.axial), V(m.cross), V(m.shear), V(m.along), V(m.across), V(m.trilinear)};
}

/// What two parts of an element add to the coupling of their aggregates: some hats of the second at a time. A component
/// that moves alone works on itself in all modes; on another one in those along their two axes, and in these turned
/// about the third.
template <int D> void couple(const Modes<D>& m, const Part<D>& p, const Part<D>& q, statics::CouplingIn<D>& to) {
  constexpr int corners = statics::corners<D>;
  using V = Lanes<double, std::min<int>(corners, statics::Machine::bytes / 8)>;
  const auto modes = in_lanes<V>(m);
  Amplitudes<D, V> moved{};
  for (int b = 0; b < D; ++b) {
    for (int hats = 0; hats < corners; hats += V::lanes) {
      for (int mode = 1; mode < mode_count<D>; ++mode) moved.at[b][mode] = V::load(&q.of(b)[mode][hats]);
      const Amplitudes<D, V> work = work_of(modes, moved);
      for (int a = 0; a < D; ++a) {
        for (int own = 0; own < corners; ++own) {
          double* const at =
              reinterpret_cast<double*>(&to.block[static_cast<std::size_t>(D * a + b)][static_cast<std::size_t>(own)]) +
              hats;
          V sum = V::load(at);
          const auto add = [&](int mode) { sum = fma(V(p.of(a)[mode][own]), work.at[a][mode], sum); };
          if (a == b) {
            for (int mode = 1; mode < mode_count<D>; ++mode) add(mode);
          } else {
            const int of_a = 1 << a, of_b = 1 << b, third = (mode_count<D> - 1) & ~(of_a | of_b);
            add(of_a);
            add(of_b);
            if (third) add(of_a | third), add(of_b | third);
          }
          sum.store(at);
        }
      }
    }
    for (int mode = 1; mode < mode_count<D>; ++mode) moved.at[b][mode] = V(0.0);
  }
}

/// All of this for the machine that the source is compiled for.
template <int D, class Sweep> constexpr Compiled<D> compiled() {
  return {statics::Machine::name, statics::Passes<Sweep>::table(statics::Machine::name), couple<D>,
          D > 2 ? couple_cell : nullptr};
}

}  // namespace
}  // namespace arenite::elements
