#include "peridynamics/solvers/reference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

double residual_reference(const Bonds& bonds, const std::vector<std::uint8_t>& prescribed, const Field<double>& u, Field<double>& work, Field<double>& f) {
  const Grid& grid = bonds.grid;
  set_zero(work);
  for (int y = 0; y < grid.height; ++y) {
    const auto rows = prescribed[static_cast<std::size_t>(y)];
    if (rows & x_prescribed) std::copy_n(u.x.data() + grid.row(y), grid.width, work.x.data() + grid.row(y));
    if (rows & y_prescribed) std::copy_n(u.y.data() + grid.row(y), grid.width, work.y.data() + grid.row(y));
  }
  kernels().force(bonds, prescribed.data(), plane(work), plane(f));
  return std::sqrt(square_norm(grid, f));
}

}  // namespace arenite::peridynamics
