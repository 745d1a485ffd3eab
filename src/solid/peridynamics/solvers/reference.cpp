#include "solid/peridynamics/solvers/reference.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/vec2.hpp"

namespace arenite::peridynamics {

template <class T>
double square_norm(const Grid& grid, const Field<T>& a) {
  double sum = 0;
  for (int y = 0; y < grid.height; ++y)
    for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
      const double ax = a.x[i], ay = a.y[i];
      sum += ax * ax + ay * ay;
    }
  return sum;
}

template <class T>
double residual_reference(const Bonds& bonds, const std::vector<std::uint8_t>& prescribed, const Field<double>& u,
                          Field<T>& work, Field<T>& f) {
  const Grid& grid = bonds.grid;
  Vec2 top;
  for (std::ptrdiff_t i = grid.row(grid.height - 1), end = i + grid.width; i < end; ++i)
    if (std::abs(u.x[i]) + std::abs(u.y[i]) > std::abs(top.x) + std::abs(top.y)) top = {u.x[i], u.y[i]};
  for (int y = 0; y < grid.height; ++y) {
    const double share = static_cast<double>(y) / (grid.height - 1) - 0.5;  // about the middle: small numbers
    std::fill_n(work.x.data() + grid.row(y), grid.width, static_cast<T>(share * top.x));
    std::fill_n(work.y.data() + grid.row(y), grid.width, static_cast<T>(share * top.y));
  }
  if constexpr (std::is_same_v<T, double>) kernels().force(bonds, prescribed.data(), plane(work), plane(f));
  else kernels().force_float(bonds, prescribed.data(), plane(work), plane(f));
  return std::sqrt(square_norm(grid, f));
}

template double square_norm(const Grid&, const Field<float>&);
template double square_norm(const Grid&, const Field<double>&);
template double residual_reference(const Bonds&, const std::vector<std::uint8_t>&, const Field<double>&, Field<float>&,
                                   Field<float>&);
template double residual_reference(const Bonds&, const std::vector<std::uint8_t>&, const Field<double>&, Field<double>&,
                                   Field<double>&);

}  // namespace arenite::peridynamics
