#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "validation/claims/chapter4.hpp"
#include "validation/claims/claims.hpp"
#include "validation/claims/thesis_choices.hpp"
#include "validation/pooled.hpp"
#include "validation/trends.hpp"

namespace arenite::validation {
namespace {

constexpr const char* study_4 = "thesis-ch4";
constexpr const char* study_5 = "thesis-ch5";

/// The slope against the ratio goes this way.
Check slope_goes(const Results& results, const char* study, const std::string& what, const Number& number,
                 int direction) {
  const Value size = slope(series(results, study, number_ratio(), number));
  return direction > 0 ? positive("slope of " + what + " against the ratio", "rises", size)
                       : negative("slope of " + what + " against the ratio", "falls", size);
}

/// Of all contacts of a run, those that are strong and of a type.
std::string share_of_strong(const std::string& type) {
  return fmt::format("force.by_type.{}.strong_share_of_all", type);
}

struct Typed {
  const char *study, *type;
};
constexpr Typed types_of_chapter_4[] = {{study_4, "POM-POM"}, {study_4, "HDPE-POM"}, {study_4, "HDPE-HDPE"}};
constexpr Typed types_of_chapter_5[] = {{study_5, "A-A"}, {study_5, "A-B"}, {study_5, "B-B"}};

/// The least and the greatest.
std::string ends(const Family& family) {
  const auto [least, greatest] = std::minmax_element(
      family.begin(), family.end(), [](const Member& a, const Member& b) { return a.value.value < b.value.value; });
  return fmt::format("{} ({}) to {} ({})", text_of(least->value), least->name, text_of(greatest->value),
                     greatest->name);
}

}  // namespace

/// Partial coordination numbers: true mean numbers of contacts a grain, and the thesis's own form, which counts unlike
/// twice.
Judgement judge_t9(const Results& results) {
  const auto lead = [&](const char* study, const std::string& form) {
    return mean_over_seeds(results.runs(study),
                           [&](const Run& run) { return run(form + "POM-ANY") - run(form + "HDPE-ANY"); });
  };
  const auto asked = [&](const char* study) {
    return std::vector<Check>{slope_goes(results, study, "z(HDPE-HDPE)", "coordination.HDPE-HDPE", +1),
                              slope_goes(results, study, "z(POM-POM)", "coordination.POM-POM", -1),
                              positive("z(POM-ANY) minus z(HDPE-ANY)", "> 0", lead(study, "coordination."))};
  };
  Judgement judgement;
  judgement.checks = asked(study_4);
  judgement.checks.push_back(
      number(positive("z(POM-ANY) minus z(HDPE-ANY), unlike contacts counted twice as in the thesis", "> 0",
                      lead(study_4, "coordination.unlike_contacts_twice."))));
  if (const Value& both = judgement.checks[2].ours; std::isfinite(both.value))
    judgement.ours = fmt::format("slopes {} and {}, z(POM-ANY) higher by {}", text_of(judgement.checks[0].ours),
                                 text_of(judgement.checks[1].ours), text_of(both));
  add_beside(judgement, "under law R", asked("thesis-ch4-r"));
  add_choices_of_ratios(judgement, results, "z(HDPE-HDPE)", "coordination.HDPE-HDPE", {{}, {}, wanted_positive()});
  add_choices_of_ratios(judgement, results, "z(POM-POM)", "coordination.POM-POM", {{}, {}, wanted_negative()});
  return judgement;
}

/// Shares of contacts above the mean force.
Judgement judge_t10(const Results& results) {
  const auto share = [&](const char* study, const std::string& type) {
    return mean_over_seeds(results.runs(study),
                           type.empty() ? "force.strong_share" : fmt::format("force.by_type.{}.strong_share", type));
  };
  const auto asked = [&](const char* fourth, const char* fifth) {
    Family all{{"ch. 4", share(fourth, ""), {{fourth, {}}}}, {"ch. 5", share(fifth, ""), {{fifth, {}}}}}, typed;
    for (const auto& [study, type] : types_of_chapter_4) typed.push_back({type, share(fourth, type), {{fourth, {}}}});
    for (const auto& [study, type] : types_of_chapter_5) typed.push_back({type, share(fifth, type), {{fifth, {}}}});
    return std::pair{all, typed};
  };
  const auto checks = [](const Family& all, const Family& typed) {
    Family both = all;
    both.insert(both.end(), typed.begin(), typed.end());
    return std::vector<Check>{
        every("fraction of contacts above the mean, all and each type", "fewer than half", both, {.high = 0.5}),
        number(every("fraction of contacts above the mean, all", "about 0.4", all, {0.36, 0.44})),
        number(every("fraction of contacts above their own mean, each type", "about 0.4", typed, {0.36, 0.44}))};
  };
  Judgement judgement;
  const auto [all, typed] = asked(study_4, study_5);
  judgement.checks = checks(all, typed);
  if (std::isfinite(all.front().value.value))
    judgement.ours = fmt::format("{} and {}; by type {}", text_of(all[0].value), text_of(all[1].value), ends(typed));
  const auto [all_r, typed_r] = asked("thesis-ch4-r", "thesis-ch5-r");
  add_beside(judgement, "under law R", checks(all_r, typed_r));
  judgement.checks.push_back(reported(
      "fraction of POM-POM minus that of HDPE-HDPE, ch. 4", mean_over_seeds(results.runs(study_4), [](const Run& run) {
        return run("force.by_type.POM-POM.strong_share") - run("force.by_type.HDPE-HDPE.strong_share");
      })));
  add_choices_of_ratios(judgement, results, "Fraction of contacts above the mean", "force.strong_share",
                        {wanted_within(0.40, 0.04), wanted_within(0.40, 0.04), {}});
  add_choices_of_ratios(judgement, results, "Fraction of POM-POM above their mean",
                        "force.by_type.POM-POM.strong_share",
                        {wanted_within(0.40, 0.04), wanted_within(0.40, 0.04), {}});
  add_stiffness_choices(judgement, results, "Fraction of contacts above the mean", "force.strong_share",
                        wanted_within(0.40, 0.04));
  return judgement;
}

/// Triangular order: of single grains and of the whole network.
Judgement judge_t11(const Results& results) {
  const char* triangular = "local_order.triangular_share.HDPE";
  const auto signal = [](const Run& run) { return run("fabric.modes.6.amplitude") / run("fabric.modes.6.noise"); };
  Family below_8, above_8;
  for (const Point& p : series(results, study_4, number_ratio(), signal))
    (p.x < 8 ? below_8 : above_8).push_back({fmt::format("ratio {:g}", p.x), value_of(p)});
  std::erase_if(above_8, [](const Member& m) { return m.name == "ratio 8"; });
  const Series share = series(results, study_4, number_ratio(), triangular);
  Judgement judgement;
  judgement.checks = {
      monotone("slope of the fraction of HDPE grains in triangular order against the ratio", "rises", share, +1),
      number(every("6-fold amplitude over its noise, ratios below 8", "quasi-isotropic", below_8, {.high = 3})),
      number(every("6-fold amplitude over its noise, ratios above 8", "ordered", above_8, {.low = 3}))};
  if (share.size() > 1)
    judgement.ours =
        fmt::format("fraction in triangular order {} at ratio {:g}, {} at {:g}", text_of(value_of(share.front())),
                    share.front().x, text_of(value_of(share.back())), share.back().x);
  add_beside(judgement, "under law R",
             {monotone("slope of the fraction of HDPE grains in triangular order against the ratio", "rises",
                       series(results, "thesis-ch4-r", number_ratio(), triangular), +1)});
  add_choices_of_ratios(judgement, results, "Fraction of HDPE grains in triangular order", triangular,
                        {{}, {}, wanted_positive()});
  add_choices_of_ratios(judgement, results, "6-fold amplitude over its noise", signal,
                        {wanted_below(3), wanted_above(3), {}});
  return judgement;
}

/// POM-POM contacts, pooled over ratios and seeds.
Judgement judge_t12(const Results& results) {
  Judgement judgement;
  for (const auto& [law, study] : laws_of_chapter_4) {
    const auto runs = results.runs(study);
    const PooledMode pom = pooled_mode(runs, "POM-POM", 2);
    const Value along = weighted_sum({{2, pooled_along(runs, "POM-POM", 2, 90)}}),
                all = weighted_sum({{2, pooled_along(runs, "", 2, 90)}});
    const std::vector<Draw> draws{{study, {}}};
    judgement.checks.push_back(
        drawn(draws, below(fmt::format("deviation of POM-POM orientations from the load axis, {}", law), "0",
                           angle_from(pom, 90, 180), 15, "deg")));
    judgement.checks.push_back(drawn(
        draws, positive(fmt::format("a_c of POM-POM contacts along the load (noise {:.2g}), {}", 2 * pom.noise, law),
                        "oriented along the load", along)));
    judgement.checks.push_back(drawn(
        draws, positive(fmt::format("a_c of POM-POM contacts minus that of all contacts, along the load, {}", law),
                        "> 0", difference(along, all))));
    judgement.checks.push_back(reported(fmt::format("a_c of all contacts along the load, {}", law), all));
    if (!runs.empty())
      judgement.ours += fmt::format("{}{}: a_c {} at {} degrees", judgement.ours.empty() ? "" : "; ", law,
                                    text_of(along), text_of(pom.phase_deg));
  }
  add_choices_of_ratios(judgement, results, "Signed a_c of POM-POM contacts", "fabric.sets.POM-POM.a_c_signed",
                        {wanted_positive(), wanted_positive(), {}});
  return judgement;
}

/// The strong contacts by type, as shares of all contacts: the types add up to the 40 % of T10. Who carries the largest
/// forces.
Judgement judge_t19(const Results& results) {
  const auto over_others = [](const char* statistic) {
    return [=](const Run& run) {
      const auto of = [&](const char* type) {
        const std::string name = fmt::format("force.by_type.{}", type);
        return run(name + ".mean_N") * (*statistic ? run(name + "." + statistic) : 1);
      };
      return of("POM-POM") / std::fmax(of("HDPE-HDPE"), of("HDPE-POM")) - 1;
    };
  };
  const auto asked = [&](const char* study) {
    const Hump mixed = hump_over_seeds(results.runs(study), number_ratio(), share_of_strong("HDPE-POM"));
    std::vector<Check> checks{
        slope_goes(results, study, "the share of all contacts that are strong and HDPE-HDPE",
                   share_of_strong("HDPE-HDPE"), +1),
        slope_goes(results, study, "the share of all contacts that are strong and POM-POM", share_of_strong("POM-POM"),
                   -1),
        positive("share of all contacts that are strong and POM-HDPE: its greatest minus that at the smallest ratio",
                 "first rises", mixed.rise),
        positive("share of all contacts that are strong and POM-HDPE: its greatest minus that at the largest ratio",
                 "then falls", mixed.fall),
        positive("largest force of POM-POM over that of the other types, minus 1", "> 0",
                 mean_over_seeds(results.runs(study), over_others("maximum")))};
    for (Check& check : checks) check.draws = {{study, {}}};
    return checks;
  };
  Judgement judgement;
  judgement.checks = asked(study_4);
  if (std::isfinite(judgement.checks[4].ours.value)) {
    for (const char* type : {"POM-POM", "HDPE-HDPE", "HDPE-POM"}) {
      const Series share = series(results, study_4, number_ratio(), share_of_strong(type));
      if (share.empty()) continue;
      judgement.ours +=
          fmt::format("{} {} to {}, ", type, text_of(value_of(share.front())), text_of(value_of(share.back())));
    }
    judgement.ours += fmt::format("largest force of POM-POM higher by {}", text_of(judgement.checks[4].ours));
  }
  judgement.checks.push_back(reported("mean force of POM-POM over the larger mean of the other types, minus 1",
                                      mean_over_seeds(results.runs(study_4), over_others(""))));
  for (const char* type : {"POM-POM", "HDPE-HDPE", "HDPE-POM"})
    judgement.checks.push_back(reported(
        fmt::format("slope of the fraction of {} contacts above the mean of all contacts against the ratio", type),
        slope(series(results, study_4, number_ratio(),
                     fmt::format("force.by_type.{}.fraction_above_mean_of_all", type)))));
  add_beside(judgement, "under law R", asked("thesis-ch4-r"));
  add_choices_of_ratios(judgement, results, "Share of all contacts that are strong and HDPE-HDPE",
                        share_of_strong("HDPE-HDPE"), {{}, {}, wanted_positive()});
  add_choices_of_ratios(judgement, results, "Share of all contacts that are strong and POM-POM",
                        share_of_strong("POM-POM"), {{}, {}, wanted_negative()});
  return judgement;
}

}  // namespace arenite::validation
