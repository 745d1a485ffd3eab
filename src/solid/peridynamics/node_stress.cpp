#include <algorithm>
#include <array>
#include <cmath>

#include "core/vec.hpp"
#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {
namespace {

/// Force on the first node of every bond, N/m, handed to `visit(i, j, e, force)`.
template <class Visit> void each_exact_bond(const Bonds& bonds, double dx, const Field<double>& u, const Visit& visit) {
  std::visit(
      [&](const auto& law) {
        each_bond(bonds, [&](const Bond& b) {
          const Offset e = b.step();
          const double l = length(e) * dx;
          const Vec2 now = Vec2{e.x * dx, e.y * dx} + u.at(b.j) - u.at(b.i);
          const double lnow = norm(now);
          visit(b.i, b.j, e, (law.force(lnow - l, bonds.modulus(b.type) * dx) / (l * lnow)) * now);
        });
      },
      bonds.law);
}

/// Sums over the half bonds that start at a node, and those that end there, bond by bond in rows.
struct StressSums {
  Buffer<double> xx, yy, xy;
  explicit StressSums(std::size_t n) : xx(n), yy(n), xy(n) {}
};

void add_linear(const BondLaw auto& law, const Bonds& bonds, double dx, const Field<double>& u, StressSums& s) {
  const Grid& grid = bonds.grid;
  std::array<std::array<double, 4>, bonds_per_node> k{};
  for (unsigned d = 0; d < bonds_per_node; ++d)
    for (unsigned t = 1; t < 4; ++t) k[d][t] = bonds.modulus(t) / (2 * dx * std::pow(length(half_bonds[d]), 3));
  for (int y = 0; y < grid.height; ++y)
    for (int d = 0; d < bonds_per_node; ++d) {
      const Offset e = half_bonds[static_cast<unsigned>(d)];
      const double ex = e.x, ey = e.y;
      const std::ptrdiff_t step = bonds.step(d);
      const auto& modulus = k[static_cast<unsigned>(d)];
      for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
        const std::ptrdiff_t j = i + step;
        const double tension = law.force(ex * (u.x[j] - u.x[i]) + ey * (u.y[j] - u.y[i]), modulus[bonds.type(i, d)]);
        s.xx[i] += ex * ex * tension;
        s.xx[j] += ex * ex * tension;
        s.yy[i] += ey * ey * tension;
        s.yy[j] += ey * ey * tension;
        s.xy[i] += ex * ey * tension;
        s.xy[j] += ex * ey * tension;
      }
    }
}

void add_exact(const Bonds& bonds, double dx, const Field<double>& u, StressSums& s) {
  each_exact_bond(bonds, dx, u, [&](std::ptrdiff_t i, std::ptrdiff_t j, Offset e, Vec2 f) {
    const double h = 1 / (2 * dx);
    for (const std::ptrdiff_t n : {i, j}) {
      s.xx[n] += h * f.x * e.x;
      s.yy[n] += h * f.y * e.y;
      s.xy[n] += h * (f.x * e.y + f.y * e.x) / 2;
    }
  });
}

}  // namespace

StressField node_stress(const Bonds& bonds, double dx, const Field<double>& u, bool exact_stretch) {
  const Grid& grid = bonds.grid;
  StressSums sums(grid.padded_size());
  if (exact_stretch) add_exact(bonds, dx, u, sums);
  else std::visit([&](const auto& law) { add_linear(law, bonds, dx, u, sums); }, bonds.law);
  StressField field;
  field.width = grid.width;
  field.height = grid.height;
  field.dx = dx;
  const auto compact = [&](const Buffer<double>& padded) {
    std::vector<double> values(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
    for (int y = 0; y < grid.height; ++y) std::copy_n(padded.data() + grid.row(y), grid.width, values.begin() + static_cast<std::ptrdiff_t>(y) * grid.width);
    return values;
  };
  field.ux = compact(u.x);
  field.uy = compact(u.y);
  field.xx = compact(sums.xx);
  field.yy = compact(sums.yy);
  field.xy = compact(sums.xy);
  return field;
}

void exact_force(const Bonds& bonds, double dx, const Field<double>& u, Field<double>& f) {
  set_zero(f);
  each_exact_bond(bonds, dx, u, [&](std::ptrdiff_t i, std::ptrdiff_t j, Offset, Vec2 g) {
    f.set(i, f.at(i) + g);
    f.set(j, f.at(j) - g);
  });
}

}  // namespace arenite::peridynamics
