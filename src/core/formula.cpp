#include "core/formula.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/text.hpp"

namespace arenite {
namespace {

struct Operator {
  std::string_view word;
  double (*of)(double, double);
};
constexpr Operator operators[] = {{"+", [](double a, double b) { return a + b; }},
                                  {"-", [](double a, double b) { return a - b; }},
                                  {"*", [](double a, double b) { return a * b; }},
                                  {"/", [](double a, double b) { return a / b; }},
                                  {"hypot", [](double a, double b) { return std::hypot(a, b); }},
                                  {"atan2", [](double a, double b) { return std::atan2(a, b); }}};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!(text = trimmed(text)).empty()) {
    words.push_back(text.substr(0, text.find(' ')));
    text.remove_prefix(words.back().size());
  }
  return words;
}

}  // namespace

std::vector<double> evaluated(std::string_view formula, std::size_t size, const NamedValues& of) {
  std::vector<std::vector<double>> stack;
  for (const std::string_view word : words_of(formula)) {
    if (const auto* op = std::ranges::find(operators, word, &Operator::word); op != std::end(operators)) {
      if (stack.size() < 2) throw std::logic_error("formula: too few values before " + std::string(word));
      const std::vector<double> right = std::move(stack.back());
      stack.pop_back();
      std::ranges::transform(stack.back(), right, stack.back().begin(), op->of);
    } else if (word == "pi") {
      stack.emplace_back(size, std::numbers::pi);
    } else if (std::isdigit(static_cast<unsigned char>(word.front())) != 0) {
      stack.emplace_back(size, std::stod(std::string(word)));
    } else {
      stack.push_back(of(word));
      if (stack.back().size() != size) throw std::logic_error("formula: no values of " + std::string(word));
    }
  }
  if (stack.size() != 1) throw std::logic_error("formula: \"" + std::string(formula) + "\" gives no single number");
  return std::move(stack.front());
}

}  // namespace arenite
