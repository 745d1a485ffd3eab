// What decides a claim's verdict, as a kind and as a sentence.
#include <fmt/core.h>

#include <algorithm>
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
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  return text;
}

using Entry = Sensitivity::Entry;

/// The choices that turn what is wanted of a number into another end, beyond the errors of both.
std::vector<const Entry*> turned_to(const Sensitivity& found, Outcome outcome) {
  std::vector<const Entry*> turned;
  for (std::size_t k = 1; k < found.entries.size(); ++k) {
    const Entry& entry = found.entries[k];
    const Value change = difference(entry.value, found.entries.front().value);
    if (entry.outcome == outcome && std::abs(change.value) > half_interval(change)) turned.push_back(&entry);
  }
  return turned;
}

Words words_of(const std::vector<const Entry*>& entries) {
  Words words;
  for (const Entry* entry : entries) words.push_back(entry->choice);
  return words;
}

/// Something is wanted of it and not there with the usual choices.
bool is_open(const Sensitivity& found) {
  const Outcome usual = found.entries.front().outcome;
  return !found.wanted.empty() && (usual == Outcome::fails || usual == Outcome::undecided);
}

/// The kind of choice that gives what is wanted and is not there, or spoils what is; none if none does.
Decider kind_that_turns(const std::vector<Sensitivity>& all, Outcome from) {
  for (const Sensitivity& found : all) {
    const bool holds = found.entries.front().outcome == Outcome::holds;
    if (from == Outcome::holds ? !holds || found.wanted.empty() : !is_open(found)) continue;
    const auto turned = turned_to(found, holds ? Outcome::fails : Outcome::holds);
    if (!turned.empty()) return turned.front()->kind;
  }
  return Decider::none;
}

/// The first number that is not as wanted and that grids bring to either end of its range.
const Sensitivity* moved_by_grids(const std::vector<Sensitivity>& all) {
  for (const Sensitivity& found : all) {
    const auto ends = [&](Outcome outcome) {
      return std::ranges::any_of(turned_to(found, outcome),
                                 [](const Entry* entry) { return entry->kind == Decider::grid; });
    };
    if (is_open(found) && ends(Outcome::holds) && ends(Outcome::fails)) return &found;
  }
  return nullptr;
}

/// "Mean in small grains: 0.976 with 512 nodes, 1.002 with the reference settings, 1.019 with 2048 nodes, required <
/// 1."
std::string grids_in_words(const Sensitivity& found) {
  std::vector<const Entry*> shown{&found.entries.front()};
  for (const Entry& entry : found.entries)
    if (entry.kind == Decider::grid && std::isfinite(entry.value.value)) shown.push_back(&entry);
  std::ranges::stable_sort(shown, {}, [](const Entry* entry) { return entry->value.value; });
  Words words;
  for (const Entry* entry : shown)
    words.push_back(fmt::format("{} {}", text_of(entry->value),
                                entry->choice.empty() ? "with the reference settings" : entry->choice));
  return fmt::format("The grid decides it. {}: {}, required {}.", capital(found.what), listed(words), found.wanted);
}

/// Which choices give what is wanted and is not there; empty if there are none.
std::string what_mends(const std::vector<Sensitivity>& all) {
  std::string text;
  for (const Sensitivity& found : all) {
    if (!is_open(found)) continue;
    if (const Words words = words_of(turned_to(found, Outcome::holds)); !words.empty())
      text += fmt::format("{}{} meets its criterion ({}) {}", text.empty() ? "" : "; ", found.what, found.wanted,
                          listed(words));
  }
  return text.empty() ? text : text + ".";
}

/// Choices whose runs are there, and how many of them may turn a number into another end for all that is known: their
/// own errors, or those of the change, leave it open.
struct Tried {
  std::size_t choices = 0, undecided = 0;
  void see(const Sensitivity& found, Outcome other_end) {
    for (std::size_t k = 1; k < found.entries.size(); ++k) {
      const Outcome outcome = found.entries[k].outcome;
      choices += outcome != Outcome::unknown;
      undecided += outcome == Outcome::undecided || outcome == other_end;
    }
    undecided -= turned_to(found, other_end).size();
  }
  /// "None of the choices tried meets the criterion; 2 of 11 are undecided and want seeds."
  std::string in_words(const char* does) const {
    if (choices == 0) return "No other choices were tried for it.";
    std::string text = fmt::format("None of the choices tried {}", does);
    if (undecided > 0)
      text += fmt::format("; {} of {} {} undecided and want{} seeds", undecided, choices, undecided > 1 ? "are" : "is",
                          undecided > 1 ? "" : "s");
    return text + ".";
  }
};

