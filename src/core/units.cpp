#include "core/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/nearest.hpp"

namespace arenite {
namespace {

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
  bool prefixes;
};

constexpr double pi = 3.141592653589793;
constexpr std::array units{
    NamedUnit{"m", {1, 0, dimension::length}, true},
    NamedUnit{"g", {1, -3, dimension::mass}, true},
    NamedUnit{"t", {1, 3, dimension::mass}, false},
    NamedUnit{"s", {1, 0, dimension::time}, true},
    NamedUnit{"min", {60, 0, dimension::time}, false},
    NamedUnit{"h", {3600, 0, dimension::time}, false},
    NamedUnit{"K", {1, 0, dimension::temperature}, true},
    NamedUnit{"N", {1, 0, dimension::force}, true},
    NamedUnit{"Pa", {1, 0, dimension::pressure}, true},
    NamedUnit{"bar", {1, 5, dimension::pressure}, true},
    NamedUnit{"J", {1, 0, dimension::energy}, true},
    NamedUnit{"W", {1, 0, dimension::energy / dimension::time}, true},
    NamedUnit{"Hz", {1, 0, dimension::frequency}, true},
    NamedUnit{"rad", {1, 0, dimension::none}, false},
    NamedUnit{"deg", {pi / 180, 0, dimension::none}, false},
    NamedUnit{"%", {1, -2, dimension::none}, false},
    NamedUnit{"1", {1, 0, dimension::none}, false},
};

struct Prefix {
  std::string_view symbol;
  int decade;
};
constexpr std::array prefixes{Prefix{"k", 3},  Prefix{"m", -3}, Prefix{"M", 6},  Prefix{"G", 9},   Prefix{"c", -2},
                              Prefix{"d", -1}, Prefix{"h", 2},  Prefix{"u", -6}, Prefix{"µ", -6},  Prefix{"μ", -6},
                              Prefix{"n", -9}, Prefix{"p", -12}, Prefix{"T", 12}};

struct NamedDimension {
  Dimension dimension;
  std::string_view name, unit;
};
constexpr std::array named_dimensions{
    NamedDimension{dimension::none, "a number without unit", ""},
    NamedDimension{dimension::length, "a length", "m"},
    NamedDimension{dimension::mass, "a mass", "kg"},
    NamedDimension{dimension::time, "a time", "s"},
    NamedDimension{dimension::temperature, "a temperature", "K"},
    NamedDimension{dimension::area, "an area", "m^2"},
    NamedDimension{dimension::volume, "a volume", "m^3"},
    NamedDimension{dimension::frequency, "a rate", "1/s"},
    NamedDimension{dimension::velocity, "a velocity", "m/s"},
    NamedDimension{dimension::acceleration, "an acceleration", "m/s^2"},
    NamedDimension{dimension::density, "a density", "kg/m^3"},
    NamedDimension{dimension::force, "a force", "N"},
    NamedDimension{dimension::pressure, "a pressure", "Pa"},
    NamedDimension{dimension::energy, "an energy", "J"},
    NamedDimension{dimension::stiffness, "a force per length", "N/m"},
    NamedDimension{dimension::damping, "a damping coefficient", "N s/m"},
    NamedDimension{dimension::thermoelastic_factor, "a thermoelastic factor", "K/Pa"},
};

const NamedDimension* find_name(Dimension d) {
  for (const auto& named : named_dimensions) {
    if (named.dimension == d) return &named;
  }
  return nullptr;
}

std::vector<std::string> all_symbols() {
  std::vector<std::string> symbols;
  for (const auto& unit : units) symbols.emplace_back(unit.symbol);
  for (const auto& unit : units) {
    for (const auto& prefix : prefixes) {
      if (unit.prefixes) symbols.push_back(std::string(prefix.symbol) + std::string(unit.symbol));
    }
  }
  return symbols;
}

[[noreturn]] void unknown_unit(std::string_view symbol) {
  const std::string near = nearest(symbol, all_symbols());
  throw InputError(near.empty() ? fmt::format("unknown unit \"{}\"; units are written like mm, kN/mm, kg/m^3, K/MPa or %", symbol)
                                : fmt::format("unknown unit \"{}\"; did you mean {}?", symbol, near));
}

Unit find_unit(std::string_view symbol) {
  for (const auto& known : units) {
    if (symbol == known.symbol) return known.unit;
  }
  for (const auto& known : units) {
    if (!known.prefixes || !symbol.ends_with(known.symbol)) continue;
    const std::string_view front = symbol.substr(0, symbol.size() - known.symbol.size());
    for (const auto& prefix : prefixes) {
      if (front != prefix.symbol) continue;
      Unit unit = known.unit;
      unit.decade += prefix.decade;
      return unit;
    }
  }
  unknown_unit(symbol);
}

Unit raised(Unit unit, int power) {
  return {std::pow(unit.factor, power), unit.decade * power,
          {unit.dimension.mass * power, unit.dimension.length * power, unit.dimension.time * power,
           unit.dimension.temperature * power}};
}

Unit operator*(const Unit& a, const Unit& b) {
  return {a.factor * b.factor, a.decade + b.decade, a.dimension * b.dimension};
}

/// Recursive descent over: expression = factor {("*" | "·" | " " | "/") factor}; factor = (symbol | "(" expression
/// ")") ["^" integer | superscript].
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text), rest_(text) {}

  Unit read() {
    const Unit unit = expression(0);
    if (!rest_.empty()) fail(fmt::format("unexpected \"{}\"", rest_));
    return unit;
  }

 private:
  static constexpr int deepest = 8, largest_power = 9, most_factors = 16;

  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(fmt::format("cannot read the unit \"{}\": {}", text_, why));
  }

  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  void skip_spaces() {
    while (take(" ")) {
    }
  }

  Unit expression(int depth) {
    skip_spaces();
    bool divided = take("/");
    Unit product = divided ? raised(factor(depth), -1) : factor(depth);
    for (int factors = 1;; ++factors) {
      if (factors > most_factors) fail("too many factors");
      skip_spaces();
      if (rest_.empty() || rest_.front() == ')') return product;
      if (take("/")) {
        divided = true;
        product = product * raised(factor(depth), -1);
        continue;
      }
      if (divided) fail("a product after a quotient can be read in two ways; write brackets, as in N/(m s)");
      if (!take("*")) take("·");
      product = product * factor(depth);
    }
  }

  Unit factor(int depth) {
    skip_spaces();
    Unit unit;
    if (take("(")) {
      if (depth == deepest) fail("too many brackets");
      unit = expression(depth + 1);
      if (!take(")")) fail("a bracket is not closed");
    } else {
      unit = find_unit(symbol());
    }
    return raised(unit, power());
  }

  std::string_view symbol() {
    std::size_t length = 0;
    while (length < rest_.size()) {
      const std::string_view here = rest_.substr(length);
      const bool ends = std::string_view(" */^()").find(here.front()) != std::string_view::npos ||
                        here.starts_with("·") || here.starts_with("²") || here.starts_with("³");
      if (ends) break;
      ++length;
    }
    if (length == 0) fail("a unit is missing");
    const std::string_view found = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return found;
  }

  int power() {
    if (take("²")) return 2;
    if (take("³")) return 3;
    skip_spaces();
    if (!take("^")) return 1;
    skip_spaces();
    int value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{} || std::abs(value) > largest_power) {
      fail(fmt::format("the power must be a whole number from -{0} to {0}", largest_power));
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  std::string_view text_, rest_;
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Length of the decimal number that `text` starts with (0: none), and where its exponent part begins.
struct NumberSpan {
  std::size_t length = 0, mantissa = 0;
};
NumberSpan number_span(std::string_view text) {
  const auto digits = [&](std::size_t& at) {
    const std::size_t first = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return at - first;
  };
  std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  std::size_t count = digits(at);
  if (at < text.size() && text[at] == '.') count += digits(++at);
  if (count == 0) return {};
  const std::size_t mantissa = at;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t exponent = at + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    if (digits(exponent) > 0) return {exponent, mantissa};
  }
  return {mantissa, mantissa};
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
  const std::string text = fmt::format("{}e{}", mantissa, exponent + decade);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? std::optional(value) : std::nullopt;
}

