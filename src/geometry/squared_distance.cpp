#include "geometry/squared_distance.hpp"

#include <algorithm>
#include <limits>

namespace arenite::geometry {
namespace {

constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::max();

/// Least of the parabolas known[c] + (x - c)^2 at the places of a line, from their lower envelope.
class DistanceLine {
 public:
  DistanceLine(int count, bool periodic)
      : count_(count),
        first_(periodic ? -count : 0),
        last_(periodic ? 2 * count : count),
        known_(static_cast<std::size_t>(count)) {}

  void lower(std::int32_t* at, std::size_t stride) {
    const auto cell = [&](int x) -> std::int32_t& { return at[static_cast<std::size_t>(x) * stride]; };
    for (int x = 0; x < count_; ++x) known_[static_cast<std::size_t>(x)] = cell(x);
    lowest_.clear();
    for (int centre = first_; centre < last_; ++centre) add(centre);
    if (lowest_.empty()) return;
    for (int x = last_; x-- > 0;) {
      while (lowest_.back().start > x) lowest_.pop_back();
      if (x < count_)
        cell(x) = static_cast<std::int32_t>(std::min<std::int64_t>(value(lowest_.back().centre, x), unknown));
    }
  }

 private:
  struct Piece {
    int centre, start;
  };
  std::int32_t known(int centre) const {
    const int place = centre < 0 ? centre + count_ : centre >= count_ ? centre - count_ : centre;
    return known_[static_cast<std::size_t>(place)];
  }
  std::int64_t value(int centre, int x) const {
    const std::int64_t across = x - centre;
    return across * across + known(centre);
  }
  void add(int centre) {
    if (known(centre) == unknown) return;
    std::int64_t start = first_;  // one behind the last x at which the parabola before is not above this one
    for (; !lowest_.empty(); lowest_.pop_back()) {
      const int before = lowest_.back().centre;
      const std::int64_t rise = value(centre, 0) - value(before, 0), run = 2 * (std::int64_t{centre} - before);
      start = 1 + (rise >= 0 ? rise / run : -((-rise + run - 1) / run));
      if (start > lowest_.back().start) break;
      start = first_;
    }
    if (start < last_) lowest_.push_back({centre, static_cast<int>(start)});
  }

  int count_, first_, last_;
  std::vector<std::int32_t> known_;
  std::vector<Piece> lowest_;
};

}  // namespace

std::vector<std::int32_t> squared_distance(const Cells& cells, const std::vector<std::uint8_t>& inside) {
  std::vector<std::int32_t> squared(cells.size());
  std::ranges::transform(inside, squared.begin(), [](std::uint8_t in) { return in ? unknown : 0; });
  const auto count = cells.count();
  const auto stride = cells.stride();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    DistanceLine line(count[axis], cells.periodic);
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int i = 0; i < count[b]; ++i)
      for (int j = 0; j < count[a]; ++j)
        line.lower(&squared[static_cast<std::size_t>(i) * stride[b] + static_cast<std::size_t>(j) * stride[a]],
                   stride[axis]);
  }
  return squared;
}

}  // namespace arenite::geometry
