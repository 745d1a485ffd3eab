#include "statistics/estimate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace arenite::statistics {

std::string with_error(const Estimate& e, double scale) {
  const double value = e.value * scale, error = e.error * scale;
  if (!std::isfinite(error)) return fmt::format("{:.4g}", value);
  if (error <= 1e-12 * std::abs(value)) return fmt::format("{:.6g}", value);
  if (error < 1e-4 || error >= 1e5 || std::abs(value) >= 1e6) return fmt::format("{:.4g} +- {:.2g}", value, error);
  const int places = std::max(0, 1 - static_cast<int>(std::floor(std::log10(error))));
  return fmt::format("{:.{}f} +- {:.{}f}", value, places, error, places);
}

StressUnit stress_unit(double size) {
  if (size >= 1e5) return {"MPa", 1e-6};
  if (size >= 1e2) return {"kPa", 1e-3};
  return {"Pa", 1};
}

}  // namespace arenite::statistics
