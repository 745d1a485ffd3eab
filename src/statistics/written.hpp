#pragma once
#include <string>

#include "statistics/numbers.hpp"

/// How numbers are written, in texts, figures and pages alike.
namespace arenite::statistics {

/// The factor and the unit with its prefix under which numbers are written.
struct Scale {
  double factor = 1;
  std::string unit;
};
/// Those that suit numbers up to `largest`, SI; a unit that has no prefixes as it is typeset: "kg/m^3" as kg/m\u00b3.
Scale scale_of(double largest, const std::string& unit);

/// What `scale_of` goes by, for pages, which write numbers that their reader points at: "prefixed", the units that have
/// prefixes, "prefixes", [factor, prefix] from the largest on, and "from", the share of its factor from which on a
/// prefix is taken.
Numbers prefixed_units();

/// How many decimals show two digits of an error, as it is once rounded; below 0 where these stand before the point.
int decimals_of(double error);

/// A whole number in raised figures.
std::string raised_figures(int number);

}  // namespace arenite::statistics
