// The ledger for programs: JSON, CSV and the verdicts alone.
#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "statistics/numbers.hpp"
#include "validation/report.hpp"
#include "validation/report_parts.hpp"

namespace arenite::validation {
namespace {

using validation::Check;
using validation::Sensitivity;

/// Says of the verdicts of small studies what they are not.
const char* size_of(bool small) { return small ? "the small studies, for the test alone: not the ledger" : "the studies in full"; }

void put(Numbers& one, const char* name, const validation::Value& value) {
  if (!std::isfinite(value.value)) return;
  one[name] = value.value;
  if (std::isfinite(value.error)) one["error"] = value.error;
  if (std::isfinite(value.error) && std::isfinite(value.freedom)) one["freedom"] = value.freedom;
}

Numbers json_of(const std::vector<Check>& checks) {
  Numbers list = Numbers::list();
  for (const Check& check : checks) {
    Numbers one{{"what", check.what}, {"kind", word_for(check.kind)}, {"source", check.source}, {"wanted", check.wanted}, {"outcome", word_for(check.outcome)}};
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

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_cell(double number) { return std::isfinite(number) ? fmt::format("{:.6g}", number) : ""; }

std::string row(const char* claim, const char* kind, const std::string& what, const std::string& choice, const std::string& source, const std::string& wanted,
                const validation::Value& ours, const std::string& unit, const char* outcome) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", claim, kind, csv_cell(what), csv_cell(choice), csv_cell(source), csv_cell(wanted),
                     csv_cell(ours.value), csv_cell(ours.error), std::isfinite(ours.error) ? csv_cell(ours.freedom) : "", csv_cell(unit), outcome);
}

}  // namespace

std::string ledger_json(const validation::Ledger& ledger) {
  Numbers studies = Numbers::tree(), claims = Numbers::tree();
  for (const auto& study : ledger.studies) studies[study.name] = {{"runs", study.runs}, {"done", study.done}};
  for (const auto& [claim, judgement] : ledger.claims)
    claims[claim->id] = {{"where", claim->where},
                         {"sentence", claim->sentence},
                         {"figure", validation::figure_place(*claim)},
                         {"verdict", word_for(judgement.verdict())},
                         {"source", claim->number},
                         {"ours", ours_text(judgement)},
                         {"decides", validation::what_decides(judgement)},
                         {"checks", json_of(judgement.checks)},
                         {"findings", judgement.findings},
                         {"sensitivity", json_of(judgement.sensitivities)}};
  return to_json(Numbers{{"studies", studies}, {"claims", claims}}, 1) + "\n";
}

std::string ledger_csv(const validation::Ledger& ledger) {
  std::string text = "claim,kind,what,choice,source,wanted,ours,error,freedom,unit,outcome\n";
  for (const auto& [claim, judgement] : ledger.claims) {
    for (const Check& c : judgement.checks)
      text += row(claim->id, word_for(c.kind), c.what, "", c.source, c.wanted, c.ours, c.unit, c.wanted.empty() ? "" : word_for(c.outcome));
    for (const Sensitivity& found : judgement.sensitivities)
      for (const auto& entry : found.entries)
        if (std::isfinite(entry.value.value))
          text += row(claim->id, "choice", found.what, entry.choice.empty() ? "as it is" : entry.choice, "", found.wanted, entry.value, "",
                      found.wanted.empty() ? "" : word_for(entry.outcome));
  }
  return text;
}

std::string ledger_verdicts(const validation::Ledger& ledger, bool small) {
  std::string text = fmt::format("{{\n  \"of\": \"{}\"", size_of(small));
  for (const auto& [claim, judgement] : ledger.claims) text += fmt::format(",\n  \"{}\": \"{}\"", claim->id, word_for(judgement.verdict()));
  return text + "\n}\n";
}

std::vector<std::string> changed_verdicts(const validation::Ledger& ledger, const std::string& expected, const std::string& file, bool small) {
  const Numbers wanted = from_json(expected).value_or(Numbers{});
  if (!wanted.is_tree() || !wanted.contains("of")) throw InputError(file, 0, "this holds no verdicts; write it with arenite verify --verdicts FILE");
  if (wanted["of"] != size_of(small))
    throw InputError(file, 0, fmt::format("these are verdicts of {}; here they are of {}", wanted.value("of", "something else"), size_of(small)));
  std::vector<std::string> changes;
  for (const auto& [claim, judgement] : ledger.claims) {
    const std::string before = wanted.value(claim->id, "missing"), now = word_for(judgement.verdict());
    if (before != now) changes.push_back(fmt::format("{}: {} now, {} in {}", claim->id, now, before, file));
  }
  return changes;
}

}  // namespace arenite::validation
