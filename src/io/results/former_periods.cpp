#include "io/results/former_periods.hpp"

#include <charconv>
#include <system_error>

namespace arenite::io {
namespace {

/// m of "modes.m.phase_deg"; 0 of other names.
int folds_of(std::string_view name) {
  constexpr std::string_view group = "modes.", end = ".phase_deg";
  const auto at = name.rfind(group);
  if (at == std::string_view::npos || !name.ends_with(end)) return 0;
  const std::string_view number = name.substr(at + group.size(), name.size() - end.size() - at - group.size());
  int folds = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), folds);
  return error == std::errc() && stop == number.data() + number.size() ? folds : 0;
}

}  // namespace

double former_period_deg(std::string_view name) {
  if (const int folds = folds_of(name); folds > 0) return 360.0 / folds;
  const std::string_view last = name.substr(name.rfind('.') + 1);
  const bool is_axis = last.starts_with("theta_") || last.starts_with("axis") || last.find("_axis") != last.npos;
  return is_axis && last.ends_with("_deg") ? 180 : 0;
}

}  // namespace arenite::io
