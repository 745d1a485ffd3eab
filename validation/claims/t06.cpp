#include <fmt/core.h>

#include <cmath>

#include "validation/claims/chapter3.hpp"
#include "validation/claims/claims.hpp"
#include "validation/claims/thesis_choices.hpp"
#include "validation/family.hpp"
#include "validation/pooled.hpp"

namespace arenite::validation {
namespace {

/// Tails that are asked the same.
struct Tails {
  std::string what;
  double least_r2 = 0;  ///< of the straight line through the logarithm, as the thesis drew it
  Family r2, lead, beta;
};

void add(Tails& tails, const std::string& name, const std::vector<Run>& runs, const std::string& distribution,
         const Draw& draw) {
  const PooledTail t = pooled_tail(runs, distribution);
  tails.r2.push_back({name, t.r2, {draw}});
  tails.lead.push_back({name, t.lead});
  tails.beta.push_back({name, t.beta});
}

void judge_tails(Judgement& judgement, const Tails& tails) {
  judgement.checks.push_back(
      every("R^2 of the semi-logarithmic line, " + tails.what, "a line", tails.r2, {.low = tails.least_r2}));
}

/// What the likelihood says of the same tails: more than a line does.
void tell_tails(Judgement& judgement, const Tails& tails) {
  for (std::size_t k = 0; k < tails.lead.size(); ++k) {
    const std::string& name = tails.lead[k].name;
    judgement.checks.push_back(beside(positive(
        fmt::format("log-likelihood ratio of exponential to half-Gaussian per sample, {}, {}", tails.what, name),
        "exponential", tails.lead[k].value)));
    judgement.checks.push_back(reported(fmt::format("beta, {}, {}", tails.what, name), tails.beta[k].value));
  }
}

/// "for all forces in 3 of 4 (lowest log-likelihood ratio -7.8 +- 1.6 per sample, ch. 5)".
std::string thinner(const Tails& tails) {
  std::size_t thin = 0;
  const Member* most = nullptr;
  for (const Member& m : tails.lead) {
    thin += outcome_of(m.value, {.high = 0}) == Outcome::holds;
    if (!most || m.value.value < most->value.value) most = &m;
  }
  return most && std::isfinite(most->value.value)
             ? fmt::format("for {} in {} of {} (lowest log-likelihood ratio {} per sample, {})", tails.what, thin,
                           tails.lead.size(), text_of(most->value), most->name)
             : "";
}

/// Forces against stresses, and against the load, in the same samples.
void add_reasons(Judgement& judgement, const Results& results) {
  int samples = 0, thinner = 0;
  const auto say = [&](const std::string& what, const std::vector<Run>& runs) {
    if (runs.empty()) return;
    const PooledTail stress = pooled_tail(runs, "sigma_norm"), force = pooled_tail(runs, "force");
    ++samples;
    thinner += stress.beta.value > force.beta.value;
    judgement.checks.push_back(reported(
        fmt::format("beta of forces, {}, mean overlap {:.2g} diameters", what, mean_overlap(runs)), force.beta));
    judgement.checks.push_back(reported(fmt::format("beta of stresses, {}", what), stress.beta));
  };
  const auto of_load = [&](const char* load) {
    return results.runs("thesis-choices",
                        {{"populations.0.count", sample_8.pom_grains}, {"stages.1.bottom.force", load}});
  };
  say("#2 under 50 kN", runs_of(results, sample_2));
  say("#8 under 50 kN", runs_of(results, sample_8));
  say("#8 under 5 kN", of_load("5"));
  say("#8 under 0.5 kN", of_load("0.5"));
  say("chapter 5 under 100 N", results.runs("thesis-ch5"));
  if (samples > 0)
    judgement.findings.push_back(
        fmt::format("The stress of a grain is a sum over its contacts, which makes the tail thinner: beta of stresses "
                    "is above that of forces in {} of {} cases.",
                    thinner, samples));
  add_choices(judgement, results, "R^2 of the line, stresses of #8", sample_8, "sigma_norm.line_r2",
              wanted_above(0.95));
  add_choices(judgement, results, "R^2 of the line, stresses of #2's HDPE", sample_2,
              "sigma_norm.by_material.HDPE.line_r2", wanted_above(0.90));
  add_choices(judgement, results, "Log-likelihood ratio of the exponential, stresses of #8", sample_8,
              "sigma_norm.log_likelihood_ratio");
  add_choices(judgement, results, "beta of stresses of #8", sample_8, "sigma_norm.beta");
  add_choices_of_ratios(judgement, results, "R^2 of the line, forces of POM-POM", "force.by_type.POM-POM.line_r2",
                        {wanted_above(0.90), wanted_above(0.90), {}});
  add_glue_choices(judgement, results, "R^2 of the line, stresses of chapter 6", "sigma_norm.line_r2",
                   wanted_above(0.95));
}

}  // namespace

/// Tails of stresses (chapters 3 and 6) and of forces (chapters 4 and 5): the straight line that the thesis drew
/// through them. The likelihood against a half-Gaussian is also reported.
Judgement judge_t6(const Results& results) {
  Tails all_stresses{"stresses of all grains", 0.95, {}, {}, {}},
      some_stresses{"stresses of one material or zone", 0.90, {}, {}, {}};
  Tails all_forces{"all forces", 0.95, {}, {}, {}}, some_forces{"forces of one type of contact", 0.90, {}, {}, {}};
  for (const auto& sample : {sample_2, sample_8, sample_12}) {
    const auto runs = runs_of(results, sample);
    const Draw draw{"thesis-ch3", where(sample)};
    add(all_stresses, sample.name, runs, "sigma_norm", draw);
    for (const char* material : {"POM", "HDPE"}) {
      const std::string distribution = fmt::format("sigma_norm.by_material.{}", material);
      const double grains = mean_over_seeds(runs, distribution + ".count").value;
      if (grains > 40 || !std::isfinite(grains))
        add(some_stresses, fmt::format("{} {}", sample.name, material), runs, distribution, draw);
    }
  }
  const auto fourth = results.runs("thesis-ch4"), fifth = results.runs("thesis-ch5"),
             sixth = results.runs("thesis-ch6", {{"contact.surface_energy", "1.060"}});
  const Draw of_fourth{"thesis-ch4", {}}, of_fifth{"thesis-ch5", {}},
      of_sixth{"thesis-ch6", {{"contact.surface_energy", "1.060"}}};
  add(all_forces, "ch. 4", fourth, "force", of_fourth);
  for (const char* type : {"POM-POM", "HDPE-HDPE", "HDPE-POM"})
    add(some_forces, fmt::format("ch. 4 {}", type), fourth, fmt::format("force.by_type.{}", type), of_fourth);
  add(all_forces, "ch. 5", fifth, "force", of_fifth);
  for (const char* type : {"A-A", "A-B", "B-B"})
    add(some_forces, fmt::format("ch. 5 {}", type), fifth, fmt::format("force.by_type.{}", type), of_fifth);
  add(all_stresses, "ch. 6", sixth, "sigma_norm", of_sixth);
  for (const char* zone : {"dry", "glued"})
    add(some_stresses, fmt::format("ch. 6 {}", zone), sixth, fmt::format("sigma_norm.by_material.{}", zone), of_sixth);
  Judgement judgement;
  std::string shapes;
  for (const Tails* tails : {&all_stresses, &some_stresses, &all_forces, &some_forces}) {
    judge_tails(judgement, *tails);
    if (const std::string shape = thinner(*tails); !shape.empty()) shapes += (shapes.empty() ? "" : "; ") + shape;
  }
  for (const Tails* tails : {&all_stresses, &some_stresses, &all_forces, &some_forces}) tell_tails(judgement, *tails);
  if (!shapes.empty())
    judgement.decides =
        "A straight line in a semi-logarithmic plot, as in the thesis, is insensitive to the curvature of a tail. By "
        "the likelihood ratio against a half-Gaussian, tails are thinner than exponential " +
        shapes + ".";
  add_reasons(judgement, results);
  return judgement;
}

}  // namespace arenite::validation
