#include "ledger/sensitivity.hpp"

#include <cmath>

namespace arenite::ledger {

Wanted wanted_above(double bound) {
  return [=](const Value& v) { return above("", "", v, bound); };
}
Wanted wanted_below(double bound) {
  return [=](const Value& v) { return below("", "", v, bound); };
}
Wanted wanted_between(double low, double high) {
  return [=](const Value& v) { return between("", "", v, low, high); };
}
Wanted wanted_within(double source, double tolerance) {
  return wanted_between(source - tolerance, source + tolerance);
}
Wanted wanted_positive() {
  return [](const Value& v) { return positive("", "", v); };
}
Wanted wanted_negative() {
  return [](const Value& v) { return negative("", "", v); };
}
Wanted wanted_none() {
  return [](const Value& v) { return none("", "", v); };
}

void add_sensitivity(Judgement& judgement, const std::string& what, const Choice& usual, const std::vector<Choice>& choices,
                     const std::function<Value(const Choice&)>& value, const Wanted& wanted) {
  Sensitivity found{what, wanted ? wanted({}).tolerance : std::string(), {}};
  const auto add = [&](const Choice& choice) {
    const Value v = value(choice);
    found.entries.push_back({choice.text, v.value, v.error, wanted ? wanted(v).holds : Holds::unknown});
  };
  add(usual);
  if (!std::isfinite(found.entries.front().value)) return;
  for (const Choice& choice : choices) add(choice);
  judgement.sensitivities.push_back(std::move(found));
}

}  // namespace arenite::ledger
