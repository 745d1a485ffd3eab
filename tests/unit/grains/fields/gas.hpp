#pragma once
#include "grains/fields/coarse_grained.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "grains/texture/texture.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {

using std::numbers::pi;

/// Grains that fly about in a periodic cell of 10 m x 8 m, with random forces where they overlap: large enough to weigh
/// as much in the balance of momentum as the flow does.
inline Packing gas(std::uint64_t seed, double tilt = 0, int grains = 60) {
  RandomStream random(seed, Purpose::test);
  Packing p = test::empty_box(10, 8, 0.06);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  p.domain.tilt = tilt;
  for (int g = 0; g < grains; ++g) {
    test::add_grain(p, {random.uniform(0, 10), random.uniform(0, 8)}, random.uniform(0.3, 0.6),
                    static_cast<int>(random.below(2)));
    p.grains.velocity.back() = {3 + random.normal(), random.normal()};
  }
  for (std::size_t i = 0; i < p.grains.size(); ++i)
    for (std::size_t j = i + 1; j < p.grains.size(); ++j)
      if (norm(p.domain.nearest_image(p.grains.position[i] - p.grains.position[j])) <
          p.grains.radius[i] + p.grains.radius[j]) {
        const double along = random.uniform(-120, 120);
        test::add_contact(p, i, j, -400 * std::log(1 - random.uniform()), along);
      }
  return p;
}

inline double total(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum;
}
template <class T> std::vector<double> part(const std::vector<T>& values, double T::*member) {
  std::vector<double> out;
  for (const T& v : values) out.push_back(v.*member);
  return out;
}

/// Derivative along x or y of a periodic field whose shortest waves are empty, by its trigonometric interpolation:
/// exact to rounding.
inline std::vector<double> derivative(const Grid& grid, const std::vector<double>& f, bool along_x) {
  const int n = along_x ? grid.columns : grid.rows;  // even
  const double length = along_x ? grid.bounds.width() : grid.bounds.height();
  std::vector<double> out(f.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      for (int k = 0; k < n; ++k) {
        const int at = along_x ? column : row;
        if (k == at) continue;
        const double weight = pi / length * ((at - k) % 2 ? -1 : 1) / std::tan(pi * (at - k) / n);
        out[static_cast<std::size_t>(row * grid.columns + column)] +=
            weight * f[static_cast<std::size_t>(along_x ? row * grid.columns + k : k * grid.columns + column)];
      }
  return out;
}
inline std::vector<double> divergence(const Grid& grid, const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> sum = derivative(grid, x, true);
  const std::vector<double> other = derivative(grid, y, false);
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += other[k];
  return sum;
}
inline double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// drho/dt and dp/dt at a point as Newton's second law moves the grains.
struct Rates {
  double density = 0;
  Vec2 momentum;
};
inline Rates rates_at(const Packing& p, Vec2 point, double width) {
  std::vector<Vec2> force(p.grains.size());
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    force[static_cast<std::size_t>(p.contacts.i[c])] += p.contacts.force_on_i(c);
    force[static_cast<std::size_t>(p.contacts.j[c])] -= p.contacts.force_on_i(c);
  }
  Rates rates;
  for (std::size_t g = 0; g < p.grains.size(); ++g)
    for (int row = -1; row <= 1; ++row)
      for (int column = -1; column <= 1; ++column) {
        const Vec2 d = point - p.grains.position[g] - Vec2{10.0 * column, 8.0 * row}, v = p.grains.velocity[g];
        const double phi = std::exp(-dot(d, d) / (2 * width * width)) / (2 * pi * width * width) / p.domain.thickness;
        const double dphi = dot(v, d) / (width * width) * phi;  // of a kernel that moves at v
        rates.density += mass_of(p, g) * dphi;
        rates.momentum += phi * force[g] + mass_of(p, g) * dphi * v;
      }
  return rates;
}

}  // namespace arenite::fields
