#include "core/error.hpp"

namespace arenite {

std::string to_string(const Problem& problem) {
  std::string text = problem.file;
  if (problem.line > 0) text += ":" + std::to_string(problem.line);
  if (problem.line > 0 && problem.column > 0) text += ":" + std::to_string(problem.column);
  return text.empty() ? problem.message : text + ": " + problem.message;
}

InputError::InputError(std::vector<Problem> problems) : problems_(std::move(problems)) {
  for (const auto& problem : problems_) text_ += (text_.empty() ? "" : "\n") + to_string(problem);
}

InputError in_file(const InputError& error, const std::string& file) {
  auto problems = error.problems();
  for (auto& problem : problems)
    if (problem.file.empty()) problem.file = file;
  return InputError(std::move(problems));
}

}  // namespace arenite
