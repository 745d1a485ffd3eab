#include "thermal/imaging/label_grains.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
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
  for (std::size_t i = 0; i < g.size(); ++i)
    g[i] = map.phase[i] != Phase::particle ? 0 : i < width ? far : std::min(far, g[i - width] + 1);
  for (std::size_t i = g.size() - width; i-- > 0;) g[i] = std::min(g[i], g[i + width] + 1);
  return g;
}

/// Least of the parabolas g[c]^2 + (x - c)^2 at every place x of a row, from their lower envelope.
void along_row(const std::int32_t* g, int width, std::int32_t* out) {
  const auto value = [&](int centre, int x) {
    const std::int64_t across = x - centre, along = g[centre];
    return across * across + along * along;
  };
  struct Piece {
    int centre, start;
  };
  std::vector<Piece> lowest;
  for (int u = 0; u < width; ++u) {
    std::int64_t start = 0;  // one behind the last x at which the parabola before is not above this one
    for (; !lowest.empty(); lowest.pop_back()) {
      const int i = lowest.back().centre;
      const std::int64_t rise = value(u, 0) - value(i, 0), run = 2 * (std::int64_t{u} - i);
      start = 1 + (rise >= 0 ? rise / run : -((-rise + run - 1) / run));
      if (start > lowest.back().start) break;
      start = 0;
    }
    if (start < width) lowest.push_back({u, static_cast<int>(start)});
  }
  for (int x = width; x-- > 0;) {
    while (lowest.back().start > x) lowest.pop_back();
    out[x] = static_cast<std::int32_t>(
        std::min<std::int64_t>(value(lowest.back().centre, x), std::numeric_limits<std::int32_t>::max()));
  }
}

/// Particle nodes from the deepest inside outwards, equals in the order of the map.
std::vector<std::int32_t> by_depth(const std::vector<std::int32_t>& squared) {
  std::vector<std::int32_t> order;
  for (std::size_t i = 0; i < squared.size(); ++i)
    if (squared[i] > 0) order.push_back(static_cast<std::int32_t>(i));
  std::ranges::stable_sort(order, std::greater{}, [&](std::int32_t i) { return squared[static_cast<std::size_t>(i)]; });
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
    const std::pair<bool, std::size_t> beside[] = {
        {i >= across, i - across}, {x > 0, i - 1}, {x + 1 < across, i + 1}, {i + across < label.size(), i + across}};
    const double level = std::sqrt(static_cast<double>(squared[i]));
    std::int32_t deepest = 0;  // of the neighbours that were taken
    for (const auto& [in, n] : beside)
      if (in && label[n] >= 0 && squared[n] > deepest) deepest = squared[n], label[i] = label[n];
    if (deepest == 0) {
      label[i] = sets.add();
      summit.push_back(level);
    }
    for (const auto& [in, n] : beside)
      if (in && label[n] >= 0) meet(label[i], label[n], level);
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
  JoinedSets sets(map.size());
  const auto width = static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (map.phase[i] != Phase::particle) continue;
    label[i] = static_cast<std::int32_t>(i);
    for (const std::size_t before : {i % width > 0 ? i - 1 : i, i >= width ? i - width : i})
      if (map.phase[before] == Phase::particle) sets.join(label[before], label[i]);
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
  for (int y = 0; y < map.height; ++y)
    along_row(g.data() + map.index(0, y), map.width, squared.data() + map.index(0, y));
  if (std::find(g.begin(), g.end(), 0) == g.end())
    std::fill(squared.begin(), squared.end(), std::numeric_limits<std::int32_t>::max());
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
