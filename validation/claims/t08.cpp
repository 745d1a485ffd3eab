#include <fmt/core.h>

#include "validation/claims/chapter4.hpp"
#include "validation/claims/claims.hpp"
#include "validation/claims/thesis_choices.hpp"
#include "validation/trends.hpp"

namespace arenite::validation {
namespace {

Value first_of(const Series& points) { return points.empty() ? Value() : value_of(points.front()); }
Value last_of(const Series& points) { return points.size() < 2 ? Value() : value_of(points.back()); }

/// What ratios differ in beside.
void tell_ends(Judgement& judgement, const char* law, const Results& results, const char* study) {
  const Series loose = series(results, study, number_ratio(), "coordination.rattlers");
  if (loose.size() < 2) return;
  const auto overlap = [&](double ratio) {
    return mean_overlap(results.runs(study, {{"populations.1.ratio", fmt::format("{:g}", ratio)}}));
  };
  for (const Point& end : {loose.front(), loose.back()}) {
    judgement.checks.push_back(
        reported(fmt::format("fraction of rattlers at ratio {:g}, {}", end.x, law), value_of(end)));
    judgement.checks.push_back(
        reported(fmt::format("mean overlap over diameter at ratio {:g}, {}", end.x, law), {overlap(end.x)}));
  }
  judgement.checks.push_back(
      reported(fmt::format("mean |F_t|/F_n, {}", law),
               mean_over_seeds(results.runs(study), "stages.load.last_state.equilibrium.mobilisation")));
}

}  // namespace

/// z at 50 kN against the number ratio: a monotone rise, of all grains and of those that bear.
Judgement judge_t8(const Results& results) {
  Judgement judgement;
  for (const auto& [law, study] : laws_of_chapter_4) {
    const Series z = series(results, study, number_ratio(), "coordination.all"),
                 bearing = series(results, study, number_ratio(), "coordination.without_rattlers");
    for (Check check :
         {monotone(fmt::format("slope of z against the ratio, {}", law), "rises", z, +1),
          monotone(fmt::format("slope of z without rattlers against the ratio, {}", law), "rises", bearing, +1),
          number(within(fmt::format("z at the smallest ratio, {}", law), first_of(z), 4.3, 0.1)),
          number(within(fmt::format("z at the largest ratio, {}", law), last_of(z), 4.9, 0.1))})
      judgement.checks.push_back(drawn({{study, {}}}, std::move(check)));
    judgement.checks.push_back(
        reported(fmt::format("z without rattlers at the smallest ratio, {}", law), first_of(bearing)));
    judgement.checks.push_back(
        reported(fmt::format("z without rattlers at the largest ratio, {}", law), last_of(bearing)));
    tell_ends(judgement, law, results, study);
    if (z.size() > 1)
      judgement.ours += fmt::format("{}{}: {} to {}", judgement.ours.empty() ? "" : "; ", law, text_of(first_of(z)),
                                    text_of(last_of(z)));
  }
  add_choices_of_ratios(judgement, results, "z", "coordination.all",
                        {wanted_within(4.3, 0.1), wanted_within(4.9, 0.1), wanted_positive()});
  add_choices_of_ratios(judgement, results, "z without rattlers", "coordination.without_rattlers",
                        {{}, {}, wanted_positive()});
  return judgement;
}

}  // namespace arenite::validation
