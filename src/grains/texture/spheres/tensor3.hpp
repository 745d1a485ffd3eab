#pragma once
#include <vector>

#include "core/vec.hpp"
#include "statistics/numbers.hpp"

namespace arenite::texture::spheres {

/// Symmetric or other 3 x 3 tensor.
struct Tensor3 {
  double at[3][3] = {};
  Tensor3& operator+=(const Tensor3& other) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) at[i][j] += other.at[i][j];
    return *this;
  }
};
inline Tensor3 operator*(double factor, const Tensor3& tensor) {
  Tensor3 scaled;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) scaled.at[i][j] = factor * tensor.at[i][j];
  return scaled;
}
inline Tensor3 outer(Vec3 a, Vec3 b) {
  Tensor3 product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) product.at[i][j] = a[i] * b[j];
  return product;
}
inline double trace(const Tensor3& tensor) { return tensor.at[0][0] + tensor.at[1][1] + tensor.at[2][2]; }
/// Of a stress, whose tension is positive: the mean of its principal values, compression positive.
inline double pressure(const Tensor3& stress) { return -trace(stress) / 3; }
/// {{xx, xy, xz}, {yx, ..}, ..}
Numbers rows_of(const Tensor3& tensor);

/// Eigenvalues of the symmetric part, the largest first, with their directions, whose z (else y, else x) is not below
/// 0.
struct Principal {
  Vec3 value;
  Vec3 direction[3];
};
Principal principal(const Tensor3& tensor);
/// sqrt(3 J_2) of it: in a triaxial test the difference of the principal stresses.
double deviator(const Tensor3& tensor);

/// Solution of the six normal equations of a least-squares fit, row by row; unknown where they are singular.
std::vector<double> solved_for_six(const double* normal, const double* right);

}  // namespace arenite::texture::spheres
