#include "validation/sensitivity.hpp"

#include <cmath>

namespace arenite::validation {

Wanted wanted_above(double bound) {
  return [=](const Value& v) { return above("", "", v, bound); };
}
Wanted wanted_below(double bound) {
  return [=](const Value& v) { return below("", "", v, bound); };
}
Wanted wanted_between(double low, double high) {
  return [=](const Value& v) { return between("", "", v, low, high); };
}
Wanted wanted_within(double source, double tolerance) { return wanted_between(source - tolerance, source + tolerance); }
Wanted wanted_positive() { return wanted_above(0); }
Wanted wanted_negative() { return wanted_below(0); }
Wanted wanted_equivalent(double margin) {
  return [=](const Value& v) { return equivalent("", "", v, margin); };
}
Wanted wanted_different(double margin) {
  return [=](const Value& v) { return differs("", "", v, margin); };
}

void add_sensitivity(Judgement& judgement, const std::string& what, const Choice& usual,
                     const std::vector<Choice>& choices, const std::function<Value(const Choice&)>& value,
                     const Wanted& wanted) {
  const Check none = wanted ? wanted({}) : Check{};
  Sensitivity found{what, none.wanted, none.range, {}};
  const auto add = [&](const Choice& choice) {
    const Value v = value(choice);
    found.entries.push_back({choice.text, v, wanted ? wanted(v).outcome : Outcome::unknown, choice.kind});
  };
  add(usual);
  if (!std::isfinite(found.entries.front().value.value)) return;
  for (const Choice& choice : choices) add(choice);
  judgement.sensitivities.push_back(std::move(found));
}

}  // namespace arenite::validation
