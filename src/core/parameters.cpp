#include "core/parameters.hpp"

#include <fmt/core.h>

#include <cmath>

#include "core/units.hpp"

namespace arenite {

std::string to_string(const Range& range, std::string_view unit) {
  const bool below = std::isfinite(range.min), above = std::isfinite(range.max);
  const std::string min = below ? format_quantity(range.min, unit) : "",
                    max = above ? format_quantity(range.max, unit) : "";
  if (below && above) {
    return range.min_excluded ? fmt::format("above {}, up to {}", min, max) : fmt::format("from {} to {}", min, max);
  }
  if (below) return fmt::format("{} {}", range.min_excluded ? "above" : "at least", min);
  return above ? fmt::format("at most {}", max) : std::string();
}

std::string to_string(const IntegerRange& range) {
  const bool below = range.min != IntegerRange{}.min, above = range.max != IntegerRange{}.max;
  if (below && above) return fmt::format("from {} to {}", range.min, range.max);
  if (below) return fmt::format("at least {}", range.min);
  return above ? fmt::format("at most {}", range.max) : std::string();
}

}  // namespace arenite
