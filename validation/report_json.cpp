// The ledger for programs: JSON, and CSV of all checks or of the verdicts alone.
#include <fmt/core.h>

#include <cmath>
#include <map>

#include "core/error.hpp"
#include "io/table/table.hpp"
#include "statistics/numbers.hpp"
#include "validation/report.hpp"
#include "validation/report_parts.hpp"

namespace arenite::validation {
namespace {

using io::quoted_cell;
using validation::Check;
using validation::Sensitivity;

/// Says of the verdicts of small studies what they are not.
const char* size_of(bool small) {
  return small ? "the small studies (for tests only, not the ledger)" : "the full studies";
}

void put(Numbers& one, const char* name, const validation::Value& value) {
  if (!std::isfinite(value.value)) return;
  one[name] = value.value;
  if (std::isfinite(value.error)) one["error"] = value.error;
  if (std::isfinite(value.error) && std::isfinite(value.freedom)) one["freedom"] = value.freedom;
}

Numbers json_of(const std::vector<Check>& checks) {
  Numbers list = Numbers::list();
  for (const Check& check : checks) {
    Numbers one{{"what", check.what},
                {"kind", word_for(check.kind)},
                {"source", check.source},
                {"wanted", check.wanted},
                {"outcome", word_for(check.outcome)}};
    put(one, "ours", check.ours);
    if (!check.unit.empty()) one["unit"] = check.unit;
    list.push_back(std::move(one));
  }
  return list;
}

Numbers json_of(const std::vector<Sensitivity>& sensitivities) {
  Numbers list = Numbers::list();
  for (const Sensitivity& found : sensitivities) {
    Numbers entries = Numbers::list();
    for (const auto& entry : found.entries) {
      if (!std::isfinite(entry.value.value)) continue;
      Numbers one{{"choice", entry.choice}};
      put(one, "value", entry.value);
      if (!found.wanted.empty()) one["outcome"] = word_for(entry.outcome);
      entries.push_back(std::move(one));
    }
    Numbers one{{"what", found.what}, {"entries", entries}};
    if (!found.wanted.empty()) one["wanted"] = found.wanted;
    list.push_back(std::move(one));
  }
  return list;
}

std::string csv_cell(double number) { return std::isfinite(number) ? fmt::format("{:.6g}", number) : ""; }

std::string row(const char* claim, const char* kind, const std::string& what, const std::string& choice,
                const std::string& source, const std::string& wanted, const validation::Value& ours,
                const std::string& unit, const char* outcome, const char* decider = "") {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", claim, kind, quoted_cell(what), quoted_cell(choice),
                     quoted_cell(source), quoted_cell(wanted), csv_cell(ours.value), csv_cell(ours.error),
                     std::isfinite(ours.error) ? csv_cell(ours.freedom) : "", quoted_cell(unit), quoted_cell(outcome),
                     decider);
}

}  // namespace

std::string ledger_json(const validation::Ledger& ledger) {
  Numbers studies = Numbers::tree(), claims = Numbers::tree();
  for (const auto& study : ledger.studies) {
    studies[study.name] = {{"runs", study.runs}, {"done", study.done}};
    if (study.first_day.empty()) continue;
    studies[study.name]["first_day"] = study.first_day;
    studies[study.name]["last_day"] = study.last_day;
  }
  for (const auto& [claim, judgement] : ledger.claims)
    claims[claim->id] = {{"where", claim->where},
                         {"sentence", claim->sentence},
                         {"figure", validation::figure_place(*claim)},
                         {"verdict", word_for(judgement.verdict())},
                         {"decider", word_for(decider_of(judgement))},
                         {"source", claim->number},
                         {"ours", ours_text(judgement)},
                         {"decides", validation::what_decides(judgement)},
                         {"checks", json_of(judgement.checks)},
                         {"findings", judgement.findings},
                         {"sensitivity", json_of(judgement.sensitivities)}};
  return to_json(Numbers{{"studies", studies}, {"claims", claims}}, 1) + "\n";
}

std::string ledger_csv(const validation::Ledger& ledger) {
  std::string text = "claim,kind,what,choice,source,wanted,ours,error,freedom,unit,outcome,decider\n";
  for (const auto& [claim, judgement] : ledger.claims) {
    text += row(claim->id, "claim", claim->sentence, "", claim->number, "", {}, "", word_for(judgement.verdict()),
                word_for(decider_of(judgement)));
    for (const Check& c : judgement.checks)
      text += row(claim->id, word_for(c.kind), c.what, "", c.source, c.wanted, c.ours, c.unit,
                  c.wanted.empty() ? "" : word_for(c.outcome));
    for (const Sensitivity& found : judgement.sensitivities)
      for (const auto& entry : found.entries)
        if (std::isfinite(entry.value.value))
          text += row(claim->id, "choice", found.what, entry.choice.empty() ? "reference" : entry.choice, "",
                      found.wanted, entry.value, "", found.wanted.empty() ? "" : word_for(entry.outcome),
                      entry.choice.empty() ? "" : word_for(entry.kind));
  }
  return text;
}

std::string ledger_verdicts(const validation::Ledger& ledger, bool small) {
  std::string text = fmt::format("claim,verdict\nof,{}\n", quoted_cell(size_of(small)));
  for (const auto& [claim, judgement] : ledger.claims)
    text += fmt::format("{},{}\n", claim->id, quoted_cell(word_for(judgement.verdict())));
  return text;
}

std::vector<std::string> changed_verdicts(const validation::Ledger& ledger, const std::string& expected,
                                          const std::string& file, bool small) {
  Problems problems;
  std::map<std::string, std::string> wanted;
  for (const auto& row : io::read_table(expected, "", problems).rows)
    if (row.cells.size() == 2) wanted.emplace(row.cells[0], row.cells[1]);
  const auto size = wanted.find("of");
  if (size == wanted.end())
    throw InputError(file, 0, "this file holds no verdicts; write one with `arenite verify --verdicts FILE`");
  if (size->second != size_of(small))
    throw InputError(
        file, 0,
        fmt::format("these are verdicts of {}, to be compared with those of {}", size->second, size_of(small)));
  std::vector<std::string> changes;
  for (const auto& [claim, judgement] : ledger.claims) {
    const auto at = wanted.find(claim->id);
    const std::string before = at == wanted.end() ? "missing" : at->second, now = word_for(judgement.verdict());
    if (before != now) changes.push_back(fmt::format("{}: {} now, {} in {}", claim->id, now, before, file));
  }
  return changes;
}

}  // namespace arenite::validation
