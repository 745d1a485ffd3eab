#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/collect.hpp"

namespace arenite::study {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::pair<std::string, Estimate>>;

constexpr std::size_t most_items = 4;

bool is_number(const Json& j) { return j.is_number() || j.is_boolean(); }

double number_in(const Json& j) { return j.is_boolean() ? static_cast<double>(j.get<bool>()) : j.get<double>(); }

/// Tensors and pairs, not curves.
bool is_short(const Json& list) {
  return list.size() <= most_items && std::all_of(list.begin(), list.end(), [](const Json& item) { return is_number(item) || (item.is_array() && is_short(item)); });
}

void flatten(const Json& j, const std::string& name, Numbers& out);

/// The error that stands beside item `i` of a list of values.
void flatten_list(const Json& values, const Json* errors, const std::string& name, Numbers& out) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string item = name + "." + std::to_string(i);
    const Json* error = errors && errors->is_array() && i < errors->size() ? &(*errors)[i] : nullptr;
    if (values[i].is_array()) flatten_list(values[i], error, item, out);
    else out.emplace_back(item, Estimate{number_in(values[i]), error && is_number(*error) ? std::optional(number_in(*error)) : std::nullopt});
  }
}

void flatten_object(const Json& j, const std::string& name, Numbers& out) {
  const auto value = j.find("value"), error = j.find("error");
  if (value != j.end() && is_number(*value)) {
    out.emplace_back(name, Estimate{number_in(*value), error != j.end() && is_number(*error) ? std::optional(number_in(*error)) : std::nullopt});
    return;
  }
  if (value != j.end() && value->is_array()) {
    if (is_short(*value)) flatten_list(*value, error != j.end() ? &*error : nullptr, name, out);
    return;
  }
  for (const auto& [key, inner] : j.items())
    if (key != "provenance") flatten(inner, name.empty() ? key : name + "." + key, out);
}

void flatten(const Json& j, const std::string& name, Numbers& out) {
  if (is_number(j)) out.emplace_back(name, Estimate{number_in(j), std::nullopt});
  else if (j.is_object()) flatten_object(j, name, out);
  else if (j.is_array() && is_short(j)) flatten_list(j, nullptr, name, out);
  else if (j.is_array())
    for (const Json& item : j)
      if (item.is_object() && item.contains("name") && item["name"].is_string()) flatten(item, name + "." + item["name"].get<std::string>(), out);
}

}  // namespace

Numbers flat_numbers(const std::string& json) {
  Numbers numbers;
  const Json j = Json::parse(json, nullptr, false);
  if (!j.is_discarded()) flatten(j, "", numbers);
  return numbers;
}

}  // namespace arenite::study
