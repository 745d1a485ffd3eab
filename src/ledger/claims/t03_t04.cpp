#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/chapter3.hpp"
#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/pooled.hpp"

namespace arenite::ledger {
namespace {

/// Six-fold order with peaks at 0, 60 and 120 degrees.
void six_fold(Verdict& verdict, const std::vector<Run>& runs, const char* set, double least, const char* bound) {
  const PooledMode mode = pooled_mode(runs, set, 6);
  const std::string name = *set ? set : "all";
  Check amplitude = above(fmt::format("6-fold amplitude, {} (noise {:.2g})", name, mode.noise), "peaks", mode.amplitude, least > 0 ? least : 3 * mode.noise);
  amplitude.tolerance = bound;
  verdict.checks.push_back(amplitude);
  verdict.checks.push_back(below(fmt::format("angle of its peaks from 0, 60, 120 degrees, {}", name), "0", angle_from(mode, 0, 60), 10, "deg"));
}

/// `wanted` degrees, or any that is `period` away.
Check near_direction(const std::string& what, const PooledMode& mode, const std::string& source, double wanted, double period) {
  Check check = below(fmt::format("{} (noise of a_c {:.2g})", what, 2 * mode.noise), source, angle_from(mode, wanted, period), 15, "deg away");
  check.tolerance = "within 15 deg";
  return check;
}

/// How far a random filling of the same disks gets.
void add_random_filling(Judgement& judgement, const Results& results) {
  const auto runs = results.runs("thesis-ch3-random");
  if (runs.empty()) return;
  const PooledMode all = pooled_mode(runs, "", 6);
  judgement.findings.push_back(fmt::format("From a random filling ({} samples) the 6-fold amplitude of all contacts together is {} (noise {:.2g}), of one sample {} in the mean; solid fraction {}.", runs.size(),
                                           text_of(all.amplitude), all.noise, text_of(mean_over_seeds(runs, "fabric.modes.6.amplitude")), text_of(mean_over_seeds(runs, "solid_fraction"))));
}

}  // namespace

/// Sample #2 is stacked: 1235 disks of one size fit the frame only as a crystal.
Judgement judge_t3(const Results& results) {
  Judgement judgement;
  const auto runs = runs_of(results, sample_2);
  for (const char* set : {"", "POM-POM", "HDPE-HDPE", "HDPE-POM"}) {
    six_fold(judgement.stated, runs, set, 0, "> 3 times the noise");
    six_fold(judgement.sharpened, runs, set, 0.5, "> 0.5");
  }
  const PooledMode all = pooled_mode(runs, "", 6);
  judgement.findings.push_back(fmt::format("Sample #2 starts stacked; its 6-fold amplitude is {:.3f} (noise {:.3f}) at {:.1f} degrees over {:.0f} contacts.", all.amplitude.value,
                                           all.noise, all.phase_deg.value, all.contacts));
  add_random_filling(judgement, results);
  add_choices(judgement, results, "6-fold amplitude of #2", sample_2, "fabric.modes.6.amplitude", wanted_above(0.5));
  return judgement;
}

/// POM-POM contacts of #8 and #12, pooled over seeds.
Judgement judge_t4(const Results& results) {
  Judgement judgement;
  const auto eight = runs_of(results, sample_8), twelve = runs_of(results, sample_12);
  const auto isotropic = below("a_c of all contacts, #8", "quasi-isotropic", mean(results, "thesis-ch3", "fabric.a_c", where(sample_8)), 0.15);
  const PooledMode pom_8 = pooled_mode(eight, "POM-POM", 2), pom_12 = pooled_mode(twelve, "POM-POM", 2);
  const Check to_the_load = near_direction("direction of POM-POM contacts, #8", pom_8, "90", 90, 180);
  judgement.stated.checks = {isotropic, to_the_load, near_direction("direction of POM-POM contacts, #12", pom_12, "45 from the vertical", 45, 90)};
  judgement.sharpened.checks = {isotropic, to_the_load};
  if (eight.size() < 10)
    for (auto* verdict : {&judgement.stated, &judgement.sharpened})
      for (std::size_t k = 1; k < verdict->checks.size(); ++k) verdict->checks[k].holds = Holds::unknown;  // too few to tell from noise
  for (const auto& [name, mode] : {std::pair{"#8", pom_8}, {"#12", pom_12}})
    judgement.findings.push_back(fmt::format("POM-POM contacts of {} together: theta_c {} degrees, a_c {:.3f}, noise of a_c {:.3f} ({:.0f} contacts).", name, text_of(mode.phase_deg),
                                             2 * mode.amplitude.value, 2 * mode.noise, mode.contacts));
  add_choices(judgement, results, "a_c of all contacts of #8", sample_8, "fabric.a_c", wanted_below(0.15));
  add_choices(judgement, results, "Signed a_c of POM-POM contacts of #8", sample_8, "fabric.sets.POM-POM.a_c_signed");
  return judgement;
}

}  // namespace arenite::ledger
