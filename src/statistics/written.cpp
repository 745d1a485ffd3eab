#include "statistics/written.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

namespace arenite::statistics {
namespace {

constexpr std::array prefixed{"N", "Pa", "J", "m", "s", "N/m", "J/m", "m/s", "Pa m^0.5", "W", "K", "g"};
constexpr std::array<std::pair<double, const char*>, 7> prefixes{
    {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "\u00b5"}, {1e-9, "n"}}};
constexpr double from = 0.9995;  // which three digits write as the factor itself

std::string typeset(const std::string& unit) {
  if (unit == "1") return "";
  if (unit == "deg") return "\u00b0";
  if (const std::size_t at = unit.find("^0.5"); at != std::string::npos)
    return typeset(unit.substr(0, at)) + "^{1/2}" + typeset(unit.substr(at + 4));
  std::string text;
  for (std::size_t k = 0; k < unit.size(); ++k) {
    if (unit[k] == ' ') {
      text += "\u2009";
      continue;
    }
    if (unit[k] != '^' || k + 1 >= unit.size()) {
      text += unit[k];
      continue;
    }
    std::size_t used = 0;
    text += raised_figures(std::stoi(unit.substr(k + 1), &used));
    k += used;
  }
  return text;
}

}  // namespace

std::string raised_figures(int number) {
  static const char* const digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                       "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text;
  for (const char c : fmt::format("{}", number)) text += c == '-' ? "\u207b" : digits[c - '0'];
  return text;
}

Scale scale_of(double largest, const std::string& unit) {
  const bool has_prefixes = std::ranges::any_of(prefixed, [&](std::string_view one) { return one == unit; });
  if (!(largest > 0) || !has_prefixes) return {1, typeset(unit)};
  const auto* at = std::ranges::find_if(prefixes, [&](const auto& p) { return largest >= from * p.first; });
  const auto& [factor, prefix] = at == std::end(prefixes) ? prefixes.back() : *at;
  return {factor, prefix + typeset(unit)};
}

Numbers prefixed_units() {
  Numbers units = Numbers::list(), list = Numbers::list();
  for (const char* unit : prefixed) units.push_back(std::string(unit));
  for (const auto& [factor, prefix] : prefixes) list.push_back(Numbers::list({factor, std::string(prefix)}));
  return {{"prefixed", std::move(units)}, {"prefixes", std::move(list)}, {"from", from}};
}

int decimals_of(double error) {
  const int decimals = 1 - static_cast<int>(std::floor(std::log10(error)));
  return std::round(error * std::pow(10, decimals)) >= 100 ? decimals - 1 : decimals;
}

}  // namespace arenite::statistics
