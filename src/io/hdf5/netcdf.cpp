#include "io/hdf5/netcdf.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "io/hdf5/handle.hpp"

namespace arenite::io {
namespace {

/// Limits are of what is stored, or, where they alone are floating, of what it stands for.
void take_limits(hid_t set, NumberType type, NumbersStated& numbers) {
  const bool floating = type == NumberType::f32 || type == NumberType::f64;
  const auto take = [&](const char* name, bool upper, std::size_t which = 0) {
    const StatedNumbers stated = stated_numbers(set, name);
    if (which >= stated.value.size() || std::isnan(stated.value[which])) return;
    const bool is_of_stored = stated.whole || floating;
    const double limit = is_of_stored ? stated.value[which] : (stated.value[which] - numbers.offset) / numbers.scale;
    (upper != (!is_of_stored && numbers.scale < 0) ? numbers.most : numbers.least) = limit;
  };
  take("valid_range", false, 0), take("valid_range", true, 1);
  take("valid_min", false), take("valid_max", true);
}

}  // namespace

bool NumbersStated::may_miss() const { return !missing.empty() || std::isfinite(least) || std::isfinite(most); }

bool NumbersStated::is_missing(double stored) const {
  return std::isnan(stored) || stored < least || stored > most || std::ranges::count(missing, stored) > 0;
}

NumbersStated numbers_stated(hid_t set, NumberType stored) {
  NumbersStated numbers;
  if (const auto scale = stated_number(set, "scale_factor"); scale && !std::isnan(*scale)) numbers.scale = *scale;
  if (const auto offset = stated_number(set, "add_offset"); offset && !std::isnan(*offset)) numbers.offset = *offset;
  for (const char* fill : {"missing_value", "_FillValue"})
    for (const double value : stated_numbers(set, fill).value)
      if (!std::isnan(value)) numbers.missing.push_back(value);
  take_limits(set, stored, numbers);
  return numbers;
}

}  // namespace arenite::io
