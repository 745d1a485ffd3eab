#include <fmt/core.h>

#include <cmath>

#include "validation/claims/claims.hpp"
#include "validation/claims/thesis_choices.hpp"
#include "validation/pooled.hpp"
#include "validation/trends.hpp"

namespace arenite::validation {
namespace {

struct LawOfChapter5 {
  const char* law;
  const char* study;
};
constexpr LawOfChapter5 laws[] = {
    {"law S", "thesis-ch5"}, {"law R", "thesis-ch5-r"}, {"no friction", "thesis-ch5-smooth"}};

/// Signed anisotropy of one set less that of another.
Number signed_lead(std::string a, std::string b) {
  return [a = std::move(a), b = std::move(b)](const Run& run) {
    return run("fabric.sets." + a + ".a_c_signed") - run("fabric.sets." + b + ".a_c_signed");
  };
}

/// What as many random directions as a set has contacts would give for a_c.
Number noise_of_a_c(std::string set) {
  return
      [set = std::move(set)](const Run& run) { return 2 * 0.886 / std::sqrt(run("fabric.sets." + set + ".contacts")); };
}

Number strong_share(std::string type) {
  return [type = std::move(type)](const Run& run) {
    return run("fabric.sets." + type + " strong.contacts") / run("fabric.sets.strong.contacts");
  };
}

/// z between k_A/k_B = 1 and 10 over z itself: what its slope against the logarithm gives for a decade, seed by seed.
Value change_a_decade(const std::vector<Run>& runs, const Number& number) {
  return ratio(slope_over_seeds(
                   runs, [](const Run& run) { return std::log10(stiffness_ratio(run)); }, number),
               mean_over_seeds(runs, number));
}

/// Samples of which the thesis shows the directions, one at each k_A/k_B.
constexpr double samples_shown = 10;

/// Steady: no further apart than this part over a decade of the ratio.
constexpr double steady = 0.05;

}  // namespace

/// Coordination against the stiffness ratio. Seeds share their first places of grains, so slopes are taken seed by
/// seed.
Judgement judge_t13(const Results& results) {
  Judgement judgement;
  const auto runs = results.runs("thesis-ch5");
  const Value change = change_a_decade(runs, "coordination.all"),
              z_ab = mean_over_seeds(runs, "coordination.parts_of_z.A-B");
  Family shares;
  for (const auto& [type, share] : {std::pair{"A-B", 0.50}, {"A-A", 0.25}, {"B-B", 0.25}})
    shares.push_back(
        {type, difference(mean_over_seeds(runs, fmt::format("coordination.share_of_contacts.{}", type)), {share, 0})});
  judgement.checks = {
      equivalent("relative change of z over a decade of k_A/k_B", "constant", change, steady),
      equivalent("relative change of z without rattlers over a decade of k_A/k_B", "constant",
                 change_a_decade(runs, "coordination.without_rattlers"), steady),
      every("fraction of contacts of one type minus 1/2 (A-B) or 1/4 (A-A, B-B)", "0", shares, {-0.05, 0.05}),
      number(within("z(A-B) as a part of z", z_ab, 1.75, 0.1))};
  if (std::isfinite(change.value))
    judgement.ours = fmt::format("relative change of z over a decade {}; z(A-B) {}", text_of(change), text_of(z_ab));
  for (const auto& [law, study] : laws)
    for (const auto& [what, name] : {std::pair{"z", "coordination.all"},
                                     {"z without rattlers", "coordination.without_rattlers"},
                                     {"z(A-B)", "coordination.parts_of_z.A-B"},
                                     {"fraction of rattlers", "coordination.rattlers"},
                                     {"mean |F_t|/F_n", "stages.load.last_state.equilibrium.mobilisation"}})
      if (const auto of_law = results.runs(study); !of_law.empty())
        judgement.checks.push_back(reported(fmt::format("{}, {}", what, law), mean_over_seeds(of_law, name)));
  add_stiffness_change(judgement, results, "Relative change of z over a decade of k_A/k_B", change_a_decade,
                       "coordination.all", wanted_equivalent(steady));
  add_stiffness_choices(judgement, results, "z(A-B) as a part of z", "coordination.parts_of_z.A-B",
                        wanted_within(1.75, 0.1));
  return judgement;
}

/// Directions of the strong and the weak network.
Judgement judge_t14(const Results& results) {
  const auto anisotropy = [&](const char* study, const std::string& set) {
    return mean_over_seeds(results.runs(study), fmt::format("fabric.sets.{}.a_c_signed", set));
  };
  const auto noise = [&](const char* study, const std::string& set) {
    return mean_over_seeds(results.runs(study), noise_of_a_c(set)).value;
  };
  // What its samples together cannot tell from random directions counts as isotropic.
  const auto isotropic = [&](const std::string& set) { return noise("thesis-ch5", set) / std::sqrt(samples_shown); };
  const auto asked = [&](const char* study) {
    return std::vector<Check>{
        positive("signed a_c of strong contacts", "oriented along the load", anisotropy(study, "strong")),
        positive("signed a_c of strong minus that of weak contacts", "> 0",
                 mean_over_seeds(results.runs(study), signed_lead("strong", "weak"))),
        below("signed a_c of weak contacts", "not oriented along the load", anisotropy(study, "weak"),
              std::isfinite(noise(study, "weak")) ? noise(study, "weak") : 0)};
  };
  Judgement judgement;
  judgement.checks = asked("thesis-ch5");
  judgement.checks.back().wanted += ", the value for as many random directions";
  for (const std::string set : {"A-A weak", "B-B weak"})
    judgement.checks.push_back(differs(fmt::format("signed a_c of {} contacts", set), "not isotropic",
                                       anisotropy("thesis-ch5", set), isotropic(set)));
  if (const Value& strong = judgement.checks.front().ours; std::isfinite(strong.value))
    judgement.ours =
        fmt::format("signed a_c: strong {}, weak {}", text_of(strong), text_of(anisotropy("thesis-ch5", "weak")));
  add_beside(judgement, "under law R", asked("thesis-ch5-r"));
  add_beside(judgement, "without friction (control)", asked("thesis-ch5-smooth"));
  add_stiffness_choices(judgement, results, "Signed a_c of strong contacts", "fabric.sets.strong.a_c_signed",
                        wanted_positive());
  add_stiffness_choices(judgement, results, "Signed a_c of weak contacts", "fabric.sets.weak.a_c_signed",
                        wanted_below(0));
  for (const std::string set : {"A-A weak", "B-B weak"})
    if (std::isfinite(isotropic(set)))
      add_stiffness_choices(judgement, results, "Signed a_c of " + set + " contacts",
                            "fabric.sets." + set + ".a_c_signed", wanted_different(isotropic(set)));
  return judgement;
}

/// Types of the strong contacts.
Judgement judge_t20(const Results& results) {
  const auto asked = [&](const char* study) {
    const auto runs = results.runs(study);
    Family quarters, leads;
    for (const std::string type : {"A-A", "B-B"}) {
      quarters.push_back({type, mean_over_seeds(runs, strong_share(type))});
      leads.push_back({type, mean_over_seeds(runs, [&](const Run& run) {
                         return strong_share("A-B").of(run) - strong_share(type).of(run);
                       })});
    }
    return std::vector<Check>{
        every("fraction of A-B among strong contacts minus that of another type", "most", leads, {.low = 0}),
        number(every("fraction of A-A, B-B among strong contacts", "a quarter each", quarters, {0.20, 0.30})),
        positive("signed a_c of A-A contacts", "slightly oriented along the load",
                 mean_over_seeds(runs, "fabric.sets.A-A.a_c_signed"))};
  };
  Judgement judgement;
  judgement.checks = asked("thesis-ch5");
  const auto runs = results.runs("thesis-ch5");
  if (!runs.empty())
    judgement.ours =
        fmt::format("A-B {}, A-A {}, B-B {}; signed a_c of A-A {}", text_of(mean_over_seeds(runs, strong_share("A-B"))),
                    text_of(mean_over_seeds(runs, strong_share("A-A"))),
                    text_of(mean_over_seeds(runs, strong_share("B-B"))), text_of(judgement.checks.back().ours));
  judgement.checks.push_back(
      reported("noise of one sample's a_c of A-A contacts", {mean_over_seeds(runs, noise_of_a_c("A-A")).value, 0}));
  add_beside(judgement, "under law R", asked("thesis-ch5-r"));
  add_beside(judgement, "without friction", asked("thesis-ch5-smooth"));
  add_stiffness_choices(judgement, results, "Fraction of A-B among strong contacts", strong_share("A-B"),
                        wanted_above(1.0 / 3));
  add_stiffness_choices(judgement, results, "Signed a_c of A-A contacts", "fabric.sets.A-A.a_c_signed",
                        wanted_positive());
  return judgement;
}

}  // namespace arenite::validation
