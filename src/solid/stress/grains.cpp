#include "solid/stress/grains.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "solid/stress/stress.hpp"
#include "statistics/correlation.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::stress {
namespace {

using statistics::Items;
using statistics::put;

/// Named sets of those grains that `wanted` holds for: "all", and "large", "small" where the map has both or one.
template <class Wanted> ByName<Items> grains_by_class(const PhaseMap& map, Wanted&& wanted) {
  ByName<Items> sets{{"all", {}}, {"large", {}}, {"small", {}}};
  for (std::size_t g = 0; g < map.grain_class.size(); ++g) {
    if (!wanted(g)) continue;
    sets[0].second.push_back(g);
    if (map.grain_class[g] != GrainClass::none)
      sets[map.grain_class[g] == GrainClass::large ? 1 : 2].second.push_back(g);
  }
  std::erase_if(sets, [](const auto& set) { return set.second.empty(); });
  return sets;
}

/// In which of so many columns from clamp to clamp each grain lies, and in which tile of a column, as many in each.
struct Blocks {
  std::vector<int> column, tile;
};
Blocks blocks_of(const PhaseMap& map, const GrainStresses& grains, int count) {
  const auto along = [&](double at, int nodes) {
    return std::clamp(static_cast<int>(at / (nodes * map.dx) * count), 0, count - 1);
  };
  Blocks blocks;
  for (const Vec2 c : grains.centre) {
    blocks.column.push_back(along(c.x, map.width));
    blocks.tile.push_back(along(c.y, map.height) * count + blocks.column.back());
  }
  return blocks;
}

Tensor2 tensor(const std::vector<Estimate>& e, double Estimate::*part) {
  return {e[0].*part, e[1].*part, e[2].*part, e[3].*part};
}

/// Every row carries the same force, so that tiles of a column are no samples of their own of what acts on rows; along
/// x nothing is carried.
TensorEstimate mean_tensor(const Items& items, const Blocks& blocks, const std::vector<Tensor2>& stress) {
  const auto add = [&](std::size_t g, double* sums) {
    const Tensor2& t = stress[g];
    const double terms[5] = {1, t.xx, t.xy, t.yx, t.yy};
    for (int k = 0; k < 5; ++k) sums[k] += terms[k];
  };
  const auto mean = [](const std::vector<double>& s) {
    return std::vector<double>{s[1] / s[0], s[2] / s[0], s[3] / s[0], s[4] / s[0]};
  };
  auto e = statistics::jackknife_of_sums(items, blocks.column, 5, add, mean);
  e[0] = statistics::jackknife_of_sums(items, blocks.tile, 5, add, mean)[0];
  return {tensor(e, &Estimate::value), tensor(e, &Estimate::error)};
}

/// Of both over their means.
Numbers agreement(const std::vector<double>& field, const std::vector<double>& contacts) {
  Numbers j{{"grains", statistics::described(field.size(), "", "Grains compared")}};
  if (field.size() < 3) return j;
  const auto a = statistics::over_mean(field), b = statistics::over_mean(contacts);
  if (std::isnan(a.front()) || std::isnan(b.front())) return j;  // a mean of zero
  const statistics::Relation relation = statistics::relate(b, a);
  put(j, "correlation", relation.pearson, "", "Pearson correlation of the two stresses");
  put(j, "slope", Estimate{relation.line.slope, relation.line.slope_error}, "",
      "Slope of the normalised stress of the field against that of the contacts");
  put(j, "rms", statistics::rms_difference(a, b), "", "Root mean square of their difference");
  return j;
}

}  // namespace