[[noreturn]] void no_number(std::string_view text) {
  for (const std::string_view word : {"nan", "inf", "+inf", "-inf", "NaN", "Inf", "infinity"}) {
    if (text.starts_with(word)) throw InputError(fmt::format("\"{}\" is not a finite number", text));
  }
  throw InputError(fmt::format("\"{}\" does not start with a number; write for example \"350 mm\"", text));
}

std::string with_unit(Dimension d) {
  const std::string unit = si_unit(d);
  return unit.empty() || !find_name(d) ? describe(d) : fmt::format("{} ({})", describe(d), unit);
}

}  // namespace

Unit parse_unit(std::string_view text) { return UnitReader(trimmed(text)).read(); }

Quantity parse_quantity(std::string_view text) {
  text = trimmed(text);
  const NumberSpan span = number_span(text);
  if (span.length == 0) no_number(text);
  const std::string_view rest = trimmed(text.substr(span.length));
  if (!rest.empty() && rest.front() == ',') {
    throw InputError(fmt::format("\"{}\" has a comma; write a decimal point", text));
  }
  const Unit unit = rest.empty() ? Unit{} : parse_unit(rest);
  const auto value = shifted(text, span, unit.decade);
  if (!value || !std::isfinite(*value * unit.factor)) {
    throw InputError(fmt::format("\"{}\" is beyond the range of numbers", text));
  }
  return {*value * unit.factor, unit.dimension, !rest.empty()};
}

