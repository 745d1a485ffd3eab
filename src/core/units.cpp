#include "core/units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/unit_names.hpp"

namespace arenite {
namespace {

/// Length of the decimal number that `text` starts with (0: none), and where its exponent part begins.
struct NumberSpan {
  std::size_t length = 0, mantissa = 0;
};
NumberSpan number_span(std::string_view text) {
  const std::size_t sign = text.starts_with('+') || text.starts_with('-') ? 1 : 0;
  if (text.size() == sign || (!is_digit(text[sign]) && text[sign] != '.')) return {};
  double value = 0;
  const char* const end = std::from_chars(text.data() + sign, text.data() + text.size(), value).ptr;
  if (end == text.data() + sign) return {};
  const auto length = static_cast<std::size_t>(end - text.data());
  return {length, std::min(text.find_first_of("eE"), length)};
}

/// number * 10^decade, rounded once.
std::optional<double> shifted(std::string_view number, const NumberSpan& span, int decade) {
  int exponent = 0;
  if (span.length > span.mantissa) {
    std::string_view digits = number.substr(span.mantissa + 1, span.length - span.mantissa - 1);
    if (digits.front() == '+') digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc{} || std::abs(exponent) > 100'000) return std::nullopt;
  }
  std::string_view mantissa = number.substr(0, span.mantissa);
  if (mantissa.front() == '+') mantissa.remove_prefix(1);
  return parse_number<double>(fmt::format("{}e{}", mantissa, exponent + decade));
}

[[noreturn]] void no_number(std::string_view text) {
  for (const std::string_view word : {"nan", "inf", "+inf", "-inf", "NaN", "Inf", "infinity"})
    if (text.starts_with(word)) throw refusal("\"{}\" is not a finite number", text);
  throw refusal("\"{}\" does not start with a number; write for example \"350 mm\"", text);
}

std::string with_unit(Dimension d) {
  const std::string unit = si_unit(d);
  return unit.empty() || describe(d).ends_with(" in " + unit) ? describe(d) : fmt::format("{} ({})", describe(d), unit);
}

}  // namespace

bool is_in_reach(double value) {
  const double magnitude = std::abs(value);
  return magnitude == 0 || (magnitude >= 1e-60 && magnitude <= 1e60);
}

std::size_t number_length(std::string_view text) { return number_span(text).length; }

Quantity parse_quantity(std::string_view text) {
  text = trimmed(text);
  const NumberSpan span = number_span(text);
  if (span.length == 0) no_number(text);
  const std::string_view rest = trimmed(text.substr(span.length));
  if (rest.starts_with(',')) throw refusal("\"{}\" has a comma; write a decimal point", text);
  const Unit unit = rest.empty() ? Unit{} : parse_unit(rest);
  const auto value = shifted(text, span, unit.decade);
  if (!value || !is_in_reach(*value * unit.factor))
    throw refusal("\"{}\" is beyond the range of numbers, 1e-60 to 1e60 in SI units; write 0 or a number in it", text);
  return {*value * unit.factor, unit.dimension, std::string(rest)};
}

double parse_si(std::string_view text, Dimension wanted, std::string_view unit) {
  constexpr std::string_view times = " x ";
  if (const auto at = text.find(times); wanted == dimension::area && at != text.npos)
    return parse_si(text.substr(0, at), dimension::length) *
           parse_si(text.substr(at + times.size()), dimension::length);
  const Quantity quantity = parse_quantity(text);
  if (quantity.dimension == wanted && (!quantity.unit.empty() || wanted == dimension::none)) return quantity.value;
  const std::string suggested = unit.empty() ? si_unit(wanted) : std::string(unit);
  if (quantity.unit.empty())
    throw refusal("\"{0}\" has no unit; write it with its unit, for example \"{0} {1}\"", trimmed(text), suggested);
  throw InputError(suggested.empty() ? fmt::format("\"{}\" is {}, but a number without unit is needed", trimmed(text),
                                                   with_unit(quantity.dimension))
                                     : fmt::format("\"{}\" is {}, but {} is needed; write it in {}", trimmed(text),
                                                   with_unit(quantity.dimension), with_unit(wanted), suggested));
}

std::string format_quantity(double value, std::string_view unit) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  if (const double factor = unit.empty() ? 1 : parse_unit(unit).factor; factor != 1)
    return fmt::format("{:.15g} {}", value / factor, unit);
  // The shortest digits of the SI value with their exponent moved read back as the very same double.
  const int decade = unit.empty() ? 0 : parse_unit(unit).decade;
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific).ptr;
  const std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::size_t mark = digits.find('e');
  int exponent = 0;
  const std::size_t skip = mark + 1 < digits.size() && digits[mark + 1] == '+' ? 2 : 1;
  std::from_chars(digits.data() + mark + skip, end, exponent);
  exponent -= decade;
  std::string number(digits.substr(0, mark));
  const bool negative = number.front() == '-';
  if (negative) number.erase(0, 1);
  std::erase(number, '.');
  const int count = static_cast<int>(number.size());
  if (value == 0) {
    number = "0";
  } else if (exponent < -5 || exponent > 8) {
    if (count > 1) number.insert(1, ".");
    number += fmt::format("e{}", exponent);
  } else if (exponent < 0) {
    number.insert(0, "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0'));
  } else if (count > exponent + 1) {
    number.insert(static_cast<std::size_t>(exponent + 1), ".");
  } else {
    number.append(static_cast<std::size_t>(exponent + 1 - count), '0');
  }
  if (negative) number.insert(0, "-");
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

}  // namespace arenite
