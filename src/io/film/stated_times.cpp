#include "io/film/stated_times.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "io/film/stamps.hpp"
#include "io/stated_units.hpp"

namespace arenite::io {
namespace {

constexpr const char* digits_of_numbers = "0123456789";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// In lower case, without what programs put between words.
std::string bare_name(std::string_view name) {
  std::string bare = lower_case(name);
  std::erase_if(bare, [](char c) { return c == '_' || c == '-' || c == ' '; });
  return bare;
}

bool is_one_of(std::string_view word, std::string_view words) {
  return std::ranges::count(split_blanks(words), word) > 0;
}

/// What stands at the start of a text after blanks, quotation marks and one of these signs; nothing without a sign.
std::optional<std::string_view> behind_sign(std::string_view text, std::string_view signs) {
  const std::size_t sign = text.find_first_not_of(" \t\"'");
  if (sign == std::string_view::npos || signs.find(text[sign]) == std::string_view::npos) return std::nullopt;
  const std::size_t value = text.find_first_not_of(" \t\"'", sign + 1);
  return value == std::string_view::npos ? std::string_view() : text.substr(value);
}

/// Hours, minutes and seconds that stand in a line, s: "12:00:03.25".
std::optional<double> clock_in(std::string_view line) {
  const std::size_t last = line.rfind(':'), first = last == 0 ? last : line.rfind(':', last - 1);
  if (last == std::string_view::npos || first == std::string_view::npos || first == last) return std::nullopt;
  const std::size_t begin = line.find_last_not_of(digits_of_numbers, first - 1) + 1;
  const std::string_view seconds = line.substr(last + 1);
  const auto h = parse_number<int>(line.substr(begin, first - begin)),
             m = parse_number<int>(line.substr(first + 1, last - first - 1));
  const auto s = parse_number<double>(seconds.substr(0, seconds.find_first_not_of("0123456789.")));
  if (first == 0 || !h || !m || !s || *h > 23 || *m > 59 || !(*s < 61)) return std::nullopt;
  return 3600.0 * *h + 60.0 * *m + *s;
}

/// The value of a time up to the end of its line: a number with a unit, or a clock's.
void take_value(std::string_view line, const std::string& unit_of_name, FrameWords& words) {
  std::string number(line.substr(0, line.find_first_not_of("+-.eE0123456789")));
  std::string_view rest = line.substr(number.size());
  if (rest.size() > 1 && rest[0] == ',' && is_digit(rest[1])) {  // a decimal comma
    const std::size_t end = std::min(rest.find_first_not_of(digits_of_numbers, 1), rest.size());
    number += fmt::format(".{}", rest.substr(1, end - 1));
    rest.remove_prefix(end);
  }
  const auto value = parse_number<double>(std::string_view(number).substr(number.starts_with('+') ? 1 : 0));
  if (!value || rest.starts_with(':') || rest.starts_with('/')) {
    if (const auto clock = clock_in(line.substr(0, line.find_first_of("\",;}")))) words.time = *clock;
    else words.not_understood = trimmed(line.substr(0, std::min<std::size_t>(line.find_first_of("\",;}"), 40)));
    return;
  }
  rest = trimmed(rest);
  std::size_t end = 0;
  while (end < rest.size() && (is_letter(rest[end]) || static_cast<unsigned char>(rest[end]) > 0x7f)) ++end;
  const std::string unit = end > 0 ? std::string(rest.substr(0, end)) : unit_of_name;
  if (const auto seconds = seconds_of(unit)) words.time = *value * *seconds;
  else words.not_understood = fmt::format("{} {}", number, unit);
}

/// The unit behind a name, "[ms]" or "(Hz)", and what stands behind that.
std::pair<std::string, std::string_view> unit_in_brackets(std::string_view text) {
  const std::string_view bare = trimmed(text);
  if (!bare.starts_with('[') && !bare.starts_with('(')) return {"", text};
  const std::size_t end = bare.find(bare.front() == '[' ? ']' : ')');
  if (end == bare.npos) return {"", text};
  return {std::string(trimmed(bare.substr(1, end - 1))), bare.substr(end + 1)};
}

/// The same of a time.
std::pair<std::string, std::string_view> unit_of_time_in_brackets(std::string_view text) {
  const auto [unit, behind] = unit_in_brackets(text);
  return unit.empty() || !seconds_of(unit) ? std::pair(std::string(), text) : std::pair(unit, behind);
}

/// "frame rate = 30 Hz", "fps: 30", "frame_rate_Hz = 30", "Frame interval [ms]: 33".
void find_rate(std::string_view line, FrameWords& words) {
  const std::string low = lower_case(line);
  for (const auto& [name, bare] : {std::pair<std::string_view, Dimension>{"frame rate", dimension::frequency},
                                   {"frame_rate", dimension::frequency},
                                   {"framerate", dimension::frequency},
                                   {"fps", dimension::frequency},
                                   {"frame interval", dimension::time},
                                   {"frame_interval", dimension::time}}) {
    const std::size_t at = low.find(name);
    if (at == low.npos || (at > 0 && is_letter(low[at - 1]))) continue;
    std::string_view rest = line.substr(at + name.size());
    std::string unit;
    if (rest.starts_with('_')) {
      const std::size_t end = rest.find_first_of(" \t\"'=:");
      unit = rest.substr(1, end - 1), rest.remove_prefix(std::min(end, rest.size()));
    } else {
      std::tie(unit, rest) = unit_in_brackets(rest);
    }
    const auto value = behind_sign(rest, "=:");
    if (!value || value->empty()) continue;
    if (const auto rate = frames_per_second(*value, bare, unit)) words.rate = *rate;
    else words.unknown_rate = fmt::format("{} = {}", name, trimmed(value->substr(0, 40)));
  }
}

bool is_of_key(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

/// A time behind its key, before which no other word stands: an exposure time is none of a frame.
void find_time(std::string_view line, FrameWords& words) {
  for (std::size_t at = 0; at < line.size() && std::isnan(words.time) && words.not_understood.empty();) {
    std::size_t end = at;
    while (end < line.size() && is_of_key(line[end])) ++end;
    const std::string_view before = trimmed(line.substr(0, at));
    const auto unit = end > at ? unit_of_time_name(line.substr(at, end - at)) : std::nullopt;
    const auto [own, behind] = unit_of_time_in_brackets(line.substr(end));
    const auto value = behind_sign(behind, "=:");
    if (unit && value && (before.empty() || !is_letter(before.back())))
      take_value(*value, own.empty() ? *unit : own, words);
    at = std::max(end, at + 1);
  }
}

/// A number behind the word frame, or frame and number, id or the like; not a rate or a count of frames.
void find_number(std::string_view line, FrameWords& words) {
  const std::string low = lower_case(line);
  for (std::size_t at = low.find("frame"); at != std::string::npos && words.number < 0;
       at = low.find("frame", at + 1)) {
    const std::size_t digit = line.find_first_of(digits_of_numbers, at);
    if (digit == std::string_view::npos) return;
    std::string between = low.substr(at, digit - at);
    std::erase_if(between, [](char c) { return !is_letter(c); });
    if (between != "frame" && !names_frame_numbers(between)) continue;
    const std::string_view rest = line.substr(digit);
    const auto number = parse_number<std::int64_t>(rest.substr(0, rest.find_first_not_of(digits_of_numbers)));
    if (number) words.number = *number;
  }
}

}  // namespace

std::optional<std::string> unit_of_time_name(std::string_view name) {
  if (name.starts_with('T') && (name.size() == 1 || !is_letter(name[1]))) return std::nullopt;  // a temperature
  constexpr std::string_view times =
      "time times timestamp timestamps t frametime frametimes frametimestamp frametimestamps relativetime "
      "relativetimes acquisitiontime acquisitiontimes elapsedtime elapsed";
  const std::size_t last = std::min(name.find_last_of("_- "), name.size());
  const std::string unit = lower_case(name.substr(std::min(last + 1, name.size())));
  if (!unit.empty() && seconds_of(unit) && is_one_of(bare_name(name.substr(0, last)), times)) return unit;
  return is_one_of(bare_name(name), times) ? std::optional(std::string()) : std::nullopt;
}

bool names_frame_numbers(std::string_view name) {
  return is_one_of(bare_name(name),
                   "framenumber framenumbers frameindex frameindices frameid frameids frameno framenr framecounter");
}

bool names_array_of_numbers(std::string_view name) {
  return names_frame_numbers(name) ||
         is_one_of(bare_name(name),
                   "frame frames index indices imagenumber imagenumbers imageindex imageid imagenr imageno");
}

bool FrameWords::says_anything() const {
  return !std::isnan(time) || number >= 0 || rate > 0 || !not_understood.empty() || !unknown_rate.empty();
}

FrameWords words_of_frame(std::string_view text) {
  FrameWords words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    find_time(text.substr(0, end), words);
    if (words.number < 0) find_number(text.substr(0, end), words);
    if (words.rate == 0) find_rate(text.substr(0, end), words);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

void take_words(FilmInfo& info, const std::vector<FrameWords>& frames, bool rate_given) {
  const auto all = static_cast<std::ptrdiff_t>(frames.size());
  const auto timed = std::ranges::count_if(frames, [](const FrameWords&f) { return !std::isnan(f.time); }),
             counted = std::ranges::count_if(frames, [](const FrameWords&f) { return f.number >= 0; });
  const auto other = std::ranges::find_if(frames, [](const FrameWords& f) { return !f.not_understood.empty(); });
  if (other != frames.end())
    info.remarks.push_back(fmt::format(
        "Frame {} states the time \"{}\", which is not understood (\"time = 0.4 s\" is); its times are left aside.",
        other - frames.begin(), other->not_understood));
  else if (timed > 0 && timed < all)
    info.remarks.push_back(
        fmt::format("Only {} of {} frames state a time that can be read; times are left aside.", timed, all));
  if (const auto at = std::ranges::find_if(frames, [](const FrameWords& f) { return !f.unknown_rate.empty(); });
      at != frames.end())
    info.remarks.push_back(fmt::format(
        "It states {}, which is not understood and left aside; give the rate of its frames.", at->unknown_rate));
  if (counted > 0 && counted < all)
    info.remarks.push_back(fmt::format("Only {} of {} frames state a number; numbers are left aside.", counted, all));
  std::vector<double> time;
  std::vector<std::int64_t> number;
  if (timed == all && other == frames.end()) time = mapped(frames, &FrameWords::time);
  if (counted == all) number = mapped(frames, &FrameWords::number);
  take_stamps_and_numbers(info, std::move(time), std::move(number), rate_given);
}

}  // namespace arenite::io
