#include "core/expression.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/decimals.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/unit_names.hpp"

namespace arenite {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

struct Function {
  std::string_view name;
  std::size_t arguments;
  enum class Takes { number, any } takes;  ///< `any`: all of one dimension, which the value has, too
  double (*of)(double, double);
};
using Takes = Function::Takes;
constexpr Function functions[] = {{"abs", 1, Takes::any, [](double a, double) { return std::abs(a); }},
                                  {"min", 2, Takes::any, [](double a, double b) { return std::min(a, b); }},
                                  {"max", 2, Takes::any, [](double a, double b) { return std::max(a, b); }},
                                  {"sin", 1, Takes::number, [](double a, double) { return std::sin(a); }},
                                  {"cos", 1, Takes::number, [](double a, double) { return std::cos(a); }},
                                  {"tan", 1, Takes::number, [](double a, double) { return std::tan(a); }},
                                  {"exp", 1, Takes::number, [](double a, double) { return std::exp(a); }},
                                  {"log", 1, Takes::number, [](double a, double) { return std::log(a); }},
                                  {"round", 1, Takes::number, [](double a, double) { return std::round(a); }},
                                  {"floor", 1, Takes::number, [](double a, double) { return std::floor(a); }},
                                  {"ceil", 1, Takes::number, [](double a, double) { return std::ceil(a); }}};
constexpr std::string_view root = "sqrt", circle = "pi";

const Function* function_named(std::string_view name) {
  const auto at = std::ranges::find(functions, name, &Function::name);
  return at == std::end(functions) ? nullptr : at;
}

Dimension raised(Dimension d, double power) {
  return {d.mass * power, d.length * power, d.time * power, d.temperature * power};
}

/// Recursive descent over: sum = product {("+" | "-") product}; product = signed {("*" | "/") signed}; signed =
/// ["-" | "+"] power; power = primary ["^" signed]; primary = number [unit] | name | name "(" sum {"," sum} ")" |
/// "(" sum ")".
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, const Variables& variables) : text_(text), rest_(text), known_(variables) {}

  Quantity read() {
    const Quantity value = sum(0);
    skip_spaces();
    if (!rest_.empty()) fail(fmt::format("unexpected \"{}\"", rest_));
    if (!std::isfinite(value.value) || !is_in_reach(value.value)) fail("it is not a finite number in reach");
    return {in_decimals(value.value, value.value), value.dimension, si_unit(value.dimension)};
  }

 private:
  static constexpr int deepest = 32;

  [[noreturn]] void fail(const std::string& why) const { throw refusal("cannot evaluate \"{}\": {}", text_, why); }

  void skip_spaces() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
  }
  bool take(char token) {
    skip_spaces();
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char token) {
    if (!take(token)) fail(fmt::format("a \"{}\" is missing", token));
  }

  Quantity sum(int depth) {
    if (depth > deepest) fail("it has too many brackets");
    Quantity value = product(depth);
    for (;;) {
      const bool plus = take('+');
      if (!plus && !take('-')) return value;
      const Quantity other = product(depth);
      require_alike(value, other, plus ? "added to" : "taken from");
      const double size = std::max(std::abs(value.value), std::abs(other.value));
      value.value = in_decimals(value.value + (plus ? other.value : -other.value), size);
    }
  }

  Quantity product(int depth) {
    Quantity value = with_sign(depth);
    for (;;) {
      if (take('*')) {
        const Quantity other = with_sign(depth);
        value = {value.value * other.value, value.dimension * other.dimension, {}};
      } else if (take('/')) {
        const Quantity other = with_sign(depth);
        if (other.value == 0) fail("it divides by zero");
        value = {value.value / other.value, value.dimension / other.dimension, {}};
      } else {
        return value;
      }
    }
  }

  Quantity with_sign(int depth) {
    if (depth > deepest) fail("it has too many signs");
    if (take('+')) return with_sign(depth + 1);
    if (!take('-')) return power(depth);
    Quantity value = with_sign(depth + 1);
    value.value = -value.value;
    return value;
  }

  Quantity power(int depth) {
    const Quantity base = primary(depth);
    if (!take('^')) return base;
    const Quantity exponent = with_sign(depth + 1);
    if (exponent.dimension != dimension::none) fail("an exponent must be a number without unit");
    if (base.dimension != dimension::none && 2 * exponent.value != std::round(2 * exponent.value))
      fail("an exponent of a quantity with a unit must be a whole number or end in .5");
    return {std::pow(base.value, exponent.value), raised(base.dimension, exponent.value), {}};
  }

  Quantity primary(int depth) {
    if (take('(')) {
      const Quantity value = sum(depth + 1);
      expect(')');
      return value;
    }
    if (!rest_.empty() && (is_digit(rest_.front()) || rest_.front() == '.')) return number();
    const std::string_view word = name();
    if (word.empty()) fail(rest_.empty() ? "something is missing at its end" : fmt::format("unexpected \"{}\"", rest_));
    if (take('(')) return call(word, depth);
    const auto at = std::ranges::find(known_, word, &Variable::name);
    if (at != known_.end()) return at->value;
    if (word == circle) return {std::numbers::pi, {}, {}};
    const auto names = mapped(known_, &Variable::name);
    const std::string near = nearest(word, names);
    fail(!near.empty()    ? fmt::format("there is no variable \"{}\"; did you mean {}?", word, near)
         : known_.empty() ? fmt::format("there is no variable \"{}\"; define it in [variables]", word)
                          : fmt::format("there is no variable \"{}\"; there are: {}", word, list_of(names)));
  }

  Quantity call(std::string_view word, int depth) {
    std::vector<Quantity> argument{sum(depth + 1)};
    while (take(',')) argument.push_back(sum(depth + 1));
    expect(')');
    const Quantity& first = argument.front();
    const Function* function = function_named(word);
    if (!function && word != root) fail(fmt::format("there is no function \"{}\"", word));
    if (argument.size() != (function ? function->arguments : 1))
      fail(fmt::format("{} has too few or too many arguments", word));
    if (!function) return {std::sqrt(first.value), raised(first.dimension, 0.5), {}};
    if (function->takes == Takes::number && first.dimension != dimension::none)
      fail(fmt::format("{} takes a number without unit or an angle, but got {}", word, describe(first.dimension)));
    require_alike(argument.back(), first, "compared with");
    return {function->of(first.value, argument.back().value), first.dimension, {}};
  }

  void require_alike(const Quantity& a, const Quantity& b, std::string_view verb) const {
    if (a.dimension == b.dimension) return;
    fail(fmt::format("{} cannot be {} {}", describe(b.dimension), verb, describe(a.dimension)));
  }

  std::string_view name() {
    skip_spaces();
    std::size_t n = 0;
    while (n < rest_.size() && (is_letter(rest_[n]) || (n > 0 && is_digit(rest_[n])))) ++n;
    const std::string_view word = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return word;
  }

  /// A number with what follows of it that is a unit and no variable: "27.35 kN/mm" is one quantity.
  Quantity number() {
    const std::size_t digits = number_length(rest_);
    std::size_t end = digits;
    for (std::size_t next = digits; const auto length = unit_at(rest_.substr(next), end == digits);) {
      next += *length;
      end = next;
    }
    const std::string_view quantity = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return parse_quantity(quantity);
  }

  /// Length of " mm", "/mm^2" or " s" at the start of a text; nothing if no unit stands there.
  std::optional<std::size_t> unit_at(std::string_view text, bool first) const {
    std::size_t at = text.find_first_not_of(' ');
    if (at == std::string_view::npos) return std::nullopt;
    if (!first && (text[at] == '/' || text[at] == '*')) at = std::min(text.find_first_not_of(' ', at + 1), text.size());
    if (first && text.substr(at).starts_with("1/")) at += 2;  // 5 1/s
    std::size_t end = at;
    while (end < text.size() &&
           (is_letter(text[end]) || text[end] == '%' || static_cast<unsigned char>(text[end]) >= 128))
      ++end;
    const std::string_view symbol = text.substr(at, end - at);
    if (symbol.empty() || std::ranges::count(known_, symbol, &Variable::name) > 0) return std::nullopt;
    if (end < text.size() && (text[end] == '(' || is_digit(text[end]))) return std::nullopt;
    try {
      parse_unit(symbol);
    } catch (const InputError&) {
      if (first && symbol != circle && !function_named(symbol) && symbol != root) throw;
      return std::nullopt;
    }
    return end + power_length(text.substr(end));
  }

  std::string_view text_, rest_;
  const Variables& known_;
};

}  // namespace

