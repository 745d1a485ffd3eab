#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/joined_sets.hpp"
#include "thermal/imaging/distance.hpp"
#include "thermal/imaging/label_grains.hpp"

namespace arenite::imaging {
namespace {

/// Particle nodes from the deepest inside outwards, equals in the order of the map: radix sort by 16 bits at a time.
std::vector<std::int32_t> by_depth(const std::vector<std::int32_t>& squared) {
  std::vector<std::int32_t> order, next;
  for (std::size_t i = 0; i < squared.size(); ++i)
    if (squared[i] > 0) order.push_back(static_cast<std::int32_t>(i));
  next.resize(order.size());
  for (const int shift : {0, 16}) {
    std::array<std::size_t, 65537> start{};
    const auto bucket = [&](std::int32_t i) { return 65535 - (static_cast<std::size_t>(squared[static_cast<std::size_t>(i)]) >> shift & 65535); };
    for (const std::int32_t i : order) ++start[bucket(i) + 1];
    for (std::size_t b = 1; b < start.size(); ++b) start[b] += start[b - 1];
    for (const std::int32_t i : order) next[start[bucket(i)]++] = i;
    order.swap(next);
  }
  return order;
}

/// Basins about the summits of the distance transform, joined where the saddle between two is less than `smoothing`
/// below the lower summit.
class Basins {
 public:
  Basins(const PhaseMap& map, const std::vector<std::int32_t>& squared, double smoothing)
      : map_(map), squared_(squared), smoothing_(smoothing), label_(map.size(), -1) {}

  std::vector<std::int32_t> flood() {
    for (const std::int32_t i : by_depth(squared_)) take(static_cast<std::size_t>(i));
    for (std::int32_t& l : label_)
      if (l >= 0) l = sets_.find(l);
    return std::move(label_);
  }

 private:
  /// A node goes to the basin of its deepest neighbour, or starts one; it is the saddle of the basins that meet there.
  void take(std::size_t i) {
    const auto width = static_cast<std::size_t>(map_.width);
    const std::size_t x = i % width;
    std::array<std::size_t, 4> neighbours{};
    std::size_t count = 0;
    const auto note = [&](std::size_t n) {
      if (label_[n] >= 0) neighbours[count++] = n;
    };
    if (i >= width) note(i - width);
    if (x > 0) note(i - 1);
    if (x + 1 < width) note(i + 1);
    if (i + width < label_.size()) note(i + width);
    const double level = std::sqrt(static_cast<double>(squared_[i]));
    if (count == 0) {
      label_[i] = sets_.add();
      summit_.push_back(level);
      return;
    }
    std::size_t deepest = neighbours[0];
    for (std::size_t k = 1; k < count; ++k)
      if (squared_[neighbours[k]] > squared_[deepest]) deepest = neighbours[k];
    label_[i] = label_[deepest];
    for (std::size_t k = 0; k < count; ++k) meet(label_[i], label_[neighbours[k]], level);
  }
  /// Basins are numbered from the deepest on, so the smaller number, which the joined ones keep, is the higher summit.
  void meet(std::int32_t a, std::int32_t b, double level) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (a != b && summit_[static_cast<std::size_t>(std::max(a, b))] - level <= smoothing_) sets_.join(a, b);
  }

  const PhaseMap& map_;
  const std::vector<std::int32_t>& squared_;
  double smoothing_;
  std::vector<std::int32_t> label_;
  JoinedSets sets_;
  std::vector<double> summit_;
};

}  // namespace

std::vector<std::int32_t> watershed(const PhaseMap& map, double smoothing) {
  const std::vector<std::int32_t> squared = squared_distance(map);
  return Basins(map, squared, smoothing).flood();
}

}  // namespace arenite::imaging
