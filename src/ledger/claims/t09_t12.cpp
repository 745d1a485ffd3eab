#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/chapter4.hpp"
#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/pooled.hpp"

namespace arenite::ledger {
namespace {

constexpr const char* study_4 = "thesis-ch4";
constexpr const char* study_4_r = "thesis-ch4-r";

Value slope_of(const Results& results, const char* study, const std::string& number) { return slope(series(results, study, number_ratio(), number)); }

/// What the checks of a claim say under the thesis's own law of friction.
void add_law_r(Judgement& judgement, const Verdict& verdict) {
  if (const std::string text = told("Law R", verdict); !text.empty()) judgement.findings.push_back(text);
}

void by_types(Verdict& verdict, const Results& results, const char* study, std::initializer_list<const char*> types, double low, double high) {
  for (const char* type : types)
    verdict.checks.push_back(between(fmt::format("share of {} contacts above their mean, {}", type, study), "about 0.4",
                                     mean(results, study, fmt::format("force.by_type.{}.strong_share", type)), low, high));
}

}  // namespace

/// Partial coordination numbers: true mean numbers of contacts a grain, and the thesis's own form, which counts unlike twice.
Judgement judge_t9(const Results& results) {
  const auto verdict = [&](const char* study, const std::string& form, const char* how) {
    const auto lead = mean(results, study, [&](const Run& run) { return run(form + "POM-ANY") - run(form + "HDPE-ANY"); });
    return Verdict{{positive("slope of z(HDPE-HDPE) against the ratio", "rises", slope_of(results, study, "coordination.HDPE-HDPE")),
                    negative("slope of z(POM-POM) against the ratio", "falls", slope_of(results, study, "coordination.POM-POM")),
                    positive(fmt::format("z(POM-ANY) - z(HDPE-ANY){}", how), "> 0", lead)}};
  };
  Judgement judgement;
  judgement.stated = verdict(study_4, "coordination.unlike_contacts_twice.", ", unlike contacts counted twice");
  judgement.sharpened = verdict(study_4, "coordination.", "");
  add_law_r(judgement, verdict(study_4_r, "coordination.", ""));
  add_choices_of_ratios(judgement, results, "z(HDPE-HDPE)", "coordination.HDPE-HDPE", {{}, {}, wanted_positive()});
  add_choices_of_ratios(judgement, results, "z(POM-POM)", "coordination.POM-POM", {{}, {}, wanted_negative()});
  return judgement;
}

/// Shares of contacts above the mean force.
Judgement judge_t10(const Results& results) {
  const auto all = [&](Verdict& verdict, const char* study) {
    verdict.checks.push_back(within(fmt::format("share of contacts above the mean, {}", study), mean(results, study, "force.strong_share"), 0.40, 0.04));
  };
  const auto sharpened = [&](const char* fourth, const char* fifth) {
    Verdict verdict;
    all(verdict, fourth);
    all(verdict, fifth);
    by_types(verdict, results, fourth, {"POM-POM", "HDPE-POM", "HDPE-HDPE"}, 0.33, 0.50);
    by_types(verdict, results, fifth, {"A-A", "A-B", "B-B"}, 0.38, 0.46);
    verdict.checks.push_back(positive(fmt::format("share of POM-POM less that of HDPE-HDPE, {}", fourth), "-", mean(results, fourth, [](const Run& run) {
      return run("force.by_type.POM-POM.strong_share") - run("force.by_type.HDPE-HDPE.strong_share");
    })));
    return verdict;
  };
  Judgement judgement;
  for (const char* study : {study_4, "thesis-ch5"}) all(judgement.stated, study);
  by_types(judgement.stated, results, study_4, {"POM-POM", "HDPE-POM", "HDPE-HDPE"}, 0.36, 0.44);
  by_types(judgement.stated, results, "thesis-ch5", {"A-A", "A-B", "B-B"}, 0.36, 0.44);
  judgement.sharpened = sharpened(study_4, "thesis-ch5");
  add_law_r(judgement, sharpened(study_4_r, "thesis-ch5-r"));
  add_choices_of_ratios(judgement, results, "Share of contacts above the mean", "force.strong_share", {wanted_within(0.40, 0.04), wanted_within(0.40, 0.04), {}});
  add_stiffness_choices(judgement, results, "Share of contacts above the mean", "force.strong_share", wanted_within(0.40, 0.04));
  return judgement;
}

/// Triangular order.
Judgement judge_t11(const Results& results) {
  const char* triangular = "local_order.triangular_share.HDPE";
  const auto local = [&](const char* study) {
    return Verdict{{positive("slope against the ratio of the share of HDPE grains in triangular order", "rises", slope_of(results, study, triangular))}};
  };
  Judgement judgement;
  const auto signal = [](const Run& run) { return run("fabric.modes.6.amplitude") / run("fabric.modes.6.noise"); };
  Value before, beyond_8;
  for (const Point& p : series(results, study_4, number_ratio(), signal)) {
    if (p.x < 8 && !(p.mean <= before.value)) before = {p.mean, p.error};
    if (p.x > 8) beyond_8 = {p.mean, p.error};
  }
  judgement.stated.checks = {below("largest 6-fold amplitude over its noise, ratios below 8", "quasi-isotropic", before, 3),
                             above("6-fold amplitude over its noise, greatest ratio above 8", "ordered", beyond_8, 3)};
  judgement.sharpened = local(study_4);
  const Series share = series(results, study_4, number_ratio(), triangular);
  const Series amplitude = series(results, study_4, number_ratio(), "fabric.modes.6.amplitude"), noise = series(results, study_4, number_ratio(), "fabric.modes.6.noise");
  for (const std::size_t end : {std::size_t{0}, share.size() - 1})
    if (share.size() > 1 && amplitude.size() == share.size() && noise.size() == share.size())
      judgement.findings.push_back(fmt::format("At ratio {:g}: share of HDPE grains in triangular order {}; 6-fold amplitude of a whole sample {}, noise {:.2g}.", share[end].x,
                                               text_of({share[end].mean, share[end].error}), text_of({amplitude[end].mean, amplitude[end].error}), noise[end].mean));
  add_law_r(judgement, local(study_4_r));
  add_choices_of_ratios(judgement, results, "Share of HDPE grains in triangular order", triangular, {{}, {}, wanted_positive()});
  return judgement;
}

/// POM-POM contacts, pooled over ratios and seeds.
Judgement judge_t12(const Results& results) {
  Judgement judgement;
  for (const auto& [law, study] : laws_of_chapter_4) {
    const auto runs = results.runs(study);
    const PooledMode pom = pooled_mode(runs, "POM-POM", 2), all = pooled_mode(runs, "", 2);
    const auto added = [law = law](const char* what) { return fmt::format("{}, {}", what, law); };
    const auto a_c = [](const PooledMode& mode) { return Value(2 * mode.amplitude.value, 2 * mode.amplitude.error); };
    Check direction = below(added("direction of POM-POM contacts"), "90", angle_from(pom, 90, 180), 15, "deg away");
    Check beyond_noise = above(added("a_c of POM-POM contacts"), "anisotropic", a_c(pom), 6 * pom.noise);
    beyond_noise.tolerance = "> 3 times its noise";
    judgement.sharpened.checks.insert(judgement.sharpened.checks.end(), {direction, beyond_noise,
                                      above(added("a_c of POM-POM less a_c of all"), "> 0", difference(a_c(pom), a_c(all)), 0)});
    if (std::string(study) == study_4) judgement.stated.checks = {direction, beyond_noise};
    if (!runs.empty())
      judgement.findings.push_back(fmt::format("{}: POM-POM a_c {} at {} degrees (noise {:.3f}), all contacts a_c {} (noise {:.3f}).", law, text_of(a_c(pom)), text_of(pom.phase_deg), 2 * pom.noise,
                                             text_of(a_c(all)), 2 * all.noise));
  }
  add_choices_of_ratios(judgement, results, "Signed a_c of POM-POM contacts", "fabric.sets.POM-POM.a_c_signed");
  add_choices_of_ratios(judgement, results, "Signed a_c of all contacts", "fabric.a_c_signed");
  return judgement;
}

/// Who carries the largest forces.
Judgement judge_t19(const Results& results) {
  const auto largest = [](const char* type) {
    const std::string name = fmt::format("force.by_type.{}", type);
    return [name](const Run& run) { return run(name + ".maximum") * run(name + ".mean_N"); };
  };
  const auto verdict = [&](const char* study) {
    const auto lead = mean_over_seeds(results.runs(study), [&](const Run& run) { return largest("POM-POM")(run) / std::fmax(largest("HDPE-HDPE")(run), largest("HDPE-POM")(run)) - 1; });
    return Verdict{{positive("slope against the ratio of the share of HDPE-HDPE above the whole network's mean", "rises", slope_of(results, study, "force.by_type.HDPE-HDPE.share_above_mean_of_all")),
                    negative("slope against the ratio of the share of POM-POM above the whole network's mean", "falls", slope_of(results, study, "force.by_type.POM-POM.share_above_mean_of_all")),
                    positive("largest force of POM-POM over that of the other types, less 1", "> 0", lead)}};
  };
  const auto mean_lead = mean_over_seeds(results.runs(study_4), [](const Run& run) {
    return run("force.by_type.POM-POM.mean_N") / std::fmax(run("force.by_type.HDPE-HDPE.mean_N"), run("force.by_type.HDPE-POM.mean_N")) - 1;
  });
  Judgement judgement;
  judgement.stated = judgement.sharpened = verdict(study_4);
  judgement.findings.push_back(fmt::format("Mean force of POM-POM over the greater mean of the other types, less 1: {}.", text_of(mean_lead)));
  add_law_r(judgement, verdict(study_4_r));
  add_choices_of_ratios(judgement, results, "Share of HDPE-HDPE above the whole network's mean", "force.by_type.HDPE-HDPE.share_above_mean_of_all", {{}, {}, wanted_positive()});
  add_choices_of_ratios(judgement, results, "Share of POM-POM above the whole network's mean", "force.by_type.POM-POM.share_above_mean_of_all", {{}, {}, wanted_negative()});
  return judgement;
}

}  // namespace arenite::ledger
