#pragma once
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace arenite {

/// Numbers that follow from others, so that whoever draws them (the page, which reads the same formulas) needs not know
/// how. Words with blanks between, operators behind what they act on: "xx yy + 2 /" is half the sum of xx and yy. Words
/// are numbers, pi, the operators + - * / hypot atan2, or names, whose `size` values are what `of` gives. Throws
/// std::logic_error for a formula that is none.
using NamedValues = std::function<std::vector<double>(std::string_view name)>;
std::vector<double> evaluated(std::string_view formula, std::size_t size, const NamedValues& of);

}  // namespace arenite
