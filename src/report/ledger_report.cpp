#include "report/ledger_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "ledger/studies.hpp"
#include "ledger/trends.hpp"

namespace arenite::report {
namespace {

using Json = nlohmann::ordered_json;
using ledger::Check;
using ledger::Judged;
using ledger::Sensitivity;

std::string ours_text(const Check& check) {
  const std::string text = ledger::text_of({check.ours, check.error});
  return check.ours_unit.empty() || !std::isfinite(check.ours) ? text : text + " " + check.ours_unit;
}

std::string lines_of(const ledger::Verdict& verdict, const char* kind) {
  std::string text = fmt::format("  {}: {}\n", kind, ledger::word_for(verdict.holds()));
  for (const Check& check : verdict.checks)
    text += fmt::format("    {:<8} {}: {} (source {}, wanted {})\n", ledger::word_for(check.holds), check.what, ours_text(check), check.source, check.tolerance);
  return text;
}

Json json_of(const ledger::Verdict& verdict) {
  Json list = Json::array();
  for (const Check& check : verdict.checks) {
    Json one{{"what", check.what}, {"source", check.source}, {"tolerance", check.tolerance}, {"verdict", ledger::word_for(check.holds)}};
    if (std::isfinite(check.ours)) one["ours"] = check.ours;
    if (std::isfinite(check.error)) one["error"] = check.error;
    if (!check.ours_unit.empty()) one["unit"] = check.ours_unit;
    list.push_back(std::move(one));
  }
  return list;
}

/// Bars would end a cell.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

/// A heading's own link.
std::string anchor_of(std::string id) {
  for (char& c : id)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return id;
}

std::string rows_of(const ledger::Verdict& verdict, const char* kind) {
  std::string text;
  for (const Check& check : verdict.checks)
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", kind, cell(check.what), cell(check.source), cell(ours_text(check)), cell(check.tolerance),
                        ledger::word_for(check.holds));
  return text;
}

std::string value_text(const Sensitivity::Entry& entry) { return ledger::text_of({entry.value, entry.error}); }

bool as_wanted(const Sensitivity::Entry& entry) { return entry.holds == ledger::Holds::yes; }

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  return text;
}

/// Whether an entry differs from how it is by more than their errors; not where one of these is not known.
bool differs(const Sensitivity::Entry& entry, const Sensitivity::Entry& usual) {
  return std::abs(entry.value - usual.value) > ledger::beyond * std::hypot(entry.error, usual.error);
}

/// Which choices give what is wanted; empty where nothing is, or nothing is missing.
std::string mended_by(const Sensitivity& found) {
  if (found.wanted.empty() || found.entries.empty() || found.entries.front().holds != ledger::Holds::no) return {};
  std::vector<std::string> sure, may_be_chance;
  for (const auto& entry : found.entries)
    if (as_wanted(entry)) (differs(entry, found.entries.front()) ? sure : may_be_chance).push_back(entry.choice);
  const std::string chance = "no further from how it is than 2 s.e.: " + listed(may_be_chance);
  if (sure.empty()) return may_be_chance.empty() ? "no choice here gives what is wanted" : "as wanted, but " + chance;
  return "as wanted " + listed(sure) + (may_be_chance.empty() ? "" : "; also, but " + chance);
}

std::string wanted_of(const Sensitivity& found) { return found.wanted.empty() ? "" : fmt::format(" (wanted {})", found.wanted); }

std::string line_of(const Sensitivity& found) {
  std::string text = fmt::format("  {}{}: {}", found.what, wanted_of(found), value_text(found.entries.front()));
  for (std::size_t k = 1; k < found.entries.size(); ++k)
    if (std::isfinite(found.entries[k].value)) text += fmt::format(", {} {}", found.entries[k].choice, value_text(found.entries[k]));
  const std::string mended = mended_by(found);
  return text + (mended.empty() ? "" : "; " + mended) + ".\n";
}

Json json_of(const std::vector<Sensitivity>& sensitivities) {
  Json list = Json::array();
  for (const Sensitivity& found : sensitivities) {
    Json entries = Json::array();
    for (const auto& entry : found.entries) {
      if (!std::isfinite(entry.value)) continue;
      Json one{{"choice", entry.choice}, {"value", entry.value}};
      if (std::isfinite(entry.error)) one["error"] = entry.error;
      if (!found.wanted.empty()) one["verdict"] = ledger::word_for(entry.holds);
      entries.push_back(std::move(one));
    }
    Json one{{"what", found.what}, {"entries", entries}};
    if (!found.wanted.empty()) one["wanted"] = found.wanted;
    list.push_back(std::move(one));
  }
  return list;
}

bool same_choices(const Sensitivity& a, const Sensitivity& b) {
  return std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(), [](const auto& x, const auto& y) { return x.choice == y.choice; });
}

/// One table for numbers with the same choices, below it which of these mend what fails.
std::string table_of(std::vector<Sensitivity>::const_iterator first, std::vector<Sensitivity>::const_iterator last) {
  std::string head = "\n| |", rule = "|---|", rows, notes;
  for (const auto& entry : first->entries) {
    head += fmt::format(" {} |", entry.choice.empty() ? "as it is" : cell(entry.choice));
    rule += "---|";
  }
  for (auto found = first; found != last; ++found) {
    rows += fmt::format("| {}{} |", cell(found->what), cell(wanted_of(*found)));
    for (const auto& entry : found->entries) {
      const char* bold = as_wanted(entry) ? "**" : "";
      rows += std::isfinite(entry.value) ? fmt::format(" {}{}{} |", bold, value_text(entry), bold) : " |";
    }
    rows += "\n";
    if (const std::string mended = mended_by(*found); !mended.empty()) notes += fmt::format("\n{}: {}.\n", found->what, mended);
  }
  return head + "\n" + rule + "\n" + rows + notes;
}

