#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/final_texture.hpp"
#include "ledger/pooled.hpp"

namespace arenite::ledger {
namespace {

constexpr const char* key = "contact.surface_energy";
constexpr double stiffness = 27.35;  // kN/mm

std::vector<Run> glued(const Results& results) { return results.runs("thesis-ch6", {{key, "1.060"}}); }

/// Normal forces between glued grains over their mean, of all runs of a surface energy.
std::vector<double> forces(const std::vector<Run>& runs) {
  std::vector<double> all;
  for (const Run& run : runs) {
    const FinalState state = final_state(run);
    const Contacts& contacts = state.packing.contacts;
    const auto& zone = state.packing.grains.zone;
    std::vector<double> own;
    double sum = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      if (contacts.is_wall(c) || zone[static_cast<std::size_t>(contacts.i[c])] == 0 || zone[static_cast<std::size_t>(contacts.j[c])] == 0) continue;
      own.push_back(contacts.fn[c]);
      sum += contacts.fn[c];
    }
    for (const double force : own) all.push_back(force * static_cast<double>(own.size()) / sum);
  }
  return all;
}

double lead_of_glued(const Run& run) { return run("sigma_norm.by_material.glued.mean_Pa") / run("sigma_norm.by_material.dry.mean_Pa") - 1; }

/// The lead with the strongest glue less that with next to none, for each seed: they start from one packing.
Value effect_of_glue(const Results& results) {
  std::vector<double> changes;
  for (const Run& with : glued(results))
    for (const Run& without : results.runs("thesis-ch6", {{key, "0.000001"}}))
      if (with.text("seed") == without.text("seed")) changes.push_back(lead_of_glued(with) - lead_of_glued(without));
  return changes.size() < 2 ? Value() : Value(statistics::mean_of(changes));
}

}  // namespace

/// Table 6.1.
Judgement judge_t15(const Results& results) {
  Judgement judgement;
  const auto runs = glued(results);
  for (const auto& [zone, number, share] : {std::tuple{"all", "sigma_norm.P0", 48.0}, {"without adhesion", "sigma_norm.by_material.dry.P0", 48.0},
                                            {"with adhesion", "sigma_norm.by_material.glued.P0", 49.4}}) {
    const Value ours = mean_over_seeds(runs, [number = number](const Run& run) { return 100 * run(number); });
    const std::string what = fmt::format("share of grains above the mean, {}", zone);
    judgement.stated.checks.push_back(below(what, "less than 50", ours, 50, "%"));
    Check check = within(what, ours, share, 4, "%");
    if (runs.size() < 5) check.holds = Holds::unknown;
    judgement.sharpened.checks.push_back(check);
  }
  add_glue_choices(judgement, results, "Share of grains above the mean", "sigma_norm.P0", wanted_within(0.48, 0.04));
  return judgement;
}

/// Four-fold order of contact directions, pooled over seeds.
Judgement judge_t16(const Results& results) {
  Judgement judgement;
  const auto runs = glued(results);
  for (const char* set : {"", "dry-dry", "glued-glued"}) {
    const PooledMode mode = pooled_mode(runs, set, 4);
    const std::string name = *set ? set : "all";
    const std::string what = fmt::format("4-fold amplitude, {} (noise {:.2g})", name, mode.noise);
    Check amplitude = above(what, "peaks", mode.amplitude, 3 * mode.noise);
    amplitude.tolerance = "> 3 times the noise";
    judgement.stated.checks.push_back(amplitude);
    judgement.stated.checks.push_back(below(fmt::format("angle of its peaks from 45 degrees, {}", name), "0", angle_from(mode, 45, 90), 15, "deg"));
    Check reported = above(fmt::format("{}, at {} degrees", what, text_of(mode.phase_deg)), "peaks at 45", mode.amplitude, 0);
    reported.tolerance = "reported";
    judgement.sharpened.checks.push_back(reported);
  }
  judgement.findings.emplace_back("The laboratory's grains were stacked by hand and their positions are lost; these samples start from random fillings.");
  add_glue_choices(judgement, results, "4-fold amplitude", "fabric.modes.4.amplitude");
  return judgement;
}

