#pragma once
#include "recipe/recipe.hpp"

#include <string>
#include <vector>

#include "core/error.hpp"
#include "model/packing.hpp"
#include "unit/recipe/smallest_recipe.hpp"

namespace arenite::recipe {

inline Recipe parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_recipe(text, "r.toml", overrides);
}

/// Every problem as main prints it, in order.
inline std::vector<std::string> problems(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parsed(text, overrides);
  } catch (const InputError& error) {
    std::vector<std::string> lines;
    for (const auto& problem : error.problems()) lines.push_back(to_string(problem));
    return lines;
  }
  return {};
}

/// The one problem of a text that has just one.
inline std::string only_problem(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const auto lines = problems(text, overrides);
  EXPECT_EQ(lines.size(), 1u) << text;
  return lines.empty() ? std::string() : lines.front();
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

}  // namespace arenite::recipe
