#pragma once
#include <array>
#include <cstddef>

/// The hats of a cell as polynomials in the place: what sums over the nodes of a cell become at its corners, and back.
/// Corners and powers in the same order: 1, x, y, x y, then the same times z.
namespace arenite::statics {

/// The moments of a residual on a cell of unit side become loads on its corners.
inline void to_corners(const float* m, double h, std::array<double, 4>& weight) {
  const double one = m[0], s = h * m[1], t = h * m[2], st = h * h * m[3];
  weight = {one - s - t + st, s - st, t - st, st};
}
inline void to_corners(const float* m, double h, std::array<double, 8>& weight) {
  std::array<double, 4> below, above;
  to_corners(m, h, below);
  to_corners(m + 4, h, above);
  for (std::size_t k = 0; k < 4; ++k) {
    weight[k + 4] = h * above[k];
    weight[k] = below[k] - weight[k + 4];
  }
}

/// Values at the corners become a polynomial in the place.
inline void to_polynomial(const std::array<double, 4>& u, double h, float* m) {
  m[0] = static_cast<float>(u[0]);
  m[1] = static_cast<float>(h * (u[1] - u[0]));
  m[2] = static_cast<float>(h * (u[2] - u[0]));
  m[3] = static_cast<float>(h * h * (u[0] - u[1] - u[2] + u[3]));
}
inline void to_polynomial(const std::array<double, 8>& u, double h, float* m) {
  to_polynomial(std::array<double, 4>{u[0], u[1], u[2], u[3]}, h, m);
  to_polynomial(std::array<double, 4>{h * (u[4] - u[0]), h * (u[5] - u[1]), h * (u[6] - u[2]), h * (u[7] - u[3])}, h,
                m + 4);
}

/// The powers of y and z that stand beside those of x.
inline void set_monomials(float y, float, std::array<float, 2>& of) { of = {1, y}; }
inline void set_monomials(float y, float z, std::array<float, 4>& of) { of = {1, y, z, y * z}; }

}  // namespace arenite::statics
