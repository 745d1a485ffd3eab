#pragma once
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "statistics/numbers.hpp"

namespace arenite::test {

inline Numbers tree_of(const nlohmann::ordered_json& j) {
  if (j.is_boolean()) return j.get<bool>();
  if (j.is_number_unsigned()) return j.get<std::uint64_t>();
  if (j.is_number_integer()) return j.get<std::int64_t>();
  if (j.is_number()) return j.get<double>();
  if (j.is_string()) return j.get<std::string>();
  if (j.is_null()) return {};
  Numbers out = j.is_array() ? Numbers::list() : Numbers::tree();
  if (j.is_array())
    for (const auto& item : j) out.push_back(tree_of(item));
  else
    for (const auto& [name, value] : j.items()) out[name] = tree_of(value);
  return out;
}

/// What JSON says; nothing where the text is none.
inline std::optional<Numbers> from_json(std::string_view text) {
  const auto j = nlohmann::ordered_json::parse(text, nullptr, false);
  return j.is_discarded() ? std::nullopt : std::optional(tree_of(j));
}

/// As they are written in JSON; not known where that is none.
inline Numbers numbers_of(const std::string& json) { return from_json(json).value_or(Numbers{}); }

inline std::vector<Numbers> numbers_of(std::initializer_list<const char*> json) {
  std::vector<Numbers> all;
  for (const char* text : json) all.push_back(numbers_of(std::string(text)));
  return all;
}

/// A number of a tree by its path, as "fabric/a_c", alone or the value of an estimate; NaN where it is not known.
inline double value_of(const Numbers& tree, const std::string& path) {
  const Numbers* node = tree.at_path("/" + path);
  if (node && node->is_tree() && node->contains("value")) node = &node->at("value");
  return node && node->is_number() ? node->get<double>() : statistics::unknown;
}

inline double error_of(const Numbers& tree, const std::string& path) { return value_of(tree, path + "/error"); }

/// A tensor or the value of its estimate.
inline Tensor2 tensor_of(const Numbers& tree, const std::string& path) {
  const std::string at = tree.at_path("/" + path + "/value") ? path + "/value/" : path + "/";
  return {value_of(tree, at + "0/0"), value_of(tree, at + "0/1"), value_of(tree, at + "1/0"),
          value_of(tree, at + "1/1")};
}

inline std::vector<double> list_of(const Numbers& tree, const std::string& path) {
  return tree.at_path("/" + path)->get<std::vector<double>>();
}

}  // namespace arenite::test
