#include "report/figures/drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/mapped.hpp"

namespace arenite::report::figures {
namespace {

std::string with_true_minus(std::string text) {
  for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; at += 3) text.replace(at, 1, "\u2212");
  return text;
}

}  // namespace

Scale scale_of(const std::vector<double>& values, const std::string& unit) {
  return scale_of(largest_of(mapped(values, [](double v) { return std::abs(v); }), 0), unit);
}

std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return "\u2013";
  if (value == 0) return "0";
  const int power = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (power >= 5 || power < -3) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    const std::size_t e = text.find('e');
    return with_true_minus(text.substr(0, e)) + "\u00b710" + statistics::raised_figures(std::stoi(text.substr(e + 1)));
  }
  return with_true_minus(fmt::format("{:.{}f}", value, std::max(0, digits - 1 - power)));
}

std::string counted(double value) {
  std::string text = fmt::format("{:.0f}", value);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, "\u202f");
  return text;
}

Said said(std::string symbol, const statistics::Estimate& e) {
  if (!(e.error > 1e-7 * std::abs(e.value))) return {std::move(symbol), rounded(e.value, 4)};
  const int decimals = std::clamp(statistics::decimals_of(e.error), 0, 8);
  return {std::move(symbol), with_true_minus(fmt::format("{:.{}f}", e.value, decimals)),
          fmt::format("{:.{}f}", e.error, decimals)};
}

Said said_in_unit(std::string symbol, const statistics::Estimate& e, const std::string& unit) {
  const Scale scale = scale_of(e.value, unit);
  Said number = said(std::move(symbol), {e.value / scale.factor, e.error / scale.factor});
  (number.error.empty() ? number.value : number.error) += "\u202f" + scale.unit;
  return number;
}

std::string in_words(const Said& number) {
  return fmt::format("{} = {}{}{}", number.symbol, number.value, number.error.empty() ? "" : " \u00b1 ", number.error);
}

std::string between_dashes(std::string key) {
  if (const std::size_t at = key.find('-'); at != std::string::npos) key.replace(at, 1, "\u2013");
  return key;
}

statistics::Estimate estimate_at(const Numbers& tree, std::string_view path) {
  const Numbers* at = tree.at_path(path);
  if (!at) return {};
  if (at->is_number()) return {at->get<double>()};
  const auto part = [&](const char* name) {
    const auto found = at->is_tree() ? at->find(name) : at->end();
    return found != at->end() && found->is_number() ? found->get<double>() : statistics::unknown;
  };
  return {part("value"), part("error")};
}

std::vector<double> reals_at(const Numbers& tree, std::string_view path) {
  const Numbers* at = tree.at_path(path);
  if (!at || !at->is_list()) return {};
  std::vector<double> values;
  for (const Numbers& item : *at) values.push_back(item.is_number() ? item.get<double>() : statistics::unknown);
  return values;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

double largest_of(const std::vector<double>& values, double otherwise) {
  for (const double value : values)
    if (std::isfinite(value)) otherwise = std::max(otherwise, value);
  return otherwise;
}

double least_above_zero(const std::vector<double>& values, double otherwise) {
  for (const double value : values)
    if (value > 0 && value < otherwise) otherwise = value;
  return otherwise;
}

Axis decades_about(std::string label, double low, double high) {
  return {.label = std::move(label),
          .logarithmic = true,
          .low = std::pow(10, std::floor(std::log10(low))),
          .high = std::pow(10, std::ceil(std::log10(high)))};
}

}  // namespace arenite::report::figures
