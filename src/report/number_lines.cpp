#include "report/number_lines.hpp"

#include <fmt/format.h>

#include "statistics/text.hpp"

namespace arenite::report {

std::string shown(const Numbers& j) {
  if (j.is_integer()) return to_json(j);
  if (j.is_number()) return fmt::format("{:.5g}", j.get<double>());
  if (j.is_truth()) return j.get<bool>() ? "yes" : "no";
  if (j.is_text()) return j.get<std::string>();
  if (!j.is_tree() || !j.contains("value") || !j["value"].is_known()) return {};
  const double value = j["value"].get<double>();
  return j.contains("error") && j["error"].is_number() ? statistics::with_error({value, j["error"].get<double>()}) : fmt::format("{:.5g}", value);
}

void NumberLines::add(const std::string& name, const std::string& path, const char* unit) {
  const Numbers* at = root_.at_path(path);
  const std::string value = at ? shown(*at) : "";
  if (!value.empty()) text_ += fmt::format("  {:<34} {}{}{}\n", name, value, *unit ? " " : "", unit);
}

}  // namespace arenite::report
