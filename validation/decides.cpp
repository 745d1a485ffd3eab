// The sentence that names what decides a claim's verdict.
#include <fmt/core.h>

#include <cmath>

#include "validation/checks.hpp"

namespace arenite::validation {
namespace {

using Words = std::vector<std::string>;

/// "a", "a and b", "a, b and c"; of many the first few.
std::string listed(Words words) {
  constexpr std::size_t most = 4;
  if (words.size() > most) {
    const std::size_t more = words.size() - (most - 1);
    words.resize(most - 1);
    words.push_back(fmt::format("{} others", more));
  }
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  return text;
}

/// Choices that turn what is wanted of a number into another end, beyond the errors of both.
Words turned_to(const Sensitivity& found, Outcome outcome) {
  Words words;
  for (std::size_t k = 1; k < found.entries.size(); ++k) {
    const auto& entry = found.entries[k];
    const Value change = difference(entry.value, found.entries.front().value);
    if (entry.outcome == outcome && std::abs(change.value) > half_interval(change)) words.push_back(entry.choice);
  }
  return words;
}

/// Which choices give what is wanted and is not there; empty if there are none.
std::string what_mends(const std::vector<Sensitivity>& all) {
  std::string text;
  for (const Sensitivity& found : all) {
    if (found.wanted.empty() || found.entries.front().outcome == Outcome::holds || found.entries.front().outcome == Outcome::unknown) continue;
    if (const Words words = turned_to(found, Outcome::holds); !words.empty())
      text += fmt::format("{}{} meets its criterion ({}) {}", text.empty() ? "" : "; ", found.what, found.wanted, listed(words));
  }
  return text.empty() ? text : text + ".";
}

/// What spoils a number that is as wanted; empty if there is none with choices.
std::string what_spoils(const std::vector<Sensitivity>& all) {
  std::string text;
  std::size_t choices = 0;
  for (const Sensitivity& found : all) {
    if (found.wanted.empty() || found.entries.front().outcome != Outcome::holds) continue;
    for (std::size_t k = 1; k < found.entries.size(); ++k) choices += found.entries[k].outcome != Outcome::unknown;
    if (const Words words = turned_to(found, Outcome::fails); !words.empty())
      text += fmt::format("{}{} no longer meets its criterion ({}) {}", text.empty() ? "" : "; ", found.what, found.wanted, listed(words));
  }
  if (!text.empty()) return text + ".";
  return choices > 0 ? "None of the choices tried reverses it." : "";
}

}  // namespace

std::string what_decides(const Judgement& judgement) {
  const Verdict verdict = judgement.verdict();
  if (verdict == Verdict::unknown) return "The runs that decide it are missing.";
  if (!judgement.decides.empty()) return judgement.decides;
  const std::string choice = verdict == Verdict::reproduced ? what_spoils(judgement.sensitivities) : what_mends(judgement.sensitivities);
  if (!choice.empty()) return choice;
  if (verdict == Verdict::reproduced) return "No other choices were tried.";
  const Check& check = *deciding_check(judgement);
  if (verdict == Verdict::undecided)
    return fmt::format("More samples are needed. {}: {}, required {}.", capital(check.what), text_of(check.ours), check.wanted);
  return fmt::format("None of the choices tried meets the criterion. {}: {}, required {}.", capital(check.what), text_of(check.ours), check.wanted);
}

}  // namespace arenite::validation
