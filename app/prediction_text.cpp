#include "prediction_text.hpp"

#include <fmt/core.h>

#include <cmath>

#include "grains/fields/regime/prediction.hpp"
#include "progress.hpp"

namespace arenite::app {
namespace {

using fields::StagePrediction;
using fields::StepLimit;
using workflow::Prediction;

std::string collision_text(const Prediction& p) {
  return fmt::format("collision ({:.3g} s; {}, {}, radius {:.3g} mm)", p.collision.time,
                     p.collision.with_wall ? "a grain and a wall" : "two grains", p.material, 1e3 * p.collision.radius);
}

std::string limit_text(const Prediction& p) {
  const std::string share =
      fmt::format("1/{:.3g} of the shortest {}", p.collision.time / p.time_step, collision_text(p));
  switch (p.limit) {
    case StepLimit::collision: return share;
    case StepLimit::stiffness: return "the largest that the stiffness of the contacts allows, " + share;
    case StepLimit::damping: return "the largest that damping (dashpots and drag) allows, " + share;
    case StepLimit::given: return "given, " + share;
  }
  return share;
}

/// Two digits of an estimate, behind a mark that says so.
std::string count_text(std::int64_t steps, bool exact) {
  if (exact || steps < 100) return fmt::format("{}{}", exact ? "" : "~", steps);
  const auto unit = static_cast<std::int64_t>(std::pow(10, std::floor(std::log10(static_cast<double>(steps))) - 1));
  return fmt::format("~{}", (steps + unit / 2) / unit * unit);
}

std::string flow_text(const StagePrediction& stage) {
  if (!stage.inertial_number) return "";
  return fmt::format("{:.2g} ({})", *stage.inertial_number, fields::flow_regime(*stage.inertial_number));
}

std::string stage_line(const StagePrediction& s) {
  return fmt::format("{:<12} {:>12} {:>10} {:>9}  {:<22} {:>8} {:>9} {:>8} {:>7}\n", s.name,
                     count_text(s.steps, s.exact), fmt::format("{}{:.3g} s", s.exact ? "" : "~", s.duration),
                     "~" + duration_text(s.seconds), flow_text(s),
                     s.stiffness_number ? fmt::format("{:.2g}", *s.stiffness_number) : "",
                     s.height ? fmt::format("~{:.3g} mm", 1e3 * *s.height) : "",
                     s.strain ? fmt::format("{:.3g} %", 100 * *s.strain) : "", s.states);
}

}  // namespace

std::string bytes_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.2g} MB", 1e-6 * bytes) : fmt::format("{:.2g} GB", 1e-9 * bytes);
}

std::string prediction_text(const Prediction& p) {
  std::string text =
      fmt::format("\ntime step    {:.3g} s: {}; stable up to {:.3g} s\n", p.time_step, limit_text(p), p.largest_step);
  if (p.stages.empty()) return text;
  text += fmt::format("{:<12} {:>12} {:>10} {:>9}  {:<22} {:>8} {:>9} {:>8} {:>7}\n", "stage", "steps", "simulated",
                      "CPU time", "inertial number", "k/P", "height", "strain", "states");
  bool all_exact = true;
  std::int64_t steps = 0;
  for (const StagePrediction& stage : p.stages) {
    text += stage_line(stage);
    all_exact = all_exact && stage.exact;
    steps += stage.steps;
  }
  const std::string from = p.sample < p.grains ? fmt::format("a sample of {} grains, for about {}", p.sample, p.grains)
                                               : fmt::format("its {} grains", p.grains);
  text += fmt::format("total        {:>12} steps, about {} on one free core, at {:.2g} s per step timed on {}\n",
                      count_text(steps, all_exact), duration_text(p.seconds()), p.seconds_per_step, from);
  text += fmt::format("files        about {}\n", bytes_text(p.bytes()));
  if (p.memory > 0) text += fmt::format("memory       about {}\n", bytes_text(p.memory));
  for (const StagePrediction& stage : p.stages)
    if (stage.inserted > 0)
      text += fmt::format("stage {}: {:.0f} grains come in, if all find room\n", stage.name, stage.inserted);
  if (!all_exact)
    text +=
        "~ marks an estimate: a stage that ends at equilibrium lasts until the sample stops oscillating, which may "
        "take half or twice as long\n";
  for (const std::string& warning : p.warnings) text += "warning: " + warning + "\n";
  return text;
}

}  // namespace arenite::app
