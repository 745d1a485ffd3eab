#pragma once
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/vec.hpp"

namespace arenite::statistics {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A statistic and its standard error; NaN where it is not known. Errors of means over grains, contacts and nodes come
/// from leaving out one block of the sample at a time (jackknife.hpp), which holds for neighbours that are not
/// independent; those of maximum-likelihood fits to grains and contacts are those of the likelihood.
struct Estimate {
  double value = unknown, error = unknown;
};

/// A symmetric or other 2 x 2 statistic with the standard error of each component.
struct TensorEstimate {
  Tensor2 value{unknown, unknown, unknown, unknown};
  Tensor2 error{unknown, unknown, unknown, unknown};
};

/// y against x, with the standard error of y (empty if there is none).
struct Curve {
  std::vector<double> x, y, error;
};

/// Values by name ("all", "POM-HDPE", "strong"), in a fixed order.
template <class T> using ByName = std::vector<std::pair<std::string, T>>;

}  // namespace arenite::statistics
