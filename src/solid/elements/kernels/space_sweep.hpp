#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/lanes.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/modes.hpp"
#include "solid/statics/passes.hpp"

/// The force of voxels on their corners, row by row.
///
/// Each voxel is worked out once in a block of rows. What it does to the corners of one of its edges along x is kept as
/// what moves both alike and what parts them, so that what the edges of the four voxels around a row of nodes do is
/// added up first and taken to the nodes after. What a row of voxels does to the nodes behind it waits in a buffer in
/// the nearest cache, what a layer does to the nodes above it in one of a layer of the block. The row of voxels before
/// a block is worked out in both, with the same bits. Vectors of void are passed over.
namespace arenite::elements {

template <class V> class SweepInSpace {
 public:
  using T = typename V::Scalar;
  static constexpr int lanes = V::lanes;
  static constexpr int tile = 1024 / static_cast<int>(sizeof(T));
  static constexpr int pitch = tile + lanes;

  static constexpr int most_rows = 36;  ///< of a block

  SweepInSpace(const Voxels& voxels, statics::PointersIn<3, const T> u) : voxels_(voxels), grid_(voxels.grid), u_(u) {}

  /// An even number, so that two threads have equal shares.
  static int blocks(const Grid& grid) {
    const int pairs = (grid.height + 2 * most_rows - 1) / (2 * most_rows);
    return 2 * pairs;
  }

  /// `everywhere`: calls `then` for nodes that no voxel touches, too.
  template <bool everywhere, class Level, class Then>
  [[gnu::always_inline]] void sweep(int block, const Level& level, const Then& then) {
    const int count = blocks(grid_), begin = grid_.height * block / count, end = grid_.height * (block + 1) / count;
    const bool is_first = begin == 0 && !grid_.periodic;
    const int all = (grid_.width + lanes - 1) / lanes * lanes;
    begin_ = begin;
    std::fill_n(&behind_[0][0], sizeof behind_ / sizeof(T), T(0));
    std::memset(met_, 0, sizeof met_);
    for (int x = 0; x < all; x += tile) {
      const int nodes = std::min(tile, all - x);
      std::fill_n(&above_[0][0][0], sizeof above_ / sizeof(T), T(0));
      std::memset(met_above_, 0, sizeof met_above_);
      for (int z = grid_.periodic ? -1 : 0; z < grid_.depth; ++z) {
        if (z >= 0) level(z);
        if (is_first) {
          std::fill_n(&behind_[0][0], sizeof behind_ / sizeof(T), T(0));
          std::memset(met_, 0, sizeof met_);
        }
        for (int y = is_first ? 0 : begin - 1; y < end; ++y) row<everywhere>(x, y, z, nodes, then);
      }
    }
  }

 private:
  using Vector = statics::ForceIn<3, V>;
  /// What voxels do to the corners of an edge along x, of one component: to both alike, and parting them.
  struct Edge {
    V even, odd;
    ARENITE_INLINE friend Edge operator+(Edge a, Edge b) { return {a.even + b.even, a.odd + b.odd}; }
    ARENITE_INLINE static Edge load(const T* p) { return {V::load(p), V::load(p + pitch)}; }
    ARENITE_INLINE void store(T* p) const { even.store(p), odd.store(p + pitch); }
  };
  /// Of a component: by whether they lie behind (larger y) and above.
  struct Edges {
    Edge front_low, back_low, front_high, back_high;
  };

  /// A row of voxels, and the nodes of its lowest edges: these have all that acts on them.
  template <bool everywhere, class Then>
  [[gnu::always_inline]] void row(int x, int y, int z, int nodes, const Then& then) {
    using Table = statics::Machine::Table<V>;
    const auto& table = voxels_.table;
    const Table axial(table[0].data()), cross(table[1].data()), shear(table[2].data()), along(table[3].data()),
        across(table[4].data()), trilinear(table[5].data());
    const std::ptrdiff_t first = grid_.index(x, y, z);
    const std::uint32_t* const words = voxels_.words.data() + first;
    const bool feeds = y < begin_;  // the row before the block: for what it does behind it
    const int slot = feeds ? 0 : y - begin_;
    std::uint8_t* const met_above = met_above_[slot];
    Vector low{}, high{};  // what the vector of voxels before does to its right corners
    bool met_left = false;
    for (int k = x > 0 || grid_.periodic ? -lanes : 0; k < nodes; k += lanes) {
      const std::ptrdiff_t i = first + k;
      const int n = k / lanes + 1;
      const bool is_left = k < 0;  // the voxels to the left of the tile: for their right corners
      const bool met = is_met(words + k), met_here = met || met_[n];
      const bool touched = met_here || met_left || (!is_left && met_above[n]);
      met_[n] = met;
      if (!touched) {
        if constexpr (everywhere)
          if (!is_left && !feeds && z >= 0) then(i, at(i), Vector{});
        continue;
      }
      Vector force;
      const auto add = [&](int c, const Edges& edges) __attribute__((always_inline)) {
        T* const kept = &behind_[4 * c][k + lanes];
        const Edge at_low = edges.front_low + Edge::load(kept),
                   at_high = edges.front_high + Edge::load(kept + 2 * pitch);
        edges.back_low.store(kept);
        edges.back_high.store(kept + 2 * pitch);
        const V right_low = at_low.odd + at_low.even, right_high = at_high.odd + at_high.even;
        const V on_low = (at_low.odd - at_low.even) - behind(low[c], right_low),
                on_high = (at_high.odd - at_high.even) - behind(high[c], right_high);
        low[c] = right_low, high[c] = right_high;
        if (is_left || feeds) return;
        T* const waiting = &above_[slot][c][k];
        force[c] = on_low + V::load(waiting);
        on_high.store(waiting);
      };
      if (met) {
        const auto word = statics::Machine::Words<lanes>(words + k);
        const ModesOf<3, V> m{axial.template find<0>(word),  cross.template find<0>(word),
                              shear.template find<0>(word),  along.template find<0>(word),
                              across.template find<0>(word), trilinear.template find<0>(word)};
        Amplitudes<3, V> a;
        statics::by_component<3>([&](int c) __attribute__((always_inline)) { amplitudes(u_[c] + i, a.at[c]); });
        const Amplitudes<3, V> p = work_of(m, a);
        statics::by_component<3>([&](int c) __attribute__((always_inline)) { add(c, edges_of(p.at[c])); });
      } else {
        statics::by_component<3>([&](int c) __attribute__((always_inline)) { add(c, Edges{}); });
      }
      const bool met_by_layer = met_here || met_left;
      met_left = met_here;
      if (is_left || feeds) continue;
      met_above[n] = met_by_layer;
      if (z < 0) continue;
      if (grid_.periodic && x + k + lanes > grid_.width) statics::clear_beyond(grid_.width - x - k, force);
      then(i, at(i), force);
    }
  }

  ARENITE_INLINE Vector at(std::ptrdiff_t i) const { return {V::load(u_.x + i), V::load(u_.y + i), V::load(u_.z + i)}; }

  /// The numbers one lane up: the last one of those before comes first.
  ARENITE_INLINE static V behind(V before, V here) {
    return [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
      return V(__builtin_shufflevector(before.v, here.v, (lanes - 1 + k)...));
    }
    (std::make_integer_sequence<int, lanes>());
  }
  /// Whether one of a vector of voxels is not void.
  [[gnu::always_inline]] static bool is_met(const std::uint32_t* words) {
    std::uint64_t two[lanes / 2], any = 0;
    std::memcpy(two, words, sizeof two);
    for (const std::uint64_t each : two) any |= each;
    return any != 0;
  }

  /// Of one component.
  [[gnu::always_inline]] void amplitudes(const T* p, V* a) const {
    const std::ptrdiff_t stride = grid_.stride, layer = grid_.layer;
    const auto along_x = [&](const T* q, V& sum, V& difference) __attribute__((always_inline)) {
      const V left = V::load(q), right = V::load(q + 1);
      sum = left + right;
      difference = right - left;
    };
    V s00, d00, s10, d10, s01, d01, s11, d11;
    along_x(p, s00, d00);
    along_x(p + stride, s10, d10);
    along_x(p + layer, s01, d01);
    along_x(p + layer + stride, s11, d11);
    const V s_low = s00 + s10, s_high = s01 + s11, y_low = s10 - s00, y_high = s11 - s01;
    const V d_low = d00 + d10, d_high = d01 + d11, xy_low = d10 - d00, xy_high = d11 - d01;
    a[mode_x] = d_low + d_high;
    a[mode_y] = y_low + y_high;
    a[mode_xy] = xy_low + xy_high;
    a[mode_z] = s_high - s_low;
    a[mode_zx] = d_high - d_low;
    a[mode_yz] = y_high - y_low;
    a[mode_xyz] = xy_high - xy_low;
  }

  /// From what the energy changes by.
  [[gnu::always_inline]] static Edges edges_of(const V* q) {
    const V y_low = q[mode_y] - q[mode_yz], y_high = q[mode_y] + q[mode_yz];
    const V x_low = q[mode_x] - q[mode_zx], x_high = q[mode_x] + q[mode_zx];
    const V xy_low = q[mode_xy] - q[mode_xyz], xy_high = q[mode_xy] + q[mode_xyz];
    return {{-(q[mode_z] + y_low), x_low - xy_low},
            {y_low - q[mode_z], x_low + xy_low},
            {q[mode_z] - y_high, x_high - xy_high},
            {q[mode_z] + y_high, x_high + xy_high}};
  }

  const Voxels& voxels_;
  const Grid grid_;
  statics::PointersIn<3, const T> u_;
  int begin_ = 0;                                     ///< first row of the block
  alignas(64) T behind_[12][pitch];                   ///< [component, high, odd]: from one vector to the left on
  alignas(64) T above_[most_rows][3][tile];           ///< [row][component]
  std::uint8_t met_[pitch / lanes];                   ///< vectors of the row before that are not all void
  std::uint8_t met_above_[most_rows][pitch / lanes];  ///< by row: vectors of nodes that a layer's voxels touch
};

struct SpaceSweep {
  using Of = Voxels;
  template <class V> using At = SweepInSpace<V>;
  static int blocks(const Voxels& voxels) { return SweepInSpace<Lanes<float, 4>>::blocks(voxels.grid); }
};

}  // namespace arenite::elements
