#pragma once
#include <string>
#include <string_view>

#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

namespace arenite {

/// What is left out of a table: nodes with one of these names, or whose names end with one of these words, separated by
/// blanks.
struct LeftOut {
  std::string_view names, endings = {};
};
/// For people: a row for each value in the tree's order, "name  value +- error unit  what it is", under the names that
/// files, CSV and Python have; texts too, and tensors, but no longer lists. A set of things that is all of what it is a
/// part of repeats it and has no rows. Notes stand last.
std::string to_text(const Numbers& tree, const LeftOut& left_out = {});
/// The rows at these dotted names alone, separated by blanks, in this order: a number's, or a whole group's; "*" at the
/// end of a step stands for anything.
std::string rows_of(const Numbers& tree, std::string_view names);

}  // namespace arenite

namespace arenite::statistics {

/// "value +- error" with two digits of the error, and the value to the same place. The value alone where the error is
/// not known, or is that of rounding (at most 1e-12 of the value).
std::string with_error(const Estimate& e, double scale = 1);

}  // namespace arenite::statistics
