#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solid/elements/cell_products.hpp"
#include "solid/elements/couplings.hpp"
#include "solid/elements/kernels/kernels.hpp"

namespace arenite::elements {

/// Galerkin sums of the elements in space that no grain's surface cuts: in each coarse cell that such an element
/// reaches into all of its corners are of one aggregate. What it couples is then a polynomial of second degree in its
/// place in the cell along every axis along which it lies inside. So elements of one kind and the same aggregates are
/// counted at three places along these axes, with Lagrange's weights, and worked out there, axis by axis.
class CellSums {
 public:
  CellSums(const Voxels& elements, const Aggregates& cut, const std::vector<std::uint8_t>& prescribed);

  /// Adds what the elements of a cell couple, those whose lowest corners are in it; calls other(x, y, z) for each that
  /// is not of this sort.
  template <class Other> void add(const statics::Cell& cell, statics::CouplingSumIn<3>& sum, const Other& other) const {
    std::vector<Count> counts;
    for (int z = cell.z0; z < cell.z0 + cell.deep; ++z)
      for (int y = cell.y0; y < cell.y0 + cell.high; ++y) add_row(cell, y, z, counts, other);
    for (const Count& count : counts) work_out(count, sum);
  }

 private:
  static constexpr int most_places = CellShares::most_places;
  using Labels = std::array<std::int32_t, 8>;  ///< aggregates of the corners
  using Weights = CellShares::Weights;

  /// How many elements of each kind there are with these aggregates, at each of the places.
  struct Count {
    unsigned across;  ///< axes along which they reach into the next cell, as bits
    Labels labels;
    std::array<std::array<Weights, most_places * most_places>, 3> at;
  };
  /// The corners of one side of an element across x.
  struct Side {
    std::array<std::int32_t, 4> labels;
    bool whole;  ///< what is in one cell is of one aggregate
  };

  Side side_of(std::ptrdiff_t node, unsigned across) const {
    Side side{{of_node_[node], of_node_[node + stride_], of_node_[node + layer_], of_node_[node + layer_ + stride_]},
              true};
    for (std::size_t c = 0; c < 4; ++c)
      side.whole = side.whole && side.labels[c] >= 0 && side.labels[c] == side.labels[c & across >> 1];
    return side;
  }
  bool is_last(int at) const { return at % side_ == side_ - 1; }

  template <class Other>
  void add_row(const statics::Cell& cell, int y, int z, std::vector<Count>& counts, const Other& other) const {
    const unsigned across = (is_last(y) ? 2u : 0u) | (is_last(z) ? 4u : 0u);
    const bool leaves = leaves_along(1, y) || leaves_along(2, z) || slides_[static_cast<std::size_t>(z)];
    const std::ptrdiff_t row = elements_.grid.index(cell.x0, y, z);
    Side left = side_of(row, across);
    for (int k = 0; k < cell.wide; ++k) {
      const Side right = side_of(row + k + 1, across);
      const Kind kind = elements_.kind(row + k);
      const int x = cell.x0 + k;
      const bool reaches = is_last(x);
      if (kind != none) {
        if (leaves || leaves_along(0, x) || !left.whole || !right.whole || (!reaches && left.labels != right.labels))
          other(x, y, z);
        else
          count_of(counts, across | (reaches ? 1u : 0u), left, right)
              .put(kind, weights_[place(x)], weights_[place(y)], weights_[place(z)]);
      }
      left = right;
    }
  }
  struct Found {
    Count& count;
    void put(Kind kind, const Weights& x, const Weights& y, const Weights& z) const {
      auto& at = count.at[kind - 1];
      for (std::size_t c = 0; c < most_places; ++c)
        for (std::size_t b = 0; b < most_places; ++b) at[most_places * c + b] += z[c] * y[b] * x;
    }
  };
  static Found count_of(std::vector<Count>& counts, unsigned across, const Side& left, const Side& right);
  CellShares shares_of(const Count& count) const;
  void work_out(const Count& count, statics::CouplingSumIn<3>& sum) const;
  bool leaves_along(std::size_t axis, int at) const {
    return elements_.grid.periodic && at + 1 == elements_.cells[axis];
  }
  std::size_t place(int at) const { return static_cast<std::size_t>(at % side_); }

  const Voxels& elements_;
  const std::int32_t* of_node_;
  std::ptrdiff_t stride_, layer_;
  int side_;
  std::vector<std::uint8_t> slides_;  ///< by layer of elements
  std::vector<int> places_;
  std::vector<Weights> weights_;        ///< of every place in a cell
  AxisProducts inside_;                 ///< of one cell with itself
  std::array<AxisProducts, 4> across_;  ///< along an axis along which elements reach into the next cell, with it or not
  CellKernel couple_ = cell_kernel();
};

}  // namespace arenite::elements
