#include "report/number_lines.hpp"

#include <fmt/format.h>

#include "statistics/text.hpp"

namespace arenite::report {

using Json = nlohmann::json;

std::string shown(const Json& j) {
  if (j.is_number_integer()) return j.dump();
  if (j.is_number()) return fmt::format("{:.5g}", j.get<double>());
  if (j.is_boolean()) return j.get<bool>() ? "yes" : "no";
  if (j.is_string()) return j.get<std::string>();
  if (!j.is_object() || !j.contains("value") || j["value"].is_null()) return {};
  const double value = j["value"];
  return j.contains("error") && j["error"].is_number() ? statistics::with_error({value, j["error"]}) : fmt::format("{:.5g}", value);
}

void NumberLines::add(const std::string& name, const std::string& path, const char* unit) {
  const Json::json_pointer at(path);
  if (!root_.contains(at)) return;
  const std::string value = shown(root_[at]);
  if (!value.empty()) text_ += fmt::format("  {:<34} {}{}{}\n", name, value, *unit ? " " : "", unit);
}

}  // namespace arenite::report
