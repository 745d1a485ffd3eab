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
template <int D, class T> double square_norm(const Grid& grid, const FieldIn<D, T>& a) {
  double sum = 0;
  grid.each([&](std::ptrdiff_t i, int) { sum += dot(a.at(i), a.at(i)); });
  return sum;
}

/// What residuals are relative to: |f(u)| of the sample strained uniformly between its clamps. (The displaced row alone
/// would give some fifty times more, and a tolerance that says little about stresses.) `u` holds the prescribed
/// displacements, `work` and `f` are overwritten. Where uniform strain is nearly at equilibrium itself, the reactions
/// of the clamps count with it. Zero only where nothing is displaced or no strain leaves a force.
template <Discretisation D, class T>
double residual_reference(const D& sample, const std::vector<std::uint8_t>& prescribed,
                          const FieldIn<D::dimension, double>& u, FieldIn<D::dimension, T>& work,
                          FieldIn<D::dimension, T>& f) {
  const Grid& grid = sample.grid;
  constexpr int dimension = D::dimension;
  const auto size_of = [](Vec<dimension> v) {
    double sum = 0;
    for (int c = 0; c < dimension; ++c) sum += std::abs(v[c]);
    return sum;
  };
  Vec<dimension> top;
  grid.each([&](std::ptrdiff_t i, int level) {
    if (level == grid.levels() - 1 && size_of(u.at(i)) > size_of(top)) top = u.at(i);
  });
  grid.each([&](std::ptrdiff_t i, int level) {
    const double share = static_cast<double>(level) / (grid.levels() - 1) - 0.5;  // about the middle: small numbers
    work.set(i, share * top);
  });
  const auto norm_of_force = [&](const std::vector<std::uint8_t>& rows) {
    if constexpr (std::is_same_v<T, double>) kernels_of(sample).force(sample, rows.data(), pointers(work), pointers(f));
    else kernels_of(sample).force_float(sample, rows.data(), pointers(work), pointers(f));
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
