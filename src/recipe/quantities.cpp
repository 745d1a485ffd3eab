#include "recipe/quantities.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/text.hpp"
#include "core/unit_names.hpp"
#include "core/units.hpp"

namespace arenite::recipe {
namespace {

/// A number or a quantity; nothing, and `why`, where it is none, or is not known yet.
std::optional<Quantity> variable_of(const Node& value, const Variables& known, std::string& why) {
  if (value.kind == Node::Kind::integer) return Quantity{static_cast<double>(value.integer), {}, {}};
  if (value.kind == Node::Kind::real) return Quantity{value.real, {}, {}};
  if (value.kind != Node::Kind::text) {
    why = fmt::format("is {}, but must be a number, a quantity or an expression in quotes", kind_name(value));
    return std::nullopt;
  }
  try {
    return evaluate(value.text, known);
  } catch (const InputError& error) { return why = error.what(), std::nullopt; }
}

}  // namespace

void read_variables(const Node& root, Reading& reading) {
  const Entry* section = root.find("variables");
  if (!section) return;
  if (section->value.kind != Node::Kind::table)
    return reading.add(section->value.place, "variables",
                       fmt::format("is {}, but must be a section [variables]", kind_name(section->value)));
  std::vector<const Entry*> open;
  for (const Entry& entry : section->value.entries) {
    if (is_variable_name(entry.key)) open.push_back(&entry);
    else
      reading.add(entry.place, fmt::format("variables.{}", entry.key),
                  "cannot be the name of a variable; take letters, digits and _, and no unit or function");
  }
  // In any order: what a base defines may stand below what builds on it.
  std::string why;
  for (std::size_t before = open.size() + 1; !open.empty() && open.size() < before;) {
    before = open.size();
    std::erase_if(open, [&](const Entry* entry) {
      const auto value = variable_of(entry->value, reading.variables, why);
      if (value) reading.variables.push_back({entry->key, *value});
      return value.has_value();
    });
  }
  for (const Entry* entry : open) {
    variable_of(entry->value, reading.variables, why);
    reading.add(entry->value.place, fmt::format("variables.{}", entry->key), why);
  }
}

/// The SI value of a quantity or an expression that must have `wanted` as its dimension. Throws InputError without
/// place.
double si_value(std::string_view text, Dimension wanted, std::string_view unit, const Variables& variables) {
  if (unit != "deg/s" && text.find("rpm") != std::string_view::npos)
    throw InputError("rpm is a unit of rotation; give a frequency in Hz or 1/s");
  const bool names_one =
      !variables.empty() && !text.empty() && !is_digit(text[0]) && is_plain_name(text.substr(0, 1)) && text[0] != '-';
  if (!is_expression(text, variables) && !names_one) return parse_si(text, wanted, unit);
  const Quantity quantity = evaluate(text, variables);
  if (quantity.dimension == wanted) return quantity.value;
  throw InputError(fmt::format("\"{}\" is {}, but {} is needed", text, describe(quantity.dimension), describe(wanted)));
}

double nearest_whole(double value) {
  const double whole = std::round(value);
  return std::abs(value - whole) <= 1e-9 * std::max(1.0, std::abs(value)) ? whole : value;
}

std::optional<std::int64_t> whole_number(const Node& node) {
  if (node.kind == Node::Kind::integer) return node.integer;
  const bool is_whole =
      node.kind == Node::Kind::real && std::floor(node.real) == node.real && std::abs(node.real) < 1e15;
  return is_whole ? std::optional(static_cast<std::int64_t>(node.real)) : std::nullopt;
}

bool is_beyond_integers(const Node& node) {
  const std::string_view text = node.text, digits = text.substr(text.starts_with('-') ? 1 : 0);
  return node.kind == Node::Kind::text && !digits.empty() && std::ranges::all_of(digits, is_digit) &&
         !parse_number<std::int64_t>(text);
}

std::string as_written(const Node& node) {
  if (node.kind == Node::Kind::text) return "\"" + node.text + "\"";
  return node.kind == Node::Kind::integer ? std::to_string(node.integer) : format_quantity(node.real, "");
}

std::string unit_is_missing(const Node& node, std::string_view unit) {
  if (unit == "deg")
    return fmt::format(
        "{} has no unit; write an angle with its unit, for example \"90 deg\" (of a part of a cycle 360 times as much: "
        "\"{:.6g} deg\")",
        as_written(node), 360 * (node.kind == Node::Kind::integer ? static_cast<double>(node.integer) : node.real));
  return fmt::format("{0} has no unit; write it with its unit, for example \"{0} {1}\"", as_written(node), unit);
}

Dimension dimension_of(std::string_view unit) { return unit.empty() ? dimension::none : parse_unit(unit).dimension; }

std::string number_literal(double value, std::string_view unit) {
  return unit.empty() ? format_quantity(value, unit) : toml_text(format_quantity(value, unit));
}

std::string with_unit(std::string_view number, std::string_view unit) {
  return unit.empty() ? std::string(number) : fmt::format("\"{} {}\"", number, unit);
}

std::string tag_of_quantity(const std::string& text, const std::vector<Form>& forms) {
  try {
    const Dimension dimension = parse_quantity(text).dimension;
    const auto at = std::ranges::find_if(
        forms, [&](const Form& form) { return !form.unit.empty() && parse_unit(form.unit).dimension == dimension; });
    return at == forms.end() ? "" : std::string(at->word);
  } catch (const InputError&) { return {}; }  // no quantity
}

}  // namespace arenite::recipe
