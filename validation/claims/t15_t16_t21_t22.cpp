#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "validation/claims/claims.hpp"
#include "validation/claims/thesis_choices.hpp"
#include "validation/family.hpp"
#include "validation/pooled.hpp"

namespace arenite::validation {
namespace {

constexpr const char* key = "contact.surface_energy";
constexpr const char* no_glue = "0.000001";
constexpr double stiffness = 27.35;  // kN/mm

std::vector<Run> glued(const Results& results) { return results.runs("thesis-ch6", {{key, "1.060"}}); }

/// Further seeds with this glue, and with next to none.
std::vector<Draw> with_and_without(const char* energy) {
  return {{"thesis-ch6", {{key, energy}}}, {"thesis-ch6", {{key, no_glue}}}};
}
const std::vector<Draw> of_glued{{"thesis-ch6", {{key, "1.060"}}}};

double lead_of_glued(const Run& run) {
  return run("sigma_norm.by_material.glued.mean_Pa") / run("sigma_norm.by_material.dry.mean_Pa") - 1;
}

/// With this glue over with next to none, minus 1, seed by seed: they start from one packing.
Value change_by_glue(const Results& results, const char* energy, const Number& number) {
  return paired_change(results.runs("thesis-ch6", {{key, energy}}), results.runs("thesis-ch6", {{key, no_glue}}),
                       number);
}

/// What cohesion could leave a trace in: of the agglomerate and of the whole sample.
Family traces(const Results& results, const char* energy) {
  const std::vector<std::pair<const char*, Number>> numbers{
      {"mean stress inside over outside", [](const Run& run) { return 1 + lead_of_glued(run); }},
      {"fraction of glued grains above their mean", "sigma_norm.by_material.glued.P0"},
      {"contacts with glued grains per glued grain",
       [](const Run& run) {
         return run("force.by_type.glued-glued.count") / run("sigma_norm.by_material.glued.count");
       }},
      {"fraction of these above their mean force", "force.by_type.glued-glued.strong_share"},
      {"mean force between glued grains over that of all",
       [](const Run& run) { return run("force.by_type.glued-glued.mean_N") / run("force.mean_N"); }},
      {"z of all grains", "coordination.all"},
      {"fraction of contacts above the mean force", "force.strong_share"}};
  Family family;
  for (const auto& [name, number] : numbers)
    if (const Value change = change_by_glue(results, energy, number); std::isfinite(change.value))
      family.push_back({name, change});
  return family;
}

/// No trace: no further apart than this part.
constexpr double no_trace = 0.05;

std::string stiffness_over(const char* energy) {
  return fmt::format("k/gamma = {:.0f}", stiffness / std::stod(energy));
}

/// A trace is seen if one of these is not zero after Holm's correction; none is left if all are within the margin.
Check trace_seen(const std::string& what, const Family& family) {
  Check check = every(what, "an effect", family, {-no_trace, no_trace});
  check.wanted = "one of them not 0";
  std::vector<double> chances;
  for (const Member& m : family) chances.push_back(chance_of_zero(m.value));
  const auto seen = holm(chances, 0.05);
  if (const auto at = std::find(seen.begin(), seen.end(), true); at != seen.end()) {
    const Member& trace = family[static_cast<std::size_t>(at - seen.begin())];
    check.what = fmt::format("{}: {}", what, trace.name);
    check.ours = trace.value;
    check.outcome = Outcome::holds;
  } else if (check.outcome == Outcome::holds) {
    check.outcome = Outcome::fails;
  } else if (check.outcome == Outcome::fails) {
    check.outcome = Outcome::undecided;
  }
  return beside(check);
}

}  // namespace

/// Table 6.1. Its 49.4 % is of one sample with 77 glued grains, where such a share scatters by 6 points: "less than
/// half" is the side of a coin there, so shares are compared within 4 points.
Judgement judge_t15(const Results& results) {
  Judgement judgement;
  const auto runs = glued(results);
  Family shares, from_table;
  for (const auto& [zone, number, share] : {std::tuple{"all", "sigma_norm.P0", 48.0},
                                            {"without adhesion", "sigma_norm.by_material.dry.P0", 48.0},
                                            {"with adhesion", "sigma_norm.by_material.glued.P0", 49.4}}) {
    const Value ours = mean_over_seeds(runs, [number = number](const Run& run) { return 100 * run(number); });
    shares.push_back({zone, ours});
    from_table.push_back({zone, difference(ours, {share, 0})});
    if (std::isfinite(ours.value))
      judgement.ours += fmt::format("{}{}", judgement.ours.empty() ? "" : ", ", text_of(ours));
  }
  if (!judgement.ours.empty()) judgement.ours += " %";
  judgement.checks = {drawn(of_glued, number(every("fraction of grains above the mean minus that of table 6.1", "0",
                                                   from_table, {-4, 4}, "%"))),
                      beside(every("fraction of grains above the mean", "less than half", shares, {.high = 50}, "%"))};
  add_glue_choices(judgement, results, "Fraction of grains above the mean", "sigma_norm.P0",
                   wanted_within(0.480, 0.04));
  add_glue_choices(judgement, results, "Fraction of glued grains above their mean", "sigma_norm.by_material.glued.P0",
                   wanted_within(0.494, 0.04));
  return judgement;
}

/// Four-fold order of contact orientations, pooled over seeds: how far they lie along 45 degrees. The thesis sees it in
/// one sample, whose positions are lost, so that no run can test it: what random fillings give is told beside, against
/// what one sample has by chance.
Judgement judge_t16(const Results& results) {
  Judgement judgement;
  const auto runs = glued(results);
  Family over_noise, angle;
  std::vector<Check> parts;
  for (const std::string set : {"", "dry-dry", "glued-glued"}) {
    const PooledMode mode = pooled_mode(runs, set, 4);
    const Value along = pooled_along(runs, set, 4, 45);
    const std::string name = set.empty() ? "all" : set;
    over_noise.push_back({name, weighted_sum({{1 / mode.noise_of_one, along}})});
    angle.push_back({name, angle_from(mode, 45, 90)});
    parts.push_back(reported(fmt::format("4-fold component along 45 degrees, {} (noise {:.2g}, of one sample {:.2g})",
                                         name, mode.noise, mode.noise_of_one),
                             along));
    if (set.empty() && mode.contacts > 0)
      judgement.ours = fmt::format("4-fold component along 45 degrees {} (noise of one sample {:.2g})", text_of(along),
                                   mode.noise_of_one);
  }
  judgement.checks = {
      beside(every("4-fold component along 45 degrees over the noise of one sample", "peaks", over_noise, {.low = 1})),
      beside(every("angle of its peaks from 45 degrees", "0", angle, {.high = 15}, "deg"))};
  judgement.checks.insert(judgement.checks.end(), parts.begin(), parts.end());
  judgement.untestable =
      "The thesis's simulation starts from the positions of a sample stacked by hand, which are lost; random fillings, "
      "which are run here, say nothing about that sample.";
  add_glue_choices(judgement, results, "4-fold amplitude", "fabric.modes.4.amplitude");
  return judgement;
}

/// Tension, and stress inside of the agglomerate.
Judgement judge_t21(const Results& results) {
  Judgement judgement;
  const auto runs = glued(results);
  const Value rare = mean_over_seeds(runs, "force.tensile_share"), inside = mean_over_seeds(runs, lead_of_glued),
              tiny = mean_over_seeds(runs, [](const Run&run) {
                const double ratio = run("force.tensile.mean_over_compressive_mean");
                return std::isfinite(ratio) || !(run("force.tensile_share") == 0) ? ratio : 0;
              });
  const auto lead = [](const Run& run) { return 1 + lead_of_glued(run); };
  const Value glue = change_by_glue(results, "1.060", lead);
  judgement.checks = {
      drawn(of_glued, below("fraction of tensile contacts", "few", rare, 0.05)),
      drawn(of_glued, below("mean tensile over mean compressive force", "very small", tiny, 0.05)),
      drawn(with_and_without("1.060"),
            negative("stress inside over outside the agglomerate, relative change by glue in the same packings",
                     "chains avoid it", glue)),
      beside(negative("mean stress inside over outside the agglomerate, minus 1", "chains avoid it", inside))};
  if (std::isfinite(rare.value))
    judgement.ours = fmt::format(
        "{} of the contacts are tensile, with {} of the mean compressive force; glue changes the stress inside over "
        "outside by {}",
        text_of(rare), text_of(tiny), text_of(glue));
  for (const char* gamma : {"0.5", "0.2735", no_glue}) {
    const auto weaker = results.runs("thesis-ch6", {{key, gamma}});
    judgement.checks.push_back(reported(fmt::format("mean stress inside over outside, minus 1, gamma {} kN/mm", gamma),
                                        mean_over_seeds(weaker, lead_of_glued)));
    judgement.checks.push_back(reported(fmt::format("fraction of tensile contacts, gamma {} kN/mm", gamma),
                                        mean_over_seeds(weaker, "force.tensile_share")));
  }
  if (std::isfinite(glue.value))
    judgement.findings.push_back(fmt::format(
        "\"Avoid\" is read as less stress than the same grains bear without glue, seed by seed, because packings "
        "differ by more than glue changes: almost without glue, the stress of these grains exceeds that of the grains "
        "around them by {} (relative), with glue by {}.",
        text_of(mean_over_seeds(results.runs("thesis-ch6", {{key, no_glue}}), lead_of_glued)), text_of(inside)));
  add_change_by_glue(judgement, results, "Stress inside over outside, relative change by glue", lead,
                     wanted_negative());
  add_glue_choices(judgement, results, "Mean stress inside over outside, minus 1", lead_of_glued);
  add_glue_choices(judgement, results, "Fraction of tensile contacts", "force.tensile_share", wanted_below(0.05));
  return judgement;
}

/// Weak cohesion against next to none, seed by seed in the same packings: equal within a margin. Strong glue is the
/// control, in which the same numbers must show a trace if there is one.
Judgement judge_t22(const Results& results) {
  Judgement judgement;
  for (const char* gamma : {"0.5", "0.2735"})
    judgement.checks.push_back(
        drawn(with_and_without(gamma), every(fmt::format("relative change by cohesion, {}", stiffness_over(gamma)),
                                             "no effect", traces(results, gamma), {-no_trace, no_trace})));
  const Family strong = traces(results, "1.060");
  const Check control =
      trace_seen(fmt::format("relative change by cohesion, {} (control)", stiffness_over("1.060")), strong);
  judgement.checks.push_back(control);
  for (const Member& m : strong)
    judgement.checks.push_back(
        reported(fmt::format("{}, relative change by cohesion, {}", m.name, stiffness_over("1.060")), m.value));
  if (!strong.empty()) {
    judgement.ours = fmt::format("largest change {}", text_of(judgement.checks.front().ours));
    judgement.decides =
        fmt::format("The margin is 5 %, in the same packings with and without glue. The control at {} {}: {} {}.",
                    stiffness_over("1.060"),
                    control.outcome == Outcome::holds   ? "shows an effect"
                    : control.outcome == Outcome::fails ? "shows none either"
                                                        : "shows none beyond its error",
                    control.what, text_of(control.ours));
  }
  return judgement;
}

}  // namespace arenite::validation
