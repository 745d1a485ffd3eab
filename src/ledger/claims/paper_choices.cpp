#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/paper_runs.hpp"

namespace arenite::ledger {
namespace {

constexpr const char* study = "paper-choices";

struct Choice {
  const char *key, *value, *text;
};

constexpr Choice usual{"contact.friction", "0.3", ""};
constexpr Choice others[] = {
    {"contact.friction", "0", "without friction"},
    {"contact.friction", "0.6", "with friction 0.6"},
    {"contact.restitution", "0.4", "with restitution 0.4 instead of 0.7"},
    {"bidisperse.hold_radius", "true", "with radii held until they are placed"},
    {"bidisperse.cut_each_class", "true", "with radii cut class by class"},
    {"cement.gap", "0.05", "with neighbours at 2 instead of 3 nodes"},
};

}  // namespace

void add_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number, Filling filling) {
  const char* kind = filling == Filling::complete ? "full" : "bridges";
  for (const char* gamma : {"1", "5"})
    for (const char* theta : {"1.4", "6"}) {
      const auto with = [&](const Choice& choice) {
        return Value(mean(results, study, number, {{"bidisperse.size_ratio", gamma}, {"bidisperse.volume_ratio", theta}, {"cement.kind", kind}, {choice.key, choice.value}}));
      };
      const Value base = with(usual);
      if (!std::isfinite(base.value)) continue;
      std::string sentence = fmt::format("{} at gamma {}, theta {}{}: {}", what, gamma, theta, filling == Filling::part ? ", eta 0.4" : "", text_of(base));
      for (const Choice& choice : others)
        if (const Value value = with(choice); std::isfinite(value.value)) sentence += fmt::format(", {} {}", choice.text, text_of(value));
      judgement.findings.push_back(sentence + ".");
    }
}

}  // namespace arenite::ledger
