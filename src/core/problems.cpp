#include "core/problems.hpp"

#include <algorithm>
#include <iterator>

#include "core/text.hpp"

namespace arenite {

std::string to_string(const Problem& problem) {
  std::string text;  // a line end in a name must not look like another problem's line
  for (const char c : problem.file) text += c == '\n' ? std::string("\u240a") : std::string(1, c);
  if (problem.line > 0) text += ":" + std::to_string(problem.line);
  if (problem.line > 0 && problem.column > 0) text += ":" + std::to_string(problem.column);
  return text.empty() ? problem.message : text + ": " + problem.message;
}

InputError::InputError(std::vector<Problem> problems) : problems_(std::move(problems)) {
  for (const auto& problem : problems_) text_ += (text_.empty() ? "" : "\n") + to_string(problem);
}

InputError::InputError(std::string message) : InputError({Problem{{}, 0, 0, std::move(message)}}) {}

InputError::InputError(std::string file, int line, std::string message)
    : InputError({Problem{std::move(file), line, 0, std::move(message)}}) {}

InputError in_file(const InputError& error, const std::string& file) {
  auto problems = error.problems();
  for (auto& problem : problems)
    if (problem.file.empty()) problem.file = file;
  return InputError(std::move(problems));
}

void Problems::raise(std::initializer_list<Problems*> inputs) {
  std::vector<Problem> all;
  for (Problems* of : inputs) {
    if (of->count_ > most)
      of->list_.push_back({of->file_, 0, 0, "and " + std::to_string(of->count_ - most) + " more problems like these"});
    std::move(of->list_.begin(), of->list_.end(), std::back_inserter(all));
  }
  if (!all.empty()) throw InputError(std::move(all));
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({replaced, previous[j] + 1, current[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
    }
    std::swap(before, previous);
    std::swap(previous, current);
  }
  return previous[b.size()];
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_word = 64;  // a longer one is no typing slip, and the table stays small
  if (word.empty() || word.size() > longest_word) return {};
  const std::string wanted = lower_case(word);
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const auto& candidate : candidates) {
    // The case weighs less than a letter, so that "mpa" finds "MPa" before "Pa".
    const std::size_t distance = edit_distance(wanted, lower_case(candidate));
    const bool as_close =
        distance == best_distance && !best.empty() && edit_distance(word, candidate) < edit_distance(word, best);
    if (distance >= best_distance && !as_close) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

}  // namespace arenite
