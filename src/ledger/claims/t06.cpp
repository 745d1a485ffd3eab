#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/chapter3.hpp"
#include "ledger/claims/claims.hpp"
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
  return judgement;
}

}  // namespace arenite::ledger
