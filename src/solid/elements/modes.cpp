#include "solid/elements/modes.hpp"

#include <cmath>
#include <cstddef>

#include "core/definite.hpp"

namespace arenite::elements {

template <> Modes<2> modes_of<2>(const Constants& constants, Element element, PlaneState plane) {
  const auto [e, nu] = constants;
  const double g = e / (2 * (1 + nu));
  const double c11 = plane == PlaneState::stress ? e / (1 - nu * nu) : e * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  const double c12 = plane == PlaneState::stress ? nu * c11 : e * nu / ((1 + nu) * (1 - 2 * nu));
  const double bending = element == Element::wilson ? c11 - c12 * c12 / c11 : c11 + g;
  return {c11 / 4, c12 / 4, g / 4, bending / 12};
}

template <> Modes<3> modes_of<3>(const Constants& constants, Element element, PlaneState) {
  const auto [e, nu] = constants;
  const double mu = e / (2 * (1 + nu)), lambda = e * nu / ((1 + nu) * (1 - 2 * nu));
  const bool wilson = element == Element::wilson;
  const double own = wilson ? 4 * mu * (lambda + mu) / (lambda + 2 * mu) / 3 : (lambda + 2 * mu) / 3;
  const double along = wilson ? own : own + mu / 3;
  return {(lambda + 2 * mu) / 16,    lambda / 16, mu / 16, along / 16, (own - 2 * mu / 3) / 16,
          (lambda + 4 * mu) / 9 / 16};
}

template <int D> std::array<std::array<double, D>, D> corner_block(const Modes<D>& modes, int c, int d) {
  std::array<std::array<double, D>, D> block{};
  for (std::size_t b = 0; b < D; ++b) {
    Amplitudes<D, double> a{};
    for (int m = 0; m < mode_count<D>; ++m) a.at[b][m] = sign_of(m, d);
    const Amplitudes<D, double> work = work_of(modes, a);
    for (std::size_t e = 0; e < D; ++e)
      for (int m = 1; m < mode_count<D>; ++m) block[e][b] += sign_of(m, c) * work.at[e][m];
  }
  return block;
}

template <int D> double highest_ratio(const Modes<D>& m) {
  constexpr std::size_t corners = 1u << D, unknowns = D * corners;
  std::array<double, unknowns> u{};
  for (std::size_t k = 0; k < unknowns; ++k) u[k] = std::cos(2.0 * static_cast<double>(k) + 1);  // along no symmetry
  std::array<std::array<double, D * D>, corners> inverses;
  for (std::size_t c = 0; c < corners; ++c) {
    const auto block = corner_block<D>(m, static_cast<int>(c), static_cast<int>(c));
    std::array<double, D * D> rows;
    for (std::size_t a = 0; a < D; ++a)
      for (std::size_t b = 0; b < D; ++b) rows[D * a + b] = block[a][b];
    inverses[c] = inverse_of_definite<D>(rows);
  }
  double ratio = 0;
  for (int round = 0; round < 2000; ++round) {  // the power method
    Amplitudes<D, double> a{};
    for (std::size_t c = 0; c < corners; ++c)
      for (int mode = 1; mode < mode_count<D>; ++mode)
        for (std::size_t k = 0; k < D; ++k) a.at[k][mode] += sign_of(mode, static_cast<int>(c)) * u[D * c + k];
    const Amplitudes<D, double> work = work_of(m, a);
    double square = 0;
    for (std::size_t c = 0; c < corners; ++c) {
      std::array<double, D> force{};
      for (std::size_t k = 0; k < D; ++k)
        for (int mode = 1; mode < mode_count<D>; ++mode)
          force[k] += sign_of(mode, static_cast<int>(c)) * work.at[k][mode];
      for (std::size_t k = 0; k < D; ++k) {
        double to = 0;
        for (std::size_t b = 0; b < D; ++b) to += inverses[c][D * k + b] * force[b];
        u[D * c + k] = to;
        square += to * to;
      }
    }
    ratio = std::sqrt(square);
    for (double& v : u) v /= ratio;
  }
  return ratio;
}

template std::array<std::array<double, 2>, 2> corner_block<2>(const Modes<2>& modes, int c, int d);
template std::array<std::array<double, 3>, 3> corner_block<3>(const Modes<3>& modes, int c, int d);
template double highest_ratio<2>(const Modes<2>& modes);
template double highest_ratio<3>(const Modes<3>& modes);

}  // namespace arenite::elements
