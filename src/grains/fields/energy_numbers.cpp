#include <algorithm>
#include <cmath>

#include "grains/fields/stage_numbers.hpp"

namespace arenite::fields {
namespace {

using statistics::described;

/// What a term has changed by since the first row of the history, J.
double change_of(const History& history, const char* name) {
  const auto* values = history.find(name);
  return values && !values->empty() ? values->back() - values->front() : 0;
}

}  // namespace

Numbers energy_numbers(const StageEnd& end) {
  const History& history = end.result.history;
  double stored = 0, spent = 0, work = 0, turned_over = 0;
  for (const char* name : {"kinetic", "elastic", "adhesive"}) stored += change_of(history, name);
  for (const char* name : {"dissipated_normal", "dissipated_friction", "dissipated_drag", "dissipated_breakage"})
    spent += change_of(history, name);
  for (const char* name : {"work_walls", "work_gravity"}) {
    work += change_of(history, name);
    turned_over += std::abs(change_of(history, name));
  }
  if (spent == 0 && work == 0) return Numbers::tree();  // not tracked
  turned_over = std::max({turned_over, std::abs(stored), std::abs(spent)});
  const double open = std::abs(stored + spent - work) / turned_over;
  return {
      {"energy_balance",
       {{"turned_over_J", described(turned_over, "J", "Work, stored or dissipated energy of the stage, the largest")},
        {"open", described(open, "",
                           "What the balance leaves open, over that: below 1e-6 at a step of T_c/500, 4e-5 to 1.5e-3 "
                           "at the default one, T_c/10")},
        {"closed", described(open <= 0.01, "", "Whether that is at most 1 %")}}}};
}

}  // namespace arenite::fields
