#include "solid/peridynamics/solvers/two_level.hpp"

#include <algorithm>
#include <utility>

namespace arenite::peridynamics {

namespace {

/// The part of the spectrum of D^-1 A that the smoother deals with. No bond network exceeds 2: a bond's energy is at
/// most twice that of its two ends held apart.
constexpr double lowest = 0.1, highest = 2.0;

}  // namespace

TwoLevel::TwoLevel(const Bonds& bonds, Pieces pieces, const std::vector<std::uint8_t>& prescribed)
    : TwoLevel(bonds, std::move(pieces), prescribed, block_diagonal(bonds)) {}

TwoLevel::TwoLevel(const Bonds& bonds, Pieces pieces, const std::vector<std::uint8_t>& prescribed,
                   const BlockDiagonal<double>& diagonal)
    : inverse_(inverse_diagonal(bonds, diagonal, prescribed)),
      coarse_(bonds, std::move(pieces), diagonal, prescribed),
      other_(bonds.grid.padded_size()),
      residual_(bonds.grid.padded_size()) {
  const double centre = (highest + lowest) / 2, half = (highest - lowest) / 2;
  double rho = half / centre;
  coefficient_[0] = {0, static_cast<float>(1 / centre)};
  for (unsigned k = 1; k < degree; ++k) {
    const double next = 1 / (2 * centre / half - rho);
    coefficient_[k] = {static_cast<float>(next * rho), static_cast<float>(2 * next / half)};
    rho = next;
  }
}

void TwoLevel::apply(const Bonds& bonds, const Field<float>& r, Field<float>& z) {
  const Kernels& k = kernels();
  const auto step = [&](Coefficient c) {
    k.chebyshev(bonds, plane(z), plane(other_), plane(r), inverse_.plane(), c.a, c.b);
    std::swap(z, other_);
  };
  // From zero the first step has no force: the caller has taken it. The second looks back at zero.
  std::fill_n(other_.x.data(), other_.x.size(), 0.0f);
  std::fill_n(other_.y.data(), other_.y.size(), 0.0f);
  for (unsigned s = 1; s < degree; ++s) step(coefficient_[s]);
  k.residual(bonds, plane(z), plane(r), plane(residual_));
  coarse_.correct(plane(residual_), plane(z));
  for (const Coefficient c : coefficient_) step(c);
}

}  // namespace arenite::peridynamics
