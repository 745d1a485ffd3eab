#include "thermal/imaging/distance.hpp"

#include <algorithm>
#include <limits>

namespace arenite::imaging {
namespace {

/// Distance down and up the columns; `far` where a column is all particle.
std::vector<std::int32_t> along_columns(const PhaseMap& map, std::int32_t far) {
  std::vector<std::int32_t> g(map.size());
  const auto width = static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < g.size(); ++i)
    g[i] = map.phase[i] != Phase::particle ? 0 : i < width ? far : std::min(far, g[i - width] + 1);
  for (std::size_t i = g.size() - width; i-- > 0;) g[i] = std::min(g[i], g[i + width] + 1);
  return g;
}

/// Lower envelope of the parabolas g[c]^2 + (x - c)^2 of one row.
class Envelope {
 public:
  explicit Envelope(int width) : centre_(static_cast<std::size_t>(width)), start_(centre_.size()) {}

  void build(const std::int32_t* g, int width) {
    top_ = 0;
    for (int u = 0; u < width; ++u) {
      while (top_ > 0 && value(g, centre_[top_ - 1], start_[top_ - 1]) > value(g, u, start_[top_ - 1])) --top_;
      if (top_ == 0) {
        push(u, 0);
      } else if (const std::int64_t from = 1 + crossing(g, centre_[top_ - 1], u); from < width) {
        push(u, static_cast<int>(from));
      }
    }
  }
  void write(const std::int32_t* g, int width, std::int32_t* out) const {
    std::size_t k = top_;
    for (int x = width; x-- > 0;) {
      while (start_[k - 1] > x) --k;
      out[x] = static_cast<std::int32_t>(
          std::min<std::int64_t>(value(g, centre_[k - 1], x), std::numeric_limits<std::int32_t>::max()));
    }
  }

 private:
  static std::int64_t value(const std::int32_t* g, int centre, int x) {
    const std::int64_t across = x - centre, along = g[centre];
    return across * across + along * along;
  }
  /// Last x at which the parabola at i is not above that at u > i.
  static std::int64_t crossing(const std::int32_t* g, int i, int u) {
    const std::int64_t rise = value(g, u, 0) - value(g, i, 0), run = 2 * (std::int64_t{u} - i);
    return rise >= 0 ? rise / run : -((-rise + run - 1) / run);
  }
  void push(int centre, int start) {
    centre_[top_] = centre;
    start_[top_++] = start;
  }
  std::vector<int> centre_, start_;
  std::size_t top_ = 0;
};

}  // namespace

std::vector<std::int32_t> squared_distance(const PhaseMap& map) {
  const auto far = static_cast<std::int32_t>(std::min<std::int64_t>(std::int64_t{map.width} + map.height, 1 << 30));
  const std::vector<std::int32_t> g = along_columns(map, far);
  std::vector<std::int32_t> squared(map.size());
  Envelope envelope(map.width);
  for (int y = 0; y < map.height; ++y) {
    const std::size_t row = map.index(0, y);
    envelope.build(g.data() + row, map.width);
    envelope.write(g.data() + row, map.width, squared.data() + row);
  }
  if (std::find(g.begin(), g.end(), 0) == g.end()) std::fill(squared.begin(), squared.end(), std::numeric_limits<std::int32_t>::max());
  return squared;
}

}  // namespace arenite::imaging
