#pragma once
#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "core/text.hpp"

namespace arenite::io {

/// Seconds of a unit of time as other programs write it, "" being a second; nothing for an unknown one.
inline std::optional<double> seconds_of(std::string_view unit) {
  constexpr std::pair<std::string_view, double> units[] = {
      {"", 1},        {"s", 1},       {"sec", 1},           {"second", 1},
      {"seconds", 1}, {"ms", 1e-3},   {"msec", 1e-3},       {"milliseconds", 1e-3},
      {"us", 1e-6},   {"usec", 1e-6}, {"\xc2\xb5s", 1e-6},  {"ns", 1e-9},
      {"min", 60},    {"h", 3600},    {"nanoseconds", 1e-9}};
  const auto* found = std::ranges::find(units, trimmed(unit), &std::pair<std::string_view, double>::first);
  return found != std::end(units) ? std::optional(found->second) : std::nullopt;
}

}  // namespace arenite::io
