#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "solid/statics/discretisation.hpp"
#include "solid/statics/watch.hpp"

namespace arenite::statics {

/// sum a . a over the nodes of the sample.
template <class T> double square_norm(const Grid& grid, const Field<T>& a) {
  double sum = 0;
  grid.each([&](std::ptrdiff_t i, int) { sum += dot(a.at(i), a.at(i)); });
  return sum;
}

/// What residuals are relative to: |f(u)| of the sample strained uniformly between its clamps. (The displaced row alone
/// would give some fifty times more, and a tolerance that says little about stresses.) `u` holds the prescribed
/// displacements, `work` and `f` are overwritten. Where uniform strain is nearly at equilibrium itself, the reactions
/// of the clamps count with it. Zero only where nothing is displaced or no strain leaves a force.
template <Discretisation D, class T>
double residual_reference(const D& sample, const std::vector<std::uint8_t>& prescribed, const Field<double>& u,
                          Field<T>& work, Field<T>& f) {
  const Grid& grid = sample.grid;
  Vec2 top;
  for (std::ptrdiff_t i = grid.row(grid.height - 1), end = i + grid.width; i < end; ++i)
    if (std::abs(u.x[i]) + std::abs(u.y[i]) > std::abs(top.x) + std::abs(top.y)) top = {u.x[i], u.y[i]};
  for (int y = 0; y < grid.height; ++y) {
    const double share = static_cast<double>(y) / (grid.height - 1) - 0.5;  // about the middle: small numbers
    std::fill_n(work.x.data() + grid.row(y), grid.width, static_cast<T>(share * top.x));
    std::fill_n(work.y.data() + grid.row(y), grid.width, static_cast<T>(share * top.y));
  }
  const auto norm_of_force = [&](const std::vector<std::uint8_t>& rows) {
    if constexpr (std::is_same_v<T, double>) kernels_of(sample).force(sample, rows.data(), plane(work), plane(f));
    else kernels_of(sample).force_float(sample, rows.data(), plane(work), plane(f));
    return std::sqrt(square_norm(grid, f));
  };
  const double inside = norm_of_force(prescribed);
  if constexpr (!D::rests_when_strained) return inside;
  const double everywhere = norm_of_force(std::vector<std::uint8_t>(prescribed.size(), nothing_prescribed));
  return inside > 1e-3 * everywhere ? inside : everywhere;
}

/// Tells a watch how far a residual has come down, on a logarithmic scale from its first value to the tolerance.
class Reporter {
 public:
  Reporter(const Watch& watch, double tolerance) : watch_(watch), tolerance_(tolerance) {}

  bool goes_on(int iterations, double residual) {
    if (!watch_) return true;
    if (first_ == 0) first_ = residual;
    if (residual > 0 && first_ > tolerance_)
      share_ = std::clamp(std::log(first_ / residual) / std::log(first_ / tolerance_), share_, 1.0);
    return watch_({share_, iterations, residual, 0, 0, 0});
  }

 private:
  const Watch& watch_;
  double tolerance_, first_ = 0, share_ = 0;
};

}  // namespace arenite::statics
