#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "grains/fields/loading.hpp"
#include "grains/fields/stage_numbers.hpp"

namespace arenite::fields {
namespace {

using statistics::described;

/// What a term has changed by since the first row of the history, J.
double change_of(const History& history, const char* name) {
  const auto* values = history.find(name);
  return values && !values->empty() ? values->back() - values->front() : 0;
}

/// Whether dissipation and work were added up on the way.
bool are_tracked(const History& history) {
  return std::ranges::any_of(energy_terms, [&](const EnergyTerm& term) {
    const auto* values = term.tracked ? history.find(term.name) : nullptr;
    return values && std::ranges::any_of(*values, [](double v) { return v != 0; });
  });
}

std::vector<const char*> names_of(EnergyRole role) {
  std::vector<const char*> names;
  for (const EnergyTerm& term : energy_terms)
    if (term.role == role) names.push_back(term.name);
  if (exchange_term.role == role) names.push_back(exchange_term.name);
  return names;
}

}  // namespace

Numbers energy_numbers(const StageEnd& end) { return energy_balance(end.result.history); }

Numbers energy_balance(const History& history) {
  if (!are_tracked(history)) return Numbers::tree();
  double stored = 0, spent = 0, work = 0, turned_over = 0;
  for (const char* name : names_of(EnergyRole::stored)) stored += change_of(history, name);
  for (const char* name : names_of(EnergyRole::spent)) spent += change_of(history, name);
  for (const char* name : names_of(EnergyRole::supplied)) {
    work += change_of(history, name);
    turned_over += std::abs(change_of(history, name));
  }
  turned_over = std::max({turned_over, std::abs(stored), std::abs(spent)});
  const double open = std::abs(stored + spent - work) / turned_over;
  return {
      {"energy_balance",
       {{"turned_over_J", described(turned_over, "J", "Work, stored or dissipated energy of the stage, the largest")},
        {"open", described(open, "", "What the balance leaves open, over that; less at a shorter step")},
        {"closed", described(open <= 0.01, "", "Whether that is at most 1 %")}}}};
}

statistics::Columns energies_of(const History& rows) {
  using Values = std::vector<double>;
  statistics::Columns found;
  if (!are_tracked(rows)) return found;
  const auto sum = [&](EnergyRole role) {
    Values total;
    for (const char* name : names_of(role))
      if (const Values* values = rows.find(name)) {
        total.resize(values->size(), 0.0);
        for (std::size_t k = 0; k < total.size(); ++k) total[k] += (*values)[k];
      }
    return total;
  };
  Values spent = sum(EnergyRole::spent), work = sum(EnergyRole::supplied);
  const std::size_t rows_there = std::max(spent.size(), work.size());
  for (Values* values : {&spent, &work}) {
    values->resize(rows_there, 0.0);
    const double first = values->front();
    for (double& v : *values) v -= first;
  }
  const char* const work_sentence =
      rows.find("exchanged")
          ? "Work of sides and gravity, and energy brought by grains that came in less that of those "
            "that left, since the first row"
          : "Work of sides and gravity since the first row";
  found.put("dissipated_energy", "J", "Energy dissipated since the first row", std::move(spent));
  found.put("work", "J", work_sentence, std::move(work));
  return found;
}

}  // namespace arenite::fields
