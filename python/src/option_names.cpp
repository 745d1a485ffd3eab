#include "option_names.hpp"

#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>
#include <utility>

namespace arenite::python {
namespace {

/// Options whose argument has another name than they have; longer ones first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> renamed{{{"--doubled merge", "merge_doubled"},
                                                                                {"--touching", "propose_contacts"},
                                                                                {"--columns", "contact_columns"},
                                                                                {"--radius", "radii"},
                                                                                {"--set", "changes"},
                                                                                {"--k ", "stiffness "}}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// An option stands at the beginning or behind a space or a bracket; two dashes within a word are the user's own.
bool is_option(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "--") != 0 || at + 2 >= text.size() || !is_letter(text[at + 2])) return false;
  return at == 0 || text[at - 1] == ' ' || text[at - 1] == '(' || text[at - 1] == '\n';
}

/// The argument for the option at the beginning of `text`, and the length of what it stands for.
std::pair<std::string, std::size_t> argument_at(std::string_view text) {
  for (const auto& [from, to] : renamed)
    if (text.starts_with(from)) return {std::string(to), from.size()};
  std::string name;
  std::size_t at = 2;
  for (; at < text.size(); ++at) {
    if (is_letter(text[at])) name += text[at];
    else if (text[at] == '-' && at + 1 < text.size() && is_letter(text[at + 1])) name += '_';
    else break;
  }
  return {name, at};
}

}  // namespace

std::string with_arguments(const std::string& sentence) {
  std::string text;
  for (std::size_t at = 0; at < sentence.size();) {
    if (!is_option(sentence, at)) {
      text += sentence[at++];
      continue;
    }
    const auto [argument, length] = argument_at(std::string_view(sentence).substr(at));
    text += argument;
    at += length;
  }
  return text;
}

}  // namespace arenite::python
