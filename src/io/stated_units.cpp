#include "io/stated_units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace arenite::io {

std::optional<double> seconds_of(std::string_view unit) {
  constexpr std::pair<std::string_view, double> units[] = {
      {"s sec secs second seconds", 1},
      {"ms msec msecs millisecond milliseconds", 1e-3},
      {"us usec usecs \xc2\xb5s \xce\xbcs microsecond microseconds", 1e-6},
      {"ns nsec nanosecond nanoseconds", 1e-9},
      {"min minute minutes", 60},
      {"h hour hours", 3600},
      {"day days", 86400}};
  const std::string_view word = trimmed(unit);
  if (word.empty()) return 1;
  for (const auto& [words, seconds] : units)
    if (std::ranges::count(split_blanks(words), word) > 0) return seconds;
  return std::nullopt;
}

std::optional<double> in_metres(double length, std::string_view unit) {
  constexpr std::pair<std::string_view, std::string_view> spelled_out[] = {
      {"meter meters metre metres", "m"},
      {"centimeter centimeters centimetre centimetres", "cm"},
      {"millimeter millimeters millimetre millimetres", "mm"},
      {"micron microns micrometer micrometers micrometre micrometres \\u00B5m \\u03BCm", "um"},
      {"nanometer nanometers nanometre nanometres", "nm"}};
  std::string_view symbol = trimmed(unit);
  for (const auto& [words, si] : spelled_out)
    if (std::ranges::count(split_blanks(words), symbol) > 0) symbol = si;
  if (symbol.empty()) return std::nullopt;
  try {
    return parse_si(fmt::format("{} {}", length, symbol), dimension::length);
  } catch (const InputError&) { return std::nullopt; }
}

std::optional<double> frames_per_second(std::string_view text, Dimension bare, std::string_view unit) {
  text = trimmed(text);
  std::size_t end = number_length(text);
  std::string number(text.substr(0, end));
  if (end > 0 && end + 1 < text.size() && text[end] == ',' && is_digit(text[end + 1])) {  // a decimal comma
    const std::size_t last = std::min(text.find_first_not_of("0123456789", end + 1), text.size());
    number += fmt::format(".{}", text.substr(end + 1, last - end - 1));
    end = last;
  }
  const std::string_view rest = trimmed(text.substr(end));
  if (const std::string_view own = rest.substr(0, rest.find_first_of(" \t,;()[]{}\"'")); !own.empty()) unit = own;
  constexpr std::pair<std::string_view, std::string_view> rates[] = {
      {"fps", "Hz"}, {"hz", "Hz"}, {"khz", "kHz"}, {"frames/s", "Hz"}, {"1/s", "Hz"}};
  for (const auto& [word, si] : rates)
    if (lower_case(unit) == word) unit = si;
  try {
    Quantity stated = parse_quantity(number);
    if (const auto seconds = seconds_of(unit); seconds && !unit.empty())
      stated = {stated.value * *seconds, dimension::time, {}};
    else if (!unit.empty()) stated = parse_quantity(fmt::format("{} {}", number, unit));
    else stated.dimension = bare;
    if (!(stated.value > 0)) return std::nullopt;
    if (stated.dimension == dimension::frequency) return stated.value;
    if (stated.dimension == dimension::time) return 1 / stated.value;
  } catch (const InputError&) {}  // said in words
  return std::nullopt;
}

}  // namespace arenite::io
