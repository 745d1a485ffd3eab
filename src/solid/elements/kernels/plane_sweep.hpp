#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/lanes.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/modes.hpp"
#include "solid/statics/passes.hpp"

/// The force of elements on their corners, row by row.
///
/// Each element is worked out once, in a first pass over a row of pixels of a tile, which writes what it does to its
/// lower and to its upper corners; a second pass adds up, for each corner of the row below, the elements on either side
/// below and above it. What elements do to the row above waits in a buffer, which stays in the nearest cache.
namespace arenite::elements {

template <class V> class SweepInPlane {
 public:
  using T = typename V::Scalar;
  static constexpr int lanes = V::lanes;
  static constexpr int tile = 4096 / static_cast<int>(sizeof(T));
  static constexpr int pitch = tile + 2 * lanes;

  SweepInPlane(const Elements& elements, statics::Plane<const T> u)
      : elements_(elements),
        grid_(elements.grid),
        words_(elements.words.data()),
        u_(u) {}

  template <class Row, class Then> [[gnu::always_inline]] void sweep(const Row& row, const Then& then) {
    const int first = grid_.periodic ? -1 : 0;
    for (int x = 0; x < grid_.row_vectors() * Grid::vector; x += tile) {
      const int nodes = std::min(tile, grid_.row_vectors() * Grid::vector - x);
      std::memset(buffer_, 0, sizeof buffer_);
      for (int y = first; y < grid_.height; ++y) {
        stretch(grid_.index(x, y), nodes, y);
        if (y < 0) continue;
        row(y);
        add(x, nodes, y, then);
      }
    }
  }

 private:
  /// What elements do to their left and right corners along one edge.
  enum Side : unsigned { left_x, right_x, left_y, right_y };
  T* lower(Side side) { return buffer_ + pitch * side; }
  T* upper(Side side, int y) { return buffer_ + pitch * (4 + 4 * (y & 1) + static_cast<int>(side)); }

  /// Forces of a row of elements, from one vector to the left of the tile on.
  [[gnu::always_inline]] void stretch(std::ptrdiff_t first, int nodes, int y) {
    using Table = statics::Machine::Table<V>;
    const Table axial(elements_.table[0].data()), cross(elements_.table[1].data()), shear(elements_.table[2].data()),
        bending(elements_.table[3].data());
    const std::ptrdiff_t stride = grid_.stride;
    const T *const ux = u_.x + first - lanes, *const uy = u_.y + first - lanes;
    const std::uint32_t* const words = words_ + first - lanes;
    T *const lx = lower(left_x), *const rx = lower(right_x), *const ly = lower(left_y), *const ry = lower(right_y);
    T *const above_lx = upper(left_x, y), *const above_rx = upper(right_x, y), *const above_ly = upper(left_y, y),
             *const above_ry = upper(right_y, y);
    for (int k = 0; k < nodes + lanes; k += lanes) {
      __builtin_prefetch(ux + k + 2 * stride);
      __builtin_prefetch(uy + k + 2 * stride);
      __builtin_prefetch(words + k + stride);
      const auto word = statics::Machine::Words<lanes>(words + k);
      const ModesOf<2, V> m{axial.template find<0>(word), cross.template find<0>(word), shear.template find<0>(word),
                            bending.template find<0>(word)};
      Amplitudes<2, V> a{};
      amplitudes(ux + k, stride, a.at[0]);
      amplitudes(uy + k, stride, a.at[1]);
      const Amplitudes<2, V> p = work_of(m, a);
      const V *const x = p.at[0], *const z = p.at[1];
      put(lx + k, rx + k, x[mode_y], x[mode_x] - x[mode_xy]);
      put(above_lx + k, above_rx + k, V(T(0)) - x[mode_y], x[mode_x] + x[mode_xy]);
      put(ly + k, ry + k, z[mode_y], z[mode_x] - z[mode_xy]);
      put(above_ly + k, above_ry + k, V(T(0)) - z[mode_y], z[mode_x] + z[mode_xy]);
    }
  }

  /// Of one component.
  [[gnu::always_inline]] static void amplitudes(const T* p, std::ptrdiff_t stride, V* a) {
    const V low = V::load(p), low_right = V::load(p + 1), high = V::load(p + stride),
            high_right = V::load(p + stride + 1);
    const V below = low_right - low, above = high_right - high;
    a[mode_x] = below + above;
    a[mode_xy] = above - below;
    a[mode_y] = (high + high_right) - (low + low_right);
  }

  [[gnu::always_inline]] static void put(T* left, T* right, V even, V odd) {
    (even + odd).store(left);
    (even - odd).store(right);
  }

  template <class Then> [[gnu::always_inline]] void add(int x0, int nodes, int y, const Then& then) {
    const statics::Plane<const T> u = u_;
    const std::ptrdiff_t first = grid_.index(x0, y);
    const T *const lx = lower(left_x) + lanes, *const rx = lower(right_x) + lanes - 1,
                   *const ly = lower(left_y) + lanes, *const ry = lower(right_y) + lanes - 1;
    const T *const below_lx = upper(left_x, y + 1) + lanes, *const below_rx = upper(right_x, y + 1) + lanes - 1,
                   *const below_ly = upper(left_y, y + 1) + lanes, *const below_ry = upper(right_y, y + 1) + lanes - 1;
    for (int k = 0; k < nodes; k += lanes) {
      const V x = (V::load(lx + k) + V::load(rx + k)) + (V::load(below_lx + k) + V::load(below_rx + k));
      const V z = (V::load(ly + k) + V::load(ry + k)) + (V::load(below_ly + k) + V::load(below_ry + k));
      const std::ptrdiff_t i = first + k;
      statics::Force<V> force{x, z};
      if (grid_.periodic && x0 + k + lanes > grid_.width) statics::clear_beyond(grid_.width - x0 - k, force);
      then(i, statics::Force<V>{V::load(u.x + i), V::load(u.y + i)}, force);
    }
  }

  const Elements& elements_;
  const Grid grid_;
  const std::uint32_t* words_;
  statics::Plane<const T> u_;
  alignas(64) T buffer_[12 * pitch];
};

struct PlaneSweep {
  using Of = Elements;
  template <class V> using At = SweepInPlane<V>;
};

}  // namespace arenite::elements
