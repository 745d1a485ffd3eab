#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/chapter3.hpp"
#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/pooled.hpp"

namespace arenite::ledger {
namespace {

/// Adds what is asked of one strong tail; `least_r2` of the straight line through the logarithm.
void tail(Judgement& judgement, const std::vector<Run>& runs, const std::string& set, const std::string& distribution, double least_r2) {
  const PooledTail t = pooled_tail(runs, distribution);
  const Value lead = t.runs == 0 ? Value() : Value(t.log_likelihood_ratio);
  judgement.stated.checks.push_back(above(fmt::format("lead of the exponential over the half-Gaussian, {}", set), "exponential", lead, 0));
  Check chance = below(fmt::format("chance of that lead, {}", set), "exponential", Value(t.p_value), 0.05);
  if (t.log_likelihood_ratio < 0 && chance.holds == Holds::yes) chance.holds = Holds::no;
  judgement.sharpened.checks.push_back(chance);
  judgement.sharpened.checks.push_back(above(fmt::format("R^2 of the semi-logarithmic line, {}", set), "a line", t.r2, least_r2));
  if (t.runs > 0) judgement.findings.push_back(fmt::format("{}: beta {} over {} runs.", set, text_of(t.beta), t.runs));
}

/// Forces against stresses, and against the load, in the same samples.
void add_reasons(Judgement& judgement, const Results& results) {
  int samples = 0, thinner = 0;
  const auto say = [&](const std::string& what, const std::vector<Run>& runs) {
    if (runs.empty()) return;
    const PooledTail stress = pooled_tail(runs, "sigma_norm"), force = pooled_tail(runs, "force");
    ++samples;
    thinner += stress.beta.value > force.beta.value;
    judgement.findings.push_back(fmt::format("{}, mean overlap {:.2g} of a diameter: lead of the exponential {:.1f} for forces (beta {}), {:.1f} for the stresses of grains (beta {}), over {} runs.", what,
                                             mean_overlap(runs), force.log_likelihood_ratio, text_of(force.beta), stress.log_likelihood_ratio, text_of(stress.beta), runs.size()));
  };
  const auto of_load = [&](const char* load) { return results.runs("thesis-choices", {{"populations.0.count", sample_8.pom_grains}, {"stages.1.bottom.force", load}}); };
  say("#2 under 50 kN", runs_of(results, sample_2));
  say("#8 under 50 kN", runs_of(results, sample_8));
  say("#8 under 5 kN", of_load("5"));
  say("#8 under 0.5 kN", of_load("0.5"));
  say("Chapter 5 under 100 N", results.runs("thesis-ch5"));
  if (samples > 0)
    judgement.findings.push_back(fmt::format("A grain's stress adds up the forces of all its contacts, and adding up thins a tail: beta of stresses is above that of forces in {} of these {} cases.", thinner, samples));
  add_choices(judgement, results, "Lead of the exponential for stresses of #2's POM", sample_2, "sigma_norm.by_material.POM.log_likelihood_ratio", wanted_above(0));
  add_choices(judgement, results, "Lead of the exponential for stresses of #2's HDPE", sample_2, "sigma_norm.by_material.HDPE.log_likelihood_ratio", wanted_above(0));
  add_choices(judgement, results, "Lead of the exponential for stresses of #8", sample_8, "sigma_norm.log_likelihood_ratio", wanted_above(0));
  add_choices(judgement, results, "Lead of the exponential for stresses of #12", sample_12, "sigma_norm.log_likelihood_ratio", wanted_above(0));
  add_choices(judgement, results, "beta of stresses of #8", sample_8, "sigma_norm.beta");
  add_choices(judgement, results, "beta of forces of #8", sample_8, "force.beta");
  add_choices_of_ratios(judgement, results, "Lead of the exponential for forces of POM-POM", "force.by_type.POM-POM.log_likelihood_ratio", {wanted_above(0), wanted_above(0), {}});
  add_glue_choices(judgement, results, "Lead of the exponential for stresses of chapter 6", "sigma_norm.log_likelihood_ratio", wanted_above(0));
}

}  // namespace

/// Tails of stresses (chapters 3 and 6) and of forces (chapters 4 and 5).
Judgement judge_t6(const Results& results) {
  Judgement judgement;
  for (const auto& sample : {sample_2, sample_8, sample_12}) {
    const auto runs = runs_of(results, sample);
    tail(judgement, runs, fmt::format("stress, {} all", sample.name), "sigma_norm", 0.95);
    for (const char* material : {"POM", "HDPE"}) {
      const std::string distribution = fmt::format("sigma_norm.by_material.{}", material);
      const double grains = mean(results, "thesis-ch3", distribution + ".count", where(sample)).value;
      if (grains > 40 || !std::isfinite(grains)) tail(judgement, runs, fmt::format("stress, {} {}", sample.name, material), distribution, 0.90);
    }
  }
  const auto fourth = results.runs("thesis-ch4"), fifth = results.runs("thesis-ch5"), sixth = results.runs("thesis-ch6", {{"contact.surface_energy", "1.060"}});
  tail(judgement, fourth, "force, ch. 4 all", "force", 0.95);
  for (const char* type : {"POM-POM", "HDPE-HDPE", "HDPE-POM"}) tail(judgement, fourth, fmt::format("force, ch. 4 {}", type), fmt::format("force.by_type.{}", type), 0.90);
  tail(judgement, fifth, "force, ch. 5 all", "force", 0.95);
  for (const char* type : {"A-A", "A-B", "B-B"}) tail(judgement, fifth, fmt::format("force, ch. 5 {}", type), fmt::format("force.by_type.{}", type), 0.90);
  tail(judgement, sixth, "stress, ch. 6 all", "sigma_norm", 0.95);
  for (const char* zone : {"dry", "glued"}) tail(judgement, sixth, fmt::format("stress, ch. 6 {}", zone), fmt::format("sigma_norm.by_material.{}", zone), 0.90);
  add_reasons(judgement, results);
  return judgement;
}

}  // namespace arenite::ledger
