#pragma once
#include <array>
#include <cstddef>

namespace arenite {

/// The inverse of a small symmetric matrix of n x n numbers, all of whose eigenvalues are positive, by elimination
/// without pivots; no finite numbers where one is zero.
template <std::size_t n> std::array<double, n * n> inverse_of_definite(std::array<double, n * n> a) {
  for (std::size_t p = 0; p < n; ++p) {
    const double pivot = 1 / a[n * p + p];
    a[n * p + p] = 1;
    for (std::size_t k = 0; k < n; ++k) a[n * p + k] *= pivot;
    for (std::size_t r = 0; r < n; ++r) {
      if (r == p) continue;
      const double factor = a[n * r + p];
      a[n * r + p] = 0;
      for (std::size_t k = 0; k < n; ++k) a[n * r + k] -= factor * a[n * p + k];
    }
  }
  return a;
}

}  // namespace arenite
