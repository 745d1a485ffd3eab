#include "peridynamics/solvers/reference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/vec2.hpp"

namespace arenite::peridynamics {

double square_norm(const Grid& grid, const Field<double>& a) {
  double sum = 0;
  for (int y = 0; y < grid.height; ++y)
    for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) sum += a.x[i] * a.x[i] + a.y[i] * a.y[i];
  return sum;
}

void set_zero(Field<double>& a) {
  std::fill_n(a.x.data(), a.x.size(), 0.0);
  std::fill_n(a.y.data(), a.y.size(), 0.0);
}

double residual_reference(const Bonds& bonds, const std::vector<std::uint8_t>& prescribed, const Field<double>& u,
                          Field<double>& work, Field<double>& f) {
  const Grid& grid = bonds.grid;
  const auto clamp = [&](int y) {
    Vec2 moved;
    for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i)
      if (std::abs(u.x[i]) + std::abs(u.y[i]) > std::abs(moved.x) + std::abs(moved.y)) moved = {u.x[i], u.y[i]};
    return moved;
  };
  const Vec2 top = clamp(grid.height - 1);
  for (int y = 0; y < grid.height; ++y) {
    const double share = static_cast<double>(y) / (grid.height - 1);
    std::fill_n(work.x.data() + grid.row(y), grid.width, share * top.x);
    std::fill_n(work.y.data() + grid.row(y), grid.width, share * top.y);
  }
  kernels().force(bonds, prescribed.data(), plane(work), plane(f));
  return std::sqrt(square_norm(grid, f));
}

}  // namespace arenite::peridynamics
