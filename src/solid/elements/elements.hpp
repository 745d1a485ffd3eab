#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/pages.hpp"
#include "model/voxel_map.hpp"
#include "solid/elements/modes.hpp"
#include "solid/elements/options.hpp"
#include "solid/statics/aggregates.hpp"
#include "solid/statics/block_diagonal.hpp"
#include "solid/statics/discretisation.hpp"
#include "solid/statics/grid.hpp"
#include "solid/statics/pool.hpp"

namespace arenite::elements {

using statics::Aggregates;
using statics::BlockDiagonalIn;
using statics::FieldIn;
using statics::Grid;

/// Kind of a pixel or a voxel.
enum Kind : std::uint32_t { none = 0, matrix = 1, interface = 2, particle = 3 };
inline constexpr std::array<Kind, 3> solid_kinds{matrix, interface, particle};

/// A map as elements. Nodes are the corners of its cells, of the pixels in the plane and of the voxels in space: one
/// more each way than there are cells, or in a periodic sample as many. The cell whose lowest corner is node i has its
/// kind at words[i], in bits 0 and 1.
template <int D> struct ElementsIn {
  static constexpr int dimension = D;
  static constexpr std::size_t corner_count = 1u << D;
  static constexpr bool rests_when_strained = true;
  Grid grid;                          ///< of corners
  std::array<int, 3> cells{1, 1, 1};  ///< along x, y and z; one layer in the plane
  Buffer<std::uint32_t> words;        ///< padded
  std::array<Modes<D>, 4> modes;      ///< by kind, as the kernels have them: rounded to single precision
  std::array<std::array<float, 4>, Modes<D>::members.size()> table{};  ///< the members of Modes, each by kind
  const ThreadPool* pool = nullptr;                                    ///< works on it in space; none: the caller alone

  Kind kind(std::ptrdiff_t i) const { return static_cast<Kind>(words[i] & 3u); }
  std::size_t count() const {
    return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) * static_cast<std::size_t>(cells[2]);
  }
  /// Of a cell in the map's order.
  std::int32_t place(int x, int y, int z) const { return x + cells[0] * (y + cells[1] * z); }
  /// Steps from a cell's lowest corner to each.
  std::array<std::ptrdiff_t, corner_count> steps() const;
  /// The node that a corner is, where a period has led beyond the last.
  std::ptrdiff_t node(int x, int y, int z) const {
    return grid.periodic ? grid.index(x % cells[0], y % cells[1], z % cells[2]) : grid.index(x, y, z);
  }
  /// visit(x, y, z) for every cell of some levels (rows in the plane, layers in space), in the map's order.
  template <class Visit> void each_between(int from, int to, const Visit& visit) const {
    std::array<int, 3> first{0, 0, 0}, last = cells;
    first[D - 1] = from, last[D - 1] = to;
    for (int z = first[2]; z < last[2]; ++z)
      for (int y = first[1]; y < last[1]; ++y)
        for (int x = 0; x < cells[0]; ++x) visit(x, y, z);
  }
  template <class Visit> void each(const Visit& visit) const { each_between(0, cells[D - 1], visit); }
  /// The same, level by level by whichever member of the pool.
  template <class Visit> void each_shared(const Visit& visit) const {
    statics::for_each(pool, static_cast<std::size_t>(cells[D - 1]), [&](std::size_t level) {
      each_between(static_cast<int>(level), static_cast<int>(level) + 1, visit);
    });
  }
};
using Elements = ElementsIn<2>;
using Voxels = ElementsIn<3>;

/// Throws InputError for a modulus that is not positive or a Poisson's ratio outside (-1, 1/2).
template <int D>
ElementsIn<D> make_elements(const MapIn<D>& map, const Material& material, bool periodic = false,
                            const ThreadPool* pool = nullptr);

// What the static solver asks (statics/discretisation.hpp), beside couplings and kernels_of (kernels/kernels.hpp).

template <int D> BlockDiagonalIn<D, double> block_diagonal(const ElementsIn<D>& elements);
/// The same of one node at a time.
template <int D> std::function<statics::BlockIn<D>(std::ptrdiff_t)> blocks_of(const ElementsIn<D>& elements);
/// Up to the largest eigenvalue of D_e^-1 K_e over the kinds, which no sum of elements exceeds. Elements reach less far
/// than bonds, so that the coarse space leaves the smoother longer waves.
template <int D> statics::Smoothing smoothing_of(const ElementsIn<D>& elements);

/// A corner belongs to the grain that most of the stiffness of its cells is of, matrix flooded to grains; pieces hang
/// together by cells. `prescribed` has one entry a level of corners, `side` is that of the coarse space's cells.
template <int D>
Aggregates cut_into_aggregates(const MapIn<D>& map, const ElementsIn<D>& elements,
                               const std::vector<std::uint8_t>& prescribed, int side = Aggregates::cell);

}  // namespace arenite::elements
