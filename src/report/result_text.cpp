#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "grains/dem/run_stage.hpp"
#include "recipe/recipe.hpp"
#include "report/summary.hpp"

namespace arenite::report {
namespace {

std::string grains_of(const Packing& packing) {
  const std::size_t all = packing.grains.size();
  if (packing.materials.size() < 2) return std::to_string(all);
  std::string parts;
  for (std::size_t m = 0; m < packing.materials.size(); ++m) {
    const auto count = std::count(packing.grains.material.begin(), packing.grains.material.end(), static_cast<std::int32_t>(m));
    parts += fmt::format("{}{} {}", m > 0 ? ", " : "", count, packing.materials[m].name);
  }
  return fmt::format("{}: {}", all, parts);
}

std::string forces_on_sides(const Domain& domain) {
  std::string text;
  for (std::size_t side = 0; side < domain.wall.size(); ++side)
    if (const double f = domain.wall[side].force; domain.wall[side].present)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", side_names[side],
                          std::abs(f) < 1e4 ? fmt::format("{:.4g} N", f) : fmt::format("{:.4g} kN", 1e-3 * f));
  return text;
}

/// The criterion that the stage was judged by, or would have been if it had not ended by its time.
dem::EquilibriumCriterion criterion_of(const Provenance& made) {
  try {
    const recipe::Recipe recipe = recipe::parse_recipe(made.recipe, "recipe");
    for (const auto& stage : recipe.stages)
      if (stage.name == made.stage) return stage.equilibrium;
  } catch (const InputError&) {}
  return {};
}

std::string state_of(const StageResult& last) {
  const Equilibrium& now = last.frames.back().equilibrium;
  const bool rests = last.converged && dem::is_at_rest(now, criterion_of(last.provenance));
  return fmt::format("{}: {}", rests ? "in equilibrium" : "NOT IN EQUILIBRIUM", dem::describe(now));
}

}  // namespace

std::string state_text(const StageResult& last) {
  const Frame& frame = last.frames.back();
  std::string text = fmt::format("\nLast state: {} of {}\n", frame.label, last.name);
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format("  {:<32} {}\n", name, value);
  };
  if (!last.provenance.kernel.empty()) add("state", state_of(last));
  add("grains", grains_of(frame.packing));
  add("forces on the walls", forces_on_sides(frame.packing.domain));
  return text;
}

std::string headlines(const Numbers& numbers) {
  return rows_of(numbers,
                 "contacts wall_contacts solid_fraction coordination.all coordination.without_rattlers coordination.all,* "
                 "coordination.rattlers coordination.Z fabric.a_c fabric.a_c_noise long_axes.order long_axes.noise force.mean_N "
                 "force.strong_share force.beta stress_details.pressure_Pa stress_details.deviator_Pa critical_state discharge "
                 "surface floor cohesion map.lengths grains.all phases.void phases.matrix S_m pores.count pores.mean voids.count "
                 "modulus_Pa poisson moduli strength_Pa failure.strain_at_strength stress.sigma_yy.sets.*.mean_over_sample_mean");
}

}  // namespace arenite::report
