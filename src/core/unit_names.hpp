#pragma once
#include <string>
#include <string_view>

#include "core/units.hpp"

namespace arenite {

/// A unit such as "kN/mm": SI value = number * factor * 10^decade. The decade is kept apart so that "16.4 mm" is the
/// double nearest to 0.0164, with no rounding of its own.
struct Unit {
  double factor = 1;
  int decade = 0;
  Dimension dimension;
};

/// Reads products, quotients and powers of units with SI prefixes: "kN/mm", "kg/m^3", "N s/m", "K/MPa", "%", "1/s",
/// "MPa m^0.5" or "MPa m^1/2". Throws InputError (without place) for what it does not know, offering the nearest known
/// unit.
Unit parse_unit(std::string_view text);

/// Length of a power at the start of a text: "^2", "^-1", "^0.5", "^1/2" or "^(3/2)"; 0 where there is none.
std::size_t power_length(std::string_view text);

/// The SI unit in its usual spelling ("N/m", "Pa", "kg/m^3"); empty for no dimension.
std::string si_unit(Dimension dimension);

/// What such a quantity is called ("a length", "a force"), or its SI unit in words where it has no name.
std::string describe(Dimension dimension);

}  // namespace arenite
