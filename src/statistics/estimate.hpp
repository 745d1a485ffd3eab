#pragma once
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/vec.hpp"

namespace arenite::statistics {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A statistic and its standard error; NaN where it is not known. Errors of means over grains, contacts and nodes come from leaving out one block of
/// the sample at a time (jackknife.hpp), which holds for neighbours that are not independent; those of maximum-likelihood fits to grains and contacts
/// are those of the likelihood.
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

/// The value of that name, or nullptr.
template <class T> const T* find(const ByName<T>& values, std::string_view name) {
  for (const auto& [key, value] : values)
    if (key == name) return &value;
  return nullptr;
}

/// "value +- error" with two digits of the error, and the value to the same place. The value alone where the error is not known, or is that of
/// rounding (at most 1e-12 of the value).
std::string with_error(const Estimate& e, double scale = 1);

/// Unit in which stresses of this size are read easily.
struct StressUnit {
  const char* name;
  double scale;
};
StressUnit stress_unit(double size);

}  // namespace arenite::statistics
