#include "core/decimals.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/text.hpp"

namespace arenite {

double in_decimals(double value, double size) {
  constexpr int digits = 15;  // that a double always keeps
  if (value == 0 || !std::isfinite(value) || !std::isfinite(size)) return value;
  const auto decade = [](double v) { return static_cast<int>(std::floor(std::log10(std::abs(v)))); };
  const int behind = digits - 1 + decade(value) - decade(std::max(std::abs(size), std::abs(value)));
  if (behind < 0) return 0;  // of what is left nothing is known
  const std::string text = fmt::format("{:.{}e}", value, behind);
  const bool is_short = text.substr(0, text.find('e')).ends_with("000");
  return is_short ? parse_number<double>(text).value_or(value) : value;
}

}  // namespace arenite
