#include "core/unit_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace arenite {
namespace {

struct NamedDimension {
  Dimension dimension;
  std::string_view name, unit;
};
constexpr NamedDimension named_dimensions[] = {{dimension::none, "a number without unit", ""},
                                               {dimension::length, "a length", "m"},
                                               {dimension::mass, "a mass", "kg"},
                                               {dimension::time, "a time", "s"},
                                               {dimension::temperature, "a temperature", "K"},
                                               {dimension::area, "an area", "m^2"},
                                               {dimension::volume, "a volume", "m^3"},
                                               {dimension::frequency, "a rate", "1/s"},
                                               {dimension::velocity, "a velocity", "m/s"},
                                               {dimension::acceleration, "an acceleration", "m/s^2"},
                                               {dimension::density, "a density", "kg/m^3"},
                                               {dimension::force, "a force", "N"},
                                               {dimension::pressure, "a pressure", "Pa"},
                                               {dimension::energy, "an energy", "J"},
                                               {dimension::stiffness, "a force per length", "N/m"},
                                               {dimension::damping, "a damping coefficient", "N s/m"},
                                               {dimension::thermoelastic_factor, "a thermoelastic factor", "K/Pa"},
                                               {dimension::toughness, "a fracture toughness", "Pa m^0.5"}};

const NamedDimension* find_name(Dimension d) {
  const auto* named = std::find_if(std::begin(named_dimensions), std::end(named_dimensions),
                                   [&](const auto& known) { return known.dimension == d; });
  return named == std::end(named_dimensions) ? nullptr : named;
}

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
  bool prefixes;
};

constexpr double pi = 3.141592653589793;
constexpr NamedUnit units[] = {
    {"m", {1, 0, dimension::length}, true},         {"g", {1, -3, dimension::mass}, true},
    {"t", {1, 3, dimension::mass}, false},          {"s", {1, 0, dimension::time}, true},
    {"min", {60, 0, dimension::time}, false},       {"h", {3600, 0, dimension::time}, false},
    {"K", {1, 0, dimension::temperature}, true},    {"N", {1, 0, dimension::force}, true},
    {"Pa", {1, 0, dimension::pressure}, true},      {"bar", {1, 5, dimension::pressure}, true},
    {"J", {1, 0, dimension::energy}, true},         {"W", {1, 0, dimension::energy / dimension::time}, true},
    {"Hz", {1, 0, dimension::frequency}, true},     {"rad", {1, 0, dimension::none}, false},
    {"deg", {pi / 180, 0, dimension::none}, false}, {"%", {1, -2, dimension::none}, false},
    {"1", {1, 0, dimension::none}, false},          {"rpm", {pi / 30, 0, dimension::frequency}, false}};

struct Prefix {
  std::string_view symbol;
  int decade;
};
constexpr Prefix prefixes[] = {{"k", 3},  {"m", -3}, {"M", 6},  {"G", 9},  {"c", -2},  {"d", -1}, {"h", 2},
                               {"u", -6}, {"µ", -6}, {"μ", -6}, {"n", -9}, {"p", -12}, {"T", 12}};

std::vector<std::string> all_symbols() {
  std::vector<std::string> symbols;
  for (const auto& unit : units) symbols.emplace_back(unit.symbol);
  for (const auto& unit : units)
    for (const auto& prefix : prefixes)
      if (unit.prefixes) symbols.push_back(std::string(prefix.symbol) + std::string(unit.symbol));
  return symbols;
}

[[noreturn]] void unknown_unit(std::string_view symbol) {
  const std::string near = nearest(symbol, all_symbols());
  throw InputError(
      near.empty() ? fmt::format("unknown unit \"{}\"; units are written like mm, kN/mm, kg/m^3, K/MPa or %", symbol)
                   : fmt::format("unknown unit \"{}\"; did you mean {}?", symbol, near));
}

