#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"

namespace arenite {

/// A quantity that has a name.
struct Variable {
  std::string name;
  Quantity value;
};
using Variables = std::vector<Variable>;

/// The value of "2*D + 5 mm" or "sqrt(n)": numbers with their units, variables, + - * / ^, brackets, pi, and the
/// functions sqrt, abs, min, max, sin, cos, tan, exp, log, round, floor and ceil. Throws InputError without place for
/// what it cannot read, and for sums of unlike quantities.
Quantity evaluate(std::string_view text, const Variables& variables);

/// Whether a text is meant to be evaluated and not to be a single quantity: a variable's name stands in it, or it goes
/// on behind an operator or a bracket.
bool is_expression(std::string_view text, const Variables& variables);

/// Whether a variable may be called so: a letter, then letters, digits and _, and neither a function nor a unit that
/// stands in many quantities.
bool is_variable_name(std::string_view name);

}  // namespace arenite