Quantity evaluate(std::string_view text, const Variables& variables) {
  return ExpressionReader(trimmed(text), variables).read();
}

bool is_variable_name(std::string_view name) {
  const bool is_name = !name.empty() && is_letter(name.front()) &&
                       std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c); });
  if (!is_name || function_named(name) || name == root || name == circle) return false;
  // W, h, t and g are better names than units; m, s, N, K and all longer symbols are not.
  if (name.size() == 1) return std::string_view("msNK").find(name) == std::string_view::npos;
  try {
    return parse_unit(name), false;
  } catch (const InputError&) { return true; }
}

bool is_expression(std::string_view text, const Variables& variables) {
  text = trimmed(text);
  std::string_view word;
  for (std::size_t at = 0; at < text.size();) {
    if (!is_letter(text[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
    word = text.substr(at, end - at);
    if (std::ranges::count(variables, word, &Variable::name) > 0) return true;
    if (end < text.size() && text[end] == '(' && (function_named(word) || word == root)) return true;
    at = end;
  }
  try {
    parse_quantity(text);
    return false;
  } catch (const InputError&) {
    // Sums and products of numbers, and no sentence.
    return !text.empty() &&
           (is_digit(text.front()) || text.front() == '(' || text.front() == '-' || text.front() == '.') &&
           text.find_first_of("+*/(-", 1) != std::string_view::npos;
  }
}

}  // namespace arenite
