#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/chapter4.hpp"
#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/pooled.hpp"

namespace arenite::ledger {
namespace {

constexpr const char* study_4 = "thesis-ch4";

Value slope_of(const Results& results, const std::string& number) { return slope(series(results, study_4, number_ratio(), number)); }

void by_types(Verdict& verdict, const Results& results, const char* study, std::initializer_list<const char*> types, double low, double high) {
  for (const char* type : types)
    verdict.checks.push_back(between(fmt::format("share of {} contacts above their mean, {}", type, study), "about 0.4",
                                     mean(results, study, fmt::format("force.by_type.{}.strong_share", type)), low, high));
}

}  // namespace

/// Partial coordination numbers: true mean numbers of contacts a grain, and the thesis's own form, which counts unlike twice.
Judgement judge_t9(const Results& results) {
  Judgement judgement;
  const Check up = positive("slope of z(HDPE-HDPE) against the ratio", "rises", slope_of(results, "coordination.HDPE-HDPE"));
  const Check down = negative("slope of z(POM-POM) against the ratio", "falls", slope_of(results, "coordination.POM-POM"));
  const auto lead = [&](const std::string& prefix) {
    return mean(results, study_4, [prefix](const Run& run) { return run(prefix + "POM-ANY") - run(prefix + "HDPE-ANY"); });
  };
  judgement.stated.checks = {up, down, positive("z(POM-ANY) - z(HDPE-ANY), unlike contacts counted twice", "> 0", lead("coordination.unlike_contacts_twice."))};
  judgement.sharpened.checks = {up, down, positive("z(POM-ANY) - z(HDPE-ANY)", "> 0", lead("coordination."))};
  add_choices_of_ratios(judgement, results, "z(HDPE-HDPE)", "coordination.HDPE-HDPE", {{}, {}, wanted_positive()});
  add_choices_of_ratios(judgement, results, "z(POM-POM)", "coordination.POM-POM", {{}, {}, wanted_negative()});
  return judgement;
}

/// Shares of contacts above the mean force.
Judgement judge_t10(const Results& results) {
  Judgement judgement;
  for (const char* study : {"thesis-ch4", "thesis-ch5"}) {
    const Check all = within(fmt::format("share of contacts above the mean, {}", study), mean(results, study, "force.strong_share"), 0.40, 0.04);
    judgement.stated.checks.push_back(all);
    judgement.sharpened.checks.push_back(all);
  }
  by_types(judgement.stated, results, "thesis-ch4", {"POM-POM", "HDPE-POM", "HDPE-HDPE"}, 0.36, 0.44);
  by_types(judgement.stated, results, "thesis-ch5", {"A-A", "A-B", "B-B"}, 0.36, 0.44);
  by_types(judgement.sharpened, results, "thesis-ch4", {"POM-POM", "HDPE-POM", "HDPE-HDPE"}, 0.33, 0.50);
  by_types(judgement.sharpened, results, "thesis-ch5", {"A-A", "A-B", "B-B"}, 0.38, 0.46);
  judgement.sharpened.checks.push_back(positive("share of POM-POM less that of HDPE-HDPE, thesis-ch4", "-", mean(results, study_4, [](const Run& run) {
    return run("force.by_type.POM-POM.strong_share") - run("force.by_type.HDPE-HDPE.strong_share");
  })));
  add_choices_of_ratios(judgement, results, "Share of contacts above the mean", "force.strong_share", {wanted_within(0.40, 0.04), wanted_within(0.40, 0.04), {}});
  add_stiffness_choices(judgement, results, "Share of contacts above the mean", "force.strong_share", wanted_within(0.40, 0.04));
  return judgement;
}

/// Triangular order.
Judgement judge_t11(const Results& results) {
  Judgement judgement;
  const auto signal = [](const Run& run) { return run("fabric.modes.6.amplitude") / run("fabric.modes.6.noise"); };
  const Series order = series(results, study_4, number_ratio(), signal);
  Value before, beyond_8;
  for (const Point& p : order) {
    if (p.x < 8 && !(p.mean <= before.value)) before = {p.mean, p.error};
    if (p.x > 8) beyond_8 = {p.mean, p.error};
  }
  judgement.stated.checks = {below("largest 6-fold amplitude over its noise, ratios below 8", "quasi-isotropic", before, 3),
                             above("6-fold amplitude over its noise, greatest ratio above 8", "ordered", beyond_8, 3)};
  judgement.sharpened.checks = {positive("slope against the ratio of the share of HDPE grains in triangular order", "rises", slope_of(results, "local_order.triangular_share.HDPE"))};
  const Series share = series(results, study_4, number_ratio(), "local_order.triangular_share.HDPE");
  if (share.size() > 1)
    judgement.findings.push_back(fmt::format("Share of HDPE grains in triangular order: {:.4f} at ratio {:g}, {:.4f} at {:g}.", share.front().mean, share.front().x, share.back().mean,
                                             share.back().x));
  add_choices_of_ratios(judgement, results, "Share of HDPE grains in triangular order", "local_order.triangular_share.HDPE", {{}, {}, wanted_positive()});
  return judgement;
}

/// POM-POM contacts, pooled over ratios and seeds.
Judgement judge_t12(const Results& results) {
  Judgement judgement;
  for (const auto& [law, study] : laws_of_chapter_4) {
    const auto runs = results.runs(study);
    const PooledMode pom = pooled_mode(runs, "POM-POM", 2), all = pooled_mode(runs, "", 2);
    const auto added = [law = law](const char* what) { return fmt::format("{}, {}", what, law); };
    Check direction = below(added("direction of POM-POM contacts"), "90", angle_between(pom.phase_deg, 90, 180), 15, "deg away");
    Check beyond_noise = above(added("a_c of POM-POM contacts"), "anisotropic", {2 * pom.amplitude, 2 * pom.noise}, 6 * pom.noise);
    beyond_noise.tolerance = "> 3 times its noise";
    judgement.sharpened.checks.insert(judgement.sharpened.checks.end(), {direction, beyond_noise,
                                      above(added("a_c of POM-POM less a_c of all"), "> 0", 2 * (pom.amplitude - all.amplitude), 0)});
    if (std::string(study) == study_4) judgement.stated.checks = {direction, beyond_noise};
    if (!runs.empty())
      judgement.findings.push_back(fmt::format("{}: POM-POM a_c {:.3f} at {:.1f} degrees (noise {:.3f}), all contacts a_c {:.3f}.", law, 2 * pom.amplitude, pom.phase_deg, 2 * pom.noise,
                                             2 * all.amplitude));
  }
  add_choices_of_ratios(judgement, results, "Signed a_c of POM-POM contacts", "fabric.sets.POM-POM.a_c_signed");
  add_choices_of_ratios(judgement, results, "Signed a_c of all contacts", "fabric.a_c_signed");
  return judgement;
}

/// Who carries the largest forces.
Judgement judge_t19(const Results& results) {
  Judgement judgement;
  const Check up = positive("slope against the ratio of the share of HDPE-HDPE above the whole network's mean", "rises", slope_of(results, "force.by_type.HDPE-HDPE.share_above_mean_of_all"));
  const Check down = negative("slope against the ratio of the share of POM-POM above the whole network's mean", "falls", slope_of(results, "force.by_type.POM-POM.share_above_mean_of_all"));
  const auto largest = [](const char* type) {
    const std::string name = fmt::format("force.by_type.{}", type);
    return [name](const Run& run) { return run(name + ".maximum") * run(name + ".mean_N"); };
  };
  const auto lead = mean_over_seeds(results.runs(study_4), [&](const Run& run) {
    return largest("POM-POM")(run) / std::fmax(largest("HDPE-HDPE")(run), largest("HDPE-POM")(run)) - 1;
  });
  const auto mean_lead = mean_over_seeds(results.runs(study_4), [](const Run& run) {
    return run("force.by_type.POM-POM.mean_N") / std::fmax(run("force.by_type.HDPE-HDPE.mean_N"), run("force.by_type.HDPE-POM.mean_N")) - 1;
  });
  judgement.stated.checks = {up, down, positive("largest force of POM-POM over that of the other types, less 1", "> 0", lead)};
  judgement.sharpened = judgement.stated;
  judgement.findings.push_back(fmt::format("Mean force of POM-POM over the greater mean of the other types, less 1: {}.", text_of(mean_lead)));
  add_choices_of_ratios(judgement, results, "Share of HDPE-HDPE above the whole network's mean", "force.by_type.HDPE-HDPE.share_above_mean_of_all", {{}, {}, wanted_positive()});
  add_choices_of_ratios(judgement, results, "Share of POM-POM above the whole network's mean", "force.by_type.POM-POM.share_above_mean_of_all", {{}, {}, wanted_negative()});
  return judgement;
}

}  // namespace arenite::ledger
