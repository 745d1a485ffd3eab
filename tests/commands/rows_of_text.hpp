#pragma once
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

namespace arenite::test {

/// Numbers of the JSON that have no row in the text, or one that does not say what they are.
inline std::string rows_without_meaning(const std::string& text, const nlohmann::json& numbers,
                                        const std::string& prefix = "") {
  std::string without;
  for (const auto& [name, value] : numbers.items()) {
    const bool has_error = value.is_object() && value.contains("value");  // a row of its own
    if (value.is_object() && !has_error) without += rows_without_meaning(text, value, prefix + name + ".");
    if (!value.is_number() && !value.is_boolean() && !has_error) continue;
    const auto at = text.find("  " + prefix + name + " ");
    const std::string row = at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
    if (!std::regex_search(row, std::regex("  [A-Z][a-z]+ "))) without += prefix + name + " ";
  }
  return without;
}

}  // namespace arenite::test
