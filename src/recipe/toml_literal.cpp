#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/units.hpp"
#include "recipe/recipe_document.hpp"
#include "recipe/recipe_record.hpp"

namespace arenite::study {
namespace {

std::string real_literal(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  std::string text = format_quantity(value, "");
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

std::string toml_literal(const Node& value) {
  std::vector<std::string> parts;
  switch (value.kind) {
    case Node::Kind::flag: return value.flag ? "true" : "false";
    case Node::Kind::integer: return std::to_string(value.integer);
    case Node::Kind::real: return real_literal(value.real);
    case Node::Kind::text: return toml_text(value.text);
    case Node::Kind::date: return "\"\"";
    case Node::Kind::array:
      for (const auto& item : value.items) parts.push_back(toml_literal(item));
      return fmt::format("[{}]", fmt::join(parts, ", "));
    case Node::Kind::table:
      for (const auto& entry : value.entries) parts.push_back(fmt::format("{} = {}", toml_key(entry.key), toml_literal(entry.value)));
      return fmt::format("{{ {} }}", fmt::join(parts, ", "));
  }
  return {};
}

}  // namespace arenite::study
