#include "geometry/label_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/joined_sets.hpp"
#include "core/problems.hpp"

namespace arenite::geometry {
namespace {

/// visit(neighbour) for the cells that share a side with one.
class CellSides {
 public:
  explicit CellSides(const Cells& cells) : count_(cells.count()), stride_(cells.stride()), periodic_(cells.periodic) {}

  template <class Visit> void each(std::size_t cell, const Visit& visit) const {
    const std::array<std::size_t, 3> place{cell % stride_[1], cell % stride_[2] / stride_[1], cell / stride_[2]};
    for (std::size_t axis = 3; axis-- > 0;)
      if (place[axis] > 0) visit(cell - stride_[axis]);
      else if (periodic_) visit(cell + last(axis) * stride_[axis]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (place[axis] < last(axis)) visit(cell + stride_[axis]);
      else if (periodic_) visit(cell - last(axis) * stride_[axis]);
  }

 private:
  std::size_t last(std::size_t axis) const { return static_cast<std::size_t>(count_[axis]) - 1; }
  std::array<int, 3> count_;
  std::array<std::size_t, 3> stride_;
  bool periodic_;
};

/// Cells inside from the deepest outwards, equals in the order of their indices.
std::vector<std::int32_t> by_depth(const std::vector<std::int32_t>& squared) {
  std::vector<std::uint64_t> order;  // numbers to be compared lie together
  for (std::size_t i = 0; i < squared.size(); ++i)
    if (squared[i] > 0)
      order.push_back(static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max() - squared[i]) << 32U |
                      std::uint64_t{i});
  std::ranges::sort(order);
  std::vector<std::int32_t> cells(order.size());
  std::ranges::transform(order, cells.begin(), [](std::uint64_t k) { return static_cast<std::int32_t>(k); });
  return cells;
}

/// Basins about the summits of the distance transform, joined where the saddle between two is less than `smoothing`
/// below the lower summit.
struct Basins {
  CellSides sides;
  const std::vector<std::int32_t>& squared;
  double smoothing;
  std::vector<std::int32_t> label = std::vector<std::int32_t>(squared.size(), -1);
  JoinedSets sets{};
  std::vector<double> summit = {};

  /// A cell goes to the basin of its deepest neighbour, or starts one; it is the saddle of the basins that meet there.
  void take(std::size_t i) {
    const double level = std::sqrt(static_cast<double>(squared[i]));
    std::int32_t deepest = 0;  // of the neighbours that were taken
    sides.each(i, [&](std::size_t n) {
      if (label[n] >= 0 && squared[n] > deepest && n != i) deepest = squared[n], label[i] = label[n];
    });
    if (deepest == 0) {
      label[i] = sets.add();
      summit.push_back(level);
    }
    sides.each(i, [&](std::size_t n) {
      if (label[n] >= 0) meet(label[i], label[n], level);
    });
  }
  /// Basins are numbered from the deepest on, so the smaller number, which the joined ones keep, is the higher summit.
  void meet(std::int32_t a, std::int32_t b, double level) {
    a = sets.find(a);
    b = sets.find(b);
    if (a != b && summit[static_cast<std::size_t>(std::max(a, b))] - level <= smoothing) sets.join(a, b);
  }
};

/// Of every cell that has a label, the one of all that were joined.
std::vector<std::int32_t> joined(std::vector<std::int32_t> label, JoinedSets& sets) {
  for (std::int32_t& l : label)
    if (l >= 0) l = sets.find(l);
  return label;
}

/// The two ways: a label for each cell inside, equal within a grain and otherwise arbitrary, -1 elsewhere.
std::vector<std::int32_t> connected(const Cells& cells, const std::vector<std::uint8_t>& inside) {
  std::vector<std::int32_t> label(inside.size(), -1);
  JoinedSets sets(inside.size());
  const CellSides sides(cells);
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (!inside[i]) continue;
    label[i] = static_cast<std::int32_t>(i);
    sides.each(i, [&](std::size_t n) {
      if (n < i && inside[n]) sets.join(label[n], label[i]);
    });
  }
  return joined(std::move(label), sets);
}

std::vector<std::int32_t> watershed(const Cells& cells, const std::vector<std::uint8_t>& inside, double smoothing) {
  const std::vector<std::int32_t> squared = squared_distance(cells, inside);
  Basins basins{CellSides(cells), squared, smoothing};
  for (const std::int32_t i : by_depth(squared)) basins.take(static_cast<std::size_t>(i));
  return joined(std::move(basins.label), basins.sets);
}

}  // namespace

CellLabels label_cells(const Cells& cells, const std::vector<std::uint8_t>& inside, const LabelOptions& options) {
  if (!(options.smoothing >= 0) || !std::isfinite(options.smoothing))
    throw refusal("the smoothing of the watershed is {:g} nodes; give zero or more", options.smoothing);
  CellLabels labels;
  labels.label =
      options.way == Labelling::components ? connected(cells, inside) : watershed(cells, inside, options.smoothing);
  std::vector<std::int32_t> number;
  for (std::int32_t& g : labels.label) {
    if (g < 0) continue;
    if (static_cast<std::size_t>(g) >= number.size()) number.resize(static_cast<std::size_t>(g) + 1, -1);
    std::int32_t& own = number[static_cast<std::size_t>(g)];
    if (own < 0) own = labels.count++;
    g = own;
  }
  return labels;
}

}  // namespace arenite::geometry