Unit find_unit(std::string_view symbol) {
  for (const auto& known : units)
    if (symbol == known.symbol) return known.unit;
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

Unit raised(Unit unit, double power) {
  const double decade = unit.decade * power, whole = std::trunc(decade);
  return {std::pow(unit.factor, power) * std::pow(10, decade - whole),
          static_cast<int>(whole),
          {unit.dimension.mass * power, unit.dimension.length * power, unit.dimension.time * power,
           unit.dimension.temperature * power}};
}

Unit operator*(const Unit& a, const Unit& b) {
  return {a.factor * b.factor, a.decade + b.decade, a.dimension * b.dimension};
}

/// Length of a fraction that a power starts with, "1/2" or "1/3"; 0: none. Others stand in brackets: of "m^3/2" the
/// half may be meant.
std::size_t fraction_length(std::string_view power) {
  if (!power.starts_with("1/")) return 0;
  const std::size_t end = std::min(power.find_first_not_of("0123456789", 2), power.size());
  return end > 2 && !power.substr(end).starts_with('.') ? end : 0;
}

bool is_half(std::string_view power) { return power.substr(0, fraction_length(power)) == "1/2"; }

/// Recursive descent over: expression = factor {("*" | "·" | " " | "/") factor}; factor = (symbol | "(" expression ")")
/// ["^" power | superscript]; a power is a whole number or ends in .5, or (1/2). "√" before a factor is its root.
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

  [[noreturn]] void fail(const std::string& why) const { throw refusal("cannot read the unit \"{}\": {}", text_, why); }

  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  void skip_spaces() {
    while (take(" ")) {}
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
    if (take("√")) {
      if (depth == deepest) fail("too many roots");
      return raised(factor(depth + 1), 0.5);
    }
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
                        here.starts_with("·") || here.starts_with("²") || here.starts_with("³") ||
                        here.starts_with("√");
      if (ends) break;
      ++length;
    }
    if (length == 0) fail("a unit is missing");
    const std::string_view found = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return found;
  }

  double power() {
    if (take("²")) return 2;
    if (take("³")) return 3;
    skip_spaces();
    if (!take("^")) return 1;
    skip_spaces();
    const bool is_root = is_half(rest_), in_brackets = take("(");
    double value = digits_of_power();
    if (!is_root && !in_brackets && divides_by_number()) wrong_power();  // a fraction is meant
    if ((is_root || in_brackets) && take("/")) value /= digits_of_power();
    if (in_brackets && !take(")")) fail("a bracket is not closed");
    if (!(std::abs(value) <= largest_power) || std::trunc(2 * value) != 2 * value) wrong_power();
    return value;
  }

  /// Whether "/3" or the like follows, which divides by no unit.
  bool divides_by_number() const {
    const std::string_view number = rest_.substr(0, std::min(rest_.find_first_not_of("0123456789", 1), rest_.size()));
    return rest_.starts_with('/') && number.size() > 1 && number != "/1";
  }

  double digits_of_power() {
    skip_spaces();
    double value = 0;
    const auto [end, error] =
        std::from_chars(rest_.data(), rest_.data() + rest_.size(), value, std::chars_format::fixed);
    if (error != std::errc{}) wrong_power();
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  [[noreturn]] void wrong_power() const {
    fail(fmt::format("the power must be a whole number from -{0} to {0}, or a half such as 0.5, (1/2) or (3/2)",
                     largest_power));
  }

  std::string_view text_, rest_;
};

}  // namespace

std::string si_unit(Dimension dimension) {
  if (const auto* named = find_name(dimension)) return std::string(named->unit);
  std::string text;
  const std::array<std::pair<const char*, double>, 4> bases{
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

std::size_t power_length(std::string_view text) {
  constexpr std::string_view of_numbers = "0123456789.";
  if (!text.starts_with('^') || text.size() < 2) return 0;
  if (const std::size_t fraction = fraction_length(text.substr(1)); fraction > 0) return 1 + fraction;
  if (text[1] == '(') {
    const std::size_t end = text.find_first_not_of("0123456789./-", 2);
    return end < text.size() && text[end] == ')' && text.find('/') < end ? end + 1 : 0;
  }
  const std::size_t begin = text[1] == '-' ? 2 : 1,
                    end = std::min(text.find_first_not_of(of_numbers, begin), text.size());
  return end > begin ? end : 0;
}

Unit parse_unit(std::string_view text) { return UnitReader(trimmed(text)).read(); }

}  // namespace arenite
