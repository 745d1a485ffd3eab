#include "validation/claims/thesis_choices.hpp"

#include <algorithm>

#include "validation/borders.hpp"
#include "validation/final_texture.hpp"
#include "validation/pooled.hpp"

namespace arenite::validation {
namespace {

constexpr double narrow = 0, wide = 5;  // strips left out along the walls, in mean diameters; usually 2.5
constexpr const char* least_ratio = "1";
constexpr const char* greatest_ratio = "10";

const Choice without_friction{{{"contact.friction", "0"}}, "without friction"};

/// Choices of friction, others, then the same states with other borders of the usual study.
std::vector<Choice> choices_of(const std::string& usual_study, const Choice& frictionless,
                               const std::vector<Choice>& others) {
  std::vector<Choice> choices{frictionless,
                              {{{"contact.friction", "0.1"}}, "with friction 0.1"},
                              {{{"contact.friction", "0.6"}}, "with friction 0.6"},
                              {{{"contact.wall_friction", "0"}}, "with smooth walls"}};
  choices.insert(choices.end(), others.begin(), others.end());
  choices.push_back({{}, "without a border", with_border(usual_study, narrow), Decider::reading});
  choices.push_back({{}, "with a border of 5 diameters", with_border(usual_study, wide), Decider::reading});
  return choices;
}

const std::vector<Choice>& in_samples() {
  static const auto choices =
      choices_of("thesis-ch3", without_friction,
                 {
                     {{{"contact.friction_law", "regularised_coulomb"}}, "with law R"},
                     {{{"contact.restitution", "0.2"}}, "with restitution 0.2"},
                     {{{"contact.restitution", "0.9"}}, "with restitution 0.9"},
                     {{{"integration.safety", "0.025"}}, "with half the time step"},
                     {{{"stages.1.equilibrium.unbalanced", "1e-6"}}, "with a 100 times stricter equilibrium"},
                     {{{"stages.0.friction", "0"}, {"contact.friction_law", ""}}, "with frictionless preparation"},
                     {{{"stages.1.gravity", "false"}, {"stages.1.bottom.force", ""}}, "without gravity"},
                     {{{"stages.1.bottom.force", "200"}}, "under 200 kN"},
                     {{{"stages.1.bottom.force", "5"}}, "under 5 kN"},
                     {{{"stages.1.bottom.force", "0.5"}}, "under 0.5 kN without gravity"},
                 });
  return choices;
}

const std::vector<Choice>& at_number_ratios() {
  static const auto choices =
      choices_of("thesis-ch4", without_friction,
                 {
                     {{}, "with law R", "thesis-ch4-r"},
                     {{{"contact.restitution", "0.2"}}, "with restitution 0.2"},
                     {{{"stages.1.equilibrium.unbalanced", "1e-6"}}, "with a 100 times stricter equilibrium"},
                     {{{"packing.solid_fraction", "0.76"}}, "from a solid fraction of 0.76"},
                     {{{"stages.0.friction", "0"}}, "with frictionless preparation"},
                     {{{"container.width", "350"}}, "in a box of 350 mm"},
                     {{{"stages.1.bottom.force", "200"}}, "under 200 kN"},
                 });
  return choices;
}

const std::vector<Choice>& with_two_stiffnesses() {
  static const auto choices =
      choices_of("thesis-ch5", {{}, "without friction", "thesis-ch5-smooth"},
                 {
                     {{}, "with law R", "thesis-ch5-r"},
                     {{{"contact.restitution", "0.2"}}, "with restitution 0.2"},
                     {{{"contact.restitution", "0.7"}}, "with restitution 0.7"},
                     {{{"integration.safety", "0.045"}}, "with half the time step"},
                     {{{"stages.0.equilibrium.unbalanced", "1e-6"}}, "with a 100 times stricter equilibrium"},
                 });
  return choices;
}

const std::vector<Choice>& with_glue() {
  static const auto choices = choices_of(
      "thesis-ch6", without_friction,
      {
          {{{"contact.friction_law", "regularised_coulomb"}}, "with law R"},
          {{{"contact.restitution", "0.9"}}, "with restitution 0.9"},
          {{{"contact.effective_radius", "sum"}}, "with r_eff = r_i + r_j", "", Decider::reading},
          {{{"contact.effective_radius", "geometric_mean"}}, "with r_eff = 2 sqrt(r_i r_j)", "", Decider::reading},
          {{{"contact.adhesion", "geometrical_breaking"}}, "with glue that breaks for good"},
          {{{"stages.1.equilibrium.unbalanced", "1e-6"}}, "with a 100 times stricter equilibrium"},
          {{{"stages.1.gravity", "false"}}, "without gravity"},
          {{{"stages.1.bottom.force", "200"}}, "under 200 kN"},
          {{{"stages.1.bottom.force", "4"}}, "under 4 kN"},
      });
  return choices;
}

/// The mean over the runs of a sample with a choice, of the study of choices unless the choice names another.
std::function<Value(const Choice&)> mean_of(const Results& results, const std::string& study, const Where& sample,
                                            const Number& number) {
  return [=, &results](const Choice& choice) {
    Where where = sample;
    where.insert(where.end(), choice.where.begin(), choice.where.end());
    return mean(results, choice.study.empty() ? study : choice.study, number, where);
  };
}

bool is_one_of(const std::string& value, std::initializer_list<const char*> wanted) {
  return std::any_of(wanted.begin(), wanted.end(), [&](const char* one) { return value == one; });
}

}  // namespace

void add_choices(Judgement& judgement, const Results& results, const std::string& what, const LaboratorySample& sample,
                 const Number& number, const Wanted& wanted) {
  add_sensitivity(judgement, what, {{}, "", "thesis-ch3"}, in_samples(),
                  mean_of(results, "thesis-choices", where(sample), number), wanted);
}

void add_choices_of_ratios(Judgement& judgement, const Results& results, const std::string& what, const Number& number,
                           const WantedAtEnds& wanted) {
  const auto at = [&](const char* ratio) {
    return mean_of(results, "thesis-choices-ratio", {{"populations.1.ratio", ratio}}, number);
  };
  const auto first = at(least_ratio), last = at(greatest_ratio);
  const Choice usual{{}, "", "thesis-ch4"};
  add_sensitivity(judgement, what + " at ratio 1", usual, at_number_ratios(), first, wanted.first);
  add_sensitivity(judgement, what + " at ratio 10", usual, at_number_ratios(), last, wanted.last);
  add_sensitivity(
      judgement, what + ", change from ratio 1 to 10", usual, at_number_ratios(),
      [&](const Choice& choice) { return difference(last(choice), first(choice)); }, wanted.change);
}

void add_stiffness_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number,
                           const Wanted& wanted) {
  add_sensitivity(judgement, what + " at k_A/k_B = 10", {{}, "", "thesis-ch5"}, with_two_stiffnesses(),
                  mean_of(results, "thesis-choices-stiffness", {{"materials.B.stiffness", "2.735"}}, number), wanted);
}

