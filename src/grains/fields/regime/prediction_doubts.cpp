#include "grains/fields/regime/prediction_doubts.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "grains/dem/run_stage.hpp"

namespace arenite::fields {

std::vector<std::string> doubts_about_step(double time_step, StepLimit limit, const ShortestCollision& collision,
                                           const dem::ContactParameters& contact) {
  constexpr double tiny = 0.01;  // of the collision
  if (time_step >= tiny * collision.time) return {};
  return {fmt::format(
      "a collision takes {:.0f} steps; a step of a tenth of its duration would suffice{}", collision.time / time_step,
      limit == StepLimit::damping
          ? fmt::format(", but damping prevents it: raise contact.restitution (now {:g}), or lower drag",
                        contact.restitution)
          : "")};
}

std::vector<std::string> doubts_about(const StagePrediction& p, const dem::Stage& stage) {
  constexpr double most_overlap = 0.01, most_inertial = 0.1;
  std::vector<std::string> doubts;
  if (p.overlap && *p.overlap > most_overlap)
    doubts.push_back(fmt::format(
        "stage {}: grains overlap by about {:.2g} % of their diameter (k/P = {:.3g}); they are hard above 1e4", p.name,
        100 * *p.overlap, *p.stiffness_number));
  const bool closes = std::ranges::count(stage.side, dem::SideDrive::Kind::velocity, &dem::SideDrive::kind) > 0;
  if (p.inertial_number && *p.inertial_number > most_inertial && closes)
    doubts.push_back(
        fmt::format("stage {}: I = {:.2g}: the sample is deformed faster than grains can rearrange; below 1e-3 it "
                    "would be quasi-static",
                    p.name, *p.inertial_number));
  const double each = static_cast<double>(p.steps) / static_cast<double>(dem::increment_count(stage));
  if (!p.exact && each > static_cast<double>(stage.equilibrium.max_steps))
    doubts.push_back(fmt::format("stage {}: an increment may need more than equilibrium.max_steps = {}", p.name,
                                 stage.equilibrium.max_steps));
  return doubts;
}

}  // namespace arenite::fields
