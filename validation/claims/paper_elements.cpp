#include "validation/claims/paper_elements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "validation/checks.hpp"

namespace arenite::validation {
namespace {

/// What makes two runs the same sample.
using SampleName = std::tuple<double, double, double, std::string>;
SampleName name_of_sample(const Run& run) { return {gamma_of(run), theta_of(run), cement_of(run), run.text("seed")}; }

Samples solved_by_elements(const Results& results) {
  Samples samples{results.runs("paper-elements"), {}};
  std::set<double> widths;
  for (const Run& run : samples.runs)
    if (const double width = cement_of(run); width != full) widths.insert(width);
  samples.widths.assign(widths.begin(), widths.end());
  return samples;
}

/// The same samples by bonds; none unless all of them are there.
Samples same_by_bonds(const Results& results, const Samples& by_elements) {
  std::set<SampleName> wanted;
  for (const Run& run : by_elements.runs) wanted.insert(name_of_sample(run));
  Samples samples = paper_samples(results);
  std::erase_if(samples.runs, [&](const Run& run) { return !wanted.contains(name_of_sample(run)); });
  if (samples.runs.size() != wanted.size()) samples.runs.clear();
  samples.widths = by_elements.widths;
  return samples;
}

bool is_decided(Outcome outcome) { return outcome == Outcome::holds || outcome == Outcome::fails; }

/// "large grains > 1: bonds 1.05 +- 0.01 (holds), elements 0.99 +- 0.01 (fails)".
std::string both_of(const Check& bonds, const Check& elements) {
  return fmt::format("{}: bonds {} ({}), elements {} ({})", bonds.what, text_of(bonds.ours), word_for(bonds.outcome),
                     text_of(elements.ours), word_for(elements.outcome));
}

}  // namespace

void add_elements(Judgement& judgement, const Results& results, const Asked& asked) {
  const Samples by_elements = solved_by_elements(results), by_bonds = same_by_bonds(results, by_elements);
  if (by_bonds.runs.empty()) return;
  const std::vector<Check> elements = asked(by_elements), bonds = asked(by_bonds);
  add_beside(judgement, "by elements", elements);
  std::size_t alike = 0, open = 0;
  std::string differ;
  for (std::size_t k = 0; k < std::min(elements.size(), bonds.size()); ++k) {
    const Outcome here = elements[k].outcome, there = bonds[k].outcome;
    if (here == Outcome::unknown || there == Outcome::unknown) continue;
    if (!is_decided(here) || !is_decided(there)) ++open;
    else if (here == there) ++alike;
    else differ += (differ.empty() ? "" : "; ") + both_of(bonds[k], elements[k]);
  }
  if (alike + open == 0 && differ.empty()) return;
  std::string finding = fmt::format(
      "Judged twice, by bonds and by elements in the same {} samples: {} checks end alike and are of the material",
      by_elements.runs.size(), alike);
  if (open > 0) finding += fmt::format(", {} are decided by one of them at most", open);
  finding += differ.empty() ? ", none is of the lattice." : fmt::format("; of the lattice: {}.", differ);
  judgement.findings.push_back(finding);
}

}  // namespace arenite::validation
