#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/pooled.hpp"

namespace arenite::ledger {
namespace {

struct LawOfChapter5 {
  const char* law;
  const char* study;
};
constexpr LawOfChapter5 laws[] = {{"law S", "thesis-ch5"}, {"law R", "thesis-ch5-r"}, {"no friction", "thesis-ch5-smooth"}};

/// Signed anisotropy of one set less that of another.
Number signed_lead(std::string a, std::string b) {
  return [a = std::move(a), b = std::move(b)](const Run& run) { return run("fabric.sets." + a + ".a_c_signed") - run("fabric.sets." + b + ".a_c_signed"); };
}

/// What as many random directions as a set has contacts would give for a_c.
Number noise_of_a_c(std::string set) {
  return [set = std::move(set)](const Run& run) { return 2 * 0.886 / std::sqrt(run("fabric.sets." + set + ".contacts")); };
}

Number strong_share(std::string type) {
  return [type = std::move(type)](const Run& run) { return run("fabric.sets." + type + " strong.contacts") / run("fabric.sets.strong.contacts"); };
}

}  // namespace

/// Coordination against the stiffness ratio. Seeds share their first places of grains, so slopes are taken seed by seed.
Judgement judge_t13(const Results& results) {
  Judgement judgement;
  const auto runs = results.runs("thesis-ch5");
  const Check steady = none("slope of z against k_A/k_B", "steady", slope_over_seeds(runs, stiffness_ratio, "coordination.all"));
  judgement.stated.checks = judgement.sharpened.checks = {steady};
  for (const auto& [type, share] : {std::pair{"A-B", 0.50}, {"A-A", 0.25}, {"B-B", 0.25}}) {
    const Check check = within(fmt::format("share of {} contacts", type), mean_over_seeds(runs, fmt::format("coordination.share_of_contacts.{}", type)), share, 0.05);
    judgement.stated.checks.push_back(check);
    judgement.sharpened.checks.push_back(check);
  }
  judgement.stated.checks.push_back(within("z(A-B), its part of z", mean_over_seeds(runs, "coordination.parts_of_z.A-B"), 1.75, 0.1));
  for (const auto& [law, study] : laws) {
    const auto of_law = results.runs(study);
    if (of_law.empty()) continue;
    judgement.findings.push_back(fmt::format("{}: z {}, without rattlers {}, z(A-B) {}, rattlers {}, mean |F_t|/F_n {}, z rises by {} a unit of the ratio.", law,
                                             text_of(mean_over_seeds(of_law, "coordination.all")), text_of(mean_over_seeds(of_law, "coordination.without_rattlers")),
                                             text_of(mean_over_seeds(of_law, "coordination.parts_of_z.A-B")), text_of(mean_over_seeds(of_law, "coordination.rattlers")),
                                             text_of(mean_over_seeds(of_law, "stages.load.last_state.equilibrium.mobilisation")),
                                             text_of(slope_over_seeds(of_law, stiffness_ratio, "coordination.all"))));
  }
  add_stiffness_choices(judgement, results, "z", "coordination.all");
  add_stiffness_slope(judgement, results, "z", "coordination.all", wanted_none());
  add_stiffness_choices(judgement, results, "z(A-B), its part of z,", "coordination.parts_of_z.A-B", wanted_within(1.75, 0.1));
  return judgement;
}

/// Directions of the strong and the weak network.
Judgement judge_t14(const Results& results) {
  const auto anisotropy = [&](const char* study, const char* set) { return mean_over_seeds(results.runs(study), fmt::format("fabric.sets.{}.a_c_signed", set)); };
  const auto sharpened = [&](const char* study) {
    return Verdict{{positive("signed a_c of strong contacts", "> 0", anisotropy(study, "strong")),
                    positive("signed a_c of strong less that of weak contacts", "> 0", mean_over_seeds(results.runs(study), signed_lead("strong", "weak")))}};
  };
  Judgement judgement;
  judgement.sharpened = sharpened("thesis-ch5");
  judgement.stated.checks = {judgement.sharpened.checks.front(), below("signed a_c of weak contacts", "does not lean to the compression", anisotropy("thesis-ch5", "weak"), 0)};
  for (const char* set : {"A-A weak", "B-B weak"}) {
    Check check = none(fmt::format("signed a_c of {} contacts", set), "not isotropic", anisotropy("thesis-ch5", set));
    check.tolerance = "not 0, by 2 s.e.";
    if (check.holds != Holds::unknown) check.holds = check.holds == Holds::yes ? Holds::no : Holds::yes;
    judgement.stated.checks.push_back(check);
  }
  for (const auto& [law, study] : laws)
    if (const auto of_law = results.runs(study); !of_law.empty())
      judgement.findings.push_back(fmt::format("{}: signed a_c of strong contacts {}, of weak {}; noise of one sample's a_c {:.2g} and {:.2g}.", law, text_of(anisotropy(study, "strong")),
                                               text_of(anisotropy(study, "weak")), mean_over_seeds(of_law, noise_of_a_c("strong")).value, mean_over_seeds(of_law, noise_of_a_c("weak")).value));
  if (const Verdict control = sharpened("thesis-ch5-smooth"); control.holds() == Holds::yes)
    judgement.findings.emplace_back("Both sharpened checks hold without friction, too: as a negative control it is none, and the lean of the strong network is not friction's doing alone.");
  add_stiffness_choices(judgement, results, "Signed a_c of strong contacts", "fabric.sets.strong.a_c_signed", wanted_positive());
  add_stiffness_choices(judgement, results, "Signed a_c of weak contacts", "fabric.sets.weak.a_c_signed", wanted_below(0));
  return judgement;
}

/// Types of the strong contacts.
Judgement judge_t20(const Results& results) {
  const auto verdict = [&](const char* study) {
    const auto runs = results.runs(study);
    Verdict found;
    found.checks.push_back(above("share of A-B among strong contacts", "most", mean_over_seeds(runs, strong_share("A-B")), 1.0 / 3));
    for (const char* type : {"A-A", "B-B"}) {
      found.checks.push_back(within(fmt::format("share of {} among strong contacts", type), mean_over_seeds(runs, strong_share(type)), 0.25, 0.05));
      found.checks.push_back(positive(fmt::format("share of A-B less that of {}", type), "> 0",
                                      mean_over_seeds(runs, [&](const Run& run) { return strong_share("A-B").of(run) - strong_share(type).of(run); })));
    }
    found.checks.push_back(positive("signed a_c of A-A contacts", "> 0", mean_over_seeds(runs, "fabric.sets.A-A.a_c_signed")));
    return found;
  };
  Judgement judgement;
  judgement.stated = judgement.sharpened = verdict("thesis-ch5");
  for (const auto& [law, study] : laws)
    if (const std::string text = told(law, verdict(study)); !text.empty() && study != std::string("thesis-ch5")) judgement.findings.push_back(text);
  if (const auto runs = results.runs("thesis-ch5"); !runs.empty())
    judgement.findings.push_back(fmt::format("Noise of one sample's a_c of A-A contacts: {:.2g}.", mean_over_seeds(runs, noise_of_a_c("A-A")).value));
  add_stiffness_choices(judgement, results, "Share of A-B among strong contacts", strong_share("A-B"), wanted_above(1.0 / 3));
  add_stiffness_choices(judgement, results, "Signed a_c of A-A contacts", "fabric.sets.A-A.a_c_signed", wanted_positive());
  return judgement;
}

}  // namespace arenite::ledger
