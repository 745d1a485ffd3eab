#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/lanes.hpp"
#include "solid/peridynamics/kernels/space_kernels.hpp"
#include "solid/statics/passes.hpp"

/// The force of all bonds on the nodes of a sample in space. A vector of nodes gathers both ends of its bonds, a pair
/// +-e at a time; groups without bonds are passed by.
namespace arenite::peridynamics {

template <class V, int reach> class StencilInSpace {
 public:
  using T = typename V::Scalar;
  static constexpr int lanes = V::lanes;
  static constexpr int tile = 32;  ///< rows that stay in a near cache from layer to layer
  static constexpr auto& half = half_bonds_in_space<reach>;

  StencilInSpace(const SpaceBonds& bonds, statics::PointersIn<3, const T> u) : bonds_(bonds), grid_(bonds.grid), u_(u) {
    for (std::size_t d = 0; d < half.size(); ++d) {
      step_[d] = bonds.step(d);
      along_[d] = static_cast<T>(bonds.stiffness[d] * half[d].multiple() * half[d].multiple());
    }
  }

  template <class Level, class Then> [[gnu::always_inline]] void sweep(const Level& level, const Then& then) {
    for (int y0 = 0; y0 < grid_.height; y0 += tile)
      for (int z = 0; z < grid_.depth; ++z) {
        level(z);
        for (int y = y0; y < grid_.height && y < y0 + tile; ++y)
          for (int g = 0; g < grid_.row_vectors(); ++g) {
            const bool any = bonds_.holds_any[static_cast<std::size_t>(bonds_.group(g, y, z))];
            const std::ptrdiff_t first = grid_.index(g * statics::Grid::vector, y, z);
            for (std::ptrdiff_t i = first; i < first + statics::Grid::vector; i += lanes) {
              statics::ForceIn<3, V> own{}, force{};
              statics::by_component<3>([&](int c) { own[c] = V::load(u_[c] + i); });
              if (any) pull(i, own, force);
              then(i, own, force);
            }
          }
      }
  }

 private:
  template <int times> ARENITE_INLINE static void add_times(V& sum, V value) {
    if constexpr (times == 1) sum = sum + value;
    else if constexpr (times == -1) sum = sum - value;
    else if constexpr (times != 0) sum = fma(V(T(times)), value, sum);
  }
  /// The component of a vector along a direction, times its length.
  template <int x, int y, int z> ARENITE_INLINE static V along(V a, V b, V c) {
    V sum = V(T(0));
    add_times<x>(sum, a);
    add_times<y>(sum, b);
    add_times<z>(sum, c);
    return sum;
  }

  ARENITE_INLINE void pull(std::ptrdiff_t i, const statics::ForceIn<3, V>& own, statics::ForceIn<3, V>& force) const {
    const statics::Machine::Table<V> table(bonds_.relative.data());
    const auto one = [&]<std::size_t d>() __attribute__((always_inline)) {
      constexpr SpaceOffset e = half[d].direction();
      constexpr int shift = 2 * static_cast<int>(d % 16);
      const std::ptrdiff_t there = i + step_[d], back = i - step_[d];
      const std::uint32_t* const words = bonds_.words[d / 16].data();
      const V here = along<e.x, e.y, e.z>(own.x, own.y, own.z);
      const auto stretch = [&](std::ptrdiff_t j) {
        return along<e.x, e.y, e.z>(V::load(u_.x + j), V::load(u_.y + j), V::load(u_.z + j)) - here;
      };
      const V up = table.template find<shift>(statics::Machine::Words<lanes>(words + i));
      const V down = table.template find<shift>(statics::Machine::Words<lanes>(words + back));
      const V tension = V(along_[d]) * fma(up, stretch(there), down * stretch(back));
      add_times<e.x>(force.x, tension);
      add_times<e.y>(force.y, tension);
      add_times<e.z>(force.z, tension);
    };
    [&]<std::size_t... d>(std::index_sequence<d...>) __attribute__((always_inline)) {
      (one.template operator()<d>(), ...);
    }
    (std::make_index_sequence<half.size()>());
  }

  const SpaceBonds& bonds_;
  const statics::Grid grid_;
  statics::PointersIn<3, const T> u_;
  std::array<std::ptrdiff_t, half.size()> step_;
  std::array<T, half.size()> along_;  ///< force over that along the shortest step of each direction
};

template <int reach> struct SpaceBondSweep {
  using Of = SpaceBonds;
  template <class V> using At = StencilInSpace<V, reach>;
};

namespace {

/// The passes of both horizons, for the processor that the source is compiled for.
constexpr SpaceKernelSet space_kernel_set() {
  constexpr const char* name = statics::Machine::name;
  return {name, {statics::Passes<SpaceBondSweep<2>>::table(name), statics::Passes<SpaceBondSweep<3>>::table(name)}};
}

}  // namespace
}  // namespace arenite::peridynamics