/// Tension, and stress inside of the agglomerate.
Judgement judge_t21(const Results& results) {
  Judgement judgement;
  const auto runs = glued(results);
  const Check rare = below("share of contacts that pull", "few", mean_over_seeds(runs, "force.tensile_share"), 0.05);
  const Check tiny = below("mean pull over mean push", "very small",
                           mean_over_seeds(runs, [](const Run& run) {
                             const double ratio = run("force.tensile.mean_over_compressive_mean");
                             return std::isfinite(ratio) || !(run("force.tensile_share") == 0) ? ratio : 0;
                           }), 0.05);
  const Value inside = mean_over_seeds(runs, lead_of_glued);
  judgement.stated.checks = {rare, tiny, below("mean stress inside of the agglomerate over outside, less 1", "< 0", inside, 0)};
  judgement.sharpened.checks = {rare, tiny, negative("mean stress inside of the agglomerate over outside, less 1", "< 0", inside)};
  for (const char* gamma : {"0.5", "0.2735", "0.000001"}) {
    const auto weaker = results.runs("thesis-ch6", {{key, gamma}});
    if (!weaker.empty())
      judgement.findings.push_back(fmt::format("With gamma {} kN/mm instead of 1.060: inside over outside, less 1, {}; share of pulling contacts {}.", gamma,
                                               text_of(mean_over_seeds(weaker, lead_of_glued)), text_of(mean_over_seeds(weaker, "force.tensile_share"))));
  }
  if (const Value glue = effect_of_glue(results); std::isfinite(glue.value))
    judgement.findings.push_back(fmt::format("In the same packings glue changes it by {}, seed by seed, where the same grains in the middle of the sample have {} with next to no glue.", text_of(glue),
                                             text_of(mean_over_seeds(results.runs("thesis-ch6", {{key, "0.000001"}}), lead_of_glued))));
  add_glue_choices(judgement, results, "Mean stress inside over outside, less 1", lead_of_glued, wanted_negative());
  add_glue_choices(judgement, results, "Share of contacts that pull", "force.tensile_share", wanted_below(0.05));
  return judgement;
}

/// Forces in the agglomerate with weak cohesion against those with next to none.
Judgement judge_t22(const Results& results) {
  Judgement judgement;
  const auto without = forces(results.runs("thesis-ch6", {{key, "0.000001"}}));
  const auto add = [&](const char* gamma) {
    Check check = above(fmt::format("chance that forces are of one law with and without cohesion, k/gamma = {:.0f}", stiffness / std::stod(gamma)), "no trace",
                        Value(chance_of_one_law(forces(results.runs("thesis-ch6", {{key, gamma}})), without)), 0.05);
    return check;
  };
  judgement.stated.checks = {add("0.5"), add("0.2735")};
  judgement.sharpened = judgement.stated;
  const Check strong = add("1.060");
  if (std::isfinite(strong.ours)) judgement.findings.push_back(fmt::format("At k/gamma = 26 that chance is {:.3g}.", strong.ours));
  for (const auto& [choice, value, words] : {std::tuple{"contact.friction", "0.3", "as above, in five samples"}, {"contact.friction", "0", "without friction"},
                                            {"contact.friction", "0.6", "with friction 0.6"}, {"contact.restitution", "0.9", "with restitution 0.9"}}) {
    const auto of = [&, choice = choice, value = value](const char* gamma) { return forces(results.runs("thesis-choices-glue", {{key, gamma}, {choice, value}})); };
    if (const double chance = chance_of_one_law(of("1.060"), of("0.000001")); std::isfinite(chance))
      judgement.findings.push_back(fmt::format("At k/gamma = 26 {} it is {:.3g}.", words, chance));
  }
  return judgement;
}

}  // namespace arenite::ledger
