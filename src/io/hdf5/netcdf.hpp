#pragma once
#include <hdf5.h>

#include <limits>
#include <vector>

#include "io/disk/byte_source.hpp"

namespace arenite::io {

/// What attributes of a dataset say of its numbers, by the conventions of netCDF: a stored number stands for
/// scale * number + offset, or for none.
struct NumbersStated {
  double scale = 1, offset = 0;  ///< scale_factor, add_offset
  std::vector<double> missing;   ///< stored numbers that stand for none (missing_value, _FillValue); NaN always does
  /// Of stored numbers: what lies beyond (valid_range, valid_min, valid_max) stands for none.
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();

  /// Whether a number other than NaN may stand for none; and whether a stored one does.
  bool may_miss() const;
  bool is_missing(double stored) const;
};

/// Those of a dataset of numbers of this type.
NumbersStated numbers_stated(hid_t set, NumberType stored);

}  // namespace arenite::io
