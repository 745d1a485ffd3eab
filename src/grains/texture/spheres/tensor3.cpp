#include "grains/texture/spheres/tensor3.hpp"

#include <Eigen/Eigenvalues>

namespace arenite::texture::spheres {

Numbers rows_of(const Tensor3& tensor) {
  Numbers rows = Numbers::list();
  for (const auto& row : tensor.at) rows.push_back(Numbers::list({row[0], row[1], row[2]}));
  return rows;
}

Principal principal(const Tensor3& tensor) {
  Eigen::Matrix3d symmetric;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) symmetric(i, j) = 0.5 * (tensor.at[i][j] + tensor.at[j][i]);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  Principal p;
  for (int k = 0; k < 3; ++k) {
    p.value[k] = solver.eigenvalues()[2 - k];
    const Eigen::Vector3d n = solver.eigenvectors().col(2 - k);
    const double sign = n[2] != 0 ? n[2] : n[1] != 0 ? n[1] : n[0];
    p.direction[k] = (sign < 0 ? -1.0 : 1.0) * Vec3{n[0], n[1], n[2]};
  }
  return p;
}

}  // namespace arenite::texture::spheres