void add_stiffness_change(Judgement& judgement, const Results& results, const std::string& what,
                          Value (*change)(const std::vector<Run>&, const Number&), const Number& number,
                          const Wanted& wanted) {
  const auto of = [&](const Choice& choice) {
    return change(results.runs(choice.study.empty() ? "thesis-choices-stiffness" : choice.study, choice.where), number);
  };
  add_sensitivity(judgement, what, {{}, "", "thesis-ch5"}, with_two_stiffnesses(), of, wanted);
}

void add_glue_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number,
                      const Wanted& wanted) {
  const auto glued_by = [&](const char* energy) {
    return mean_of(results, "thesis-choices-glue", {{"contact.surface_energy", energy}}, number);
  };
  const Choice usual{{}, "", "thesis-ch6"};
  add_sensitivity(judgement, what + ", with glue", usual, with_glue(), glued_by("1.060"), wanted);
  add_sensitivity(judgement, what + ", almost without glue", usual, with_glue(), glued_by("0.000001"), {});
}

void add_change_by_glue(Judgement& judgement, const Results& results, const std::string& what, const Number& number,
                        const Wanted& wanted) {
  const auto of = [&](const Choice& choice) {
    const auto runs = [&](const char* energy) {
      Where where{{"contact.surface_energy", energy}};
      where.insert(where.end(), choice.where.begin(), choice.where.end());
      return results.runs(choice.study.empty() ? "thesis-choices-glue" : choice.study, where);
    };
    return paired_change(runs("1.060"), runs("0.000001"), number);
  };
  add_sensitivity(judgement, what, {{}, "", "thesis-ch6"}, with_glue(), of, wanted);
}

void measure_with_other_borders(Results& results) {
  const auto all = [](const Run&) { return true; };
  const auto at_ends = [](const Run& run) {
    return is_one_of(run.text("populations.1.ratio"), {least_ratio, greatest_ratio});
  };
  const auto of_three = [](const Run& run) {
    return is_one_of(run.text("materials.B.stiffness"), {"27.35", "6.8375", "2.735"});
  };
  const auto of_samples = [](const Run& run) {
    return is_one_of(run.text("populations.0.count"),
                     {sample_2.pom_grains, sample_8.pom_grains, sample_11.pom_grains, sample_12.pom_grains});
  };
  for (const double border : {narrow, wide}) {
    add_with_border(results, "thesis-ch3", border, of_samples);
    add_with_border(results, "thesis-ch4", border, at_ends);
    add_with_border(results, "thesis-ch5", border, of_three);
    add_with_border(results, "thesis-ch6", border, all);
  }
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

}  // namespace arenite::validation
