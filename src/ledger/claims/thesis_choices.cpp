#include "ledger/claims/thesis_choices.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ledger/final_texture.hpp"
#include "ledger/trends.hpp"

namespace arenite::ledger {
namespace {

struct Choice {
  Where where;
  const char* text;
};

const Choice usual{{{"contact.friction", "0.3"}}, ""};

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

void add(Judgement& judgement, const Results& results, const char* study, const std::string& what, const Where& sample, const std::vector<Choice>& choices, const Number& number) {
  const auto with = [&](const Choice& choice) {
    Where where = sample;
    where.insert(where.end(), choice.where.begin(), choice.where.end());
    return Value(mean(results, study, number, where));
  };
  const Value base = with(usual);
  if (!std::isfinite(base.value)) return;
  std::string sentence = fmt::format("{}: {}", what, text_of(base));
  for (const Choice& choice : choices)
    if (const Value value = with(choice); std::isfinite(value.value)) sentence += fmt::format(", {} {}", choice.text, text_of(value));
  judgement.findings.push_back(sentence + ".");
}

}  // namespace

void add_choices(Judgement& judgement, const Results& results, const std::string& what, const std::string& pom_grains, const Number& number) {
  add(judgement, results, "thesis-choices", what, {{"populations.0.count", pom_grains}}, in_samples, number);
}

void add_choices_of_ratios(Judgement& judgement, const Results& results, const std::string& what, const Number& number) {
  for (const auto& [grains, ratio] : {std::pair{"500", 1}, {"91", 10}}) add_choices(judgement, results, fmt::format("{} of 1000 grains at ratio {}", what, ratio), grains, number);
}

void add_stiffness_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number) {
  add(judgement, results, "thesis-choices-stiffness", what + " of 1000 grains at k_A/k_B = 10", {}, with_two_stiffnesses, number);
}

void add_glue_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number) {
  add(judgement, results, "thesis-choices-glue", what + ", with glue", {{"contact.surface_energy", "1.060"}}, with_glue, number);
  add(judgement, results, "thesis-choices-glue", what + ", with next to none", {{"contact.surface_energy", "0.000001"}}, with_glue, number);
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
