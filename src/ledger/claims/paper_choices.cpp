#include <fmt/format.h>

#include "ledger/claims/paper_runs.hpp"

namespace arenite::ledger {
namespace {

const Choice usual{{{"contact.friction", "0.3"}}, ""};

const std::vector<Choice> choices{
    {{{"contact.friction", "0"}}, "without friction"},
    {{{"contact.friction", "0.6"}}, "with friction 0.6"},
    {{{"contact.restitution", "0.4"}}, "with restitution 0.4"},
    {{{"bidisperse.hold_radius", "true"}}, "with radii held until they are placed"},
    {{{"bidisperse.cut_each_class", "true"}}, "with radii cut class by class"},
    {{{"cement.gap", "0.05"}}, "with neighbours at 2 instead of 3 nodes"},
};

}  // namespace

void add_choices(Judgement& judgement, const Results& results, const std::string& what, const Number& number, const WantedAtEnds& wanted, Filling filling) {
  for (const char* theta : {"1.4", "6"}) {
    const std::string at = fmt::format(", theta {}{}", theta, filling == Filling::part ? ", eta 0.4" : "");
    const auto of = [&](const char* gamma, const Where& choice) {
      Where where{{"bidisperse.size_ratio", gamma}, {"bidisperse.volume_ratio", theta}, {"cement.kind", filling == Filling::complete ? "full" : "bridges"}};
      where.insert(where.end(), choice.begin(), choice.end());
      return Value(mean(results, "paper-choices", number, where));
    };
    add_sensitivity(judgement, what + ", gamma 1" + at, usual, choices, [&](const Choice& choice) { return of("1", choice.where); }, wanted.first);
    add_sensitivity(judgement, what + ", gamma 5" + at, usual, choices, [&](const Choice& choice) { return of("5", choice.where); }, wanted.last);
    add_sensitivity(judgement, what + ", change from gamma 1 to 5" + at, usual, choices, [&](const Choice& choice) { return difference(of("5", choice.where), of("1", choice.where)); }, wanted.change);
  }
}

}  // namespace arenite::ledger
