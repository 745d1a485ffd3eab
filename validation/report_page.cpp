// The ledger as a page of Markdown.
#include <fmt/core.h>

#include <algorithm>

#include "validation/report.hpp"
#include "validation/report_dots.hpp"
#include "validation/report_parts.hpp"

namespace arenite::validation {
namespace {

using validation::Check;
using validation::Judged;
using validation::Kind;
using validation::Outcome;
using validation::Verdict;

/// Bars would end a cell.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

/// As print has it.
std::string with_signs(std::string text) {
  for (std::size_t at = text.find("+-"); at != std::string::npos; at = text.find("+-", at)) text.replace(at, 2, "±");
  return text;
}

/// A heading's own link.
std::string anchor_of(std::string id) {
  for (char& c : id)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return id;
}

bool simply_reproduced(const Judged& judged) { return judged.judgement.verdict() == Verdict::reproduced; }

/// Of the studies those whose runs are not all there; otherwise that all are.
std::string runs_of(const std::vector<validation::StudyState>& studies) {
  std::string missing;
  std::size_t done = 0;
  for (const auto& study : studies) {
    done += study.done;
    if (study.done < study.runs || (study.runs == 0 && progress_of(study) == "not started"))
      missing += fmt::format("{}`{}` ({})", missing.empty() ? "" : ", ", study.name, progress_of(study));
  }
  return missing.empty() ? fmt::format("All {} runs of the studies are done.", done)
                         : "Runs are missing: " + missing + ".";
}

/// Which runs the verdicts are from.
std::string studies_of_ledger(const validation::Ledger& ledger) {
  std::string text = "\n## Runs\n\n| study | runs | ended |\n|---|---|---|\n";
  for (const auto& study : ledger.studies) {
    const bool one_day = study.first_day == study.last_day;
    const std::string days = one_day ? study.first_day : study.first_day + " to " + study.last_day;
    text += fmt::format("| {} | {} | {} |\n", study.name, progress_of(study), days);
  }
  return text;
}

/// "20 reproduced, 6 trend reproduced, numbers not, ...".
std::string counts(const validation::Ledger& ledger) {
  std::string text;
  for (const Verdict verdict : all_verdicts) {
    const auto count = std::count_if(ledger.claims.begin(), ledger.claims.end(),
                                     [=](const Judged& judged) { return judged.judgement.verdict() == verdict; });
    if (count > 0) text += fmt::format("{}{} *{}*", text.empty() ? "" : "; ", count, word_for(verdict));
  }
  return text;
}

std::string table_of(const validation::Ledger& ledger) {
  std::string text = "| claim | | source | ours | verdict | decided by | reason |\n|---|---|---|---|---|---|---|\n";
  for (const Judged& judged : ledger.claims) {
    const std::string id = judged.claim->id;
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} |\n",
        simply_reproduced(judged) ? id : fmt::format("[{}](#{})", id, anchor_of(id)), cell(judged.claim->sentence),
        cell(judged.claim->number), cell(with_signs(ours_text(judged.judgement))), word_for(judged.judgement.verdict()),
        word_for(decider_of(judged.judgement)), cell(with_signs(validation::what_decides(judged.judgement))));
  }
  return text;
}

/// Checks of the claim itself that do not simply hold.
std::string open_checks(const std::vector<Check>& checks) {
  std::string rows;
  for (const Check& check : checks)
    if (check.kind != Kind::beside && check.outcome != Outcome::holds)
      rows += fmt::format("| {} | {} | {} | {} | {} |\n", cell(with_signs(check.what)), cell(check.source),
                          cell(with_signs(ours_text(check))), cell(with_signs(check.wanted)), word_for(check.outcome));
  return rows.empty() ? rows : "\n| what | source | ours | required | |\n|---|---|---|---|---|\n" + rows;
}

std::string section_of(const Judged& judged, const std::string& pictures) {
  const auto& [claim, judgement] = judged;
  const std::string figure = validation::figure_place(*claim);
  std::string text =
      fmt::format("\n### {}\n\n**{}** (decided by: {}). {} ({}{}). {}", claim->id, word_for(judgement.verdict()),
                  word_for(decider_of(judgement)), claim->sentence, claim->where,
                  figure.empty() ? "" : fmt::format("; figure: `{}`", figure), validation::what_decides(judgement));
  for (const auto& finding : judgement.findings) text += " " + finding;
  text = with_signs(text) + "\n" + open_checks(judgement.checks);
  if (has_dots(judgement))
    text += fmt::format("\n![{}: open choices and the required range]({}/{}.svg)\n", claim->id, pictures, claim->id);
  return text;
}

}  // namespace

std::string ledger_page(const validation::Ledger& ledger, const std::string& pictures) {
  std::string text = fmt::format("{} {}.\n\n{}{}", runs_of(ledger.studies), counts(ledger), table_of(ledger),
                                 studies_of_ledger(ledger));
  const bool all = std::all_of(ledger.claims.begin(), ledger.claims.end(), simply_reproduced);
  if (!all) text += "\n## Claims not fully reproduced\n";
  for (const Judged& judged : ledger.claims)
    if (!simply_reproduced(judged)) text += section_of(judged, pictures);
  return text;
}

}  // namespace arenite::validation
