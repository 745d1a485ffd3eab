#pragma once
#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "core/text.hpp"

namespace arenite::io {

/// Seconds of a unit of time as other programs write it, "" being a second; nothing for an unknown one.
inline std::optional<double> seconds_of(std::string_view unit) {
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

}  // namespace arenite::io
