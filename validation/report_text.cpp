// The ledger at a terminal.
#include <fmt/core.h>

#include <cmath>

#include "validation/report.hpp"
#include "validation/report_parts.hpp"
#include "validation/studies.hpp"

namespace arenite::validation {
namespace {

using validation::Check;
using validation::Judged;
using validation::Outcome;
using validation::Sensitivity;

std::string line_of(const Check& check) {
  if (check.wanted.empty()) return fmt::format("    {:<9} {}: {}\n", "", check.what, ours_text(check));
  return fmt::format("    {:<9} {}: {} (source {}, required {}; {})\n", word_for(check.outcome), check.what,
                     ours_text(check), check.source, check.wanted, word_for(check.kind));
}

std::string line_of(const Sensitivity& found) {
  std::string text =
      fmt::format("    {}{}: {}", found.what, found.wanted.empty() ? "" : fmt::format(" (required {})", found.wanted),
                  validation::text_of(found.entries.front().value));
  for (std::size_t k = 1; k < found.entries.size(); ++k) {
    const auto& entry = found.entries[k];
    if (!std::isfinite(entry.value.value)) continue;
    text += fmt::format("; {} {}", entry.choice, validation::text_of(entry.value));
    if (!found.wanted.empty()) text += fmt::format(" ({})", word_for(entry.outcome));
  }
  return text + "\n";
}

}  // namespace

std::string ours_text(const Check& check) {
  const std::string text = validation::text_of(check.ours);
  return check.unit.empty() || !std::isfinite(check.ours.value) ? text : text + " " + check.unit;
}

std::string ours_text(const validation::Judgement& judgement) {
  if (!judgement.ours.empty()) return judgement.ours;
  const Check* check = validation::deciding_check(judgement);
  if (!check) return "not known";
  return std::isfinite(check->ours.value) ? fmt::format("{}: {}", check->what, ours_text(*check)) : "not known";
}

std::string progress_of(const validation::StudyState& study) {
  if (study.runs > 0) return fmt::format("{} of {} runs done", study.done, study.runs);
  const auto* source = validation::find_study(study.name);
  return source && source->has_runs() ? "not started" : "tables of the source";
}

std::string ledger_text(const validation::Ledger& ledger) {
  std::string text;
  for (const auto& study : ledger.studies) text += fmt::format("{:<24} {}\n", study.name, progress_of(study));
  for (const Judged& judged : ledger.claims) {
    const validation::Judgement& judgement = judged.judgement;
    text += fmt::format("\n{}  {}\n  {}\n  {} (decided by: {}): source {}, ours {}\n  {}\n", judged.claim->id,
                        judged.claim->sentence, judged.claim->where, word_for(judgement.verdict()),
                        word_for(decider_of(judgement)), judged.claim->number, ours_text(judgement),
                        validation::what_decides(judgement));
    for (const Check& check : judgement.checks) text += line_of(check);
    for (const auto& finding : judgement.findings) text += fmt::format("  {}\n", finding);
    if (!judgement.sensitivities.empty()) text += "  open choices, one at a time:\n";
    for (const auto& found : judgement.sensitivities) text += line_of(found);
    if (const std::string figure = validation::figure_place(*judged.claim); !figure.empty())
      text += fmt::format("  figure: {}\n", figure);
  }
  return text;
}

}  // namespace arenite::validation
