#pragma once
#include <string>
#include <string_view>

#include "core/expression.hpp"
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

/// A number or a text as it stands in the recipe.
std::string as_written(const Node& node);

/// What is wrong with a number that is written without its unit.
std::string unit_is_missing(const Node& node, std::string_view unit);

}  // namespace arenite::recipe
