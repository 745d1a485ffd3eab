#include "grains/fields/silo.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "core/mapped.hpp"
#include "grains/fields/driven.hpp"
#include "grains/fields/free_surface.hpp"
#include "grains/fields/steady_state.hpp"
#include "grains/texture/stress.hpp"

namespace arenite::fields {
namespace {

statistics::Measured late_mean_of(const History& history, const char* name) {
  const std::vector<double>* values = history.find(name);
  return values ? late_mean(*values) : statistics::Measured{};
}

/// Mean gravity over the second half, m/s^2 downward; 0 where it ever pulls aside.
double late_gravity(const StageResult& stage) {
  const std::vector<Vec2> gravity = gravity_in(stage.history, stage.asked);
  const auto late = std::span(gravity).last(gravity.size() / 2);
  const double most =
      std::accumulate(late.begin(), late.end(), 0.0, [](double m, Vec2 g) { return std::max(m, norm(g)); });
  if (late.empty() || std::ranges::any_of(late, [&](Vec2 g) { return std::abs(g.x) > 1e-9 * most; })) return 0;
  return std::accumulate(late.begin(), late.end(), 0.0, [](double sum, Vec2 g) { return sum - g.y; }) /
         static_cast<double>(late.size());
}

/// Of the sums over contacts of force times branch, over the states of the second half.
double ratio_of_stresses(const StageResult& stage) {
  Vec2 sum{};
  for (std::size_t k = stage.snapshots.size() / 2; k < stage.snapshots.size(); ++k)
    for (const Tensor2& moment : texture::grain_moments(stage.snapshots[k].packing)) sum += {moment.xx, moment.yy};
  return sum.y != 0 ? sum.x / sum.y : statistics::unknown;
}

}  // namespace

std::optional<SiloState> silo_state(const StageResult& stage) {
  if (stage.snapshots.empty() || stage.snapshots.back().packing.grains.size() == 0) return {};
  const Packing& packing = stage.snapshots.back().packing;
  const Domain& d = packing.domain;
  if (!d.wall[bottom].present || !d.wall[left].present || !d.wall[right].present) return {};
  const double gravity = late_gravity(stage);
  if (!(gravity > 0)) return {};
  const FreeSurface surface = find_free_surface(packing, {0, -gravity});
  SiloState silo{statistics::mean_of(surface.height).value - surface.bottom, d.width(), d.thickness,
                 late_mean_of(stage.history, "bottom_force"), gravity * mass_of(packing)};
  const double sides =
      late_mean_of(stage.history, "left_force").value + late_mean_of(stage.history, "right_force").value;
  if (!(silo.force.value > 0) || !(sides > 0)) return {};
  silo.wall_friction = (silo.weight - silo.force.value) / sides;
  silo.stress_ratio = ratio_of_stresses(stage);
  return silo;
}

}  // namespace arenite::fields
