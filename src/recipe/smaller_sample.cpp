#include "recipe/smaller_sample.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

namespace arenite::recipe {

std::size_t grains_asked(const Recipe& recipe) {
  if (recipe.packing.method == PackingParameters::Method::file) return 0;
  if (recipe.bidisperse) {
    const auto& law = recipe.bidisperse->law;
    constexpr double solid = 0.6;  // about what the sampling reaches
    const double large = solid * law.box_area * law.volume_ratio / (1 + law.volume_ratio);
    return static_cast<std::size_t>(large * (1 + law.size_ratio * law.size_ratio / law.volume_ratio));
  }
  std::int64_t sum = 0;
  bool shares = false;
  for (const auto& population : recipe.populations) {
    sum += population.count.value_or(0);
    shares |= population.ratio.has_value();
  }
  return static_cast<std::size_t>(std::max(sum, shares ? recipe.packing.grains : 0));
}

namespace {

Recipe with_fewer(Recipe recipe, double share, double across, double along) {
  if (recipe.bidisperse) recipe.bidisperse->law.box_area *= share;
  const auto fewer = [share](std::int64_t count) {
    return std::max<std::int64_t>(1, std::llround(share * static_cast<double>(count)));
  };
  for (auto& population : recipe.populations)
    if (population.count) population.count = fewer(*population.count);
  recipe.packing.grains = fewer(recipe.packing.grains);
  recipe.container.width *= across;
  recipe.container.height *= along;
  return recipe;
}

SmallerSample of_disks(const Recipe& recipe, double share) {
  constexpr double fewest_across = 10;
  double widest = 0;
  for (const auto& population : recipe.populations)
    widest = std::max(widest, std::visit([](const auto& law) { return law.largest(); }, population.size));
  const double width = recipe.container.width;
  double across = std::sqrt(share), along = across;
  if (width > 0 && across * width < fewest_across * widest) {
    across = std::min(1.0, fewest_across * widest / width);
    along = share / across;
  }
  return {with_fewer(recipe, share, across, along), across, along};
}

SmallerSample of_spheres(const Recipe& recipe, double share) {
  const double by = std::cbrt(share);
  Recipe smaller = with_fewer(recipe, share, by, by);
  smaller.container.depth *= by;
  if (smaller.packing.area)
    for (std::optional<double>& edge : smaller.packing.area->edge)
      if (edge) *edge *= by;
  smaller.boundaries_in_space.clear();
  for (dem::Stage& stage : smaller.stages) {
    stage.boundaries_in_space.clear();
    std::erase_if(stage.programmes, [](const dem::Programme& programme) { return programme.of.is_of_boundary(); });
  }
  return {std::move(smaller), by, by};
}

}  // namespace

SmallerSample smaller_sample(const Recipe& recipe, double share) {
  if (share >= 1) return {recipe};
  return recipe.dimension == 3 ? of_spheres(recipe, share) : of_disks(recipe, share);
}

}  // namespace arenite::recipe
