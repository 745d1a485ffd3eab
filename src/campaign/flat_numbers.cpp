#include <algorithm>

#include "statistics/numbers.hpp"
#include "campaign/collect.hpp"

namespace arenite::study {
namespace {

using Flat = std::vector<std::pair<std::string, Estimate>>;

constexpr std::size_t most_items = 4;

bool is_number(const Numbers& j) { return j.is_number() || j.is_truth(); }

double number_in(const Numbers& j) { return j.is_truth() ? static_cast<double>(j.get<bool>()) : j.get<double>(); }

/// Tensors and pairs, not curves.
bool is_short(const Numbers& list) {
  return list.size() <= most_items && std::all_of(list.begin(), list.end(), [](const Numbers& item) { return is_number(item) || (item.is_list() && is_short(item)); });
}

void flatten(const Numbers& j, const std::string& name, Flat& out);

/// The error that stands beside item `i` of a list of values.
void flatten_list(const Numbers& values, const Numbers* errors, const std::string& name, Flat& out) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string item = name + "." + std::to_string(i);
    const Numbers* error = errors && errors->is_list() && i < errors->size() ? &(*errors)[i] : nullptr;
    if (values[i].is_list()) flatten_list(values[i], error, item, out);
    else out.emplace_back(item, Estimate{number_in(values[i]), error && is_number(*error) ? std::optional(number_in(*error)) : std::nullopt});
  }
}

void flatten_object(const Numbers& j, const std::string& name, Flat& out) {
  const auto value = j.find("value"), error = j.find("error");
  if (value != j.end() && is_number(*value)) {
    out.emplace_back(name, Estimate{number_in(*value), error != j.end() && is_number(*error) ? std::optional(number_in(*error)) : std::nullopt});
    return;
  }
  if (value != j.end() && value->is_list()) {
    if (is_short(*value)) flatten_list(*value, error != j.end() ? &*error : nullptr, name, out);
    return;
  }
  for (const auto& [key, inner] : j.items())
    if (key != "provenance") flatten(inner, name.empty() ? key : name + "." + key, out);
}

void flatten(const Numbers& j, const std::string& name, Flat& out) {
  if (is_number(j)) out.emplace_back(name, Estimate{number_in(j), std::nullopt});
  else if (j.is_tree()) flatten_object(j, name, out);
  else if (j.is_list() && is_short(j)) flatten_list(j, nullptr, name, out);
  else if (j.is_list())
    for (const Numbers& item : j)
      if (item.is_tree() && item.contains("name") && item["name"].is_text()) flatten(item, name + "." + item["name"].get<std::string>(), out);
}

}  // namespace

Flat flat_numbers(const Numbers& numbers) {
  Flat flat;
  flatten(numbers, "", flat);
  return flat;
}

}  // namespace arenite::study
