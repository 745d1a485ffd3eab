#pragma once
#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace arenite {

/// Without the blanks around it.
inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Words separated by blanks.
inline std::vector<std::string_view> split_blanks(std::string_view line) {
  std::vector<std::string_view> cells;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(" \t\r", at)) != std::string_view::npos) {
    const auto end = std::min(line.find_first_of(" \t\r", at), line.size());
    cells.push_back(line.substr(at, end - at));
    at = end;
  }
  return cells;
}

/// What stands between commas, without the blanks around it.
inline std::vector<std::string> split_commas(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    parts.emplace_back(trimmed(text.substr(from, comma - from)));
    from = comma + 1;
  }
  return parts;
}

/// Words one after the other, with this between two of them.
template <std::ranges::range Words>
requires std::convertible_to<std::ranges::range_reference_t<const Words>, std::string_view> std::string list_of(
    const Words& words, std::string_view between = ", ") {
  std::string list;
  std::string_view gap;
  for (const std::string_view word : words) list.append(gap).append(word), gap = between;
  return list;
}

/// With the letters of ASCII in lower case; others stay, whatever the locale.
inline char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lower_case(c);
  return result;
}

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// What plain names are made of, which stand in files, keys and commands without quotes: letters, digits, _ and -.
inline bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}
inline bool is_plain_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), is_name_character);
}

/// Whether all of it is well-formed (RFC 3629): no byte is missing or too many, no character is longer than it need be.
inline bool is_utf8(std::string_view text) {
  constexpr std::uint32_t least[] = {0, 0x80, 0x800, 0x10000};
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const unsigned more = lead < 0x80 ? 0 : lead >> 5 == 6 ? 1 : lead >> 4 == 14 ? 2 : lead >> 3 == 30 ? 3 : 4;
    if (more > 3 || text.size() - at <= more) return false;
    std::uint32_t code = more == 0 ? lead : lead & (0x3fu >> more);
    for (unsigned k = 0; k < more; ++k) {
      const auto next = static_cast<unsigned char>(text[++at]);
      if (next >> 6 != 2) return false;
      code = code << 6 | (next & 0x3fu);
    }
    if (code < least[more] || code > 0x10ffff || code >> 11 == 0x1b)
      return false;  // halves of UTF-16 are no characters
  }
  return true;
}

/// For a terminal: what would move its cursor, change its colours or its title, or speak for the user is shown as a
/// sign that does nothing: control characters as their pictures (U+2400 and on), what is no character of UTF-8 and what
/// turns the direction of writing as U+FFFD. Line ends and tabs stay.
inline std::string printable(std::string_view text) {
  // U+061C, U+200E and f, U+202A to E, U+2066 to 9
  constexpr std::string_view turning[] = {"\xd8\x9c",     "\xe2\x80\x8e", "\xe2\x80\x8f", "\xe2\x80\xaa",
                                          "\xe2\x80\xab", "\xe2\x80\xac", "\xe2\x80\xad", "\xe2\x80\xae",
                                          "\xe2\x81\xa6", "\xe2\x81\xa7", "\xe2\x81\xa8", "\xe2\x81\xa9"};
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t length = lead < 0x80 ? 1 : lead >> 5 == 6 ? 2 : lead >> 4 == 14 ? 3 : 4;
    const std::string_view one = text.substr(at, length);
    const bool whole = is_utf8(one);
    const bool second_controls = whole && length == 2 && lead == 0xc2 && static_cast<unsigned char>(one[1]) < 0xa0;
    const bool turns = length > 1 && std::ranges::count(turning, one) > 0;
    if (!whole || second_controls || turns) shown += "\xef\xbf\xbd";
    else if (lead == 0x7f) shown += "\xe2\x90\xa1";
    else if (lead < 0x20 && lead != '\n' && lead != '\t') shown += {'\xe2', '\x90', static_cast<char>(0x80 + lead)};
    else shown += one;
    at += whole ? length : 1;
  }
  return shown;
}

/// A text that is a number of this type and nothing else; empty otherwise.
template <class T> std::optional<T> parse_number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace arenite
