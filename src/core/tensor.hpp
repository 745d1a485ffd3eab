#pragma once
#include <type_traits>

#include "core/vec.hpp"

namespace arenite {

/// 3 x 3 tensor; not necessarily symmetric. That of the plane stands with its vectors.
struct Tensor3 {
  double at[3][3] = {};
  constexpr Tensor3& operator+=(const Tensor3& other) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) at[i][j] += other.at[i][j];
    return *this;
  }
};
constexpr Tensor3 operator*(double factor, const Tensor3& tensor) {
  Tensor3 scaled;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) scaled.at[i][j] = factor * tensor.at[i][j];
  return scaled;
}
constexpr Tensor3 outer(Vec3 a, Vec3 b) {
  Tensor3 product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) product.at[i][j] = a[i] * b[j];
  return product;
}
constexpr double trace(const Tensor3& tensor) { return tensor.at[0][0] + tensor.at[1][1] + tensor.at[2][2]; }

/// Of the plane or of space.
template <int D> using Tensor = std::conditional_t<D == 2, Tensor2, Tensor3>;

/// Mean of the principal values.
constexpr double mean_principal(const Tensor2& tensor) { return trace(tensor) / 2; }
constexpr double mean_principal(const Tensor3& tensor) { return trace(tensor) / 3; }

/// With this value everywhere.
template <int D> constexpr Tensor<D> filled(double value);
template <> constexpr Tensor2 filled<2>(double value) { return {value, value, value, value}; }
template <> constexpr Tensor3 filled<3>(double value) {
  return {{{value, value, value}, {value, value, value}, {value, value, value}}};
}

}  // namespace arenite
