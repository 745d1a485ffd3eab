#include "thermal/thermography/resample.hpp"

namespace arenite::thermography {

namespace {

/// One line of `n` numbers that lie `stride` apart: forth and back with the pole of the cubic spline (Unser's filter).
void filter(float* value, int n, std::ptrdiff_t stride) {
  if (n < 2) return;
  const double pole = std::sqrt(3.0) - 2;
  const auto at = [&](int k) -> float& { return value[k * stride]; };
  double sum = 0, power = 1;
  for (int k = 0; k < std::min(n, 24); ++k, power *= pole) sum += power * static_cast<double>(at(k));
  double last = 6 * sum;
  at(0) = static_cast<float>(last);
  for (int k = 1; k < n; ++k) at(k) = static_cast<float>(last = 6 * static_cast<double>(at(k)) + pole * last);
  last = pole / (pole * pole - 1) * (static_cast<double>(at(n - 1)) + pole * static_cast<double>(at(n - 2)));
  at(n - 1) = static_cast<float>(last);
  for (int k = n - 2; k >= 0; --k) at(k) = static_cast<float>(last = pole * (last - static_cast<double>(at(k))));
}

}  // namespace

void spline_coefficients(float* picture, int width, int height) {
  for (int row = 0; row < height; ++row) filter(picture + static_cast<std::ptrdiff_t>(row) * width, width, 1);
  for (int column = 0; column < width; ++column) filter(picture + column, height, width);
}

}  // namespace arenite::thermography