std::string tables_of(const std::vector<Sensitivity>& sensitivities) {
  std::string text;
  for (auto first = sensitivities.begin(); first != sensitivities.end();) {
    const auto last = std::find_if(first, sensitivities.end(), [&](const Sensitivity& other) { return !same_choices(*first, other); });
    text += table_of(first, last);
    first = last;
  }
  return text.empty() ? text : "\nOpen choices, one at a time (bold: as wanted):\n" + text;
}

std::string progress_of(const ledger::StudyState& study) {
  if (study.runs > 0) return fmt::format("{} of {} runs done", study.done, study.runs);
  const auto* source = ledger::find_study(study.name);
  const bool has_runs = source && std::any_of(source->files.begin(), source->files.end(), [](const auto& file) { return file.first == "recipe.toml"; });
  return has_runs ? "not begun" : "the source's tables";
}

}  // namespace

std::string ledger_text(const ledger::Ledger& ledger) {
  std::string text;
  for (const auto& study : ledger.studies) text += fmt::format("{:<24} {}\n", study.name, progress_of(study));
  for (const Judged& judged : ledger.claims) {
    text += fmt::format("\n{}  {}\n  {}\n", judged.claim->id, judged.claim->sentence, judged.claim->where);
    text += lines_of(judged.judgement.stated, "as stated");
    text += lines_of(judged.judgement.sharpened, "as sharpened");
    for (const auto& finding : judged.judgement.findings) text += fmt::format("  {}\n", finding);
    for (const auto& found : judged.judgement.sensitivities) text += line_of(found);
    if (const std::string figure = ledger::figure_place(*judged.claim); !figure.empty()) text += fmt::format("  figure: {}\n", figure);
  }
  return text;
}

std::string ledger_json(const ledger::Ledger& ledger) {
  Json studies = Json::object(), claims = Json::object();
  for (const auto& study : ledger.studies) studies[study.name] = {{"runs", study.runs}, {"done", study.done}};
  for (const auto& [claim, judgement] : ledger.claims)
    claims[claim->id] = {{"where", claim->where}, {"sentence", claim->sentence}, {"figure", ledger::figure_place(*claim)},
                         {"stated", ledger::word_for(judgement.stated.holds())}, {"sharpened", ledger::word_for(judgement.sharpened.holds())},
                         {"stated_checks", json_of(judgement.stated)}, {"sharpened_checks", json_of(judgement.sharpened)},
                         {"findings", judgement.findings}, {"sensitivity", json_of(judgement.sensitivities)}};
  return Json{{"studies", studies}, {"claims", claims}}.dump(1) + "\n";
}

std::string ledger_markdown(const ledger::Ledger& ledger, const std::string& title) {
  std::string text = fmt::format("## {}\n\n", title);
  for (const auto& study : ledger.studies) text += fmt::format("- `{}`: {}\n", study.name, progress_of(study));
  text += "\n| claim | | as stated | as sharpened |\n|---|---|---|---|\n";
  for (const auto& [claim, judgement] : ledger.claims)
    text += fmt::format("| [{}](#{}) | {} | {} | {} |\n", claim->id, anchor_of(claim->id), cell(claim->sentence), ledger::word_for(judgement.stated.holds()),
                        ledger::word_for(judgement.sharpened.holds()));
  for (const auto& [claim, judgement] : ledger.claims) {
    const std::string figure = ledger::figure_place(*claim);
    text += fmt::format("\n### {}\n\n{}. ({}{})\n\n", claim->id, claim->sentence, claim->where, figure.empty() ? "" : fmt::format("; here `{}`", figure));
    text += "| verdict | what | source | ours | wanted | |\n|---|---|---|---|---|---|\n";
    text += rows_of(judgement.stated, "stated") + rows_of(judgement.sharpened, "sharpened");
    for (const auto& finding : judgement.findings) text += "\n" + finding + "\n";
    text += tables_of(judgement.sensitivities);
  }
  return text;
}

std::string ledger_verdicts(const ledger::Ledger& ledger) {
  std::string text = "{\n";
  for (std::size_t k = 0; k < ledger.claims.size(); ++k) {
    const auto& [claim, judgement] = ledger.claims[k];
    text += fmt::format("  \"{}\": {{\"stated\": \"{}\", \"sharpened\": \"{}\"}}{}\n", claim->id, ledger::word_for(judgement.stated.holds()),
                        ledger::word_for(judgement.sharpened.holds()), k + 1 < ledger.claims.size() ? "," : "");
  }
  return text + "}\n";
}

std::vector<std::string> changed_verdicts(const ledger::Ledger& ledger, const std::string& expected, const std::string& file) {
  const Json wanted = Json::parse(expected, nullptr, false);
  if (!wanted.is_object()) throw InputError(file, 0, "this holds no verdicts; write it with arenite verify --verdicts FILE");
  std::vector<std::string> changes;
  for (const auto& [claim, judgement] : ledger.claims)
    for (const auto& [kind, verdict] : {std::pair{"stated", &judgement.stated}, {"sharpened", &judgement.sharpened}}) {
      const auto entry = wanted.find(claim->id);
      const std::string before = entry != wanted.end() ? entry->value(kind, "missing") : "missing", now = ledger::word_for(verdict->holds());
      if (before != now) changes.push_back(fmt::format("{} as {}: {} now, {} in {}", claim->id, kind, now, before, file));
    }
  return changes;
}

}  // namespace arenite::report
