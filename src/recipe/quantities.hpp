#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/expression.hpp"
#include "core/parameters.hpp"
#include "recipe/document.hpp"
#include "recipe/reader.hpp"

namespace arenite::recipe {

/// Reads the section [variables], whose values may hold each other, in any order. Problems are collected.
void read_variables(const Node& root, Reading& reading);

/// The SI value of a quantity or an expression that must have `wanted` as its dimension. Throws InputError without
/// place.
double si_value(std::string_view text, Dimension wanted, std::string_view unit, const Variables& variables);

/// A whole number without the rounding of the expression that it came from; other numbers as they are.
double nearest_whole(double value);

/// The whole number that a node holds; nothing of anything else.
std::optional<std::int64_t> whole_number(const Node& node);
/// Whether it has the digits of one, but of more of them than TOML has numbers for, so that it was read as a text.
bool is_beyond_integers(const Node& node);

/// A number or a text as it stands in the recipe.
std::string as_written(const Node& node);

/// What is wrong with a number that is written without its unit.
std::string unit_is_missing(const Node& node, std::string_view unit);

/// Of a unit's name; none of an empty one.
Dimension dimension_of(std::string_view unit);

/// A number with its unit as a recipe has it: "27.35 kN/mm" in quotes, or 0.5.
std::string number_literal(double value, std::string_view unit);
/// A literal with this in the place of the number.
std::string with_unit(std::string_view number, std::string_view unit);

/// The form that a quantity without its tag could be meant for, by its dimension.
std::string tag_of_quantity(const std::string& text, const std::vector<Form>& forms);

}  // namespace arenite::recipe
