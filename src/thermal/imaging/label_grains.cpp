#include "thermal/imaging/label_grains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/joined_sets.hpp"
#include "core/problems.hpp"

namespace arenite::imaging {
namespace {

/// Distance down and up the columns; `far` where a column is all particle.
std::vector<std::int32_t> along_columns(const PhaseMap& map, std::int32_t far) {
  std::vector<std::int32_t> g(map.size());
  const auto width = static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < g.size(); ++i) g[i] = map.phase[i] != Phase::particle ? 0 : i < width ? far : std::min(far, g[i - width] + 1);
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
      out[x] = static_cast<std::int32_t>(std::min<std::int64_t>(value(g, centre_[k - 1], x), std::numeric_limits<std::int32_t>::max()));
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
struct Basins {
  int width;
  const std::vector<std::int32_t>& squared;
  double smoothing;
  std::vector<std::int32_t> label = std::vector<std::int32_t>(squared.size(), -1);
  JoinedSets sets{};
  std::vector<double> summit = {};

  /// A node goes to the basin of its deepest neighbour, or starts one; it is the saddle of the basins that meet there.
  void take(std::size_t i) {
    const auto across = static_cast<std::size_t>(width);
    const std::size_t x = i % across;
    std::array<std::size_t, 4> neighbours{};
    std::size_t count = 0;
    const auto note = [&](std::size_t n) {
      if (label[n] >= 0) neighbours[count++] = n;
    };
    if (i >= across) note(i - across);
    if (x > 0) note(i - 1);
    if (x + 1 < across) note(i + 1);
    if (i + across < label.size()) note(i + across);
    const double level = std::sqrt(static_cast<double>(squared[i]));
    if (count == 0) {
      label[i] = sets.add();
      summit.push_back(level);
      return;
    }
    std::size_t deepest = neighbours[0];
    for (std::size_t k = 1; k < count; ++k)
      if (squared[neighbours[k]] > squared[deepest]) deepest = neighbours[k];
    label[i] = label[deepest];
    for (std::size_t k = 0; k < count; ++k) meet(label[i], label[neighbours[k]], level);
  }
  /// Basins are numbered from the deepest on, so the smaller number, which the joined ones keep, is the higher summit.
  void meet(std::int32_t a, std::int32_t b, double level) {
    a = sets.find(a);
    b = sets.find(b);
    if (a != b && summit[static_cast<std::size_t>(std::max(a, b))] - level <= smoothing) sets.join(a, b);
  }
};

/// Of every node that has a label, the one of all that were joined.
std::vector<std::int32_t> joined(std::vector<std::int32_t> label, JoinedSets& sets) {
  for (std::int32_t& l : label)
    if (l >= 0) l = sets.find(l);
  return label;
}

/// The two ways: a label for each particle node, equal within a grain and otherwise arbitrary, -1 elsewhere.
std::vector<std::int32_t> connected_particles(const PhaseMap& map) {
  std::vector<std::int32_t> label(map.size(), -1);
  JoinedSets sets;
  const auto width = static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (map.phase[i] != Phase::particle) continue;
    const std::int32_t before = i % width > 0 ? label[i - 1] : -1, below = i >= width ? label[i - width] : -1;
    if (before >= 0 && below >= 0) label[i] = before == below ? before : sets.join(before, below);
    else label[i] = before >= 0 ? before : below >= 0 ? below : sets.add();
  }
  return joined(std::move(label), sets);
}

std::vector<std::int32_t> watershed(const PhaseMap& map, double smoothing) {
  const std::vector<std::int32_t> squared = squared_distance(map);
  Basins basins{map.width, squared, smoothing};
  for (const std::int32_t i : by_depth(squared)) basins.take(static_cast<std::size_t>(i));
  return joined(std::move(basins.label), basins.sets);
}

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

void label_grains(PhaseMap& map, const LabelOptions& options) {
  if (!(options.smoothing >= 0) || !std::isfinite(options.smoothing))
    throw refusal("the smoothing of the watershed is {:g} nodes; give zero or more", options.smoothing);
  map.grain = options.way == Labelling::components ? connected_particles(map) : watershed(map, options.smoothing);
  std::vector<std::int32_t> number;
  std::int32_t grains = 0;
  for (std::int32_t& g : map.grain) {
    if (g < 0) continue;
    if (static_cast<std::size_t>(g) >= number.size()) number.resize(static_cast<std::size_t>(g) + 1, -1);
    std::int32_t& own = number[static_cast<std::size_t>(g)];
    if (own < 0) own = grains++;
    g = own;
  }
  map.grain_class.assign(static_cast<std::size_t>(grains), GrainClass::none);
}

}  // namespace arenite::imaging
