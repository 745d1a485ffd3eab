#include "io/table/comment_units.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

/// "# Units: mm" as "units" and "mm"; two empty texts for what is no comment of a name and what it is.
std::pair<std::string, std::string_view> statement_in(std::string_view comment) {
  comment = trimmed(comment);
  comment.remove_prefix(std::min(comment.find_first_not_of("#% \t"), comment.size()));
  const std::size_t at = comment.find_first_of(":=");
  if (at == comment.npos) return {};
  return {lower_case(trimmed(comment.substr(0, at))), comment.substr(at + 1)};
}

}  // namespace

std::string unit_among(std::string_view words, Dimension dimension) {
  std::string blanks(words);
  std::ranges::replace_if(
      blanks, [](char c) { return c == ',' || c == ';' || c == '"'; }, ' ');
  for (const std::string_view word : split_blanks(blanks)) try {
      unit_factor(word, dimension);
      return std::string(word);
    } catch (const InputError&) {  // of something else
    }
  return {};
}

std::string unit_of_comments(std::string_view text, std::string_view name, Dimension dimension) {
  std::string unit;
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty()) continue;
    if (trimmed(line).front() != '#' && trimmed(line).front() != '%') break;
    auto [stated, words] = statement_in(line);
    std::ranges::replace(stated, '_', ' ');
    if (stated == "unit" || stated == "units" || stated == std::string(name) + " unit")
      if (std::string found = unit_among(words, dimension); !found.empty()) unit = std::move(found);
  }
  return unit;
}

}  // namespace arenite::io
