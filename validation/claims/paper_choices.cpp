#include "validation/claims/paper_choices.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace arenite::validation {
namespace {

constexpr const char* choices_study = "paper-choices";

const std::vector<Choice> open_choices{
    {{{"contact.friction", "0"}}, "without friction"},
    {{{"contact.friction", "0.6"}}, "with friction 0.6"},
    {{{"contact.restitution", "0.4"}}, "with restitution 0.4"},
    {{{"stages.1.equilibrium.unbalanced", "1e-3"}}, "with equilibrium at 1e-3"},
    {{{"stages.1.equilibrium.unbalanced", "1e-6"}}, "with equilibrium at 1e-6"},
    {{{"bidisperse.trials", "100"}}, "with 100 trials per disk", "", Decider::reading},
    {{{"bidisperse.maximal", "true"}}, "with every gap filled", "", Decider::reading},
    {{{"bidisperse.hold_radius", "true"}}, "with radii kept until placed", "", Decider::reading},
    {{{"bidisperse.truncate_each_class", "true"}}, "with radii truncated by class", "", Decider::reading},
    {{{"cement.gap", "0.05"}}, "with a neighbour gap of 2 nodes (not 3)", "", Decider::reading},
    {{{"grid.nodes", "1280"}}, "with a crop of 32 rbar_L", "", Decider::grid},
    {{{"grid.nodes", "512"}}, "with 512 nodes", "", Decider::grid},
    {{{"grid.nodes", "2048"}}, "with 2048 nodes", "", Decider::grid},
};

using Place = std::tuple<double, double, double>;

Place place_of(const Run& run) { return {gamma_of(run), theta_of(run), cement_of(run)}; }

/// The usual runs at the pairs and cements that choices are made at.
Samples where_chosen(const Results& results) {
  std::set<Place> places;
  for (const Run& run : results.runs(choices_study)) places.insert(place_of(run));
  Samples usual = paper_samples(results);
  std::erase_if(usual.runs, [&](const Run& run) { return !places.contains(place_of(run)); });
  return usual;
}

/// Samples at the place that has fewest.
std::size_t samples_a_place(const std::vector<Run>& runs) {
  std::map<Place, std::size_t> count;
  for (const Run& run : runs) ++count[place_of(run)];
  const auto fewest =
      std::min_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return fewest == count.end() ? 0 : fewest->second;
}

/// The runs with a choice, if there are any at every place: a statistic over some of the pairs would be another one.
Samples chosen(const Results& results, const Where& choice, const Samples& usual) {
  Samples samples{results.runs(choices_study, choice), usual.widths};
  std::set<Place> wanted, there;
  for (const Run& run : usual.runs) wanted.insert(place_of(run));
  for (const Run& run : samples.runs) there.insert(place_of(run));
  if (wanted != there) samples.runs.clear();
  return samples;
}

/// Once a claim.
void tell_samples(Judgement& judgement, const Results& results, const Samples& usual) {
  std::size_t fewest = 0;
  for (const Choice& choice : open_choices)
    if (const std::size_t here = samples_a_place(chosen(results, choice.where, usual).runs); here > 0)
      fewest = fewest == 0 ? here : std::min(fewest, here);
  const std::string note =
      fmt::format("Open choices (below): {} samples per pair with the reference settings, {} with each choice.",
                  samples_a_place(usual.runs), fewest);
  if (std::find(judgement.findings.begin(), judgement.findings.end(), note) == judgement.findings.end())
    judgement.findings.push_back(note);
}

void tell_difference(Judgement& judgement, const std::string& what, const Check& everywhere, const Check& there) {
  if (everywhere.outcome == there.outcome || everywhere.outcome == Outcome::unknown) return;
  judgement.findings.push_back(fmt::format(
      "{}: {} ({}) over all pairs, {} ({}) over those for which choices were varied.", what, text_of(everywhere.ours),
      word_for(everywhere.outcome), text_of(there.ours), word_for(there.outcome)));
}

}  // namespace

void add_choices(Judgement& judgement, const Results& results, const std::string& what,
                 const std::function<Value(const Samples&)>& value, const Wanted& wanted) {
  const Samples usual = where_chosen(results);
  if (usual.runs.empty() || !std::isfinite(value(usual).value)) return;
  tell_samples(judgement, results, usual);
  if (wanted) tell_difference(judgement, what, wanted(value(paper_samples(results))), wanted(value(usual)));
  const Choice as_it_is{};
  add_sensitivity(
      judgement, what, as_it_is, open_choices,
      [&](const Choice& choice) { return value(choice.where.empty() ? usual : chosen(results, choice.where, usual)); },
      wanted);
}

}  // namespace arenite::validation