GrainStresses measure_grains(const PhaseMap& map, const StressField& field, int clamp_rows, int columns) {
  const std::size_t n = map.grain_class.size();
  const int margin = std::clamp(clamp_rows, 1, map.height);
  GrainStresses grains{std::vector<std::int64_t>(n, 0),
                       std::vector<std::uint8_t>(n, 1),
                       std::vector<Vec2>(n),
                       std::vector<Tensor2>(n),
                       {}};
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const std::size_t i = map.index(x, y);
      if (map.grain[i] < 0) continue;
      const auto g = static_cast<std::size_t>(map.grain[i]);
      ++grains.nodes[g];
      grains.centre[g] += {x + 0.5, y + 0.5};
      if (field.size() > 0) grains.stress[g] += {field.xx[i], field.xy[i], field.xy[i], field.yy[i]};
      if (x == 0 || x == map.width - 1 || y < margin || y >= map.height - margin) grains.whole[g] = 0;
    }
  for (std::size_t g = 0; g < n; ++g) {
    if (grains.nodes[g] == 0) {
      grains.whole[g] = 0;
      continue;
    }
    const double share = 1 / static_cast<double>(grains.nodes[g]);
    grains.centre[g] = share * map.dx * grains.centre[g];
    grains.stress[g] = share * grains.stress[g];
  }
  const Blocks blocks = blocks_of(map, grains, columns);
  for (const auto& [name, items] : grains_by_class(map, [&](std::size_t g) { return grains.whole[g] != 0; }))
    grains.mean.emplace_back(name, mean_tensor(items, blocks, grains.stress));
  return grains;
}

GrainExtremes extremes_of(const PhaseMap& map, const StressField& field) {
  std::vector<double> least(map.grain_class.size(), statistics::unknown), most = least;
  for (std::size_t k = 0; k < field.size(); ++k) {
    if (map.grain[k] < 0) continue;
    const auto g = static_cast<std::size_t>(map.grain[k]);
    least[g] = std::fmin(least[g], field.yy[k]);
    most[g] = std::fmax(most[g], field.yy[k]);
  }
  return {std::move(least), std::move(most)};
}

Numbers numbers(const GrainStresses& g) {
  std::size_t whole = 0;
  for (const auto w : g.whole) whole += w;
  Numbers j{{"whole", statistics::described(whole, "", "Grains entirely inside the map and away from the clamps")}};
  for (const auto& [name, mean] : g.mean)
    put(j["mean_stress_Pa"], name, mean, "Pa", "Mean stress of whole grains, tension positive");
  Numbers centres = Numbers::list();
  for (const Vec2 c : g.centre) centres.push_back({c.x, c.y});
  j["by_grain"] = {{"nodes", g.nodes}, {"whole", g.whole}, {"centre_m", centres}, {"sigma_Pa", g.stress}};
  j["by_grain"].mark(Trait::curve);
  return j;
}

Numbers compare(const PhaseMap& map, const GrainStresses& grains, const std::vector<Tensor2>& contact_stress) {
  if (contact_stress.size() != map.grain_class.size() || grains.stress.size() != map.grain_class.size())
    throw refusal(
        "{} grains have a contact stress, {} a mean stress, and the phase map has {}; all three must be of the same "
        "packing",
        contact_stress.size(), grains.stress.size(), map.grain_class.size());
  const auto known = [&](std::size_t g) {
    const Tensor2& t = contact_stress[g];
    const double size = std::abs(t.xx) + std::abs(t.yy) + std::abs(t.xy) + std::abs(t.yx);
    return grains.whole[g] != 0 && std::isfinite(size) && size > 0;
  };
  Numbers j = Numbers::tree();
  for (const auto& [name, items] : grains_by_class(map, known)) {
    const auto values = [&items = items](const std::vector<Tensor2>& stress, auto of) {
      return mapped(items, [&](std::size_t g) { return of(stress[g]); });
    };
    const auto compared = [&](auto of) { return agreement(values(grains.stress, of), values(contact_stress, of)); };
    j["sigma_yy"][name] = compared([](const Tensor2& t) { return t.yy; });
    j["sigma_hyd"][name] = compared([](const Tensor2& t) { return 0.5 * trace(t); });
  }
  return j;
}

}  // namespace arenite::stress