double parse_si(std::string_view text, Dimension wanted, std::string_view unit) {
  const Quantity quantity = parse_quantity(text);
  if (quantity.dimension == wanted && (quantity.has_unit || wanted == dimension::none)) return quantity.value;
  const std::string suggested = unit.empty() ? si_unit(wanted) : std::string(unit);
  if (!quantity.has_unit) {
    throw InputError(fmt::format("\"{0}\" has no unit; write it with its unit, for example \"{0} {1}\"", trimmed(text),
                                 suggested));
  }
  throw InputError(suggested.empty()
                       ? fmt::format("\"{}\" is {}, but a number without unit is needed", trimmed(text),
                                     with_unit(quantity.dimension))
                       : fmt::format("\"{}\" is {}, but {} is needed; write it in {}", trimmed(text),
                                     with_unit(quantity.dimension), with_unit(wanted), suggested));
}

std::string format_quantity(double si_value, std::string_view unit) {
  // The shortest digits of the SI value with their exponent moved read back as the very same double.
  const int decade = unit.empty() ? 0 : parse_unit(unit).decade;
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), si_value, std::chars_format::scientific).ptr;
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
  if (si_value == 0) {
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

std::string si_unit(Dimension dimension) {
  if (const auto* named = find_name(dimension)) return std::string(named->unit);
  std::string text;
  const std::array<std::pair<const char*, int>, 4> bases{
      {{"kg", dimension.mass}, {"m", dimension.length}, {"s", dimension.time}, {"K", dimension.temperature}}};
  for (const auto& [symbol, power] : bases) {
    if (power == 0) continue;
    text += (text.empty() ? "" : " ") + std::string(symbol);
    if (power != 1) text += fmt::format("^{}", power);
  }
  return text;
}

std::string describe(Dimension dimension) {
  const auto* named = find_name(dimension);
  return named ? std::string(named->name) : "a quantity in " + si_unit(dimension);
}

}  // namespace arenite
