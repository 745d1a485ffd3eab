#pragma once
#include "grains/fields/coarse_grained.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

/// The same of spheres in a periodic cell of 8 m x 8 m x 8 m, sheared by a tilt.
inline PackingIn<3> gas_in_space(std::uint64_t seed, double tilt = 0, int grains = 40) {
  RandomStream random(seed, Purpose::test);
  PackingIn<3> p;
  p.materials = {{"A", 1000, 0, 0}, {"B", 2000, 0, 0}};
  p.domain.periodic = {true, true, true};
  for (int side = 0; side < 6; ++side) p.domain.wall[side] = {false, side % 2 == 0 ? 0.0 : 8.0};
  p.domain.tilt = tilt;
  const auto vector = [&](auto&& along) { return by_axis<3>([&](int) { return along(); }); };
  p.grains.resize(static_cast<std::size_t>(grains));
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    p.grains.position[g] = vector([&] { return random.uniform(0, 8); });
    p.grains.radius[g] = random.uniform(0.8, 1.4);
    p.grains.material[g] = static_cast<int>(random.below(2));
    p.grains.velocity[g] = Vec3{3, 0, 0} + vector([&] { return random.normal(); });
  }
  for (std::size_t i = 0; i < p.grains.size(); ++i)
    for (std::size_t j = i + 1; j < p.grains.size(); ++j) {
      const Vec3 way = p.domain.nearest_image(p.grains.position[i] - p.grains.position[j]);
      const double gap = norm(way) - p.grains.radius[i] - p.grains.radius[j];
      if (gap >= 0) continue;
      const Vec3 turning = vector([&] { return random.uniform(-2e4, 2e4); });
      p.contacts.add(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), way / norm(way),
                     -6e4 * std::log(1 - random.uniform()), turning, p.grains.radius[i] + gap / 2,
                     p.grains.radius[j] + gap / 2);
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

inline double component(const Tensor2& t, int row, int column) {
  const double all[2][2] = {{t.xx, t.xy}, {t.yx, t.yy}};
  return all[row][column];
}
inline double component(const Tensor<3>& t, int row, int column) { return t.at[row][column]; }

inline Tensor2 dyad(Vec2 a, Vec2 b) { return outer(a, b); }
inline Tensor<3> dyad(Vec3 a, Vec3 b) { return outer(a, b); }

/// One component of vectors, and of tensors.
template <int D> std::vector<double> along(const std::vector<Vec<D>>& values, int axis) {
  std::vector<double> out;
  for (const Vec<D>& v : values) out.push_back(v[axis]);
  return out;
}
template <class T> std::vector<double> components(const std::vector<T>& values, int row, int column) {
  std::vector<double> out;
  for (const T& t : values) out.push_back(component(t, row, column));
  return out;
}

/// Calls `visit` for the cells of every point of a grid.
template <int D, class Visit> void for_every_point(const GridIn<D>& grid, const Visit& visit) {
  for (std::size_t k = 0; k < grid.size(); ++k) {
    auto rest = static_cast<std::int32_t>(k);
    Cells<D> at;
    for (int axis = 0; axis < D; rest /= grid.count[axis++]) at[axis] = rest % grid.count[axis];
    ASSERT_EQ(grid.index(at), k);
    visit(at);
  }
}

/// Derivative along an axis of a periodic field whose shortest waves are empty, by its trigonometric interpolation:
/// exact to rounding.
template <int D> std::vector<double> derivative(const GridIn<D>& grid, const std::vector<double>& f, int axis) {
  const int n = grid.count[axis];  // even
  std::vector<double> out(f.size());
  for_every_point(grid, [&](const Cells<D>& at) {
    Cells<D> other = at;
    for (int k = 0; k < n; ++k) {
      if (k == at[axis]) continue;
      const double weight = pi / grid.extent(axis) * ((at[axis] - k) % 2 ? -1 : 1) / std::tan(pi * (at[axis] - k) / n);
      other[axis] = k;
      out[grid.index(at)] += weight * f[grid.index(other)];
    }
  });
  return out;
}
template <int D> std::vector<double> divergence(const GridIn<D>& grid, const std::vector<Vec<D>>& vectors) {
  std::vector<double> sum(grid.size());
  for (int axis = 0; axis < D; ++axis) {
    const std::vector<double> of = derivative(grid, along(vectors, axis), axis);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += of[k];
  }
  return sum;
}
/// Of the row of a tensor that belongs to the force along an axis.
template <int D, class T>
std::vector<double> divergence(const GridIn<D>& grid, const std::vector<T>& tensors, int row) {
  std::vector<Vec<D>> rows;
  for (const T& t : tensors) rows.push_back(by_axis<D>([&](int column) { return component(t, row, column); }));
  return divergence(grid, rows);
}
inline double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// What masses and forces are counted by.
inline double length_of(const Packing& p) { return p.domain.thickness; }
inline double length_of(const PackingIn<3>& /*packing*/) { return 1; }

/// drho/dt and dp/dt at a point as Newton's second law moves the grains, smeared out by a Gaussian.
template <int D> struct Rates {
  double density = 0;
  Vec<D> momentum;
};
template <int D> Rates<D> rates_at(const PackingIn<D>& p, Vec<D> point, double width) {
  std::vector<Vec<D>> force(p.grains.size());
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    force[static_cast<std::size_t>(p.contacts.i[c])] += p.contacts.force_on_i(c);
    force[static_cast<std::size_t>(p.contacts.j[c])] -= p.contacts.force_on_i(c);
  }
  const double norm_of = std::pow(2 * pi * width * width, 0.5 * D) * length_of(p);
  Rates<D> rates;
  for (std::size_t g = 0; g < p.grains.size(); ++g)
    p.domain.each_near_cell([&](const Cells<D>& image) {
      const Vec<D> d = point - p.grains.position[g] - p.domain.way(image), v = p.grains.velocity[g];
      const double phi = std::exp(-dot(d, d) / (2 * width * width)) / norm_of;
      const double dphi = dot(v, d) / (width * width) * phi;  // of a kernel that moves at v
      rates.density += mass_of(p, g) * dphi;
      rates.momentum += phi * force[g] + mass_of(p, g) * dphi * v;
    });
  return rates;
}

}  // namespace arenite::fields
