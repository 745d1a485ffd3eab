#include "grains/packing/size_curve.hpp"

#include <algorithm>
#include <numeric>

namespace arenite::packing {

namespace {

constexpr std::int64_t many = 200'000;  // grains: their curve is the law's to a few thousandths
constexpr std::uint64_t seed = 1;       // no grain of a sample is drawn from it

}  // namespace

SizeCurve measured_size_curve(const Grains& grains, const Materials& materials, std::size_t most) {
  std::vector<std::size_t> order(grains.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t g) { return grains.radius[g]; });
  const auto mass = [&](std::size_t g) { return materials[static_cast<std::size_t>(grains.material[g])].density * grains.radius[g] * grains.radius[g]; };
  double total = 0;
  for (const std::size_t g : order) total += mass(g);
  SizeCurve curve;
  if (order.empty() || !(total > 0)) return curve;
  curve.diameter.push_back(2 * grains.radius[order.front()]);
  curve.passing.push_back(0);
  double below = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    below += mass(order[k]);
    const bool last = k + 1 == order.size(), wider_follows = !last && grains.radius[order[k + 1]] > grains.radius[order[k]];
    const double share = last ? 1 : below / total;
    if (!last && (!wider_follows || share < curve.passing.back() + 1 / static_cast<double>(most))) continue;
    curve.diameter.push_back(2 * grains.radius[order[k]]);
    curve.passing.push_back(share);
  }
  return curve;
}

SizeCurve asked_size_curve(const std::vector<Population>& populations, const Materials& materials, std::int64_t total, std::size_t most) {
  std::int64_t counted = 0;
  for (const Population& p : populations) counted += p.count.value_or(0);
  const std::int64_t times = std::max<std::int64_t>(1, many / std::max<std::int64_t>(1, std::max(total, counted)));
  auto enlarged = populations;
  for (Population& p : enlarged)
    if (p.count) *p.count *= times;
  return measured_size_curve(draw_grains(enlarged, materials, total * times, seed), materials, most);
}

}  // namespace arenite::packing