/// What spoils a number that is as wanted; empty if there is none with choices.
std::string what_spoils(const std::vector<Sensitivity>& all) {
  std::string text;
  Tried tried;
  for (const Sensitivity& found : all) {
    if (found.wanted.empty() || found.entries.front().outcome != Outcome::holds) continue;
    tried.see(found, Outcome::fails);
    if (const Words words = words_of(turned_to(found, Outcome::fails)); !words.empty())
      text += fmt::format("{}{} no longer meets its criterion ({}) {}", text.empty() ? "" : "; ", found.what,
                          found.wanted, listed(words));
  }
  if (!text.empty()) return text + ".";
  return tried.in_words("reverses it");
}

std::string in_words(const Check& check) {
  return fmt::format("{}: {}, required {}.", capital(check.what), text_of(check.ours), check.wanted);
}

/// "About 1.8 times as many seeds would decide it."
std::string seeds_in_words(const Check& check) {
  const double factor = seeds_factor(check);
  if (!(factor < most_times_seeds)) return "More seeds are needed, and many: its value lies close to the bound.";
  return fmt::format("About {:.{}f} times as many seeds would decide it.", factor, factor < 10 ? 1 : 0);
}

std::string without_choice(const Judgement& judgement, const Check& check) {
  switch (decider_of(judgement)) {
    case Decider::seeds: return seeds_in_words(check) + " " + in_words(check);
    case Decider::grid:
      if (const Sensitivity* moved = moved_by_grids(judgement.sensitivities)) return grids_in_words(*moved);
      return "The grid decides it. " + in_words(check);
    case Decider::reading: return "The reading of the source decides it. " + in_words(check);
    default: break;
  }
  Tried tried;
  for (const Sensitivity& found : judgement.sensitivities)
    if (is_open(found)) tried.see(found, Outcome::holds);
  return tried.in_words("meets the criterion") + " " + in_words(check);
}

}  // namespace

Decider decider_of(const Judgement& judgement) {
  const Check* check = deciding_check(judgement);
  const bool knows_itself = check && check->decider != Decider::none;
  switch (judgement.verdict()) {
    case Verdict::unknown: return Decider::runs;
    case Verdict::not_testable: return Decider::lost;
    case Verdict::source_inconsistent: return Decider::source;
    case Verdict::reproduced: return kind_that_turns(judgement.sensitivities, Outcome::holds);
    case Verdict::undecided:
      if (knows_itself) return check->decider;
      return moved_by_grids(judgement.sensitivities) ? Decider::grid : Decider::seeds;
    case Verdict::trend_reproduced:
    case Verdict::not_reproduced: break;
  }
  if (knows_itself) return check->decider;
  return moved_by_grids(judgement.sensitivities) ? Decider::grid
                                                 : kind_that_turns(judgement.sensitivities, Outcome::fails);
}

double seeds_factor(const Check& check) {
  const auto& [value, error, freedom] = check.ours;
  const double inside = std::min(value - check.range.low, check.range.high - value), distance = std::abs(inside);
  if (!(error > 0) || !(freedom > 0) || !std::isfinite(distance)) return statistics::unknown;
  const auto half_with = [&, value = value, error = error, freedom = freedom](double times) {
    const Value surer{value, error / std::sqrt(times), (freedom + 1) * times - 1};
    return half_interval(surer, inside < 0 ? check.outside : usual_side);
  };
  double times = 1;
  while (times < most_times_seeds && half_with(times) > distance) times *= 1.02;
  return std::min(times, most_times_seeds);
}

std::string what_decides(const Judgement& judgement) {
  const Verdict verdict = judgement.verdict();
  if (verdict == Verdict::unknown) return "The runs that decide it are missing.";
  if (verdict == Verdict::not_testable) return judgement.untestable;
  const bool by_seeds = decider_of(judgement) == Decider::seeds;
  if (!judgement.decides.empty() && !by_seeds) return judgement.decides;
  if (verdict == Verdict::reproduced) return what_spoils(judgement.sensitivities);
  const Check& check = *deciding_check(judgement);
  if (by_seeds && !judgement.decides.empty()) return without_choice(judgement, check) + " " + judgement.decides;
  const bool by_grid = decider_of(judgement) == Decider::grid;
  const std::string mends = by_grid ? "" : what_mends(judgement.sensitivities);
  if (mends.empty()) return without_choice(judgement, check);
  return by_seeds ? without_choice(judgement, check) + " " + mends : mends;
}

}  // namespace arenite::validation
