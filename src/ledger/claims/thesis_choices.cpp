#include "ledger/claims/thesis_choices.hpp"

#include "ledger/final_texture.hpp"
#include "ledger/pooled.hpp"

namespace arenite::ledger {
namespace {

constexpr const char* stiffness_study = "thesis-choices-stiffness";

const Where usual{{"contact.friction", "0.3"}};

const std::vector<Choice> in_samples{
    {{{"contact.friction", "0"}}, "without friction"},
    {{{"contact.friction", "0.1"}}, "with friction 0.1"},
    {{{"contact.friction", "0.6"}}, "with friction 0.6"},
    {{{"contact.wall_friction", "0"}}, "with smooth walls"},
    {{{"contact.restitution", "0.2"}}, "with restitution 0.2"},
    {{{"contact.restitution", "0.9"}}, "with restitution 0.9"},
    {{{"integration.safety", "0.025"}}, "with half the time step"},
    {{{"stages.0.friction", "0"}}, "prepared without friction"},
    {{{"stages.1.gravity", "false"}, {"stages.1.bottom.force", ""}}, "without gravity"},
    {{{"stages.1.bottom.force", "5"}}, "under 5 kN"},
    {{{"stages.1.bottom.force", "0.5"}}, "under 0.5 kN without gravity"},
};

const std::vector<Choice> with_two_stiffnesses{
    {{{"contact.friction", "0"}}, "without friction"},
    {{{"contact.friction", "0.1"}}, "with friction 0.1"},
    {{{"contact.friction", "0.6"}}, "with friction 0.6"},
    {{{"contact.wall_friction", "0"}}, "with smooth walls"},
    {{{"contact.restitution", "0.2"}}, "with restitution 0.2"},
    {{{"contact.restitution", "0.7"}}, "with restitution 0.7"},
    {{{"integration.safety", "0.045"}}, "with half the time step"},
};

const std::vector<Choice> with_glue{
    {{{"contact.friction", "0"}}, "without friction"},
    {{{"contact.friction", "0.1"}}, "with friction 0.1"},
    {{{"contact.friction", "0.6"}}, "with friction 0.6"},
    {{{"contact.wall_friction", "0"}}, "with smooth walls"},
    {{{"contact.restitution", "0.9"}}, "with restitution 0.9"},
    {{{"contact.effective_radius", "sum"}}, "with r_eff = r_i + r_j"},
    {{{"contact.adhesion", "geometrical_breaking"}}, "with glue that breaks for good"},
    {{{"stages.1.gravity", "false"}}, "without gravity"},
    {{{"stages.1.bottom.force", "4"}}, "under 4 kN"},
};

/// The mean over the runs of a sample with a choice.
std::function<Value(const Where&)> mean_of(const Results& results, const char* study, const Where& sample, const Number& number) {
  return [=, &results](const Where& choice) {
    Where where = sample;
    where.insert(where.end(), choice.begin(), choice.end());
    return Value(mean(results, study, number, where));
  };
}

std::function<Value(const Where&)> of_sample(const Results& results, const std::string& pom_grains, const Number& number) {
  return mean_of(results, "thesis-choices", {{"populations.0.count", pom_grains}}, number);
}

}  // namespace

void add_choices(Judgement& judgement, const Results& results, const std::string& what, const std::string& pom_grains, const Number& number, const Wanted& wanted) {
  add_sensitivity(judgement, what, usual, in_samples, of_sample(results, pom_grains, number), wanted);
}

void add_choices_of_ratios(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const WantedAtEnds& wanted) {
  const auto first = of_sample(results, "500", number), last = of_sample(results, "91", number);
  add_sensitivity(judgement, what + " of 1000 grains at ratio 1", usual, in_samples, first, wanted.first);
  add_sensitivity(judgement, what + " of 1000 grains at ratio 10", usual, in_samples, last, wanted.last);
  add_sensitivity(judgement, what + ", change from ratio 1 to 10", usual, in_samples, [&](const Where& choice) { return difference(last(choice), first(choice)); }, wanted.change);
}

void add_stiffness_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const Wanted& wanted) {
  add_sensitivity(judgement, what + " of 1000 grains at k_A/k_B = 10", usual, with_two_stiffnesses, mean_of(results, stiffness_study, {{"materials.B.stiffness", "2.735"}}, number), wanted);
}

void add_stiffness_slope(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const Wanted& wanted) {
  const auto slope = [&](const Where& choice) { return slope_over_seeds(results.runs(stiffness_study, choice), stiffness_ratio, number); };
  add_sensitivity(judgement, what + " of 1000 grains, slope between k_A/k_B = 1 and 10", usual, with_two_stiffnesses, slope, wanted);
}

void add_glue_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const Wanted& wanted) {
  const auto glued_by = [&](const char* energy) { return mean_of(results, "thesis-choices-glue", {{"contact.surface_energy", energy}}, number); };
  add_sensitivity(judgement, what + ", with glue", usual, with_glue, glued_by("1.060"), wanted);
  add_sensitivity(judgement, what + ", with next to none", usual, with_glue, glued_by("0.000001"), {});
}

double stiffness_ratio(const Run& run) {
  constexpr double stiffness_a = 27.35;  // kN/mm, as in the studies' recipes
  return stiffness_a / run.key("materials.B.stiffness");
}

double mean_overlap(const std::vector<Run>& runs) {
  double sum = 0;
  for (const Run& run : runs) {
    const FinalState state = final_state(run);
    const Contacts& contacts = state.packing.contacts;
    double overlap = 0, count = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c)
      if (!contacts.is_wall(c)) overlap += contacts.overlap[c], ++count;
    sum += overlap / count / state.texture.mean_diameter;
  }
  return runs.empty() ? statistics::unknown : sum / static_cast<double>(runs.size());
}

}  // namespace arenite::ledger
