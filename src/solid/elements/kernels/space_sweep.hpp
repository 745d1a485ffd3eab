#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/lanes.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/modes.hpp"
#include "solid/statics/passes.hpp"

/// The force of voxels on their corners, row by row.
///
/// Each voxel is worked out once in a block of rows, in a first pass over a row of voxels of a tile, which writes what
/// it does to its corners along four edges; a second pass adds up, for each node of the lower edge, the voxels on
/// either side of it, before it and below it. What a row of voxels does to the nodes behind it waits in a buffer in the
/// nearest cache, what a layer does to the nodes above it in one of a layer of the block. The row of voxels before a
/// block is worked out in both, with the same bits. Vectors of void are passed over.
namespace arenite::elements {

template <class V> class SweepInSpace {
 public:
  using T = typename V::Scalar;
  static constexpr int lanes = V::lanes;
  static constexpr int tile = 512 / static_cast<int>(sizeof(T));
  static constexpr int pitch = tile + 2 * lanes;

  static constexpr int most_rows = 24;  ///< of a block

  SweepInSpace(const Voxels& voxels, statics::PointersIn<3, const T> u) : voxels_(voxels), grid_(voxels.grid), u_(u) {}

  /// An even number, so that two threads have equal shares.
  static int blocks(const Grid& grid) {
    const int pairs = (grid.height + 2 * most_rows - 1) / (2 * most_rows);
    return 2 * pairs;
  }

  /// `everywhere`: calls `then` for nodes that no voxel touches, too.
  template <bool everywhere, class Level, class Then>
  [[gnu::always_inline]] void sweep(int block, const Level& level, const Then& then) {
    const int first = grid_.periodic ? -1 : 0, count = blocks(grid_);
    const int begin = grid_.height * block / count, end = grid_.height * (block + 1) / count;
    begin_ = begin;
    for (int x = 0; x < grid_.row_vectors() * Grid::vector; x += tile) {
      const int nodes = std::min(tile, grid_.row_vectors() * Grid::vector - x);
      std::fill_n(above_, sizeof above_ / sizeof(T), T(0));
      std::memset(met_above_, 0, sizeof met_above_);
      for (int z = first; z < grid_.depth; ++z) {
        if (z >= 0) level(z);
        const bool starts = begin == 0 && !grid_.periodic;
        if (starts) {
          std::fill_n(&edge_[0][0][0], sizeof edge_ / sizeof(T), T(0));
          std::memset(met_, 0, sizeof met_);
        }
        for (int y = starts ? 0 : begin - 1; y < end; ++y) {
          stretch(grid_.index(x, y, z), nodes, y);
          if (y >= begin) add<everywhere>(x, y, z, nodes, then);
        }
      }
    }
  }

 private:
  /// Edges of a row of voxels along x: by whether they lie behind (larger y) and above.
  enum Edge : unsigned { front_low, back_low, front_high, back_high };
  using Row = T[pitch];

  /// What voxels do to their left and right corners along an edge; edges behind are kept for the next row.
  Row* edge(Edge e, int y) { return edge_[e & 1 ? 2 * e + static_cast<unsigned>(y & 1) : 2 * e]; }

  /// Forces of a row of voxels, from one vector to the left of the tile on.
  [[gnu::always_inline]] void stretch(std::ptrdiff_t first, int nodes, int y) {
    using Table = statics::Machine::Table<V>;
    const auto& table = voxels_.table;
    const Table axial(table[0].data()), cross(table[1].data()), shear(table[2].data()), along(table[3].data()),
        across(table[4].data()), trilinear(table[5].data());
    const std::ptrdiff_t begin = first - lanes, stride = grid_.stride, layer = grid_.layer;
    const std::uint32_t* const words = voxels_.words.data() + begin;
    Row *const front_of_low = edge(front_low, y), *const back_of_low = edge(back_low, y),
               *const front_of_high = edge(front_high, y), *const back_of_high = edge(back_high, y);
    std::uint8_t* const met = met_[y & 1];
    for (int k = 0; k < nodes + lanes; k += lanes) {
      met[k / lanes] = is_met(words + k);
      if (!met[k / lanes]) {
        for (Row* const rows : {front_of_low, back_of_low, front_of_high, back_of_high})
          for (int n = 0; n < 6; ++n) V(T(0)).store(rows[n] + k);
        continue;
      }
      const auto word = statics::Machine::Words<lanes>(words + k);
      const ModesOf<3, V> m{axial.template find<0>(word),  cross.template find<0>(word),
                            shear.template find<0>(word),  along.template find<0>(word),
                            across.template find<0>(word), trilinear.template find<0>(word)};
      Amplitudes<3, V> a{};
      statics::by_component<3>([&](int c) { amplitudes(u_[c] + begin + k, stride, layer, a.at[c]); });
      const Amplitudes<3, V> p = work_of(m, a);
      statics::by_component<3>([&](int c) __attribute__((always_inline)) {
        const V* const q = p.at[c];
        put(front_of_low, c, k, (q[mode_yz] - q[mode_y]) - q[mode_z],
            (q[mode_x] + q[mode_xyz]) - (q[mode_xy] + q[mode_zx]));
        put(back_of_low, c, k, (q[mode_y] - q[mode_yz]) - q[mode_z],
            (q[mode_x] + q[mode_xy]) - (q[mode_zx] + q[mode_xyz]));
        put(front_of_high, c, k, (q[mode_z] - q[mode_yz]) - q[mode_y],
            (q[mode_x] + q[mode_zx]) - (q[mode_xy] + q[mode_xyz]));
        put(back_of_high, c, k, (q[mode_y] + q[mode_yz]) + q[mode_z],
            (q[mode_x] + q[mode_xy]) + (q[mode_zx] + q[mode_xyz]));
      });
    }
  }

  /// Whether one of a vector of voxels is not void.
  [[gnu::always_inline]] static bool is_met(const std::uint32_t* words) {
    std::uint64_t two[lanes / 2], any = 0;
    std::memcpy(two, words, sizeof two);
    for (const std::uint64_t each : two) any |= each;
    return any != 0;
  }

  /// Of one component.
  [[gnu::always_inline]] static void amplitudes(const T* p, std::ptrdiff_t stride, std::ptrdiff_t layer, V* a) {
    const auto along_x = [&](const T* q, V& sum, V& difference) {
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

  /// The force on the left corners of an edge, and that on the right ones turned about, from what the energy changes by
  /// as both corners move alike (`even`) and as they part (`odd`).
  [[gnu::always_inline]] static void put(Row* rows, int c, int k, V even, V odd) {
    (odd - even).store(rows[2 * c] + k);
    (odd + even).store(rows[2 * c + 1] + k);
  }

  template <bool everywhere, class Then>
  [[gnu::always_inline]] void add(int x, int y, int z, int nodes, const Then& then) {
    const Row *const front_of_low = edge(front_low, y), *const before_low = edge(back_low, y + 1),
                     *const front_of_high = edge(front_high, y), *const before_high = edge(back_high, y + 1);
    T* const above = above_ + static_cast<std::ptrdiff_t>(3 * tile) * (y - begin_);
    const std::ptrdiff_t first = grid_.index(x, y, z);
    const std::uint8_t *const met = met_[y & 1], *const met_before = met_[(y + 1) & 1];
    std::uint8_t* const met_above = met_above_[y - begin_];
    for (int k = 0; k < nodes; k += lanes) {
      const int n = k / lanes;
      const std::uint8_t met_here = met[n] | met[n + 1] | met_before[n] | met_before[n + 1];
      const bool touched = met_here | met_above[n];
      met_above[n] = met_here;
      if (!everywhere && !touched) continue;
      statics::ForceIn<3, V> own{}, force{};
      statics::by_component<3>([&](int c) {
        const auto at_nodes = [&](const Row* rows) {
          return V::load(rows[2 * c] + lanes + k) - V::load(rows[2 * c + 1] + lanes - 1 + k);
        };
        T* const waiting = above + tile * c + k;
        force[c] = (at_nodes(front_of_low) + at_nodes(before_low)) + V::load(waiting);
        (at_nodes(front_of_high) + at_nodes(before_high)).store(waiting);
      });
      if (z < 0) continue;
      const std::ptrdiff_t i = first + k;
      if (grid_.periodic && x + k + lanes > grid_.width) statics::clear_beyond(grid_.width - x - k, force);
      statics::by_component<3>([&](int c) { own[c] = V::load(u_[c] + i); });
      then(i, own, force);
    }
  }

  const Voxels& voxels_;
  const Grid grid_;
  statics::PointersIn<3, const T> u_;
  int begin_ = 0;                                    ///< first row of the block
  alignas(64) T above_[3 * tile * (most_rows + 1)];  ///< [row][component][node of the tile]
  std::uint8_t met_[2][pitch / lanes] = {};          ///< vectors of even and odd rows of voxels that are not all void
  std::uint8_t met_above_[most_rows + 1][tile / lanes];  ///< by row: vectors of nodes that a layer's voxels touch
  alignas(64) T edge_[8][6][pitch];  ///< [edge, behind: of even and odd rows][left and right of each component]
};

struct SpaceSweep {
  using Of = Voxels;
  template <class V> using At = SweepInSpace<V>;
  static int blocks(const Voxels& voxels) { return SweepInSpace<Lanes<float, 4>>::blocks(voxels.grid); }
};

}  // namespace arenite::elements
